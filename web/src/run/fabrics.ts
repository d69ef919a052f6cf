// The fabrics of the runs that are watched: the newest live view of a run under way, the last stored frame of another.

import { signal } from "@preact/signals";
import type { Blob } from "../api/blob";
import * as client from "../api/client";
import type { FrameHead, RunHead, RunModel } from "../api/types";
import type { Box, Vec3 } from "../view3d/types";
import { isLinked, runs } from "../state/runs";
import { details } from "../state/run_details";
import { Paced, withEntry } from "../state/paced";

const kPause = 60; // ms between two views of a run

export interface WatchedFabric {
  model: Blob<RunModel>;
  room: Box; // around the fabric from the start to the end of the test
  course: Int32Array;
  wale: Int32Array;
  frame: Blob<FrameHead> | null; // null: as it was before the test
  positions: Float32Array; // of the frame
  broken: Int32Array | undefined;
  live: number; // of the run when the frame was asked for; the count begins anew when a run goes on
  ranges: ReadonlyMap<string, [number, number]>; // of the fields, over all views so far
  generation: number;
}

export const fabrics = signal<ReadonlyMap<string, WatchedFabric>>(new Map());
export const fabricTroubles = signal<ReadonlyMap<string, string>>(new Map());

const kMargin = 0.02; // of the gauge length

function roomOf(model: Blob<RunModel>, target: number): Box {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  model.floats("positions").forEach((x, i) => {
    lowest[i % 3] = Math.min(lowest[i % 3]!, x);
    highest[i % 3] = Math.max(highest[i % 3]!, x);
  });
  const margin = kMargin * model.head.gauge_length;
  highest[1]! += target * model.head.gauge_length;
  return { lowest: lowest.map((x) => x - margin) as unknown as Vec3, highest: highest.map((x) => x + margin) as unknown as Vec3 };
}

function widened(ranges: WatchedFabric["ranges"], frame: Blob<FrameHead>): WatchedFabric["ranges"] {
  const next = new Map(ranges);
  for (const { name, lowest, highest } of frame.head.fields) {
    const [low, high] = next.get(name) ?? [lowest, highest];
    next.set(name, [Math.min(low, lowest), Math.max(high, highest)]);
  }
  return next;
}

function isShown({ frame, live }: WatchedFabric, wanted: FrameHead["index"], newest: number): boolean {
  if (frame === null || frame.head.index !== wanted) return false;
  return wanted !== null || live === newest || frame.head.live === newest;
}

/** Number of the stored frame that is wanted, null for a live view, undefined if there is neither yet. */
function wantedFrame(run: RunHead): number | null | undefined {
  return run.active && run.live > 0 ? null : details.value.get(run.id)?.frame_list.at(-1)?.index;
}

async function readModel(run: RunHead): Promise<WatchedFabric> {
  const model = await client.runModel(run.id);
  return {
    model,
    room: roomOf(model, run.target_strain),
    course: model.integers("course"),
    wale: model.integers("wale"),
    frame: null,
    positions: model.floats("positions"),
    broken: undefined,
    live: 0,
    ranges: new Map(),
    generation: 1,
  };
}

async function bringUpToDate(id: string): Promise<void> {
  const run = runs.value.get(id);
  if (run === undefined) return;
  const before = fabrics.value.get(id) ?? (await readModel(run));
  fabrics.value = withEntry(fabrics.value, id, before);
  if (fabricTroubles.value.has(id)) fabricTroubles.value = withEntry(fabricTroubles.value, id, undefined);
  const wanted = wantedFrame(run);
  if (wanted === undefined || isShown(before, wanted, run.live)) return;
  const frame = wanted === null ? await liveOrNothing(id) : await client.frame(id, wanted);
  if (frame === null || !runs.value.has(id)) return;
  fabrics.value = withEntry(fabrics.value, id, {
    ...before,
    frame,
    positions: frame.floats("positions"),
    broken: frame.integers("broken"),
    live: run.live,
    ranges: widened(before.ranges, frame),
    generation: before.generation + 1,
  });
}

/** Nothing if the run has ended meanwhile; then its last stored frame is shown. */
async function liveOrNothing(id: string): Promise<Blob<FrameHead> | null> {
  try {
    return await client.liveFrame(id);
  } catch (error) {
    if (error instanceof client.Refused && error.status === 404) return null;
    throw error;
  }
}

const following = new Paced(kPause, bringUpToDate, (id, error) => {
  if (isLinked.value && runs.value.has(id)) fabricTroubles.value = withEntry(fabricTroubles.value, id, error instanceof Error ? error.message : String(error));
});

function isBehind(run: RunHead): boolean {
  const fabric = fabrics.value.get(run.id);
  const wanted = wantedFrame(run);
  return fabric === undefined || (wanted !== undefined && !isShown(fabric, wanted, run.live));
}

/** Keeps the fabrics of these runs up to date and forgets all others. */
export function followFabrics(watched: readonly RunHead[]): void {
  const ids = new Set(watched.map((run) => run.id));
  const left = [...fabrics.value].filter(([id]) => ids.has(id));
  if (left.length < fabrics.value.size) fabrics.value = new Map(left);
  for (const run of watched) if (isBehind(run)) following.ask(run.id);
}
