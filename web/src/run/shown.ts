// Which runs are shown, and how: all of it stands in the address, so that a link or a reload brings it back.

import { computed } from "@preact/signals";
import type { RunHead } from "../api/types";
import { kRunColours } from "../parts/curve_data";
import { noteView, route } from "../state/route";
import { areRead, newestFirst, runs } from "../state/runs";

export const kMostShown = kRunColours;
export const kMostBeside = 4;

let words: Record<string, string> = {}; // of the page as it was last

const address = computed(() => {
  if (route.value.page === "run" && route.value.words.size > 0) words = Object.fromEntries(route.value.words);
  return words;
});

/** A word of the address. */
export const wordOf = (name: string): string => address.value[name] ?? "";

/** Writes words into the address; an empty one is taken out of it. */
export function setWords(changed: Record<string, string>): void {
  const all = { ...address.value, ...changed };
  noteView("run", Object.fromEntries(Object.entries(all).filter(([name, value]) => value !== "" || name === "runs")));
}

const joined = (ids: readonly string[]): string => ids.map((id) => id.replaceAll("%", "%25").replaceAll(",", "%2C")).join(",");
const parted = (text: string): string[] => text.split(",").filter((id) => id !== "").map((id) => id.replaceAll("%2C", ",").replaceAll("%25", "%"));

const asked = computed(() => [...new Set(parted(wordOf("runs")))].slice(0, kMostShown));

/** Names in the address of which the folder has no run. */
export const missing = computed(() => (areRead.value ? asked.value.filter((id) => !runs.value.has(id)) : []));

/** The runs whose curves are shown, in the order in which they were chosen. */
export const shownIds = computed(() => asked.value.filter((id) => runs.value.has(id)));
export const shown = computed(() => shownIds.value.map((id) => runs.value.get(id) as RunHead));

/** The run whose fabric and values are shown: one of the shown ones. */
export const selectedId = computed(() => {
  const named = wordOf("run");
  return shownIds.value.includes(named) ? named : (shownIds.value[0] ?? null);
});
export const selected = computed(() => (selectedId.value === null ? null : (runs.value.get(selectedId.value) ?? null)));

/** Whether the fabrics of all shown runs are beside each other. */
export const areBeside = computed(() => wordOf("beside") !== "" && shown.value.length > 1);

/** The runs whose fabrics are shown. */
export const watched = computed(() => {
  if (areBeside.value) return shown.value.slice(0, kMostBeside);
  return selected.value === null ? [] : [selected.value];
});

let coloursBefore: ReadonlyMap<string, number> = new Map();

/** Colours by run, of the chart's palette; a run keeps its colour as long as it is shown. */
export const colours = computed<ReadonlyMap<string, number>>(() => {
  const next = new Map<string, number>();
  for (const id of asked.value) {
    const before = coloursBefore.get(id);
    if (before !== undefined) next.set(id, before);
  }
  for (const id of asked.value) {
    if (next.has(id)) continue;
    const taken = new Set(next.values());
    next.set(id, Array.from({ length: kRunColours }, (_, i) => i).find((i) => !taken.has(i)) ?? 0);
  }
  coloursBefore = next;
  return next;
});

const show = (ids: readonly string[], run: string): void => setWords({ runs: joined(ids), run });

/** Shows the curve of a run or hides it; false if too many are shown already. */
export function toggleShown(id: string): boolean {
  const others = shownIds.value.filter((other) => other !== id);
  if (others.length === shownIds.value.length && others.length >= kMostShown) return false;
  if (others.length === shownIds.value.length) show([...others, id], selectedId.value ?? id);
  else show(others, selectedId.value === id ? "" : (selectedId.value ?? ""));
  return true;
}

/** Looks at a run: in place of the only one that is shown, otherwise together with those. */
export function select(id: string): void {
  if (shownIds.value.includes(id)) show(shownIds.value, id);
  else if (shownIds.value.length <= 1) show([id], id);
  else show([...shownIds.value.slice(0, kMostShown - 1), id], id);
}

/** Before anything was chosen: the runs that are under way, otherwise the newest one. */
export function chooseFirst(): void {
  if (!areRead.value || route.value.page !== "run" || route.value.words.has("runs")) return;
  if (address.value["runs"] !== undefined) {
    setWords({});
    return;
  }
  const active = newestFirst.value.filter((run) => run.active).slice(0, kMostShown);
  const first = active.length > 0 ? active : newestFirst.value.slice(0, 1);
  if (first.length > 0) show(first.map((run) => run.id), first[0]!.id);
}
