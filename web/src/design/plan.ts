// Where things of the loop are in its drawing: x and y in mm become pixels, the yarn becomes lines.

import type { LoopDrawing } from "../api/types";

export type Point = [number, number];

export interface Size {
  width: number; // px
  height: number;
}

export interface Plan {
  scale: number; // px per mm
  at: (x: number, y: number) => Point; // mm, from the middle of the ERC's stitch, to px
  band: number; // px, width of the yarn
}

const kMargins = { left: 78, right: 176, top: 36, bottom: 60 }; // px, for the dimensions and the side view

const kMostSpacing = 1.5; // of H, for which the drawing makes room

/** Two stitches wide and one loop or course spacing high, as large as the place allows. */
export function planOf({ width: L, height: H, course_spacing, diameter }: LoopDrawing, { width, height }: Size): Plan {
  const across = Math.max(width - kMargins.left - kMargins.right, 40);
  const down = Math.max(height - kMargins.top - kMargins.bottom, 40);
  const shown = Math.max(H, Math.min(course_spacing ?? 0, kMostSpacing * H));
  const scale = Math.min(across / (2 * L), down / (shown + diameter));
  const middle = kMargins.left + across / 2;
  const centre = kMargins.top + down / 2 + ((shown - H) / 2) * scale;
  return { scale, band: Math.max(diameter * scale, 1), at: (x, y) => [middle + x * scale, centre - y * scale] };
}

/** The centreline of the ERC in plan, moved: mirrored at the middle of the head, by wales and by courses. */
export function ercPoints({ path, width, course_spacing }: LoopDrawing, side: 1 | -1, wales: number, courses: number): Point[] {
  return path.map(([x, y]) => [side * x + wales * width, y + courses * (course_spacing ?? 0)]);
}

export function pathOf(points: Point[], plan: Plan): string {
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${plan.at(x, y).map((each) => each.toFixed(2)).join(" ")}`).join("");
}

/** The part of a line above a height, where a course lies in front of the one below it. The line comes from above. */
export function above(points: Point[], height: number): Point[] {
  const end = points.findIndex(([, y]) => y < height);
  if (end <= 0) return end === 0 ? [] : points;
  const [[xa, ya], [xb, yb]] = [points[end - 1] as Point, points[end] as Point];
  const share = (ya - height) / (ya - yb);
  return [...points.slice(0, end), [xa + share * (xb - xa), height]];
}

/** The point of the leg at a share of its length from the head, in mm. */
export function onLeg({ points: { P3, P4 } }: LoopDrawing, share: number): Point {
  return [P3[0] + share * (P4[0] - P3[0]), P3[1] + share * (P4[1] - P3[1])];
}
