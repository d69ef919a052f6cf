// By what the yarns are coloured, and from which value to which.

import { computed, effect, signal } from "@preact/signals";
import type { FieldHead } from "../api/types";
import { noteError } from "../state/program";
import type { FabricColouring } from "../view3d/types";
import { frameList, opened } from "./open_run";
import { nearest } from "./shown";

export type Range = { of: "frame" } | { of: "all" } | { of: "own"; lowest: number; highest: number };

export const colourBy = signal("course"); // "course", "plain" or the name of a field
export const range = signal<Range>({ of: "frame" });

type Ends = readonly [number, number];
/** Of each field over all stored frames; null until they have been read. */
export const allEnds = signal<ReadonlyMap<string, Ends> | null>(null);
export const framesRead = signal(0); // on the way to allEnds

export const fieldHead = computed<FieldHead | null>(
  () => nearest.value?.head.fields.find((field) => field.name === colourBy.value) ?? null,
);

/** Ends of the colour bar. */
export const ends = computed<Ends | null>(() => {
  const field = fieldHead.value;
  if (field === null) return null;
  const wanted = range.value;
  if (wanted.of === "own") return [wanted.lowest, wanted.highest];
  const all = wanted.of === "all" ? allEnds.value?.get(field.name) : undefined;
  return all ?? [field.lowest, field.highest];
});

export const colouring = computed<FabricColouring>(() => {
  const field = fieldHead.value;
  const values = field === null ? undefined : nearest.value?.fields.get(field.name);
  if (field === null || values === undefined || ends.value === null)
    return { by: colourBy.value === "plain" ? "plain" : "course" };
  const [lowest, highest] = ends.value;
  return { by: "field", values, ofElements: field.of_elements, lowest, highest };
});

function widened(known: ReadonlyMap<string, Ends>, fields: readonly FieldHead[]): Map<string, Ends> {
  const result = new Map(known);
  for (const { name, lowest, highest } of fields) {
    const before = result.get(name) ?? [lowest, highest];
    result.set(name, [Math.min(before[0], lowest), Math.max(before[1], highest)]);
  }
  return result;
}

/** Reads all stored frames for their ranges. */
async function findAllEnds(): Promise<void> {
  const run = opened.value;
  const list = frameList.value;
  framesRead.value = 0;
  let found: ReadonlyMap<string, Ends> = new Map();
  try {
    for (const { index } of list) {
      const frame = await run!.store.read(index);
      if (opened.value !== run || frameList.value !== list || range.value.of !== "all") return;
      found = widened(found, frame.head.fields);
      framesRead.value += 1;
    }
    allEnds.value = found;
  } catch (error) {
    noteError(error);
  }
}

export function keepRanges(): () => void {
  return effect(() => {
    const isWanted = range.value.of === "all" && opened.value !== null && frameList.value.length > 0;
    allEnds.value = null;
    if (isWanted) void findAllEnds();
  });
}
