// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// A TrueType font of which every letter is the same box: with it a page has the
// same lines and widths on every machine, whatever fonts are installed there.

const unitsPerEm = 1000;
const advance = 560;
const ascent = 900;
const descent = -250;
const box = { left: 80, bottom: 0, right: 480, top: 520 };
const glyphs = { missing: 0, box: 1, space: 2 };
const spaces = [0x20, 0xa0];
// Latin, Greek, punctuation, arrows, signs of mathematics.
const letters = [
  [0x21, 0x7e],
  [0xa1, 0xff],
  [0x370, 0x3ff],
  [0x2010, 0x2044],
  [0x2190, 0x22ff],
];

function numbers(bytes, write) {
  return (...values) => {
    const buffer = Buffer.alloc(bytes * values.length);
    values.forEach((value, i) => buffer[write](value, bytes * i));
    return buffer;
  };
}
const i16 = numbers(2, "writeInt16BE");
const u16 = numbers(2, "writeUInt16BE");
const u32 = numbers(4, "writeUInt32BE");
const bytes = (...values) => Buffer.from(values);
const join = (...parts) => Buffer.concat(parts);
const zeros = (count) => Buffer.alloc(count);

const bounds = i16(box.left, box.bottom, box.right, box.top);

function head() {
  const magic = 0x5f0f3cf5;
  return join(
    u32(0x10000, 0x10000, 0, magic),
    u16(0, unitsPerEm),
    zeros(16), // dates
    bounds,
    u16(0, 8, 2, 0, 0), // short offsets in `loca`
  );
}

const hhea = () =>
  join(
    u32(0x10000),
    i16(ascent, descent, 0, advance),
    i16(box.left, advance - box.right, box.right, 1, 0, 0, 0, 0, 0, 0, 0),
    u16(3), // widths in `hmtx`
  );

const maxp = () =>
  join(u32(0x10000), u16(3, 4, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0));

// The box is glyph 1, and what is missing or a space is empty.
const hmtx = () =>
  join(...[0, box.left, 0].map((side) => join(u16(advance), i16(side))));

function glyf() {
  const onCurve = 1;
  return join(
    i16(1), // contour
    bounds,
    u16(3, 0), // its last point; no instructions
    bytes(onCurve, onCurve, onCurve, onCurve),
    i16(box.left, 0, box.right - box.left, 0), // steps to the right
    i16(box.bottom, box.top - box.bottom, 0, box.bottom - box.top), // and up
    zeros(2),
  );
}

const loca = () => u16(0, 0, glyf().length / 2, glyf().length / 2);

// Groups of one letter each: those of a longer one have glyphs of their own.
function cmap() {
  const codes = letters.flatMap(([first, last]) =>
    Array.from({ length: last - first + 1 }, (_, i) => first + i),
  );
  const glyphOf = (code) => (spaces.includes(code) ? glyphs.space : glyphs.box);
  const groups = [...spaces, ...codes]
    .sort((a, b) => a - b)
    .map((code) => u32(code, code, glyphOf(code)));
  const table = join(
    u16(12, 0),
    u32(16 + 12 * groups.length, 0, groups.length),
    ...groups,
  );
  const windowsUnicode = u16(3, 10);
  return join(u16(0, 1), windowsUnicode, u32(12), table);
}

const os2 = () =>
  join(
    u16(4, advance, 400, 5, 0),
    zeros(20), // subscripts and superscripts
    zeros(2 + 2 + 10 + 16 + 4), // strike-out, class, panose, ranges, vendor
    u16(0x40, letters[0][0], 0xffff), // regular
    i16(ascent, descent, 0),
    u16(ascent, -descent),
    zeros(8),
    i16(box.top, box.top),
    u16(0, 0x20, 1),
  );

const name = () => u16(0, 0, 6);
const post = () => join(u32(0x30000), zeros(28));

const padded = (table) => join(table, zeros(-table.length & 3));

// The file of the font. Browsers do not look at its checksums.
export function boxFont() {
  const tables = Object.entries({
    "OS/2": os2(),
    cmap: cmap(),
    glyf: glyf(),
    head: head(),
    hhea: hhea(),
    hmtx: hmtx(),
    loca: loca(),
    maxp: maxp(),
    name: name(),
    post: post(),
  });
  let offset = 12 + 16 * tables.length;
  const directory = tables.map(([tag, table]) => {
    const entry = join(Buffer.from(tag), u32(0, offset, table.length));
    offset += padded(table).length;
    return entry;
  });
  return join(
    u32(0x10000),
    u16(tables.length, 128, 3, 16 * tables.length - 128),
    ...directory,
    ...tables.map(([, table]) => padded(table)),
  );
}

// Writes the page in this font.
export async function writeInBoxes(page) {
  await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const font = new FontFace("boxes", bytes.buffer, { weight: "100 900" });
    document.fonts.add(await font.load());
  }, boxFont().toString("base64"));
  await page.addStyleTag({ content: "* { font-family: boxes !important; }" });
}
