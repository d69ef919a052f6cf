// The elements of a fabric in short runs with the boxes around them, so that what is out of sight, cut away or far from a
// line of sight is left out run by run.

import type { FabricHead } from "../api/types";
import type { Box, Vec3 } from "./types";

const kElementsOfChunk = 48;

export class Chunks {
  readonly count: number;
  readonly first: Int32Array; // element
  readonly elements: Int32Array; // number of them
  readonly yarn: Int32Array;
  readonly boxes: Float32Array; // lowest and highest x, y, z of each
  box: Box = { lowest: [0, 0, 0], highest: [0, 0, 0] }; // around all that is a number
  private readonly room: number; // from the centreline to the yarn's surface, and what the curve bulges

  constructor(fabric: FabricHead) {
    const runs: [number, number, number][] = [];
    fabric.yarns.forEach((yarn, index) => {
      for (let done = 0; done < yarn.nodes - 1; done += kElementsOfChunk)
        runs.push([yarn.first_node + done, Math.min(kElementsOfChunk, yarn.nodes - 1 - done), index]);
    });
    this.count = runs.length;
    this.first = Int32Array.from(runs, (run) => run[0]);
    this.elements = Int32Array.from(runs, (run) => run[1]);
    this.yarn = Int32Array.from(runs, (run) => run[2]);
    this.boxes = new Float32Array(6 * runs.length);
    this.room = 0.75 * Math.max(fabric.diameter, fabric.edge_diameter ?? 0);
  }

  /** Finds the boxes for new positions. */
  follow(positions: Float32Array): void {
    const whole = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let chunk = 0; chunk < this.count; ++chunk) {
      const begin = 3 * this.first[chunk]!;
      const end = begin + 3 * (this.elements[chunk]! + 1);
      for (let axis = 0; axis < 3; ++axis) {
        let lowest = Infinity;
        let highest = -Infinity;
        for (let i = begin + axis; i < end; i += 3) {
          const x = positions[i]!;
          if (x < lowest) lowest = x;
          if (x > highest && x < Infinity) highest = x;
        }
        this.boxes[6 * chunk + axis] = lowest - this.room;
        this.boxes[6 * chunk + 3 + axis] = highest + this.room;
        whole[axis] = Math.min(whole[axis]!, lowest - this.room);
        whole[3 + axis] = Math.max(whole[3 + axis]!, highest + this.room);
      }
    }
    if (whole.every(Number.isFinite))
      this.box = { lowest: whole.slice(0, 3) as unknown as Vec3, highest: whole.slice(3) as unknown as Vec3 };
  }

  overlaps(chunk: number, box: Box): boolean {
    for (let axis = 0; axis < 3; ++axis) {
      if (this.boxes[6 * chunk + axis]! > box.highest[axis]!) return false;
      if (this.boxes[6 * chunk + 3 + axis]! < box.lowest[axis]!) return false;
    }
    return true;
  }

  /** Whether some of the box is on the inner side of all planes, each a, b, c, d with a x + b y + c z + d >= 0 inside. */
  isInside(chunk: number, planes: readonly (readonly [number, number, number, number])[]): boolean {
    const at = 6 * chunk;
    return planes.every(([a, b, c, d]) => {
      const x = this.boxes[at + (a > 0 ? 3 : 0)]!;
      const y = this.boxes[at + 1 + (b > 0 ? 3 : 0)]!;
      const z = this.boxes[at + 2 + (c > 0 ? 3 : 0)]!;
      return a * x + b * y + c * z + d >= 0;
    });
  }

  /** Whether a line comes within a distance of the box. */
  isMet(chunk: number, origin: Vec3, direction: Vec3, distance: number): boolean {
    let enter = -Infinity;
    let leave = Infinity;
    for (let axis = 0; axis < 3; ++axis) {
      const low = this.boxes[6 * chunk + axis]! - distance - origin[axis]!;
      const high = this.boxes[6 * chunk + 3 + axis]! + distance - origin[axis]!;
      const along = direction[axis]!;
      if (Math.abs(along) < 1e-12) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      enter = Math.max(enter, Math.min(low / along, high / along));
      leave = Math.min(leave, Math.max(low / along, high / along));
    }
    return leave >= Math.max(enter, 0);
  }
}
