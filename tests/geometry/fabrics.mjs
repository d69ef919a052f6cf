// What the tests of exported geometry share: a folder with small fabrics in it, exports of them, and the centrelines by
// which they are judged.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { newFolder, runProgram, smallCase } from "../browser/harness.mjs";

/** 3 x 3 stitches with turning arcs of a yarn half as thick. */
const joinedCase = () =>
  smallCase("Joined courses").replace(/^\[test\]/m, '[edge_yarn]\ndiameter = "0.06 mm"\n\n[test]').replace(/^courses = 3/m, 'courses = 3\nstructure = "adjusted"');

/** Pulled until its yarns break, and farther. */
const breakingCase = () =>
  smallCase("Breaking yarns")
    .replace(/^\[yarn\]/m, '[yarn]\nstrength = "0.5 mN"')
    .replace(/^\[test\]/m, '[test]\non_break = "go on"');

/** A folder with joined.toml and the runs results/jersey and results/broken. */
export function makeFabrics() {
  const folder = newFolder();
  writeFileSync(join(folder, "joined.toml"), joinedCase());
  writeFileSync(join(folder, "jersey.toml"), smallCase());
  writeFileSync(join(folder, "broken.toml"), breakingCase());
  for (const name of ["jersey", "broken"]) runProgram(folder, "run", `${name}.toml`, "--no-pictures", "--quiet");
  return folder;
}

/** The bytes of an export: exported(folder, "results/jersey", "gltf", "--sides", 8). */
export function exported(folder, source, format, ...words) {
  const file = join(folder, "exported");
  runProgram(folder, "export", source, "-f", format, "-o", file, ...words.map(String));
  return readFileSync(file);
}

/** The yarns of a CSV export: rows of points [mm], each yarn with its radius [mm]. */
export function yarnsOfCsv(text) {
  const [head, ...lines] = text.trimEnd().split("\n");
  assert.equal(head, "yarn,x_mm,y_mm,z_mm,radius_mm");
  const yarns = [];
  for (const line of lines) {
    const [yarn, x, y, z, radius] = line.split(",").map(Number);
    assert.ok([x, y, z, radius].every(Number.isFinite), line);
    (yarns[yarn - 1] ??= { radius, points: [] }).points.push([x, y, z]);
  }
  return yarns;
}

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export const lengthOf = (points) =>
  points.slice(1).reduce((sum, point, i) => sum + Math.hypot(...minus(point, points[i])), 0);

/** Lowest and highest coordinates of points. */
export function boxOf(points) {
  const box = { lowest: [Infinity, Infinity, Infinity], highest: [-Infinity, -Infinity, -Infinity] };
  for (const point of points) {
    for (let axis = 0; axis < 3; ++axis) {
      box.lowest[axis] = Math.min(box.lowest[axis], point[axis]);
      box.highest[axis] = Math.max(box.highest[axis], point[axis]);
    }
  }
  return box;
}
