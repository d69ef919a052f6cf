// All runs of the folder, newest first.

import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import type { RunHead } from "../api/types";
import { addressOf } from "../state/route";
import { areRead, newestFirst } from "../state/runs";
import { RunItem } from "./run_item";
import { missing } from "./shown";
import { statusText } from "./words";

const kManyRuns = 10; // more than these can be filtered

function matches(run: RunHead, words: string): boolean {
  const text = `${run.id} ${run.title} ${statusText(run)}`.toLowerCase();
  return words
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

function Empty(): JSX.Element {
  return (
    <p class="empty">
      There is no run in the folder yet. <a href={addressOf("design")}>Design a case</a> and press Run.
    </p>
  );
}

export function RunList(): JSX.Element {
  const filter = useSignal("");
  const all = newestFirst.value;
  const found = all.filter((run) => matches(run, filter.value));
  return (
    <section class="panel run-list" aria-label="Runs">
      <header>
        <h2>Runs</h2>
        <span class="quiet">{areRead.value && all.length > 0 ? all.length : ""}</span>
        {all.length > kManyRuns || filter.value !== "" ? (
          <input
            type="search"
            placeholder="Filter"
            aria-label="Show only runs with these words"
            value={filter.value}
            onInput={(event) => (filter.value = event.currentTarget.value)}
          />
        ) : null}
      </header>
      {missing.value.length === 0 ? null : <p class="missing">Not in the folder: {missing.value.join(", ")}</p>}
      {areRead.value && all.length === 0 ? <Empty /> : null}
      {all.length > 0 && found.length === 0 ? <p class="empty">No run has these words.</p> : null}
      <ul>
        {found.map((run) => (
          <RunItem key={run.id} run={run} />
        ))}
      </ul>
    </section>
  );
}
