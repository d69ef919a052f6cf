// The histories of the runs that are shown. Rows are only ever added: each request asks for those that are new.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import type { RunHead } from "../api/types";
import { isLinked, runs } from "../state/runs";
import { Paced, withEntry } from "../state/paced";

const kPause = 250; // ms between two requests for the rows of a run

export interface Table {
  rows: number;
  columns: Record<string, number[]>; // by the names of history.csv
  force: number[]; // N, at the pulled grip
  wasActive: boolean;
}

export const histories = signal<ReadonlyMap<string, Table>>(new Map());
export const historyTroubles = signal<ReadonlyMap<string, string>>(new Map()); // why a curve is not there

const emptyTable = (): Table => ({ rows: 0, columns: {}, force: [], wasActive: false });

function cut(table: Table, rows: number): void {
  table.rows = Math.max(0, Math.min(table.rows, rows));
  for (const column of [...Object.values(table.columns), table.force]) column.length = Math.min(column.length, table.rows);
}

/** A run that goes on from its checkpoint has lost its last rows and writes them anew. */
function dropLostRows(table: Table, run: RunHead): void {
  if (run.active && !table.wasActive) cut(table, table.rows - 1);
  cut(table, run.rows);
  table.wasActive = run.active;
}

/** What comes after a request was sent must still fit to its end. */
function append(table: Table, from: number, columns: Record<string, number[]>): void {
  if (from !== table.rows) return;
  for (const [name, values] of Object.entries(columns)) {
    const column = (table.columns[name] ??= []);
    for (const value of values) column.push(value);
  }
  const forces = columns["force_top_N"] ?? [];
  for (const force of forces) table.force.push(force);
  table.rows += forces.length;
}

function keep(id: string, table: Table): void {
  histories.value = withEntry(histories.value, id, { ...table });
}

async function bringUpToDate(id: string): Promise<void> {
  const run = runs.value.get(id);
  if (run === undefined) return;
  const table = histories.value.get(id) ?? emptyTable();
  dropLostRows(table, run);
  if (run.rows > table.rows) append(table, table.rows, (await client.history(id, table.rows)).columns);
  keep(id, table);
  if (historyTroubles.value.has(id)) historyTroubles.value = withEntry(historyTroubles.value, id, undefined);
}

const following = new Paced(kPause, bringUpToDate, (id, error) => {
  if (isLinked.value && runs.value.has(id)) historyTroubles.value = withEntry(historyTroubles.value, id, error instanceof Error ? error.message : String(error));
});

function isBehind(run: RunHead): boolean {
  const table = histories.value.get(run.id);
  return table === undefined || table.rows !== run.rows || table.wasActive !== run.active;
}

/** Reads what the histories of these runs have more than before. */
export function followHistories(shown: readonly RunHead[]): void {
  for (const run of shown) if (isBehind(run)) following.ask(run.id);
}

/** Runs that are gone; another one may come under the same name. */
export function forgetHistories(isThere: (id: string) => boolean): void {
  const left = [...histories.value].filter(([id]) => isThere(id));
  if (left.length < histories.value.size) histories.value = new Map(left);
}
