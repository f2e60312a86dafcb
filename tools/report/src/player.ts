// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Plays the frames, from the last on to the first again; rest is not one.

import { Store } from "./state";

export class Player {
  private lastStep = 0;

  constructor(
    private readonly store: Store,
    private readonly moments: number,
  ) {
    store.subscribe((state, changed) => {
      if (!changed.has("playing") || !state.playing) return;
      this.lastStep = 0;
      requestAnimationFrame((now) => this.tick(now));
    });
  }

  toggle(): void {
    this.store.set({ playing: !this.store.state.playing });
  }

  // Stops, and goes some moments on or back.
  step(by: number): void {
    this.goTo(this.store.state.moment + by);
  }

  goTo(moment: number): void {
    this.store.set({
      playing: false,
      moment: Math.min(this.moments - 1, Math.max(0, moment)),
    });
  }

  private tick(now: number): void {
    const { playing, framesPerSecond, moment } = this.store.state;
    if (!playing) return;
    const pause = 1000 / framesPerSecond;
    if (now - this.lastStep >= pause) {
      // Keeps the rate on average, but does not catch up what was missed.
      this.lastStep = Math.max(this.lastStep + pause, now - pause);
      this.store.set({ moment: moment + 1 < this.moments ? moment + 1 : 1 });
    }
    requestAnimationFrame((next) => this.tick(next));
  }
}
