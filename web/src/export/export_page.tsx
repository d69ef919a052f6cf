// The page Export: files for other programs, for papers and for colleagues.

import { computed, useSignalEffect } from "@preact/signals";
import type { JSX } from "preact";
import { design } from "../state/design";
import { details, followDetails } from "../state/run_details";
import { areRead, newestFirst, runs } from "../state/runs";
import { CaseCard, DeckCard, GeometryCard } from "./case_cards";
import { PictureCard } from "./picture_card";
import { CurveCard, FramesCard, ReportCard } from "./run_cards";
import { chooseSubject, runId, subject, type Subject } from "./subject";

function Chooser(): JSX.Element {
  const title = design.value?.given["title"]?.typed ?? "";
  return (
    <label class="of-what">
      <span>Export of</span>
      <select aria-label="Export of" value={runId.value ?? ""} onChange={(event) => chooseSubject(event.currentTarget.value)}>
        <option value="">The case in Design{title === "" ? "" : `: ${title}`}</option>
        <optgroup label="Runs">
          {newestFirst.value.map((run) => (
            <option key={run.id} value={run.id}>
              {run.title === "" ? run.id : `${run.id}: ${run.title}`}
            </option>
          ))}
        </optgroup>
      </select>
    </label>
  );
}

function OfRun({ subject: { run, detail } }: { subject: Subject }): JSX.Element | null {
  if (run === null) {
    return <p class="hint quiet">Curves, frames, pictures and reports come from a run: choose one above.</p>;
  }
  if (run.status === "damaged") return <p class="hint wrong">{run.message}</p>;
  return (
    <>
      <ReportCard run={run} detail={detail} />
      <CurveCard run={run} detail={detail} />
      <FramesCard run={run} detail={detail} />
      <PictureCard key={run.id} run={run} detail={detail} />
    </>
  );
}

let count = 0;
/** Rises with everything that is shown here. */
const generation = computed(() => {
  void [subject.value, details.value];
  return ++count;
});

export function ExportPage(): JSX.Element {
  useSignalEffect(() => {
    const run = subject.value?.run;
    if (run != null) followDetails([run]);
  });
  return (
    <div class="export" data-generation={generation.value}>
      <h1 class="unseen">Export</h1>
      <header>
        <Chooser />
      </header>
      {subject.value === null ? (
        <p class="hint wrong">{areRead.value && !runs.value.has(runId.value ?? "") ? `There is no run ${runId.value} in the folder.` : ""}</p>
      ) : (
        <div class="cards" key={runId.value ?? ""}>
          <DeckCard subject={subject.value} />
          <GeometryCard subject={subject.value} />
          <CaseCard subject={subject.value} />
          <OfRun subject={subject.value} />
        </div>
      )}
    </div>
  );
}
