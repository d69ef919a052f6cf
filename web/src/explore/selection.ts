// What is picked and measured. A place is one on the yarn, not one in space, and goes with the yarn from strain to strain.

import { computed, signal } from "@preact/signals";
import type { Picked, Vec3 } from "../view3d/types";
import type { Contacts } from "./frames";
import { opened, type OpenRun } from "./open_run";
import { nearest, shown } from "./shown";

/** A place on the axis of a yarn. */
export interface YarnPlace {
  element: number; // its first node
  share: number; // of the element
}

/** A contact by the yarns and the places that touch, by which it is found again in another frame. */
export interface ContactPlace {
  yarns: [number, number];
  places: [number, number]; // mm
}

export const tool = signal<"pick" | "measure">("pick");
export const place = signal<YarnPlace | null>(null);
export const contact = signal<ContactPlace | null>(null);
export const isAlone = signal(false); // only the picked yarn is drawn
export const measured = signal<readonly YarnPlace[]>([]);
export const showsContacts = signal(false);

const kSameContact = 6; // diameters between places of the same contact in two frames

export function yarnOf(run: OpenRun, element: number): number {
  return run.fabric.yarns.findIndex((yarn) => element >= yarn.first_node && element < yarn.first_node + yarn.nodes - 1);
}

export function contactPlace(contacts: Contacts, i: number): ContactPlace {
  return {
    yarns: [contacts.yarns[2 * i]!, contacts.yarns[2 * i + 1]!],
    places: [contacts.places[2 * i]!, contacts.places[2 * i + 1]!],
  };
}

/** Index of the picked contact in the nearest stored frame; null if it is open there. */
export const contactIndex = computed<number | null>(() => {
  const wanted = contact.value;
  const contacts = nearest.value?.contacts;
  const run = opened.value;
  if (wanted === null || contacts === undefined || run === null) return null;
  let best: { index: number; distance: number } | null = null;
  for (let i = 0; i < contacts.normalForce.length; ++i) {
    const { yarns, places } = contactPlace(contacts, i);
    if (yarns[0] !== wanted.yarns[0] || yarns[1] !== wanted.yarns[1]) continue;
    const distance = Math.max(Math.abs(places[0] - wanted.places[0]), Math.abs(places[1] - wanted.places[1]));
    if (distance <= kSameContact * run.fabric.diameter && (best === null || distance < best.distance))
      best = { index: i, distance };
  }
  return best?.index ?? null;
});

export function pointAt(positions: Float32Array, at: YarnPlace): Vec3 {
  return [0, 1, 2].map((axis) => {
    const a = positions[3 * at.element + axis]!;
    return a + at.share * (positions[3 * at.element + 3 + axis]! - a);
  }) as unknown as Vec3;
}

/** The measured points as they are now. */
export const measuredPoints = computed<readonly Vec3[]>(() => {
  const positions = shown.value?.positions;
  return positions === undefined ? [] : measured.value.map((at) => pointAt(positions, at));
});

export function clearSelection(): void {
  place.value = null;
  contact.value = null;
  isAlone.value = false;
}

/** The place at a length along a yarn. */
export function placeAt(run: OpenRun, yarn: number, length: number): YarnPlace {
  const { first_node: first, nodes } = run.fabric.yarns[yarn]!;
  const wanted = run.arcLength[first]! + length;
  let [low, high] = [first, first + nodes - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (run.arcLength[middle]! <= wanted) low = middle;
    else high = middle;
  }
  const share = (wanted - run.arcLength[low]!) / (run.arcLength[low + 1]! - run.arcLength[low]!);
  return { element: low, share: Math.min(1, Math.max(0, share)) };
}

/** Contacts of the nearest stored frame, halfway between the two yarns as they lie now. */
export const contactPoints = computed<Float32Array>(() => {
  const now = shown.value;
  const contacts = nearest.value?.contacts;
  if (now === null || contacts === undefined) return new Float32Array();
  if (now.after === null) return contacts.positions;
  const points = new Float32Array(contacts.positions.length);
  for (let i = 0; 3 * i < points.length; ++i) {
    const { yarns, places } = contactPlace(contacts, i);
    const [a, b] = yarns.map((yarn, k) => pointAt(now.positions, placeAt(now.run, yarn, places[k]!)));
    points.set([0, 1, 2].map((axis) => 0.5 * (a![axis]! + b![axis]!)), 3 * i);
  }
  return points;
});

/** A click on the view. */
export function take(picked: Picked | null): void {
  if (tool.value === "measure") {
    if (picked === null) return;
    const point = { element: picked.element, share: picked.share };
    measured.value = measured.value.length === 1 ? [...measured.value, point] : [point];
    return;
  }
  if (picked === null) {
    clearSelection();
    return;
  }
  place.value = { element: picked.element, share: picked.share };
  const contacts = nearest.value?.contacts;
  const isContact = picked.contact !== null && contacts !== undefined;
  contact.value = isContact ? contactPlace(contacts, picked.contact!) : null;
}

/** To the next element of the same yarn, or the one before. */
export function stepAlong(direction: 1 | -1): void {
  const run = opened.value;
  const now = place.value;
  if (run === null || now === null) return;
  const next = now.element + direction;
  if (yarnOf(run, next) !== yarnOf(run, now.element)) return;
  contact.value = null;
  place.value = { element: next, share: 0.5 };
}
