// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What was run, how it ended, what was repaired.

import { MeshReport, isClean } from "../data/report";
import { Run } from "../data/run";
import { button, element, section } from "../dom";
import { readable } from "../palette";

type Row = [string, string | Node];

function table(rows: Row[]): HTMLElement {
  return element(
    "table",
    { class: "facts" },
    element(
      "tbody",
      {},
      ...rows.map(([name, value]) =>
        element(
          "tr",
          {},
          element("th", { scope: "row" }, name),
          element("td", {}, value),
        ),
      ),
    ),
  );
}

function list(texts: string[]): HTMLElement {
  return element(
    "ul",
    { class: "plain" },
    ...texts.map((text) => element("li", {}, text)),
  );
}

// "3 of 36 frames, then: interrupted" and the like.
export function endOf(run: Run): string {
  const { finished, frames_planned, stopped } = run.report.summary;
  if (finished) return `finished, ${run.frames.length} frames`;
  const planned = frames_planned ? ` of ${frames_planned}` : "";
  return (
    `stopped after ${run.frames.length}${planned} frames: ` +
    (stopped ??
      "the program ended without saying why (killed, or still running)")
  );
}

// Stop reasons with the frames that have them.
function stopReasons(run: Run): string[] {
  const frames = new Map<string, string[]>();
  for (const frame of run.frames) {
    const names = frames.get(frame.stop_reason) ?? [];
    frames.set(frame.stop_reason, [...names, frame.name]);
  }
  return [...frames].map(([reason, names]) =>
    names.length > 6
      ? `${reason}: ${names.length} frames`
      : `${reason}: ${names.join(", ")}`,
  );
}

// Counts and lengths that are not zero: "merged points 12, longest merge 0.1 mm".
function nonZero(figures: Record<string, number | boolean>): string {
  const texts = Object.entries(figures)
    .filter(([, value]) => value !== 0 && value !== false)
    .map(([key, value]) => {
      const [, name, unit] = /^(.*?)(_mm2|_mm3|_mm)?$/.exec(key)!;
      const units: Record<string, string> = {
        _mm: " mm",
        _mm2: " mm²",
        _mm3: " mm³",
      };
      const shown =
        typeof value === "number" ? ` ${Number(value.toPrecision(4))}` : "";
      return readable(name) + shown + (unit ? units[unit] : "");
    });
  return texts.join(", ");
}

function repairs(meshes: MeshReport[]): HTMLElement {
  return element(
    "div",
    { class: "scrolls" },
    element(
      "table",
      { class: "repairs" },
      element(
        "thead",
        {},
        element(
          "tr",
          {},
          ...["mesh", "as delivered", "repairs"].map((title) =>
            element("th", { scope: "col" }, title),
          ),
        ),
      ),
      element(
        "tbody",
        {},
        ...meshes.map(({ name, defects, repairs }) => {
          const { components, ...others } = defects;
          const found = nonZero(
            Number(components) > 1 ? { ...others, components } : others,
          );
          return element(
            "tr",
            {},
            element("th", { scope: "row" }, readable(name)),
            element("td", {}, found || "nothing wrong"),
            element("td", {}, nonZero(repairs) || "none"),
          );
        }),
      ),
    ),
  );
}

function command(text: string): HTMLElement {
  const copy = button("copy", "Copy the command line", () => {
    void navigator.clipboard?.writeText(text);
  });
  return element("div", { class: "command" }, element("code", {}, text), copy);
}

// "yes", and what that was not tested for: only certified contact refuses a
// frame because meshes cross.
function usability(run: Run): string {
  const { contact, summary } = run.report;
  if (!summary.usable) return "no: report.json says why";
  const yes = summary.finished ? "yes" : "so far";
  if (contact === "none") {
    return `${yes}; not tested for crossings (contact none)`;
  }
  const crossing = run.frames.some((frame) => !isClean(frame.intersections));
  return crossing && contact === "paper"
    ? `${yes}; contact paper does not refuse frames in which meshes cross`
    : yes;
}

function runSummary(run: Run): HTMLElement {
  const { report } = run;
  const clean = run.frames.filter((frame) => isClean(frame.intersections));
  const volumeErrors = run.frames.flatMap((frame) =>
    frame.muscles.map((muscle) => Math.abs(muscle.volume_error)),
  );
  const times = run.frames.map(({ wall_ms }) => wall_ms).sort((a, b) => a - b);
  const options = Object.entries(report.options ?? {}).map(
    ([name, value]) => `--${name}=${value}`,
  );
  const rows: Row[] = [
    ["Ended", endOf(run)],
    ["Usable", usability(run)],
    ["Frames without crossings", `${clean.length} of ${run.frames.length}`],
    ["Stop reasons", list(stopReasons(run))],
  ];
  if (run.frames.length > 0) {
    rows.push(
      ["Largest volume error", Math.max(...volumeErrors).toPrecision(3)],
      ["Median time a frame", `${times[times.length >> 1].toFixed(1)} ms`],
    );
  }
  rows.push(
    ["Preparation", `${(report.prepare.wall_ms / 1000).toFixed(1)} s`],
    ["Scene", report.scene],
    ["Solver", report.solver],
    ["Contact", report.contact],
  );
  if (report.motion) {
    rows.push(["Model", report.motion.model], ["Motion", report.motion.file]);
  }
  rows.push(
    [
      "Machine",
      `${report.machine.processor}, ${report.machine.cores} cores` +
        (report.machine.threads ? `, ${report.machine.threads} threads` : ""),
    ],
    ["Version", report.version],
    ["Hash of inputs and options", report.inputs_hash],
    ["To run it again", command(report.command)],
  );
  if (options.length > 0) {
    rows.push([
      "All options",
      element(
        "details",
        {},
        element("summary", {}, `${options.length} options`),
        list(options),
      ),
    ]);
  }
  const said = [
    ...run.warnings,
    ...(report.warnings ?? []),
    ...report.prepare.warnings,
    ...(report.prepare.notes ?? []),
  ];
  if (said.length > 0) rows.push(["Warnings and notes", list(said)]);
  return element(
    "div",
    { class: "run-summary" },
    element("h3", {}, run.folder),
    table(rows),
    element("h4", {}, "Repairs"),
    repairs([...report.prepare.muscles, ...report.prepare.bones]),
  );
}

export function summarySection(runs: Run[]): HTMLElement {
  return section(
    "Summary",
    "summary",
    element("div", { class: "summaries" }, ...runs.map(runSummary)),
  );
}
