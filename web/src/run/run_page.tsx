// The page Run: the runs of the folder, their curves, their fabrics as they deform. The page only looks; what runs goes
// on without it.

import { computed, signal, useSignalEffect } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { program } from "../api/client";
import { areRead, isLinked, runs } from "../state/runs";
import { ChartPanel } from "./chart_panel";
import { details, followDetails, forgetDetails } from "../state/run_details";
import { DropSign, listenToDrops } from "./drop";
import { fabrics, followFabrics } from "./fabrics";
import { FabricPanel } from "./fabric_panel";
import { Facts } from "./facts";
import { followHistories, forgetHistories, histories } from "./histories";
import { MeasuredDialog } from "./measured_dialog";
import { RunList } from "./run_list";
import { areBeside, chooseFirst, selected, shown, watched } from "./shown";

const kLook = 1000; // ms between two looks at what no event tells
const kProbe = 3000; // ms between two tries to find out why the program does not answer

function followAll(): void {
  followHistories(shown.value);
  followDetails([...new Set([...watched.value, ...(selected.value === null ? [] : [selected.value])])]);
  followFabrics(watched.value);
}

const isThere = (id: string): boolean => runs.value.has(id);

const linkTrouble = signal(""); // why there is no link, in the program's words if it answers at all

async function probe(): Promise<void> {
  try {
    await program();
    linkTrouble.value = "";
  } catch (error) {
    linkTrouble.value = error instanceof Error ? error.message : String(error);
  }
}

function LinkTrouble(): JSX.Element | null {
  useEffect(() => {
    if (isLinked.value) return;
    void probe();
    const timer = setInterval(() => void probe(), kProbe);
    return () => clearInterval(timer);
  }, [isLinked.value]);
  if (isLinked.value) return null;
  return (
    <p class="link-trouble" role="alert">
      <strong>No link to the program.</strong> {linkTrouble.value} Shown is what came last; the page goes on by itself when the link is back.
    </p>
  );
}

function Nothing(): JSX.Element {
  const words = !areRead.value ? "Reading the runs." : runs.value.size === 0 ? "Curves and fabrics appear here when a case runs." : "Choose a run in the list.";
  return <section class="panel nothing quiet">{words}</section>;
}

let count = 0;
/** Rises with everything that is drawn here. */
const generation = computed(() => {
  void [runs.value, shown.value, histories.value, details.value, fabrics.value];
  return ++count;
});

export function RunPage(): JSX.Element {
  useSignalEffect(chooseFirst);
  useSignalEffect(followAll);
  useSignalEffect(() => {
    if (!areRead.value) return;
    forgetHistories(isThere);
    forgetDetails(isThere);
  });
  useEffect(listenToDrops, []);
  useEffect(() => {
    const timer = setInterval(followAll, kLook);
    return () => clearInterval(timer);
  }, []);
  return (
    <div class="run-page" data-generation={generation.value}>
      <h1 class="unseen">Run</h1>
      <LinkTrouble />
      <div class={areBeside.value ? "run-grid beside" : "run-grid"}>
        <RunList />
        {selected.value === null ? (
          <Nothing />
        ) : (
          <>
            <ChartPanel />
            <FabricPanel />
            <Facts run={selected.value} />
          </>
        )}
      </div>
      <MeasuredDialog />
      <DropSign />
    </div>
  );
}
