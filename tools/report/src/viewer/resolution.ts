// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// How finely pictures are drawn. Without a graphics card they are coarse while
// something moves, and as fine as antialiasing once it stands still.

const stillAfterMs = 250;
const slowPictureMs = 40;
const coarsest = 0.5;
const finest = 2;

function drawsInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  if (!gl || !info) return false;
  const name = String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Resolution {
  readonly isSoftware = drawsInSoftware();
  private moving = 1; // to a CSS pixel, while something moves
  private last = 0;
  private timer = 0;
  private isStill = false;
  // The last picture is as fine as it will be.
  isFinal = false;

  constructor(private readonly request: () => void) {}

  // Pixels to a CSS pixel for the picture that is drawn now.
  next(now: number, isPlaying: boolean): number {
    this.isFinal = !this.isSoftware || this.isStill;
    if (!this.isSoftware) return Math.min(devicePixelRatio, finest);
    if (this.isStill) {
      this.isStill = false;
      return finest;
    }
    const elapsed = now - this.last;
    this.last = now;
    // Long pauses are no sign of slow pictures.
    if (isPlaying && elapsed > slowPictureMs && elapsed < 1000) {
      this.moving = Math.max(coarsest, 0.85 * this.moving);
    }
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.isStill = true;
      this.request();
    }, stillAfterMs);
    return this.moving;
  }
}
