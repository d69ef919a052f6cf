// The page Explore: the fabric of a run at any strain, coloured by what it bears.

import { computed } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { FabricView, type ContactLayer, type FabricViewHandle, type Highlight, type Mark } from "../parts/fabric_view";
import { addressOf } from "../state/route";
import { areRead, runs } from "../state/runs";
import { ColourBar, ColourPanel } from "./colour_panel";
import { colouring, keepRanges } from "./colouring";
import { Header } from "./header";
import { frameList, opened, room, trouble } from "./open_run";
import { PickPanel } from "./pick_panel";
import * as selection from "./selection";
import { broken, isLive, keepShown, nearest, shown, stepFrame, togglePlay } from "./shown";
import { Strip } from "./strip";
import { LayersPanel, MeasurePanel, SectionPanel } from "./tools_panel";
import { camera, clip, keepAddress, runId } from "./view_words";
import { mm, percent } from "./words";

/** Marks the contacts of yarns that are not drawn. */
function otherContacts(yarns: Int32Array): Uint8Array | undefined {
  const { place, isAlone } = selection;
  if (!isAlone.value || place.value === null || opened.value === null) return undefined;
  const yarn = selection.yarnOf(opened.value, place.value.element);
  return Uint8Array.from({ length: yarns.length / 2 }, (_, i) => (yarns[2 * i] === yarn || yarns[2 * i + 1] === yarn ? 0 : 1));
}

const contactLayer = computed<ContactLayer | undefined>(() => {
  const contacts = nearest.value?.contacts;
  if (contacts === undefined || !selection.showsContacts.value) return undefined;
  const { normalForce: force, slips } = contacts;
  const largest = force.reduce((most, x) => Math.max(most, x), 0);
  return { positions: selection.contactPoints.value, force, slips, largest, hidden: otherContacts(contacts.yarns) };
});

const highlight = computed<Highlight | undefined>(() => {
  const run = opened.value;
  const at = selection.place.value;
  if (run === null || at === null) return undefined;
  const isContactShown = selection.showsContacts.value && selection.contactIndex.value !== null;
  return {
    yarn: selection.yarnOf(run, at.element),
    element: at.element,
    contact: isContactShown ? selection.contactIndex.value! : undefined,
    alone: selection.isAlone.value,
  };
});

const marks = computed<readonly Mark[]>(() => {
  const [from, to] = selection.measuredPoints.value;
  if (from === undefined) return [];
  const text = to === undefined ? "" : mm(Math.hypot(...[0, 1, 2].map((axis) => to[axis]! - from[axis]!)));
  return [{ from, to: to ?? null, text }];
});

function View({ handle }: { handle: { current: FabricViewHandle | null } }): JSX.Element {
  const now = shown.value;
  if (now === null || room.value === null) return <p class="explore-note quiet">{whyNoView()}</p>;
  const run = now.run;
  return (
    <>
      <FabricView
        key={run.id}
        fabric={run.fabric}
        positions={now.positions}
        course={run.course}
        wale={run.wale}
        generation={now.generation}
        label={`The fabric at ${percent(now.strain)} strain`}
        colour={colouring.value}
        broken={broken.value}
        contacts={contactLayer.value}
        clip={clip.value ?? undefined}
        highlight={highlight.value}
        marks={marks.value}
        room={room.value}
        camera={camera.value}
        onCamera={(state) => (camera.value = state)}
        onPick={selection.take}
        handle={handle}
      />
      <ColourBar />
    </>
  );
}

function whyNoView(): string {
  if (trouble.value !== "") return trouble.value;
  if (opened.value !== null && frameList.value.length === 0 && !isLive.value) return "This run has no stored frame yet.";
  return "Reading the run…";
}

function NoRun(): JSX.Element {
  return (
    <div class="explore-empty">
      <h1>Nothing to explore yet</h1>
      <p>
        A run leaves the frames that are shown here. Make a case on the page <a href={addressOf("design")}>Design</a> and
        start it, or look how a run goes on at <a href={addressOf("run")}>Run</a>.
      </p>
    </div>
  );
}

/** Keys that work while nothing else has the focus. */
function handleKey(event: KeyboardEvent): void {
  if (event.target !== document.body || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "ArrowLeft") stepFrame(-1);
  else if (event.key === "ArrowRight") stepFrame(1);
  else if (event.key === " ") togglePlay();
  else return;
  event.preventDefault();
}

export function ExplorePage(): JSX.Element {
  const handle = useRef<FabricViewHandle | null>(null);
  useEffect(() => {
    const ends = [keepAddress(), keepShown(), keepRanges()];
    document.addEventListener("keydown", handleKey);
    return () => {
      document.removeEventListener("keydown", handleKey);
      for (const end of ends) end();
    };
  }, []);
  if (runId.value === null) return areRead.value ? <NoRun /> : <p class="explore-note quiet">Reading the runs…</p>;
  const isGone = areRead.value && opened.value !== null && !runs.value.has(opened.value.id);
  return (
    <div class="explore" data-generation={shown.value?.generation ?? 0}>
      <h1 class="unseen">Explore</h1>
      <section class={selection.tool.value === "measure" ? "explore-view measuring" : "explore-view"} aria-label="View">
        <View handle={handle} />
      </section>
      <aside class="explore-side" aria-label="Settings and values">
        {isGone ? <p class="wrong small">The folder of this run is no longer there.</p> : null}
        <Header view={handle} />
        <ColourPanel />
        <LayersPanel />
        <PickPanel />
        <MeasurePanel />
        <SectionPanel />
      </aside>
      <Strip />
    </div>
  );
}
