// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The joints: how far to trust them, what was measured, and their sliders.

import { element } from "../dom";
import { readable } from "../palette";
import { Store } from "../state";
import { turnColors } from "./colors";
import { Coordinate, Joint, JointsFile, Shape } from "./data";
import { withFollowers } from "./kinematics";
import { JointsState, rangeOf } from "./state";

// "good", "weak", "failed", or "given" by the user.
export function qualityOf(joint: Joint): string {
  return joint.given && joint.quality !== "failed" ? "given" : joint.quality;
}

function shapeRow(shape: Shape): HTMLElement {
  const cells = [
    shape.radius_mm > 0 ? `${shape.radius_mm.toFixed(1)} mm` : "",
    shape.spread_mm > 0 ? `${shape.spread_mm.toFixed(2)} mm` : "",
    shape.coverage !== undefined
      ? `${(100 * shape.coverage).toFixed(0)} %`
      : shape.angle_deg
        ? `${shape.angle_deg.toFixed(0)}°`
        : "",
  ];
  return element(
    "tr",
    {},
    element("th", { scope: "row" }, shape.what),
    ...cells.map((cell) => element("td", {}, cell)),
  );
}

function shapeTable(shapes: Shape[]): HTMLElement {
  const titles = ["shape", "radius", "spread", "covered"];
  return element(
    "table",
    { class: "measured" },
    element(
      "thead",
      {},
      element(
        "tr",
        {},
        ...titles.map((title) => element("th", { scope: "col" }, title)),
      ),
    ),
    element("tbody", {}, ...shapes.map(shapeRow)),
  );
}

function degrees(value: number): string {
  const text = value.toFixed(1);
  return `${text === "-0.0" ? "0.0" : text.replace("-", "−")}°`;
}

function slider(
  coordinate: Coordinate,
  color: string,
  file: JointsFile,
  store: Store<JointsState>,
): HTMLElement {
  const { name, scan_deg, follows } = coordinate;
  const [lowest, highest] = rangeOf(coordinate);
  const input = element("input", {
    type: "range",
    id: `coordinate-${name}`,
    min: lowest,
    max: highest,
    step: "any",
    "aria-label": `${readable(name)}, degrees`,
    disabled: follows !== undefined,
    title: follows
      ? `follows ${readable(follows.coordinate)}`
      : `${degrees(lowest)} to ${degrees(highest)}, ${degrees(scan_deg)} in the scan`,
    oninput: () =>
      store.set({
        values: withFollowers(file, {
          ...store.state.values,
          [name]: Number(input.value),
        }),
      }),
  });
  const shown = element("output", { for: input.id });
  const swatch = element("i", { class: "swatch" });
  swatch.style.background = color;
  store.subscribe(({ values }, changed) => {
    if (!changed.has("values")) return;
    input.value = String(values[name]);
    shown.textContent = degrees(values[name]);
    input.setAttribute("aria-valuetext", `${values[name].toFixed(1)} degrees`);
  });
  return element(
    "div",
    { class: "coordinate" },
    element("label", { for: input.id }, swatch, readable(name)),
    input,
    shown,
  );
}

function item(
  joint: Joint,
  file: JointsFile,
  store: Store<JointsState>,
): HTMLElement {
  const quality = qualityOf(joint);
  const select = element(
    "button",
    {
      type: "button",
      class: "joint-name",
      title: "Show this joint",
      onclick: () => {
        const isSelected = store.state.selected === joint.name;
        store.set({ selected: isSelected ? null : joint.name });
      },
    },
    element("span", {}, readable(joint.name)),
    element("span", { class: "quality", "data-quality": quality }, quality),
  );
  const made = element(
    "li",
    { class: "joint", "data-joint": joint.name },
    select,
    element(
      "p",
      { class: "note" },
      `${readable(joint.parent)} – ${readable(joint.child)}`,
    ),
  );
  if (joint.reasons.length > 0) {
    const reasons = joint.reasons.map((text) => element("li", {}, text));
    made.append(element("ul", { class: "reasons" }, ...reasons));
  }
  if (joint.shapes.length > 0) made.append(shapeTable(joint.shapes));
  (joint.coordinates ?? []).forEach((coordinate, i) =>
    made.append(
      slider(coordinate, turnColors[i % turnColors.length], file, store),
    ),
  );
  store.subscribe(({ selected }) => {
    const isSelected = selected === joint.name;
    select.setAttribute("aria-pressed", String(isSelected));
    const isNew = isSelected && !made.classList.contains("selected");
    made.classList.toggle("selected", isSelected);
    if (isNew) made.scrollIntoView({ block: "nearest" });
  });
  return made;
}

export function jointList(
  file: JointsFile,
  store: Store<JointsState>,
): HTMLElement {
  return element(
    "ul",
    { class: "joints" },
    ...file.joints.map((joint) => item(joint, file, store)),
  );
}
