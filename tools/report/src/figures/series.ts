// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The figures over the motion: what is drawn in each, taken from report.json.

import { FrameFigures, MuscleFigures } from "../data/report";
import { Run } from "../data/run";
import { stageColor } from "../palette";

// One curve: a value for each frame of a run, in the order of its frames.
export interface Series {
  name: string;
  muscle: string; // whose colour and toggle it has; "" for the whole scene
  run: number;
  values: number[]; // NaN where there is none
  color?: string; // of its own
}

export interface Figure {
  group: FigureGroup;
  id: string;
  title: string;
  label: string; // of the y axis, with the unit
  note?: string;
  // The coordinate over which measured moment arms may be laid.
  measured?: string;
  series: Series[];
}

// In the order in which they are shown.
export const figureGroups = [
  "Moment arms and lengths",
  "Stretch and volume",
  "Contact",
  "Solver",
] as const;
export type FigureGroup = (typeof figureGroups)[number];

type Value = (muscle: MuscleFigures, frame: FrameFigures) => number | undefined;

// A curve for each muscle of each run.
function byMuscle(runs: Run[], value: Value): Series[] {
  return runs.flatMap((run, i) =>
    run.muscles.map(({ name }) => ({
      name,
      muscle: name,
      run: i,
      values: run.frames.map((frame) => {
        const muscle = frame.muscles.find((each) => each.name === name);
        return (muscle && value(muscle, frame)) ?? NaN;
      }),
    })),
  );
}

// A curve for each action line.
function byLine(
  runs: Run[],
  value: (
    line: string,
    muscle: MuscleFigures,
    frame: FrameFigures,
    place: { run: Run; at: number },
  ) => number | undefined,
): Series[] {
  return runs.flatMap((run, i) =>
    run.muscles.flatMap((muscle) =>
      muscle.lines.names.map((line) => ({
        name: line,
        muscle: muscle.name,
        run: i,
        values: run.frames.map((frame, at) => {
          const record = frame.muscles.find(({ name }) => name === muscle.name);
          return (record && value(line, record, frame, { run, at })) ?? NaN;
        }),
      })),
    ),
  );
}

function ofScene(
  runs: Run[],
  name: string,
  value: (frame: FrameFigures) => number,
): Series[] {
  return runs.map((run, i) => ({
    name,
    muscle: "",
    run: i,
    values: run.frames.map(value),
  }));
}

// A curve for each stage of a frame; none for runs without --profile.
function byStage(runs: Run[]): Series[] {
  const stages = runs.flatMap(({ frames }) =>
    frames.flatMap((frame) => frame.stages ?? []),
  );
  const names = [...new Set(stages.map(({ name }) => name))];
  const series = runs.flatMap((run, i) =>
    names.map((name, at) => ({
      name,
      muscle: "",
      run: i,
      color: stageColor(at),
      values: run.frames.map(
        ({ stages }) => stages?.find((stage) => stage.name === name)?.ms ?? NaN,
      ),
    })),
  );
  return series.filter(hasValues);
}

function movingCoordinates(runs: Run[]): { name: string; unit: string }[] {
  const found = new Map(
    runs
      .flatMap((run) => run.report.motion?.coordinates ?? [])
      .filter(({ moves }) => moves)
      .map((coordinate) => [coordinate.name, coordinate]),
  );
  return [...found.values()];
}

const arms: FigureGroup = "Moment arms and lengths";

const hasValues = ({ values }: Series) => values.some(Number.isFinite);

// As the lines are carried: by the program where it has them, else from the
// lengths over the frames.
function carriedMomentArms(runs: Run[]): Figure[] {
  return movingCoordinates(runs).map((coordinate) => ({
    group: arms,
    id: `carried-moment-arms-${coordinate.name}`,
    title: `Moment arms, ${coordinate.name}`,
    label: coordinate.unit === "m" ? "mm / m" : "mm",
    note: "−dl/dq of the lines as the muscles carry them",
    measured: coordinate.name,
    series: byLine(runs, (line, muscle, _, { run, at }) => {
      const { carriedMomentArms: differences } = run;
      return (
        muscle.line_moment_arms_mm?.[line]?.[coordinate.name] ??
        (differences?.coordinate === coordinate.name
          ? differences.muscles[muscle.name]?.[line]?.[at]
          : undefined)
      );
    }).filter(hasValues),
  }));
}

function pathMomentArms(runs: Run[]): Figure[] {
  return movingCoordinates(runs).map((coordinate) => ({
    group: arms,
    id: `moment-arms-${coordinate.name}`,
    title: `Moment arms of straight paths, ${coordinate.name}`,
    label: coordinate.unit === "m" ? "mm / m" : "mm",
    note: "−dl/dq of the straight paths through the path points",
    measured: coordinate.name,
    series: byLine(
      runs,
      (line, _, frame) => frame.path_moment_arms_mm[line]?.[coordinate.name],
    ).filter(hasValues),
  }));
}

// A curve for each attachment area of each muscle.
function byAttachment(runs: Run[]): Series[] {
  return runs.flatMap((run, i) =>
    (run.frames[0]?.muscles ?? []).flatMap((muscle, m) =>
      muscle.attachments.map(({ body }, area) => ({
        name: `${muscle.name} on ${body}`,
        muscle: muscle.name,
        run: i,
        values: run.frames.map(
          ({ muscles }) => muscles[m].attachments[area].max_drift_mm,
        ),
      })),
    ),
  );
}

// What poses do to the shapes of muscles.
function shapeFigures(runs: Run[]): Figure[] {
  const group = "Stretch and volume";
  const shape = (value: (muscle: MuscleFigures) => number) =>
    byMuscle(runs, value).filter(hasValues);
  return [
    {
      group,
      id: "stretch-999",
      title: "Stretch of all but a thousandth",
      label: "ratio of lengths",
      note: "99.9 % of the surface is stretched less; the largest stretch may be that of single triangles",
      series: shape((muscle) => muscle.shape.triangle_stretch.quantile_999),
    },
    {
      group,
      id: "stretch",
      title: "Largest stretch",
      label: "ratio of lengths",
      note: "of a length on the surface to that at rest; beyond 1.6 it is warned of",
      series: shape((muscle) => muscle.shape.max_stretch),
    },
    {
      group,
      id: "stretch-patch",
      title: "Largest patch stretched beyond 2",
      label: "mm²",
      note: "area at rest of connected triangles that are drawn out to more than twice a length at rest",
      series: shape(
        (muscle) => muscle.shape.triangle_stretch.largest_patch_mm2,
      ),
    },
    {
      group,
      id: "volume-ratio",
      title: "Volume error",
      label: "volume error",
      note: "of the fine mesh against its volume at rest; 0 is kept to the last digit",
      series: byMuscle(runs, (muscle) => muscle.volume_error),
    },
  ];
}

function contactFigures(runs: Run[]): Figure[] {
  const group = "Contact";
  return [
    {
      group,
      id: "crossing-pairs",
      title: "Crossing pairs",
      label: "triangle pairs",
      note: "of each muscle with all other meshes; a pair of muscles counts for both, and once in all",
      series: [
        ...byMuscle(runs, (muscle, frame) =>
          frame.intersections.pairs
            .filter(({ a, b }) => a === muscle.name || b === muscle.name)
            .reduce((sum, pair) => sum + pair.triangle_pairs, 0),
        ),
        ...ofScene(runs, "all", (frame) => frame.intersections.triangle_pairs),
      ],
    },
    {
      group,
      id: "gap",
      title: "Smallest gap",
      label: "mm",
      note: "of a vertex of the muscle to another mesh; negative inside it",
      series: byMuscle(runs, (muscle) => muscle.min_gap_mm),
    },
    {
      group,
      id: "drift",
      title: "Drift of attachments",
      label: "mm",
      note: "largest distance of an attachment area from where its body has it; beyond 2 mm it is warned of",
      series: byAttachment(runs),
    },
  ];
}

function solverFigures(runs: Run[]): Figure[] {
  const group = "Solver";
  return [
    {
      group,
      id: "change",
      title: "Change from frame to frame",
      label: "mm",
      note: "largest distance of a vertex from its place in the frame before; in the first frame of a motion from rest",
      series: byMuscle(runs, (muscle) => muscle.shape.max_change_mm).filter(
        hasValues,
      ),
    },
    {
      group,
      id: "time",
      title: "Time per frame",
      label: "ms",
      note: "moving the scene, and counting what crosses",
      series: [
        ...ofScene(runs, "moving", (frame) => frame.wall_ms),
        ...ofScene(runs, "counting", (frame) => frame.certify_ms),
      ],
    },
    {
      group,
      id: "stages",
      title: "Time by stage",
      label: "ms",
      note: "where the time of a frame goes; the stages add up",
      series: byStage(runs),
    },
  ];
}

// In the order of their groups.
export function figuresOf(runs: Run[]): Figure[] {
  const figures: Figure[] = [
    ...carriedMomentArms(runs),
    ...pathMomentArms(runs),
    {
      group: arms,
      id: "line-lengths",
      title: "Line lengths",
      label: "mm",
      note: "of the action lines as the muscles carry them",
      series: byLine(runs, (line, muscle) => muscle.line_lengths_mm[line]),
    },
    ...shapeFigures(runs),
    ...contactFigures(runs),
    ...solverFigures(runs),
  ];
  return figures.filter(({ series }) => series.length > 0);
}

// What the frames may be laid out by.
export interface Abscissa {
  id: string;
  label: string;
  value(frame: FrameFigures, at: number): number;
}

export function abscissasOf(runs: Run[]): Abscissa[] {
  const byFrame: Abscissa = {
    id: "frame",
    label: "frame",
    value: (_, at) => at + 1,
  };
  const times = runs[0].frames.map(({ time }) => time);
  const rise = times.every((time, i) => i === 0 || time > times[i - 1]);
  const byTime: Abscissa[] =
    rise && times.length > 1
      ? [{ id: "time", label: "time, s", value: ({ time }) => time }]
      : [];
  const byCoordinate = movingCoordinates(runs).map(
    ({ name, unit }): Abscissa => ({
      id: `coordinate ${name}`,
      label: unit ? `${name}, ${unit}` : name,
      value: ({ coordinates }) => coordinates[name] ?? NaN,
    }),
  );
  return [byFrame, ...byTime, ...byCoordinate];
}
