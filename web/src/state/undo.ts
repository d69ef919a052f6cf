// The earlier and the later texts of the case that is being edited. Changes of one value in one go are one step.

import { computed, signal } from "@preact/signals";

const kSteps = 200; // that are remembered; a text is a few kB
const kPause = 1500; // ms without a change, after which the next change is a step of its own

const past = signal<readonly string[]>([]);
const future = signal<readonly string[]>([]);
let latest = ""; // what the latest change changed
let changedAt = 0; // ms

export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

/** Remembers the text before a change of `what`: the key of a value, or "text". */
export function remember(before: string, what: string): void {
  const now = Date.now();
  const goesOn = what === latest && now - changedAt < kPause && past.value.length > 0;
  if (!goesOn) past.value = [...past.value.slice(1 - kSteps), before];
  future.value = [];
  latest = what;
  changedAt = now;
}

/** The text one step back, or forth again, from the present one; null if there is none. */
export function stepBack(present: string): string | null {
  const text = past.value.at(-1);
  if (text === undefined) return null;
  past.value = past.value.slice(0, -1);
  future.value = [...future.value, present];
  latest = "";
  return text;
}

export function stepForth(present: string): string | null {
  const text = future.value.at(-1);
  if (text === undefined) return null;
  future.value = future.value.slice(0, -1);
  past.value = [...past.value, present];
  latest = "";
  return text;
}

export function forgetSteps(): void {
  past.value = [];
  future.value = [];
  latest = "";
}
