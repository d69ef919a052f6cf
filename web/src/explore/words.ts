// How places and numbers are told.

import { figures } from "../parts/curve_data";
import type { OpenRun } from "./open_run";
import { yarnOf, type YarnPlace } from "./selection";

export const percent = (strain: number): string => `${(100 * strain).toFixed(2)} %`;
export const withUnit = (value: number, unit: string): string => `${figures(value)} ${unit}`.trim();
export const mm = (value: number): string => withUnit(value, "mm");

/** "course 3, wale 2", counted from 1, as the program's messages tell it. */
export function placeWords(run: OpenRun, element: number): string {
  const next = element + 1;
  // Of the two nodes, the one on the turning arc, or else the one that no other stitch shares.
  const isOnStitch = run.wale[element]! >= 0;
  const tellsNext = isOnStitch && (run.wale[next]! < 0 || run.wale[next]! > run.wale[element]!);
  const node = tellsNext ? next : element;
  const course = run.course[node]! + 1;
  if (run.wale[node]! < 0) return `turning arc of courses ${course} and ${course + 1}`;
  return `course ${course}, wale ${run.wale[node]! + 1}`;
}

/** Length along the stress-free yarn from its first node [mm]. */
export function alongYarn(run: OpenRun, at: YarnPlace): number {
  const first = run.fabric.yarns[yarnOf(run, at.element)]!.first_node;
  const a = run.arcLength[at.element]!;
  return a + at.share * (run.arcLength[at.element + 1]! - a) - run.arcLength[first]!;
}
