// Measured curves beside the simulated ones. They stay as long as the window of the browser, also after a reload.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import type { Measured } from "../api/types";
import { note } from "../state/program";

export interface MeasuredSet extends Measured {
  id: string;
  name: string; // of the file
  gaugeLength: number; // mm, of the specimens
  width: number;
  showsSpecimens: boolean;
}

const kStored = "knitmech.measured";
const kLargestStored = 2_000_000; // characters; browsers keep about five million

function readStored(): MeasuredSet[] {
  try {
    return JSON.parse(sessionStorage.getItem(kStored) ?? "[]") as MeasuredSet[];
  } catch {
    return [];
  }
}

export const measuredSets = signal<readonly MeasuredSet[]>(readStored());

function store(sets: readonly MeasuredSet[]): void {
  measuredSets.value = sets;
  const text = JSON.stringify(sets);
  if (text.length <= kLargestStored) {
    sessionStorage.setItem(kStored, text);
    return;
  }
  sessionStorage.removeItem(kStored);
  note("The measured curves are too many to be kept when the page is reloaded.");
}

export interface Specimens {
  gaugeLength: string; // as typed, with unit
  width: string;
}

const kMillimetres: Record<string, number> = { um: 1e-3, mm: 1, cm: 10, m: 1000 };

/** "5 cm" -> 50; the program has read the text already and refused what is no length. */
function millimetres(typed: string): number {
  const [, number = "", unit = ""] = /^\s*([^a-zA-Z]*?)\s*([a-zA-Z]+)\s*$/.exec(typed) ?? [];
  return Number(number) * (kMillimetres[unit] ?? NaN);
}

/** Throws Refused where the program cannot read the file. */
export async function addMeasured(file: File, specimens: Specimens): Promise<void> {
  const text = await file.text();
  const found = await client.measured({ name: file.name, text, gauge_length: specimens.gaugeLength, width: specimens.width });
  const set: MeasuredSet = {
    ...found,
    id: `measured-${Date.now()}-${measuredSets.value.length}`,
    name: file.name,
    gaugeLength: millimetres(specimens.gaugeLength),
    width: millimetres(specimens.width),
    showsSpecimens: false,
  };
  store([...measuredSets.value, set]);
}

export function removeMeasured(id: string): void {
  store(measuredSets.value.filter((set) => set.id !== id));
}

export function toggleSpecimens(id: string): void {
  store(measuredSets.value.map((set) => (set.id === id ? { ...set, showsSpecimens: !set.showsSpecimens } : set)));
}
