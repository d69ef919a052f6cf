// The view in the address: #/explore?run=jersey&strain=12.5&colour=curvature&... A link with it restores the view.

import { batch, effect, signal, untracked } from "@preact/signals";
import { noteView, route } from "../state/route";
import { newestFirst, runs } from "../state/runs";
import type { Box, CameraState, Vec3 } from "../view3d/types";
import { colourBy, range, type Range } from "./colouring";
import { opened, openRun, trouble } from "./open_run";
import * as selection from "./selection";
import { isLive, isPlaying, strain } from "./shown";

export const runId = signal<string | null>(null);
export const camera = signal<CameraState | undefined>(undefined);
export const clip = signal<Box | null>(null);

const kPause = 250; // ms without a change until the address follows

const short = (value: number, figures = 5): string => String(Number(value.toPrecision(figures)));
const numbers = (text: string | null): number[] => (text ?? "").split(",").map(Number);
const areNumbers = (values: readonly number[], count: number): boolean =>
  values.length === count && values.every(Number.isFinite);
const rounded = (values: readonly number[], figures?: number): string => values.map((x) => short(x, figures)).join(",");

function cameraOf(text: string | null): CameraState | undefined {
  const words = (text ?? "").split(",");
  const values = words.slice(0, 6).map(Number);
  if (!areNumbers(values, 6) || !(values[5]! > 0)) return undefined;
  const [azimuth, elevation, x, y, z, span] = values as [number, number, number, number, number, number];
  return { azimuth, elevation, target: [x, y, z], span, orthographic: words[6] !== "perspective" };
}

function cameraText(state: CameraState): string {
  const text = rounded([state.azimuth, state.elevation, ...state.target, state.span]);
  return state.orthographic ? text : `${text},perspective`;
}

function clipOf(text: string | null): Box | null {
  const values = numbers(text);
  if (text === null || !areNumbers(values, 6)) return null;
  const [lowest, highest] = [values.slice(0, 3), values.slice(3)];
  if (lowest.some((x, axis) => x > highest[axis]!)) return null;
  return { lowest: lowest as unknown as Vec3, highest: highest as unknown as Vec3 };
}

function rangeOf(text: string | null): Range {
  if (text === "all") return { of: "all" };
  const [lowest = NaN, highest = NaN] = numbers(text);
  return text !== null && lowest < highest ? { of: "own", lowest, highest } : { of: "frame" };
}

function placesOf(text: string | null, most: number): selection.YarnPlace[] {
  const values = numbers(text);
  if (text === null || !areNumbers(values, values.length) || values.length % 2 !== 0) return [];
  const places: selection.YarnPlace[] = [];
  for (let i = 0; i < values.length && places.length < most; i += 2)
    places.push({ element: Math.max(0, Math.floor(values[i]!)), share: Math.min(1, Math.max(0, values[i + 1]!)) });
  return places;
}

function contactOf(text: string | null): selection.ContactPlace | null {
  const [a, b, c, d] = numbers(text);
  if (text === null || ![a, b, c, d].every(Number.isFinite)) return null;
  return { yarns: [a!, b!], places: [c!, d!] };
}

/** Places that the run does not have are left out: the link may be of a run that was made again. */
function dropStrangers(): void {
  const run = opened.value;
  if (run === null) return;
  const isThere = (at: selection.YarnPlace): boolean => selection.yarnOf(run, at.element) >= 0;
  if (selection.place.value !== null && !isThere(selection.place.value)) selection.clearSelection();
  if (!selection.measured.value.every(isThere)) selection.measured.value = [];
}

function write(): Record<string, string> {
  const words: Record<string, string> = {};
  if (runId.value === null) return words;
  words["run"] = runId.value;
  if (isLive.value) words["live"] = "1";
  else words["strain"] = short(100 * strain.value);
  if (colourBy.value !== "course") words["colour"] = colourBy.value;
  const wanted = range.value;
  if (wanted.of === "all") words["range"] = "all";
  if (wanted.of === "own") words["range"] = rounded([wanted.lowest, wanted.highest]);
  if (camera.value !== undefined) words["camera"] = cameraText(camera.value);
  if (clip.value !== null) words["clip"] = rounded([...clip.value.lowest, ...clip.value.highest]);
  if (selection.showsContacts.value) words["contacts"] = "1";
  const { place, contact, isAlone, measured } = selection;
  if (place.value !== null) words["at"] = `${place.value.element},${short(place.value.share, 2)}`;
  if (contact.value !== null) words["contact"] = rounded([...contact.value.yarns, ...contact.value.places]);
  if (isAlone.value) words["alone"] = "1";
  if (measured.value.length > 0)
    words["measure"] = measured.value.map((at) => `${at.element},${short(at.share, 2)}`).join(",");
  return words;
}

/** The newest run with something to see. */
const runToShow = (): string | null => newestFirst.value.find((run) => run.frames > 0 || run.live > 0)?.id ?? null;

/** Takes the view over from the address. Without a strain the newest state or the last stored frame is shown. */
function read(words: URLSearchParams): void {
  const id = words.get("run") ?? runToShow();
  batch(() => {
    isPlaying.value = false;
    const goesOn = runs.value.get(id ?? "")?.active === true;
    isLive.value = words.get("live") === "1" || (goesOn && !words.has("strain"));
    const percent = words.has("strain") ? Number(words.get("strain")) : NaN;
    strain.value = Number.isFinite(percent) ? percent / 100 : Infinity;
    colourBy.value = words.get("colour") ?? "course";
    range.value = rangeOf(words.get("range"));
    camera.value = cameraOf(words.get("camera"));
    clip.value = clipOf(words.get("clip"));
    selection.showsContacts.value = words.get("contacts") === "1";
    selection.place.value = placesOf(words.get("at"), 1)[0] ?? null;
    selection.contact.value = contactOf(words.get("contact"));
    selection.isAlone.value = words.get("alone") === "1";
    selection.measured.value = placesOf(words.get("measure"), 2);
    if (id !== runId.value || trouble.value !== "") {
      runId.value = id;
      if (id !== null) void openRun(id).then(dropStrangers);
    } else dropStrangers();
  });
}

let written = ""; // the words that the page itself put into the address

/** Another run, seen in the same way but from afresh. */
export function chooseRun(id: string): void {
  batch(() => {
    camera.value = undefined;
    clip.value = null;
    selection.clearSelection();
    selection.measured.value = [];
    isLive.value = false;
    isPlaying.value = false;
    strain.value = Infinity;
    runId.value = id;
  });
  void openRun(id);
}

export const addressNow = (): string => {
  note(write());
  return location.href;
};

function note(words: Record<string, string>): void {
  written = new URLSearchParams(words).toString();
  if (route.value.words.toString() !== written) noteView("explore", words);
}

/** Keeps address and view the same while the page is there; the result ends it. */
export function keepAddress(): () => void {
  written = "";
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ends = [
    effect(() => {
      const { page, words } = route.value;
      const text = words.toString();
      if (page !== "explore" || (text === written && text !== "")) return;
      written = text;
      untracked(() => (text === "" && runId.value !== null ? note(write()) : read(words)));
    }),
    effect(() => {
      if (runId.value === null && runToShow() !== null) untracked(() => read(route.value.words));
    }),
    effect(() => {
      const words = write();
      clearTimeout(timer);
      if (words["run"] === undefined || words["strain"] === "Infinity") return;
      timer = setTimeout(() => note(words), kPause);
    }),
  ];
  return () => {
    clearTimeout(timer);
    for (const end of ends) end();
  };
}
