// Where the viewer stands: turning, moving and zooming a CameraState, and the way from it to the screen.

import { Matrix4, type Camera } from "three";
import type { Box, CameraState, Vec3, ViewName } from "./types";

const kFieldOfView = (28 * Math.PI) / 180; // of the perspective, upright
const kMargin = 1.06; // room around a whole fabric
const kSteepest = 90; // degrees of elevation

const kAngles: Record<ViewName, [number, number]> = {
  front: [0, 0],
  back: [180, 0],
  side: [90, 0],
  top: [0, 90],
  oblique: [38, 24],
};

export interface Axes {
  right: Vec3;
  up: Vec3;
  towards: Vec3; // the viewer
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const plus = (a: Vec3, b: Vec3, factor = 1): Vec3 => [
  a[0] + factor * b[0],
  a[1] + factor * b[1],
  a[2] + factor * b[2],
];

export function axesOf(state: CameraState): Axes {
  const azimuth = (state.azimuth * Math.PI) / 180;
  const elevation = (state.elevation * Math.PI) / 180;
  const [sa, ca, se, ce] = [Math.sin(azimuth), Math.cos(azimuth), Math.sin(elevation), Math.cos(elevation)];
  return { right: [ca, 0, -sa], up: [-sa * se, ce, -ca * se], towards: [sa * ce, se, ca * ce] };
}

export function cornersOf(box: Box): Vec3[] {
  const ends = [box.lowest, box.highest];
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
    (ends[i & 1] as Vec3)[0],
    (ends[(i >> 1) & 1] as Vec3)[1],
    (ends[i >> 2] as Vec3)[2],
  ]);
}

const middleOf = (box: Box): Vec3 => [0, 1, 2].map((i) => 0.5 * (box.lowest[i]! + box.highest[i]!)) as unknown as Vec3;

/** Moves and zooms so that the box fills a view of some size, but for a strip at its top [px]. */
export function fitted(state: CameraState, box: Box, width: number, height: number, strip: number): CameraState {
  const axes = axesOf(state);
  const free = Math.max(height - strip, height / 2);
  const target = middleOf(box);
  let [across, upright, near] = [0, 0, 0];
  for (const corner of cornersOf(box)) {
    const from = plus(corner, target, -1);
    across = Math.max(across, Math.abs(dot(from, axes.right)));
    upright = Math.max(upright, Math.abs(dot(from, axes.up)));
    near = Math.max(near, dot(from, axes.towards));
  }
  const flat = 2 * kMargin * Math.max((upright * height) / free, (across * height) / width);
  const span = state.orthographic ? flat : flat + 2 * near * Math.tan(kFieldOfView / 2);
  const down = (0.5 * span * (height - free)) / height;
  return { ...state, target: plus(target, axes.up, down), span: Math.max(span, 1e-6) };
}

/** From a named view; the azimuth takes the shorter way round. */
export function seenFrom(state: CameraState, view: ViewName): CameraState {
  const [azimuth, elevation] = kAngles[view];
  const turns = Math.round((state.azimuth - azimuth) / 360);
  return { ...state, azimuth: azimuth + 360 * turns, elevation };
}

export function turned(state: CameraState, azimuth: number, elevation: number): CameraState {
  const steep = Math.min(kSteepest, Math.max(-kSteepest, state.elevation + elevation));
  return { ...state, azimuth: state.azimuth + azimuth, elevation: steep };
}

/** Moves the fabric by shares of the view's height, to the right and up. */
export function moved(state: CameraState, right: number, up: number): CameraState {
  const axes = axesOf(state);
  const target = plus(plus(state.target, axes.right, -right * state.span), axes.up, -up * state.span);
  return { ...state, target };
}

/** Zooms in by a factor; the point at a place of the view (shares of its height from the middle) stays where it is. */
export function zoomed(state: CameraState, factor: number, right: number, up: number): CameraState {
  const after = { ...state, span: state.span / factor };
  return moved(after, right * (1 - factor), up * (1 - factor));
}

const kDegreesOfRest = 0.01;

/** A state on the way from one to the other; null when they are as good as the same. */
export function stateBetween(from: CameraState, to: CameraState, share: number): CameraState | null {
  const distance = Math.hypot(...plus(from.target, to.target, -1)) / to.span;
  const angle = Math.abs(from.azimuth - to.azimuth) + Math.abs(from.elevation - to.elevation);
  const zoom = Math.abs(Math.log(from.span / to.span));
  if (distance < 2e-4 && angle < kDegreesOfRest && zoom < 2e-4) return null;
  const mix = (a: number, b: number): number => a + (b - a) * share;
  return {
    azimuth: mix(from.azimuth, to.azimuth),
    elevation: mix(from.elevation, to.elevation),
    target: plus(from.target, plus(to.target, from.target, -1), share),
    span: from.span * (to.span / from.span) ** share,
    orthographic: to.orthographic,
  };
}

/** The way from mm to a view of some size in pixels. */
export class Projection {
  readonly axes: Axes;
  readonly eye: Vec3;
  readonly pixelsPerMm: number; // at the target
  private readonly distance: number; // from the eye to the target
  private readonly matrix = new Matrix4();

  constructor(
    readonly state: CameraState,
    readonly width: number,
    readonly height: number,
    box: Box,
  ) {
    this.axes = axesOf(state);
    const depths = cornersOf(box).map((corner) => dot(plus(corner, state.target, -1), this.axes.towards));
    const nearest = Math.max(...depths);
    this.distance = state.orthographic
      ? Math.max(nearest, 0) + state.span
      : state.span / (2 * Math.tan(kFieldOfView / 2));
    this.eye = plus(state.target, this.axes.towards, this.distance);
    this.pixelsPerMm = height / state.span;
    this.fillMatrix(this.distance - nearest, this.distance - Math.min(...depths));
  }

  private fillMatrix(nearest: number, farthest: number): void {
    const far = Math.max(farthest, 1e-3 * this.distance) * 1.01 + 1e-6;
    const near = Math.min(Math.max(nearest * 0.99 - 1e-6, 2e-3 * this.distance), 0.999 * far);
    const half = this.state.orthographic ? this.state.span / 2 : near * Math.tan(kFieldOfView / 2);
    const across = (half * this.width) / this.height;
    if (this.state.orthographic) this.matrix.makeOrthographic(-across, across, half, -half, near, far);
    else this.matrix.makePerspective(-across, across, half, -half, near, far);
  }

  applyTo(camera: Camera): void {
    const { right, up, towards } = this.axes;
    const e = this.eye;
    // prettier-ignore
    camera.matrixWorld.set(
      right[0], up[0], towards[0], e[0],
      right[1], up[1], towards[1], e[1],
      right[2], up[2], towards[2], e[2],
      0, 0, 0, 1);
    camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
    camera.projectionMatrix.copy(this.matrix);
    camera.projectionMatrixInverse.copy(this.matrix).invert();
  }

  /** Size of a mm at a point [px]; 0 behind the eye. */
  scaleAt(point: Vec3): number {
    if (this.state.orthographic) return this.pixelsPerMm;
    const depth = dot(plus(this.eye, point, -1), this.axes.towards);
    return depth > 0 ? (this.pixelsPerMm * this.distance) / depth : 0;
  }

  /** Place of a point in the view [px], from the upper left corner. */
  placeOf(point: Vec3): [number, number] {
    const scale = this.scaleAt(point);
    const from = plus(point, this.state.target, -1);
    return [
      this.width / 2 + scale * dot(from, this.axes.right),
      this.height / 2 - scale * dot(from, this.axes.up),
    ];
  }

  /** The line of sight through a place of the view [px]. */
  rayThrough(column: number, row: number): { origin: Vec3; direction: Vec3 } {
    const right = (column - this.width / 2) / this.pixelsPerMm;
    const up = (this.height / 2 - row) / this.pixelsPerMm;
    const onTarget = plus(plus(this.state.target, this.axes.right, right), this.axes.up, up);
    if (this.state.orthographic) {
      const back: Vec3 = [-this.axes.towards[0], -this.axes.towards[1], -this.axes.towards[2]];
      return { origin: plus(onTarget, this.axes.towards, this.distance), direction: back };
    }
    const along = plus(onTarget, this.eye, -1);
    const length = Math.hypot(...along);
    return { origin: this.eye, direction: [along[0] / length, along[1] / length, along[2] / length] };
  }
}
