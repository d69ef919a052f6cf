// What is known of a run beyond its head: quality, stages, stored frames. It is read anew when the run has come further.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import type { RunDetail, RunHead } from "../api/types";
import { isLinked, runs } from "./runs";
import { Paced, withEntry } from "./paced";

const kPause = 500; // ms between two requests for a run
/** After so long the detail of an active run is read again [ms]; the program makes live views of a run only as long as
 *  someone asks for it. */
const kFresh = 2000;

export const details = signal<ReadonlyMap<string, RunDetail>>(new Map());
export const detailTroubles = signal<ReadonlyMap<string, string>>(new Map());

const readAt = new Map<string, number>(); // ms

const following = new Paced(
  kPause,
  async (id) => {
    readAt.set(id, Date.now());
    const detail = await client.run(id);
    if (!runs.value.has(id)) return;
    details.value = withEntry(details.value, id, detail);
    if (detailTroubles.value.has(id)) detailTroubles.value = withEntry(detailTroubles.value, id, undefined);
  },
  (id, error) => {
    if (isLinked.value && runs.value.has(id)) detailTroubles.value = withEntry(detailTroubles.value, id, error instanceof Error ? error.message : String(error));
  },
);

function isOld(run: RunHead): boolean {
  const detail = details.value.get(run.id);
  if (detail === undefined) return true;
  if (detail.status !== run.status || detail.frames !== run.frames || detail.modified !== run.modified) return true;
  return run.status === "running" && Date.now() - (readAt.get(run.id) ?? 0) > kFresh;
}

/** Reads the details of these runs where they are old. To be called from time to time as well as after events. */
export function followDetails(watched: readonly RunHead[]): void {
  for (const run of watched) if (isOld(run)) following.ask(run.id);
}

/** Something was done that the head of the run does not tell, such as its report written anew. */
export const readDetail = (id: string): void => following.ask(id);

export function forgetDetails(isThere: (id: string) => boolean): void {
  const left = [...details.value].filter(([id]) => isThere(id));
  if (left.length < details.value.size) details.value = new Map(left);
}
