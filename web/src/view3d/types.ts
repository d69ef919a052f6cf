// What the 3-D view of the fabric shows and tells. Lengths are mm; a yarn is its index in FabricHead.yarns, an element the
// index of its first node.

export type Vec3 = readonly [number, number, number];

/** What the colours of the yarns tell. A value that is not a finite number is drawn grey. */
export type FabricColouring =
  | { by: "course" }
  | { by: "plain" }
  | {
      by: "field";
      values: Float32Array; // one per node
      ofElements: boolean; // the value at a node is that of the element that begins there
      lowest: number; // ends of the colour map
      highest: number;
    };

/** Contacts as discs whose area is in proportion to the force. */
export interface ContactLayer {
  positions: Float32Array; // 3 a contact
  force: Float32Array; // N
  slips: Int32Array; // 0 stick, 1 slip
  largest: number; // N, of the largest disc
  hidden?: Uint8Array | undefined; // 1: not drawn
}

export interface Box {
  lowest: Vec3;
  highest: Vec3;
}
export type ClipBox = Box;

export interface Highlight {
  yarn?: number | undefined;
  element?: number | undefined;
  contact?: number | undefined; // index in the ContactLayer
  alone?: boolean | undefined; // only that yarn is drawn
}

/** From where the fabric is seen: angles in degrees around the target, 0 0 from the front. */
export interface CameraState {
  azimuth: number;
  elevation: number;
  target: Vec3;
  span: number; // height of the view at the target
  orthographic: boolean;
}

export interface Picked {
  yarn: number;
  element: number;
  share: number; // of the element, from its first node to the next
  place: Vec3; // on the surface of the yarn
  contact: number | null;
}

/** A measured length, or one point of it. */
export interface Mark {
  from: Vec3;
  to: Vec3 | null;
  text: string;
}

export const viewNames = ["front", "back", "side", "top", "oblique"] as const;
export type ViewName = (typeof viewNames)[number];

/** Colours of the theme, sRGB as 0 to 1. */
export interface ViewColours {
  back: Vec3;
  text: Vec3;
  courses: readonly [Vec3, Vec3];
  plain: Vec3;
  unknown: Vec3;
  picked: Vec3;
  stick: Vec3;
  slip: Vec3;
}
