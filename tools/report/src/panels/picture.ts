// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The view as a picture, with what is written over it and the legend.

import { Run } from "../data/run";
import { button, download, element, svg } from "../dom";
import { Store } from "../state";
import { vertexScale } from "../viewer/coloring";
import { Viewer } from "../viewer/viewer";
import { legendBar, legendTitle } from "./legend";

const pixelRatio = 2; // to a CSS pixel
const margin = 12;
const ink = "#1d2125";

function legendInPicture(runs: Run[], store: Store): SVGElement[] {
  const scale = vertexScale(store.state.coloring, runs);
  if (!scale) return [];
  const bar = legendBar(scale);
  bar.setAttribute("x", String(margin));
  bar.setAttribute("y", String(margin + 20));
  const title = svg(
    "text",
    { x: margin, y: margin + 12, "font-size": 13, fill: "currentColor" },
    legendTitle(scale),
  );
  return [title, bar];
}

// What is written, as an SVG of its own: pages' variables do not reach there.
function writing(
  overlay: SVGSVGElement,
  legend: SVGElement[],
  width: number,
  height: number,
): string {
  const copy = overlay.cloneNode(true) as SVGSVGElement;
  copy.append(...legend);
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
  copy.setAttribute("font-family", "sans-serif");
  copy.style.color = ink;
  return new XMLSerializer()
    .serializeToString(copy)
    .replaceAll("var(--stage)", "#ffffff");
}

async function imageOf(svgText: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText)}`;
  await image.decode();
  return image;
}

// As a PNG; without a background it is transparent.
async function pictureOf(
  viewer: Viewer,
  overlay: SVGSVGElement,
  legend: SVGElement[],
  background: string | null,
): Promise<Blob> {
  const { clientWidth: width, clientHeight: height } = overlay;
  const canvas = element("canvas", {
    width: pixelRatio * width,
    height: pixelRatio * height,
  });
  const context = canvas.getContext("2d")!;
  if (background) {
    context.fillStyle = background;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }
  viewer.takePicture(pixelRatio, (drawn) =>
    context.drawImage(drawn, 0, 0, canvas.width, canvas.height),
  );
  const text = writing(overlay, legend, width, height);
  context.drawImage(await imageOf(text), 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) =>
      blob ? resolve(blob) : reject(new Error("no picture")),
    ),
  );
}

// Buttons that save what is seen. `nameOf` names the file, without ending.
export function pictureButtons(
  runs: Run[],
  store: Store,
  viewer: () => Viewer | null,
  overlay: () => SVGSVGElement | null,
  nameOf: () => string,
): HTMLElement[] {
  const save = async (background: string | null) => {
    const [view, written] = [viewer(), overlay()];
    if (!view || !written) return;
    store.set({ playing: false });
    const legend = legendInPicture(runs, store);
    const picture = await pictureOf(view, written, legend, background);
    download(`${nameOf()}.png`, picture);
  };
  return [
    button("PNG", "Save the view as a picture, on white", () => save("#fff")),
    button("PNG, transparent", "Save the view as a picture, transparent", () =>
      save(null),
    ),
  ];
}
