// The runs in the folder, kept up to date by the program's events.

import { computed, signal } from "@preact/signals";
import * as client from "../api/client";
import type { RunHead } from "../api/types";
import { noteError } from "./program";

export const runs = signal<ReadonlyMap<string, RunHead>>(new Map());
export const areRead = signal(false); // whether all runs are known
export const isLinked = signal(true); // whether the program can be reached

export const newestFirst = computed(() => [...runs.value.values()].sort((a, b) => b.modified - a.modified));

function put(run: RunHead): void {
  runs.value = new Map(runs.value).set(run.id, run);
}

export async function readRuns(): Promise<void> {
  runs.value = new Map((await client.runs()).map((run) => [run.id, run]));
  areRead.value = true;
}

export function followRuns(): () => void {
  return client.listen(
    put,
    (id) => {
      const left = new Map(runs.value);
      left.delete(id);
      runs.value = left;
    },
    (up) => {
      if (up && !isLinked.value) readRuns().catch(noteError);
      isLinked.value = up;
    },
  );
}
