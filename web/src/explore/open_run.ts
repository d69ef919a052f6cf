// The run that is looked at: its yarns, its stored frames, its curve.

import { batch, signal } from "@preact/signals";
import * as client from "../api/client";
import type { RunDetail, RunHead, RunModel } from "../api/types";
import { noteError } from "../state/program";
import type { Curve } from "../parts/curve_data";
import type { Box, Vec3 } from "../view3d/types";
import { FrameStore } from "./frames";

export interface OpenRun {
  id: string;
  title: string;
  fabric: RunModel;
  start: Float32Array; // stress-free positions
  course: Int32Array;
  wale: Int32Array;
  arcLength: Float32Array;
  store: FrameStore;
}

export const opened = signal<OpenRun | null>(null);
export const frameList = signal<readonly { index: number; strain: number }[]>([]); // ascending
export const curve = signal<Curve | null>(null);
export const room = signal<Box | null>(null); // around the fabric at the start and at the end
export const trouble = signal(""); // why nothing can be shown

let asked = 0; // number of the latest opening

function boxAround(all: readonly Float32Array[], margin: number): Box {
  const lowest = [Infinity, Infinity, Infinity];
  const highest = [-Infinity, -Infinity, -Infinity];
  for (const positions of all)
    positions.forEach((x, i) => {
      if (!Number.isFinite(x)) return;
      const axis = i % 3;
      if (x < lowest[axis]!) lowest[axis] = x;
      if (x > highest[axis]!) highest[axis] = x;
    });
  return {
    lowest: lowest.map((x) => x - margin) as unknown as Vec3,
    highest: highest.map((x) => x + margin) as unknown as Vec3,
  };
}

/** Around the fabric from the start of the test to its end, also where that is still to come. */
async function findRoom(run: OpenRun, detail: RunDetail): Promise<void> {
  const last = detail.frame_list.at(-1);
  const ends = last === undefined ? [] : [(await run.store.read(last.index)).positions];
  if (opened.value !== run) return;
  const box = boxAround([run.start, ...ends], run.fabric.diameter);
  const atStart = boxAround([run.start], run.fabric.diameter);
  const atEnd = detail.active ? atStart.highest[1] + detail.target_strain * detail.gauge_length : -Infinity;
  room.value = { lowest: box.lowest, highest: [box.highest[0], Math.max(box.highest[1], atEnd), box.highest[2]] };
}

async function readCurve(id: string, title: string): Promise<void> {
  const known = curve.value?.id === id ? curve.value : null;
  const history = await client.history(id, known?.strain.length ?? 0);
  const added = { strain: history.columns["strain"] ?? [], force: history.columns["force_top_N"] ?? [] };
  if (opened.value?.id !== id || (known !== null && added.strain.length === 0)) return;
  curve.value = {
    id,
    name: title,
    strain: [...(known?.strain ?? []), ...added.strain],
    force: [...(known?.force ?? []), ...added.force],
  };
}

/** Opens a run in place of the present one. */
export async function openRun(id: string): Promise<void> {
  const number = ++asked;
  batch(() => {
    opened.value = null;
    frameList.value = [];
    curve.value = null;
    room.value = null;
    trouble.value = "";
  });
  try {
    const [detail, model] = await Promise.all([client.run(id), client.runModel(id)]);
    if (number !== asked) return;
    const run: OpenRun = {
      id,
      title: model.head.title,
      fabric: model.head,
      start: model.floats("positions"),
      course: model.integers("course"),
      wale: model.integers("wale"),
      arcLength: model.floats("arc_length"),
      store: new FrameStore(id),
    };
    batch(() => {
      opened.value = run;
      frameList.value = detail.frame_list;
    });
    await Promise.all([findRoom(run, detail), readCurve(id, run.title)]);
  } catch (error) {
    if (number === asked) trouble.value = error instanceof Error ? error.message : String(error);
  }
}

let latest: RunHead | null = null; // told while something was being read
let isFollowing = false;

/** Follows a run that goes on: more rows of its curve, more stored frames. */
export async function followRun(head: RunHead): Promise<void> {
  latest = head;
  if (isFollowing) return;
  isFollowing = true;
  try {
    while (latest !== null) {
      const next: RunHead = latest;
      latest = null;
      await catchUp(next);
    }
  } catch (error) {
    noteError(error);
  } finally {
    isFollowing = false;
  }
}

async function catchUp(head: RunHead): Promise<void> {
  const run = opened.value;
  if (run === null || run.id !== head.id || curve.value === null) return;
  if (head.rows > curve.value.strain.length) await readCurve(head.id, run.title);
  if (head.frames <= frameList.value.length) return;
  const detail = await client.run(head.id);
  if (opened.value !== run) return;
  frameList.value = detail.frame_list;
}
