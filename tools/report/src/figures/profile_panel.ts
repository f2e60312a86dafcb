// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The area of sections along each muscle, in the frame shown and at rest.

import * as Plot from "@observablehq/plot";

import { Muscle, Run } from "../data/run";
import { Moment } from "../data/timeline";
import { button, element } from "../dom";
import { MeshColors } from "../mesh_colors";
import { readable } from "../palette";
import { Store } from "../state";
import { csvText, downloadFigure, svgFileText } from "./downloads";
import { SectionProfile, sectionProfile } from "./section_profile";

const title = "Area of sections along the muscle";
const note =
  "by planes at right angles to the mean of its lines; dotted: at rest";
const id = "section-areas";
const pauseMs = 150; // frames that pass are not drawn

interface Curve {
  run: number;
  muscle: string;
  pose: number;
  profile: SectionProfile;
}

export class ProfilePanel {
  readonly root: HTMLElement;
  private readonly place = element("div", { class: "plot" });
  private readonly atRest = new Map<Muscle, SectionProfile | null>();
  private curves: Curve[] = [];
  private timer = 0;

  constructor(
    private readonly runs: Run[],
    private readonly timeline: Moment[],
    private readonly colors: MeshColors,
    private readonly store: Store,
    private readonly isShown: (muscle: string) => boolean,
  ) {
    this.root = element(
      "article",
      { class: "figure", id: `figure-${id}`, "aria-label": title },
      element(
        "header",
        {},
        element("h4", {}, title),
        button("SVG", `Download "${title}" as SVG`, () => {
          const svg = this.place.querySelector("svg")!;
          downloadFigure(id, "svg", svgFileText(svg, title));
        }),
        button("CSV", `Download "${title}" as CSV`, () =>
          downloadFigure(id, "csv", this.csv()),
        ),
      ),
      this.place,
      element("p", { class: "note" }, note),
    );
    store.subscribe((state, changed) => {
      if (!changed.has("moment") && !changed.has("playing")) return;
      clearTimeout(this.timer);
      if (state.playing || this.curves.length === 0) return;
      this.timer = window.setTimeout(() => this.draw(), pauseMs);
    });
  }

  mark(): void {}

  draw(): void {
    this.measure();
    const points = this.curves.flatMap(({ run, muscle, pose, profile }) =>
      profile.along.map((x, i) => ({
        x,
        y: profile.areas[i],
        key: `${run} ${muscle} ${pose}`,
        color: this.colors.get(muscle)!,
        isAtRest: pose === 0,
        text: `${readable(muscle)}${pose === 0 ? " at rest" : ""}\n${x.toFixed(0)} mm: ${profile.areas[i].toFixed(0)} mm²`,
      })),
    );
    const line = (isAtRest: boolean) =>
      Plot.line(
        points.filter((point) => point.isAtRest === isAtRest),
        {
          x: "x",
          y: "y",
          z: "key",
          stroke: "color",
          strokeWidth: isAtRest ? 1 : 1.6,
          strokeDasharray: isAtRest ? "1 3" : undefined,
        },
      );
    const plot = Plot.plot({
      width: Math.max(260, this.place.clientWidth),
      height: 220,
      marginLeft: 62,
      marginBottom: 36,
      style: { background: "transparent", color: "inherit", fontSize: "12px" },
      ariaLabel: title,
      ariaDescription: note,
      x: { label: "along the muscle, mm", ticks: 6 },
      y: { label: "mm²", grid: true, nice: true, ticks: 5 },
      color: { type: "identity" },
      marks: [
        line(true),
        line(false),
        Plot.tip(
          points,
          Plot.pointer({
            x: "x",
            y: "y",
            title: "text",
            fill: "var(--surface)",
            stroke: "var(--line)",
            pointerSize: 0,
          }),
        ),
      ],
    });
    this.place.replaceChildren(plot);
  }

  private measure(): void {
    const { poses } = this.timeline[this.store.state.moment];
    this.curves = this.runs.flatMap((run, i) =>
      run.muscles
        .filter(({ name }) => this.isShown(name))
        .flatMap((muscle) => {
          const shown = [...new Set([0, poses[i] ?? 0])];
          return shown.flatMap((pose) => {
            const profile = this.profileOf(muscle, pose);
            return profile
              ? [{ run: i, muscle: muscle.name, pose, profile }]
              : [];
          });
        }),
    );
  }

  private profileOf(muscle: Muscle, pose: number): SectionProfile | null {
    if (pose > 0) return sectionProfile(muscle, pose);
    if (!this.atRest.has(muscle)) {
      this.atRest.set(muscle, sectionProfile(muscle, 0));
    }
    return this.atRest.get(muscle)!;
  }

  private csv(): string {
    const rows = this.curves.flatMap(({ run, muscle, pose, profile }) =>
      profile.along.map((mm, i) => [
        this.runs[run].folder,
        pose === 0 ? "rest" : this.runs[run].frames[pose - 1].name,
        muscle,
        mm,
        profile.areas[i],
      ]),
    );
    return csvText([
      ["run", "name", "muscle", "along_mm", "area_mm2"],
      ...rows,
    ]);
  }
}
