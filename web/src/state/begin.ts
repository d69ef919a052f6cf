// What is read when the page opens.

import * as client from "../api/client";
import { open } from "./design";
import { noteError, program, readProgram } from "./program";
import { goTo, route } from "./route";
import { followRuns, readRuns } from "./runs";

const kFirstExample = "01-first-loop";

/** The named case; if it cannot be read the page says so and shows the first example. */
async function firstCase(named: string | null): Promise<void> {
  if (named !== null) {
    try {
      open(await client.readCase(named));
      return;
    } catch (error) {
      noteError(error);
    }
  }
  open(await client.example(kFirstExample));
}

export async function begin(): Promise<void> {
  try {
    await readProgram();
    const opened = program.value?.opened;
    if (opened?.run != null && location.hash === "") goTo("explore", { run: opened.run });
    followRuns();
    await Promise.all([readRuns(), firstCase(route.value.words.get("case") ?? opened?.case ?? null)]);
  } catch (error) {
    noteError(error);
  }
}
