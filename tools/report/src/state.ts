// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the visitor has chosen. Every part of a page reads it and is told of
// changes; nothing else is shared between them.

export interface MeshLook {
  opacity: Record<string, number>; // by mesh; 1 if not there
  hidden: Record<string, boolean>;
}

export type Coloring =
  "name" | "displacement" | "stretch" | "gap" | "contact" | "attachment";
export type SectionAxis = "off" | "anterior" | "lateral" | "superior";

// On the page of a run.
export interface State extends MeshLook {
  moment: number; // on the timeline
  playing: boolean;
  framesPerSecond: number;
  coloring: Coloring;
  lines: boolean;
  fibres: boolean;
  crossings: boolean;
  section: SectionAxis;
  sectionPlace: number; // along the axis, mm
  sectionFlipped: boolean;
  measuring: boolean; // clicks set the ends of the ruler
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
  sectionPlace: 0,
  sectionFlipped: false,
  measuring: false,
};

type Listener<S> = (state: S, changed: Set<keyof S>) => void;

export class Store<S extends object = State> {
  private listeners: Listener<S>[] = [];

  constructor(public state: S) {}

  // Calls the listener now, and after every change.
  subscribe(listener: Listener<S>): void {
    this.listeners.push(listener);
    listener(this.state, new Set(Object.keys(this.state) as (keyof S)[]));
  }

  set(change: Partial<S>): void {
    const keys = Object.keys(change) as (keyof S)[];
    const changed = new Set(
      keys.filter((key) => this.state[key] !== change[key]),
    );
    if (changed.size === 0) return;
    this.state = { ...this.state, ...change };
    for (const listener of this.listeners) listener(this.state, changed);
  }
}

// A store of any page, as far as it tells how meshes look.
export interface MeshLookStore {
  readonly state: MeshLook;
  subscribe(listener: (state: MeshLook) => void): void;
  set(change: Partial<MeshLook>): void;
}
