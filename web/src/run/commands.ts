// What can be done with a run. The program tells of every change by an event; until then the button is busy.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import { openFrom } from "../design/files";
import { noteError } from "../state/program";
import { goTo } from "../state/route";
import { readDetail } from "../state/run_details";

export const busy = signal<ReadonlySet<string>>(new Set()); // runs of which something was asked that is not answered yet

/** Does something with a run, one thing at a time; says what goes wrong. */
async function once(id: string, action: () => Promise<unknown>): Promise<void> {
  if (busy.value.has(id)) return;
  busy.value = new Set([...busy.value, id]);
  try {
    await action();
  } catch (error) {
    noteError(error);
  } finally {
    busy.value = new Set([...busy.value].filter((other) => other !== id));
  }
}

export type Command = "pause" | "resume" | "stop";

export const command = (id: string, word: Command): Promise<void> => once(id, () => client.commandRun(id, word));

export const writeReport = (id: string): Promise<void> =>
  once(id, async () => {
    await client.writeReport(id);
    readDetail(id);
  });

/** The case of a run in Design, as one that is in no file yet. */
export function openCase(text: string): void {
  goTo("design");
  void openFrom(() => Promise.resolve({ path: null, text, stamp: null }));
}
