// What is on the screen: the fabric at a strain, between two stored frames, or as it is now in a run that goes on.

import { batch, computed, effect, signal } from "@preact/signals";
import * as client from "../api/client";
import { forceAt } from "../parts/curve_data";
import { noteError } from "../state/program";
import { runs } from "../state/runs";
import { unpacked, type LoadedFrame } from "./frames";
import { curve, followRun, frameList, opened, type OpenRun } from "./open_run";

export interface Shown {
  run: OpenRun;
  strain: number;
  positions: Float32Array;
  before: LoadedFrame;
  after: LoadedFrame | null; // null: a stored or live frame as it is
  share: number; // of the way from before to after
  generation: number;
}

export const strain = signal(Infinity); // wanted; beyond what is stored: the end of it
export const isLive = signal(false); // the newest state of the run is wanted
export const isPlaying = signal(false);
export const shown = signal<Shown | null>(null);

export const nearest = computed<LoadedFrame | null>(() => {
  const now = shown.value;
  if (now === null) return null;
  return now.after !== null && now.share >= 0.5 ? now.after : now.before;
});

/** Elements that are broken: in between, those of the later frame. */
export const broken = computed(() => (shown.value?.after ?? shown.value?.before)?.broken);

export const force = computed<number | null>(() => {
  const now = shown.value;
  if (now === null) return null;
  if (now.after === null) return now.before.head.force;
  return curve.value === null ? null : forceAt(curve.value, now.strain);
});

const kSameStrain = 1e-6;
const kSecondsOfPlay = 6;

/** The stored frames on both sides of a strain, as places in the list; the same one twice where one is just there. */
export function framesAround(list: readonly { strain: number }[], at: number): [number, number] {
  const close = list.findIndex((frame) => Math.abs(frame.strain - at) <= kSameStrain);
  if (close >= 0) return [close, close];
  const above = list.findIndex((frame) => frame.strain > at);
  if (above < 0) return [list.length - 1, list.length - 1];
  return above === 0 ? [0, 0] : [above - 1, above];
}

let generation = 0;
let buffers: [Float32Array, Float32Array] = [new Float32Array(), new Float32Array()]; // in turn

function mixed(a: Float32Array, b: Float32Array, share: number): Float32Array {
  buffers.reverse();
  if (buffers[0].length !== a.length) buffers = [new Float32Array(a.length), new Float32Array(a.length)];
  const result = buffers[0];
  for (let i = 0; i < a.length; ++i) result[i] = a[i]! + share * (b[i]! - a[i]!);
  return result;
}

function show(run: OpenRun, before: LoadedFrame, after: LoadedFrame | null, share: number): void {
  const positions = after === null ? before.positions : mixed(before.positions, after.positions, share);
  const from = before.head.strain;
  const at = after === null ? from : from + share * (after.head.strain - from);
  shown.value = { run, strain: at, positions, before, after, share, generation: ++generation };
}

let isReading = false;

/** Brings the wanted strain to the screen; while frames are read, only the latest wanted one counts. */
async function followStrain(): Promise<void> {
  if (isReading) return;
  isReading = true;
  try {
    for (;;) {
      const run = opened.value;
      const list = frameList.value;
      if (run === null || list.length === 0 || isLive.value) return;
      const wanted = Math.min(list.at(-1)!.strain, Math.max(list[0]!.strain, strain.value));
      strain.value = wanted;
      const [low, high] = framesAround(list, wanted).map((place) => list[place]!);
      const before = run.store.at(low!.index) ?? (await run.store.read(low!.index));
      const after = low === high ? null : (run.store.at(high!.index) ?? (await run.store.read(high!.index)));
      if (run !== opened.value || isLive.value || wanted !== strain.value) continue;
      const width = high!.strain - low!.strain;
      show(run, before, after, after === null ? 0 : (wanted - low!.strain) / width);
      return;
    }
  } catch (error) {
    isPlaying.value = false;
    noteError(error);
  } finally {
    isReading = false;
  }
}

async function followLive(run: OpenRun): Promise<void> {
  try {
    const frame = unpacked(await client.liveFrame(run.id));
    if (run !== opened.value || !isLive.value) return;
    batch(() => {
      show(run, frame, null, 0);
      strain.value = frame.head.strain;
    });
  } catch (error) {
    isLive.value = false;
    noteError(error);
  }
}

/** Goes to a strain within what is stored. */
export function goToStrain(wanted: number): void {
  const list = frameList.value;
  if (list.length === 0) return;
  batch(() => {
    isLive.value = false;
    strain.value = Math.min(list.at(-1)!.strain, Math.max(list[0]!.strain, wanted));
  });
}

/** To the next stored frame, or the one before. */
export function stepFrame(direction: 1 | -1): void {
  const list = frameList.value;
  const [low, high] = framesAround(list, strain.value);
  const place = direction > 0 ? (low === high ? high + 1 : high) : low === high ? low - 1 : low;
  const frame = list[place];
  if (frame !== undefined) goToStrain(frame.strain);
}

function play(): void {
  const list = frameList.value;
  const [first, last] = [list[0]?.strain ?? 0, list.at(-1)?.strain ?? 0];
  if (strain.value >= last - kSameStrain) goToStrain(first);
  let before = performance.now();
  const step = (now: number): void => {
    if (!isPlaying.value) return;
    const ahead = (Math.min(100, now - before) / 1000 / kSecondsOfPlay) * (last - first);
    before = now;
    if (!isReading) goToStrain(strain.value + ahead);
    if (strain.value >= last - kSameStrain) isPlaying.value = false;
    else requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

export function togglePlay(): void {
  isPlaying.value = !isPlaying.value && frameList.value.length > 1;
  if (isPlaying.value) play();
}

/** Keeps the screen up to what is wanted; the result ends it. */
export function keepShown(): () => void {
  const ends = [
    effect(() => {
      if (opened.value !== shown.peek()?.run) shown.value = null;
    }),
    effect(() => {
      void [opened.value, frameList.value, strain.value, isLive.value];
      void followStrain();
    }),
    effect(() => {
      const head = runs.value.get(opened.value?.id ?? "");
      if (head === undefined) return;
      void followRun(head);
      if (head.live > 0 && head.frames === 0) isLive.value = true;
      if (isLive.value && !head.active) isLive.value = false;
    }),
    effect(() => {
      const run = opened.value;
      if (run !== null && isLive.value && (runs.value.get(run.id)?.live ?? 0) > 0) void followLive(run);
    }),
  ];
  return () => {
    isPlaying.value = false;
    for (const end of ends) end();
  };
}
