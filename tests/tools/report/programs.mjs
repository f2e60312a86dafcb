// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Runs of musclewarp-deform for the tests, and pages of them.

import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

function setting(name) {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set: run this by ctest`);
  return value;
}

const programs = {
  deform: setting("MUSCLEWARP_DEFORM"),
  report: setting("MUSCLEWARP_REPORT"),
};
export const dataDir = setting("MUSCLEWARP_DATA_DIR");

export const workDir = mkdtempSync(join(tmpdir(), "musclewarp_page_"));
process.on("exit", () => rmSync(workDir, { recursive: true, force: true }));

// Without contact, so that there are crossings to show; flags that come later win.
export function deform(...flags) {
  const { status, stderr } = spawnSync(
    programs.deform,
    ["--contact=none", ...flags],
    {
      encoding: "utf8",
      maxBuffer: 1 << 26,
    },
  );
  if (status !== 0 && status !== 1) throw new Error(stderr);
  return status;
}

export function writePage(run, page, ...flags) {
  execFileSync(programs.report, [`--in=${run}`, `--out=${page}`, ...flags]);
  return page;
}

export function readReport(run) {
  return JSON.parse(readFileSync(join(run, "report.json"), "utf8"));
}

export function writeReport(run, report) {
  writeFileSync(join(run, "report.json"), JSON.stringify(report));
}
