// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The functions of the coordinates that were fitted to the run, and how good
// they are.

import { PathTable } from "../data/run";
import { element, section } from "../dom";
import { readable } from "../palette";

function millimetres(errors: [number, number, number] | null): string[] {
  return errors ? errors.map((error) => error.toFixed(2)) : ["–", "–", "–"];
}

// A column: its head, and whether it holds numbers.
const columns: [string, boolean][] = [
  ["path", false],
  ["coordinates", false],
  ["terms", true],
  ["length, mean", true],
  ["95 %", true],
  ["largest", true],
  ["arm, mean", true],
  ["95 %", true],
  ["largest", true],
  ["jumps", true],
  ["lines with a change of sign", true],
  ["within bounds", false],
];

function rowOf(row: PathTable["rows"][number]): HTMLElement {
  const cells = [
    row.coordinates.join(", "),
    String(row.terms),
    ...millimetres(row.length_mm),
    ...millimetres(row.arm_mm),
    String(row.jumps),
    `${row.with_sign_change} of ${row.lines}`,
    row.within_bounds ? "yes" : "no",
  ];
  return element(
    "tr",
    { "data-within-bounds": String(row.within_bounds) },
    element("th", { scope: "row", title: readable(row.muscle) }, row.name),
    ...cells.map((text, i) =>
      element("td", { class: columns[i + 1][1] ? "number" : "" }, text),
    ),
  );
}

export function functionsSection(functions: PathTable): HTMLElement {
  const [length, arm, largest] = functions.bounds_mm;
  return section(
    "Functions of the coordinates",
    "functions",
    element(
      "p",
      { class: "note" },
      `${functions.file}: ${functions.rows.length} functions of ` +
        `${functions.frames} frames, ${functions.frames_doubtful} of them doubtful; ` +
        `${functions.frames_left_out} left out. All lengths and arms in ` +
        `${functions.microseconds.toFixed(1)} microseconds. Errors, mm, are at ` +
        "postures that a function does not know; bounds are " +
        `${length} (length, mean), ${arm} (arm, mean) and ${largest} (arm, largest). ` +
        "Jumps and changes of sign are of arms along straight lines through the range.",
    ),
    element(
      "div",
      { class: "scrolls" },
      element(
        "table",
        { class: "functions" },
        element(
          "thead",
          {},
          element(
            "tr",
            {},
            ...columns.map(([head, isNumber]) =>
              element(
                "th",
                { scope: "col", class: isNumber ? "number" : "" },
                head,
              ),
            ),
          ),
        ),
        element("tbody", {}, ...functions.rows.map(rowOf)),
      ),
    ),
  );
}
