// A blob is what the program sends where there are many numbers: a head in JSON and arrays of numbers.
// Bytes: u32 length of the head, the head (padded with spaces), then the arrays; the head's `arrays` tells by name where
// each begins, counted from the end of the head, and how many numbers it has. All little-endian, all on multiples of 8.

interface ArrayPlace {
  type: "f32" | "i32";
  offset: number;
  length: number;
}

export interface Blob<Head> {
  head: Head;
  floats(name: string): Float32Array;
  integers(name: string): Int32Array;
}

export function readBlob<Head>(bytes: ArrayBuffer): Blob<Head> {
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as Head & {
    arrays: Record<string, ArrayPlace>;
  };
  const start = 4 + length;
  const placeOf = (name: string, type: ArrayPlace["type"]): ArrayPlace => {
    const place = head.arrays[name];
    if (place === undefined || place.type !== type) throw new Error(`the blob has no ${type} array ${name}`);
    return place;
  };
  return {
    head,
    floats: (name) => {
      const place = placeOf(name, "f32");
      return new Float32Array(bytes, start + place.offset, place.length);
    },
    integers: (name) => {
      const place = placeOf(name, "i32");
      return new Int32Array(bytes, start + place.offset, place.length);
    },
  };
}
