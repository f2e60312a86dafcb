// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Elements. Texts are set as text, never parsed as HTML.

type Attributes = Record<string, string | number | boolean | EventListener>;
type Child = Node | string;

// Attributes that are functions are listeners ("onclick"), true stands without
// value, false is left out.
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      made.addEventListener(name.slice(2), value);
    } else if (value !== false) {
      made.setAttribute(name, value === true ? "" : String(value));
    }
  }
  made.append(...children);
  return made;
}

// Drawn, since fonts lack some of them: paths in a square of 16 x 16.
const icons = {
  first: "M3 3h2v10H3zM13 3v10L6 8z",
  back: "M11 3v10L4 8z",
  play: "M4 2v12l9-6z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  forward: "M5 3v10l7-5z",
  last: "M11 3h2v10h-2zM3 3v10l7-5z",
  theme: "M8 2a6 6 0 1 0 0 12zM8 2a6 6 0 0 1 0 12v-1a5 5 0 0 0 0-10z",
};

const svgSpace = "http://www.w3.org/2000/svg";

// As element, for drawings.
export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number> = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS(svgSpace, tag);
  for (const [name, value] of Object.entries(attributes)) {
    made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}

export function icon(name: keyof typeof icons): SVGSVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 16 16", class: "icon", "aria-hidden": "true" },
    svg("path", { d: icons[name] }),
  );
}

// A button with an accessible name and a tooltip that tells its key.
export function button(
  label: Child,
  title: string,
  onclick: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  return element(
    "button",
    { type: "button", title, "aria-label": title, onclick, ...attributes },
    label,
  );
}

export function labelled(text: string, control: HTMLElement): HTMLLabelElement {
  return element("label", {}, element("span", {}, text), control);
}

export function select<Value extends string>(
  label: string,
  options: [Value, string][],
  onchange: (value: Value) => void,
): HTMLSelectElement {
  const made = element(
    "select",
    { "aria-label": label },
    ...options.map(([value, text]) => element("option", { value }, text)),
  );
  made.addEventListener("change", () => onchange(made.value as Value));
  return made;
}

export function section(
  title: string,
  id: string,
  ...children: Child[]
): HTMLElement {
  return element(
    "section",
    { id, "aria-labelledby": `${id}-title` },
    element("h2", { id: `${id}-title` }, title),
    ...children,
  );
}

export function download(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = element("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
