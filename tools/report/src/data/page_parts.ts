// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What the data of all pages have in common, as
// src/musclewarp/page/page_parts.cc hands it over.

import { sayProgress } from "../progress";
import { NumbersRef, PackedNumbers, inflated } from "./numbers";

export type Vector = [number, number, number];

export interface View {
  toward_viewer: Vector;
  up: Vector;
}

export interface BoneShapeJson {
  name: string;
  vertices: number;
  triangles: NumbersRef;
  points: NumbersRef;
  triangles_in_files: number;
  view_error_mm: number;
}

export interface BoneShape {
  name: string;
  triangles: Uint32Array;
  points: Float32Array; // at rest
  trianglesInFiles: number;
  viewError: number;
}

export function boneShapeFrom(
  json: BoneShapeJson,
  step: number,
  packed: PackedNumbers,
): BoneShape {
  return {
    name: json.name,
    triangles: new Uint32Array(packed.at(json.triangles)),
    points: Float32Array.from(packed.at(json.points)).map((n) => n * step),
    trianglesInFiles: json.triangles_in_files,
    viewError: json.view_error_mm,
  };
}

function textOf(id: string): string {
  const text = document.getElementById(id)?.textContent;
  if (!text) throw new Error("The page holds no data: was it cut short?");
  return text;
}

// The JSON of the page, and the numbers that it refers to.
export async function readParts<Json>(
  id: string,
): Promise<{ json: Json; packed: PackedNumbers }> {
  const json = (await inflated(textOf(id)).json()) as Json;
  await sayProgress("unpacking positions");
  const packed = await PackedNumbers.fromBase64(textOf("numbers"));
  return { json, packed };
}
