// Force-strain curves in the shape that uPlot draws: one row of strains for all, in percent.

import uPlot from "uplot";

/** A force-strain curve. */
export interface Curve {
  id: string;
  name: string;
  strain: readonly number[]; // as a share, 0.1 for 10 %
  force: readonly number[]; // in the unit of the chart
  band?: { lowest: readonly number[]; highest: readonly number[] } | undefined; // drawn as an area around the curve
  colour?: number | undefined; // of the palette, from 0; left out: by its place among the curves
  dashed?: boolean | undefined; // a measured one
  thin?: boolean | undefined; // one of many: pale and not in the legend
}

export const kPaletteSize = 9;
export const kRunColours = 6; // the first ones; those after them are of measured curves

/** The rows that can be drawn: numbers, with a strain that rises. */
function risingRows(curve: Curve): number[] {
  const rows: number[] = [];
  let last = -Infinity;
  curve.strain.forEach((strain, i) => {
    if (!(strain > last) || !Number.isFinite(curve.force[i])) return;
    rows.push(i);
    last = strain;
  });
  return rows;
}

/** Curves one after the other; one with a band has its highest and lowest values after its own. */
export function alignedData(curves: readonly Curve[]): uPlot.AlignedData {
  if (curves.length === 0) return [[], []];
  const tables = curves.map((curve): uPlot.AlignedData => {
    const rows = risingRows(curve);
    const columns = [curve.force, ...(curve.band === undefined ? [] : [curve.band.highest, curve.band.lowest])];
    return [rows.map((i) => 100 * curve.strain[i]!), ...columns.map((column) => rows.map((i) => column[i]!))];
  });
  return uPlot.join(tables);
}

/** Force of a curve at a strain, on the line between the rows beside it; null outside. */
export function forceAt(curve: Curve, strain: number): number | null {
  const rows = curve.strain;
  let low = 0;
  let high = rows.length - 1;
  if (high < 0 || strain < rows[low]! - 1e-9 || strain > rows[high]! + 1e-9) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rows[middle]! <= strain) low = middle;
    else high = middle;
  }
  const width = rows[high]! - rows[low]!;
  const share = width > 0 ? Math.min(1, Math.max(0, (strain - rows[low]!) / width)) : 0;
  const force = curve.force[low]! + share * (curve.force[high]! - curve.force[low]!);
  return Number.isFinite(force) ? force : null;
}

/** A number with three figures, without an exponent as long as it is legible. */
export function figures(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return (size < 1e-4 || size >= 1e6 ? value.toExponential(2) : value.toPrecision(size >= 1000 ? 4 : 3)).replaceAll("-", "−");
}

/** The same without zeros at its end: for round numbers, on a scale. */
export function roundFigures(value: number): string {
  const text = figures(value);
  return text.includes(".") && !text.includes("e") ? text.replace(/\.?0+$/, "") : text;
}
