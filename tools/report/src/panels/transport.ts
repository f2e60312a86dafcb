// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Play, step, scrub.

import { Run } from "../data/run";
import { Moment } from "../data/timeline";
import { button, element, icon, labelled, select } from "../dom";
import { Player } from "../player";
import { Store } from "../state";
import { certificateLegend, certificateStrip } from "./certificate";

// "hip_flexion_r -4 degrees · frame 3 of 36 · t=0.03"
export function momentText(timeline: Moment[], at: number): string {
  const { frame, name } = timeline[at];
  if (!frame) return "rest, as the meshes came";
  const parts = [name, `frame ${at} of ${timeline.length - 1}`];
  return [...parts, ...(frame.name === name ? [] : [frame.name])].join(" · ");
}

export function transport(
  runs: Run[],
  timeline: Moment[],
  store: Store,
  player: Player,
): HTMLElement {
  const play = button(icon("play"), "Play (space)", () => player.toggle(), {
    id: "play",
    class: "primary",
  });
  const slider = element("input", {
    type: "range",
    id: "slider",
    min: 0,
    max: timeline.length - 1,
    step: 1,
    "aria-label": "Frame; 0 is rest",
    oninput: () => player.goTo(Number(slider.value)),
  });
  const text = element("output", { for: "slider", id: "moment" });
  const speed = select(
    "Frames per second",
    ["5", "10", "15", "30"].map((n) => [n, `${n} / s`] as [string, string]),
    (value) => store.set({ framesPerSecond: Number(value) }),
  );
  store.subscribe((state, changed) => {
    // Only then: a press whose icon is replaced before its release is no click.
    if (changed.has("playing")) {
      play.replaceChildren(icon(state.playing ? "pause" : "play"));
      const title = state.playing ? "Pause (space)" : "Play (space)";
      play.title = title;
      play.setAttribute("aria-label", title);
    }
    slider.value = String(state.moment);
    speed.value = String(state.framesPerSecond);
    text.textContent = momentText(timeline, state.moment);
    slider.setAttribute("aria-valuetext", text.textContent);
  });
  play.disabled = timeline.length < 3;
  return element(
    "div",
    { class: "transport", role: "group", "aria-label": "Frames" },
    element(
      "div",
      { class: "buttons" },
      button(icon("first"), "Rest (Home)", () => player.goTo(0)),
      button(icon("back"), "Frame before (left arrow)", () => player.step(-1)),
      play,
      button(
        icon("forward"),
        "Next frame (right arrow)",
        () => player.step(1),
        {
          id: "next",
        },
      ),
      button(icon("last"), "Last frame (End)", () =>
        player.goTo(timeline.length - 1),
      ),
      labelled("Speed", speed),
      text,
    ),
    slider,
    ...runs.map((run, i) => certificateStrip(run, i, timeline, store, player)),
    certificateLegend(runs),
  );
}
