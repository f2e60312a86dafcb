// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the visitor has chosen. Every part of the page reads it and is told of
// changes; nothing else is shared between them.

export type Coloring =
  "name" | "displacement" | "stretch" | "gap" | "contact" | "attachment";
export type SectionAxis = "off" | "anterior" | "lateral" | "superior";

export interface State {
  moment: number; // on the timeline
  playing: boolean;
  framesPerSecond: number;
  coloring: Coloring;
  opacity: Record<string, number>; // by mesh; 1 if not there
  hidden: Record<string, boolean>;
  lines: boolean;
  fibres: boolean;
  crossings: boolean;
  section: SectionAxis;
  sectionPlace: number; // 0 to 1 along the axis
  sectionFlipped: boolean;
}

export const initialState: State = {
  moment: 0,
  playing: false,
  framesPerSecond: 15,
  coloring: "name",
  opacity: {},
  hidden: {},
  lines: true,
  fibres: false,
  crossings: true,
  section: "off",
  sectionPlace: 0.5,
  sectionFlipped: false,
};

type Listener = (state: State, changed: Set<keyof State>) => void;

export class Store {
  private listeners: Listener[] = [];

  constructor(public state: State) {}

  // Calls the listener now, and after every change.
  subscribe(listener: Listener): void {
    this.listeners.push(listener);
    listener(this.state, new Set(Object.keys(this.state) as (keyof State)[]));
  }

  set(change: Partial<State>): void {
    const keys = Object.keys(change) as (keyof State)[];
    const changed = new Set(
      keys.filter((key) => this.state[key] !== change[key]),
    );
    if (changed.size === 0) return;
    this.state = { ...this.state, ...change };
    for (const listener of this.listeners) listener(this.state, changed);
  }
}
