// What lies under the pointer: the yarn whose surface a line of sight meets first, or passes closest.

import type { FabricHead } from "../api/types";
import type { Projection } from "./camera";
import { dot, plus } from "./camera";
import type { ContactDots } from "./contact_dots";
import type { Tubes } from "./tubes";
import type { Box, Picked, Vec3 } from "./types";

const kNearMiss = 5; // px

interface Hit {
  element: number;
  chunk: number;
  share: number;
  along: number; // the line of sight [mm]
  miss: number; // distance of the centreline from the line [mm]
}

const isIn = (box: Box, p: Vec3): boolean => p.every((x, axis) => x >= box.lowest[axis]! && x <= box.highest[axis]!);

/** The places at which a line and an element are closest. */
function closest(origin: Vec3, direction: Vec3, a: Vec3, b: Vec3): { share: number; along: number; miss: number } {
  const side = plus(b, a, -1);
  const from = plus(a, origin, -1);
  const e = dot(side, direction);
  const across = dot(side, side) - e * e;
  const wanted = across > 1e-18 ? (e * dot(from, direction) - dot(from, side)) / across : 0;
  const share = Math.min(1, Math.max(0, wanted));
  const onYarn = plus(from, side, share);
  const along = dot(onYarn, direction);
  return { share, along, miss: Math.hypot(...plus(onYarn, direction, -along)) };
}

function pickContact(dots: ContactDots, projection: Projection, clip: Box, column: number, row: number): number | null {
  const layer = dots.layer;
  if (layer === undefined) return null;
  let best: { contact: number; distance: number } | null = null;
  for (let i = 0; i < layer.force.length; ++i) {
    if (layer.hidden?.[i] === 1) continue;
    const place = layer.positions.subarray(3 * i, 3 * i + 3) as unknown as Vec3;
    if (!isIn(clip, [place[0], place[1], place[2]])) continue;
    const [x, y] = projection.placeOf(place);
    const distance = Math.hypot(x - column, y - row) - dots.radiusOf(i, projection.scaleAt(place));
    if (distance < 0 && (best === null || distance < best.distance)) best = { contact: i, distance };
  }
  return best?.contact ?? null;
}

export function pick(
  fabric: FabricHead,
  positions: Float32Array,
  tubes: Tubes,
  dots: ContactDots,
  projection: Projection,
  column: number,
  row: number,
): Picked | null {
  const { origin, direction } = projection.rayThrough(column, row);
  const radius = 0.5 * Math.max(fabric.diameter, fabric.edge_diameter ?? 0);
  const reach = radius + kNearMiss / projection.pixelsPerMm;
  const node = (i: number): Vec3 => [positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!];
  let best: Hit | null = null;
  for (let chunk = 0; chunk < tubes.chunks.count; ++chunk) {
    if (!tubes.isDrawn(chunk) || !tubes.chunks.isMet(chunk, origin, direction, reach)) continue;
    const begin = tubes.chunks.first[chunk]!;
    for (let element = begin; element < begin + tubes.chunks.elements[chunk]!; ++element) {
      if (tubes.hidden[element] === 1) continue;
      const hit = { element, chunk, ...closest(origin, direction, node(element), node(element + 1)) };
      if (hit.miss > reach || !isIn(tubes.clip, plus(origin, direction, hit.along))) continue;
      if (best === null || isBefore(hit, best, radius)) best = hit;
    }
  }
  const contact = pickContact(dots, projection, tubes.clip, column, row);
  if (best === null) return null;
  const depth = best.along - Math.sqrt(Math.max(0, radius * radius - best.miss * best.miss));
  return {
    yarn: tubes.chunks.yarn[best.chunk]!,
    element: best.element,
    share: best.share,
    place: plus(origin, direction, depth),
    contact,
  };
}

/** What the line meets goes before what it misses; then what is nearer to the viewer, or to the line. */
function isBefore(a: Hit, b: Hit, radius: number): boolean {
  const meetsA = a.miss <= radius;
  const meetsB = b.miss <= radius;
  if (meetsA !== meetsB) return meetsA;
  return meetsA ? a.along < b.along : a.miss < b.miss;
}
