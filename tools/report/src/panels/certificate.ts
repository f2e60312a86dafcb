// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// One mark a frame: clean, crossing or not usable; told apart by shape as well
// as colour. A click goes to the frame.

import { isClean } from "../data/report";
import { Run } from "../data/run";
import { Moment } from "../data/timeline";
import { element } from "../dom";
import { Player } from "../player";
import { Store } from "../state";

type Verdict = "clean" | "crossing" | "unusable" | "missing";

const verdictTexts: Record<Verdict, string> = {
  clean: "nothing crosses",
  crossing: "meshes cross",
  unusable: "not usable",
  missing: "not in this run",
};

function verdictOf(run: Run, pose: number | null): Verdict {
  if (pose === null) return "missing";
  if (pose === 0) {
    return isClean(run.report.rest.intersections) ? "clean" : "crossing";
  }
  const frame = run.frames[pose - 1];
  if (!frame.usable) return "unusable";
  return isClean(frame.intersections) ? "clean" : "crossing";
}

function describe(run: Run, moment: Moment, pose: number | null): string {
  const verdict = verdictOf(run, pose);
  const counts =
    pose === null
      ? null
      : pose === 0
        ? run.report.rest.intersections
        : run.frames[pose - 1].intersections;
  const shortcomings = pose ? (run.frames[pose - 1].shortcomings ?? []) : [];
  const said = [
    `${moment.name}: ${verdictTexts[verdict]}`,
    ...(verdict === "crossing" || verdict === "unusable"
      ? [`${counts!.triangle_pairs} crossing pairs`]
      : []),
    ...shortcomings,
  ];
  return said.join(", ");
}

export function certificateStrip(
  run: Run,
  i: number,
  timeline: Moment[],
  store: Store,
  player: Player,
): HTMLElement {
  const marks = timeline.map((moment, at) => {
    const text = describe(run, moment, moment.poses[i]);
    return element("button", {
      type: "button",
      class: "mark",
      "data-verdict": verdictOf(run, moment.poses[i]),
      title: text,
      "aria-label": text,
      // The slider above goes through the frames by keyboard.
      tabindex: -1,
      onclick: () => player.goTo(at),
    });
  });
  marks[0].append("rest");
  store.subscribe((state, changed) => {
    if (!changed.has("moment")) return;
    marks.forEach((mark, at) =>
      mark.toggleAttribute("aria-current", at === state.moment),
    );
  });
  return element(
    "div",
    {
      class: "strip",
      role: "group",
      "aria-label": `Certificate of each frame of ${run.folder}`,
    },
    ...marks,
  );
}

// What the marks mean, and what runs were not tested for.
export function certificateLegend(runs: Run[]): HTMLElement {
  const untested = runs.filter(({ report }) => report.contact === "none");
  const which =
    untested.length < runs.length ? " of the runs without contact" : "";
  return element(
    "p",
    { class: "strip-legend" },
    ...(["clean", "crossing", "unusable"] as const).map((verdict) =>
      element(
        "span",
        {},
        element("i", { class: "mark", "data-verdict": verdict }),
        verdictTexts[verdict],
      ),
    ),
    ...(untested.length > 0
      ? [
          element(
            "span",
            {},
            `Frames${which} are not tested for crossings (contact none): ` +
              "they are counted, and no frame is refused for them.",
          ),
        ]
      : []),
  );
}
