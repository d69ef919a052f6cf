// The stored frames of a run, read when they are needed; those looked at last are kept.

import type { Blob } from "../api/blob";
import * as client from "../api/client";
import type { FrameHead } from "../api/types";

const kBytesKept = 300e6;

/** A frame with its arrays taken out of the answer. */
export interface LoadedFrame {
  head: FrameHead;
  positions: Float32Array;
  broken: Int32Array;
  fields: ReadonlyMap<string, Float32Array>;
  contacts: Contacts;
}

export interface Contacts {
  positions: Float32Array;
  normalForce: Float32Array; // N
  friction: Float32Array; // N
  gap: Float32Array; // mm
  slip: Float32Array; // mm
  slips: Int32Array; // 0 or 1
  yarns: Int32Array; // 2 a contact
  places: Float32Array; // 2 a contact, mm along those yarns
}

export function unpacked(blob: Blob<FrameHead>): LoadedFrame {
  return {
    head: blob.head,
    positions: blob.floats("positions"),
    broken: blob.integers("broken"),
    fields: new Map(blob.head.fields.map((field) => [field.name, blob.floats(field.name)])),
    contacts: {
      positions: blob.floats("contact_positions"),
      normalForce: blob.floats("contact_normal_force"),
      friction: blob.floats("contact_friction"),
      gap: blob.floats("contact_gap"),
      slip: blob.floats("contact_slip"),
      slips: blob.integers("contact_slips"),
      yarns: blob.integers("contact_yarns"),
      places: blob.floats("contact_places"),
    },
  };
}

export class FrameStore {
  private readonly kept = new Map<number, Promise<LoadedFrame>>(); // looked at last comes last
  private readonly ready = new Map<number, LoadedFrame>();

  constructor(private readonly id: string) {}

  /** The frame if it has been read. */
  at(index: number): LoadedFrame | undefined {
    return this.ready.get(index);
  }

  read(index: number): Promise<LoadedFrame> {
    const known = this.kept.get(index);
    if (known !== undefined) {
      this.kept.delete(index);
      this.kept.set(index, known);
      return known;
    }
    const asked = client.frame(this.id, index).then((blob) => {
      const frame = unpacked(blob);
      this.ready.set(index, frame);
      this.forget(frame.positions.buffer.byteLength);
      return frame;
    });
    asked.catch(() => this.kept.delete(index)); // the next reading asks again
    this.kept.set(index, asked);
    return asked;
  }

  private forget(bytesOfOne: number): void {
    const most = Math.max(3, Math.floor(kBytesKept / bytesOfOne));
    for (const index of this.kept.keys()) {
      if (this.kept.size <= most) return;
      this.kept.delete(index);
      this.ready.delete(index);
    }
  }
}
