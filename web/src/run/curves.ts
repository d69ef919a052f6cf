// The curves of the chart: those of the shown runs, and measured ones.

import { computed } from "@preact/signals";
import { kPaletteSize, kRunColours, type Curve } from "../parts/curve_data";
import { histories } from "./histories";
import { measuredSets, type MeasuredSet } from "./measured";
import { colours, setWords, shown, wordOf } from "./shown";

export type ForceUnit = "N" | "N/mm";

export const unit = computed<ForceUnit>(() => (wordOf("force") === "per-width" ? "N/mm" : "N"));
export const setUnit = (now: ForceUnit): void => setWords({ force: now === "N/mm" ? "per-width" : "" });

/** Width of a run's fabric at the start [mm]. */
export function widthAtStart(id: string): number | null {
  return histories.value.get(id)?.columns["width_mm"]?.[0] ?? null;
}

const runCurves = computed<readonly Curve[]>(() =>
  shown.value.flatMap(({ id }): Curve[] => {
    const table = histories.value.get(id);
    const width = widthAtStart(id);
    if (table === undefined || width === null) return [];
    const force = unit.value === "N" ? table.force : table.force.map((newtons) => newtons / width);
    return [{ id, name: id, strain: table.columns["strain"] ?? [], force, colour: colours.value.get(id) }];
  }),
);

export const measuredColour = (place: number): number => kRunColours + (place % (kPaletteSize - kRunColours));

function curvesOf(set: MeasuredSet, place: number): Curve[] {
  const factor = unit.value === "N" ? set.width : 1;
  const inUnit = (values: readonly number[]): number[] => values.map((value) => value * factor);
  const colour = measuredColour(place);
  const { strain, mean, lowest, highest } = set.mean;
  const band = set.specimens.length > 1 ? { lowest: inUnit(lowest), highest: inUnit(highest) } : undefined;
  const specimens = set.specimens.map((specimen, i): Curve => {
    return { id: `${set.id} ${i}`, name: specimen.name, strain: specimen.strain, force: inUnit(specimen.force_per_width), colour, thin: true };
  });
  return [{ id: set.id, name: set.name, strain, force: inUnit(mean), band, colour, dashed: true }, ...(set.showsSpecimens ? specimens : [])];
}

const measuredCurves = computed(() => measuredSets.value.flatMap(curvesOf));

export const curves = computed<readonly Curve[]>(() => [...measuredCurves.value, ...runCurves.value]);

/** Whether a force alone is no fair comparison: the specimens are not as wide as a simulated fabric. */
export const widthsDiffer = computed(() =>
  measuredSets.value.some((set) => shown.value.some(({ id }) => Math.abs((widthAtStart(id) ?? set.width) - set.width) > 0.01 * set.width)),
);
