// Pointer and keys on the view: turn, move, zoom at the pointer, pick.

import * as camera from "./camera";
import type { CameraState } from "./types";

const kDegreesPerPixel = 0.4;
const kDegreesPerKey = 6;
const kMovePerKey = 0.06; // of the view's height
const kZoomPerKey = 1.2;
const kZoomPerWheel = 0.0016; // logarithm for a px
const kClickPixels = 4; // a press that moves farther is a drag

export interface Controlled {
  change(change: (state: CameraState) => CameraState, atOnce?: boolean): void;
  showWhole(): void;
  click(column: number, row: number): void;
}

const kKeys: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function handleKey(event: KeyboardEvent, view: Controlled): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = kKeys[event.key];
  if (arrow !== undefined) {
    const [x, y] = arrow;
    if (event.shiftKey) view.change((state) => camera.moved(state, kMovePerKey * x, kMovePerKey * y));
    else view.change((state) => camera.turned(state, -kDegreesPerKey * x, -kDegreesPerKey * y));
  } else if (event.key === "+" || event.key === "=") view.change((state) => camera.zoomed(state, kZoomPerKey, 0, 0));
  else if (event.key === "-") view.change((state) => camera.zoomed(state, 1 / kZoomPerKey, 0, 0));
  else if (event.key === "0") view.showWhole();
  else return;
  event.preventDefault();
}

/** Place in the view as shares of its height from the middle, to the right and up. */
function sharesOf(element: HTMLElement, event: MouseEvent): [number, number] {
  const box = element.getBoundingClientRect();
  return [
    (event.clientX - box.left - box.width / 2) / box.height,
    (box.height / 2 - (event.clientY - box.top)) / box.height,
  ];
}

function handleWheel(event: WheelEvent, element: HTMLElement, view: Controlled): void {
  event.preventDefault();
  const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 * event.deltaY : event.deltaY;
  const factor = Math.exp(-kZoomPerWheel * Math.max(-300, Math.min(300, pixels)));
  const [right, up] = sharesOf(element, event);
  view.change((state) => camera.zoomed(state, factor, right, up));
}

function followPointers(element: HTMLElement, view: Controlled, signal: AbortSignal): void {
  const pressed = new Map<number, { x: number; y: number }>();
  let travelled = 0;
  const spread = (): number => {
    const [a, b] = [...pressed.values()];
    return a !== undefined && b !== undefined ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  const drag = (event: PointerEvent, x: number, y: number): void => {
    const height = element.clientHeight;
    const isMove = event.shiftKey || (event.buttons & 6) !== 0 || pressed.size > 1;
    if (isMove) view.change((state) => camera.moved(state, x / height, -y / height), true);
    else view.change((state) => camera.turned(state, -kDegreesPerPixel * x, kDegreesPerPixel * y));
  };
  element.addEventListener("pointerdown", (event) => {
    if (pressed.size === 0) travelled = 0;
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY });
    element.setPointerCapture(event.pointerId);
  }, { signal });
  element.addEventListener("pointermove", (event) => {
    const last = pressed.get(event.pointerId);
    if (last === undefined) return;
    const [x, y] = [event.clientX - last.x, event.clientY - last.y];
    travelled += Math.hypot(x, y);
    const before = spread();
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (travelled <= kClickPixels) return;
    drag(event, x / pressed.size, y / pressed.size);
    const after = spread();
    if (before > 0 && after > 0) view.change((state) => camera.zoomed(state, after / before, 0, 0), true);
  }, { signal });
  const release = (event: PointerEvent): void => {
    if (!pressed.delete(event.pointerId)) return;
    if (event.type !== "pointerup" || travelled > kClickPixels || event.button !== 0) return;
    const box = element.getBoundingClientRect();
    view.click(event.clientX - box.left, event.clientY - box.top);
  };
  element.addEventListener("pointerup", release, { signal });
  element.addEventListener("pointercancel", release, { signal });
}

/** Begins to listen; the result ends it. */
export function addControls(element: HTMLElement, view: Controlled): () => void {
  const end = new AbortController();
  const signal = end.signal;
  followPointers(element, view, signal);
  element.addEventListener("wheel", (event) => handleWheel(event, element, view), { passive: false, signal });
  element.addEventListener("keydown", (event) => handleKey(event, view), { signal });
  element.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  return () => end.abort();
}
