// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Bundles a page into one HTML file, with a comment where the program that
// writes it puts the data: the page of a run, or that of joints.
//
// usage: node build.mjs run|joints OUTPUT.html

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import * as esbuild from "esbuild";

const pages = {
  run: {
    entry: "src/main.ts",
    shows: "a run of musclewarp",
    program: "musclewarp-report",
  },
  joints: {
    entry: "src/joints/main.ts",
    shows: "joints found by musclewarp",
    program: "musclewarp-articulate",
  },
};
const [kind, output] = process.argv.slice(2);
const chosen = pages[kind];
if (!chosen || !output) {
  throw new Error("usage: node build.mjs run|joints OUTPUT.html");
}
const target = resolve(output);
const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry) {
  const result = await esbuild.build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    charset: "utf8",
    legalComments: "none",
    format: "iife",
    target: ["chrome111", "firefox113", "safari16.4"],
  });
  return { text: result.outputFiles[0].text.trim(), meta: result.metafile };
}

// The folders of the packages that are in the bundle.
function packagesIn(metafile) {
  const folders = Object.keys(metafile.inputs)
    .map((path) => /^(node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1])
    .filter(Boolean);
  return [...new Set(folders)].sort();
}

function licenceOf(folder) {
  const { name, version, license } = JSON.parse(
    readFileSync(join(here, folder, "package.json"), "utf8"),
  );
  const file = ["LICENSE", "LICENSE.md", "LICENSE.txt", "LICENCE"]
    .map((each) => join(here, folder, each))
    .find(existsSync);
  if (!file) throw new Error(`${folder} has no licence file`);
  return `${name} ${version} (${license})\n\n${readFileSync(file, "utf8").trim()}\n`;
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

const script = await bundle(chosen.entry);
const style = await bundle("src/style.css");
const licences = [
  "musclewarp (Apache-2.0), Copyright 2026 The musclewarp authors\n",
  ...packagesIn(script.meta).map(licenceOf),
].join("\n----\n\n");
const parts = {
  shows: chosen.shows,
  program: chosen.program,
  "script-hash": createHash("sha256").update(script.text).digest("base64"),
  style: style.text,
  licences: escaped(licences),
  script: script.text,
};
const page = readFileSync(join(here, "src/page.html"), "utf8").replace(
  /\{\{([a-z-]+)\}\}/g,
  (_, name) => parts[name],
);
mkdirSync(dirname(target), { recursive: true });
writeFileSync(target, page);
