// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The numbers of the page: packed by src/musclewarp/page/packed_numbers.cc,
// which says how.

export interface NumbersRef {
  at: number;
  count: number;
  stride: number;
}

// Of bytes as DeflatedBase64() of the same file writes them.
export function inflated(base64: string): Response {
  const text = atob(base64);
  const deflated = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) deflated[i] = text.charCodeAt(i);
  const stream = new Blob([deflated])
    .stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream);
}

export class PackedNumbers {
  private constructor(private readonly bytes: Uint8Array) {}

  static async fromBase64(base64: string): Promise<PackedNumbers> {
    return new PackedNumbers(
      new Uint8Array(await inflated(base64).arrayBuffer()),
    );
  }

  at(ref: NumbersRef): Int32Array {
    const numbers = new Int32Array(ref.count);
    let byte = ref.at;
    for (let i = 0; i < ref.count; ++i) {
      let code = 0;
      // Five groups of 7 bits hold 32: what the packer was given.
      for (let shift = 0; ; shift += 7) {
        const next = this.bytes[byte++];
        code |= (next & 127) << shift;
        if (next < 128) break;
      }
      const before = i < ref.stride ? 0 : numbers[i - ref.stride];
      numbers[i] = before + ((code >>> 1) ^ -(code & 1));
    }
    return numbers;
  }
}
