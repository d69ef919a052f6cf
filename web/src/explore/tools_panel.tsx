// Layers, measuring and sections.

import type { JSX } from "preact";
import type { Box, Vec3 } from "../view3d/types";
import { room } from "./open_run";
import * as selection from "./selection";
import { nearest } from "./shown";
import { clip } from "./view_words";
import { mm } from "./words";

export function LayersPanel(): JSX.Element {
  const count = nearest.value?.head.contacts ?? 0;
  return (
    <section class="group" aria-labelledby="layers-title">
      <h2 id="layers-title">Layers</h2>
      <label class="tick">
        <input
          type="checkbox"
          checked={selection.showsContacts.value}
          onChange={(event) => (selection.showsContacts.value = event.currentTarget.checked)}
        />
        <span>Contacts</span>
        <span class="quiet small">{count === 0 ? "none at this strain" : `${count}, area by force`}</span>
      </label>
      {selection.showsContacts.value ? (
        <p class="contact-key small quiet">
          <i class="stick" /> stick <i class="slip" /> slip
        </p>
      ) : null}
    </section>
  );
}

function Distance({ from, to }: { from: Vec3; to: Vec3 }): JSX.Element {
  const parts = [0, 1, 2].map((axis) => to[axis]! - from[axis]!);
  return (
    <dl class="place-values" data-test="distance">
      <dt>Distance</dt>
      <dd>{mm(Math.hypot(...parts))}</dd>
      {["x", "y", "z"].map((name, axis) => [<dt key={name}>{`d${name}`}</dt>, <dd key={`${name} value`}>{mm(parts[axis]!)}</dd>])}
    </dl>
  );
}

const kMeasureHelp = [
  "Click on two yarns. What is measured is the distance of their axes there.",
  "Click on the second yarn.",
  "The points go with the yarns when the strain changes.",
];

export function MeasurePanel(): JSX.Element {
  const [from, to] = selection.measuredPoints.value;
  const isOn = selection.tool.value === "measure";
  const count = selection.measured.value.length;
  return (
    <section class="group" aria-labelledby="measure-title">
      <h2 id="measure-title">Measure</h2>
      <div class="buttons">
        <button type="button" aria-pressed={isOn} onClick={() => (selection.tool.value = isOn ? "pick" : "measure")}>
          {isOn ? "Stop measuring" : "Measure a distance"}
        </button>
        {count > 0 ? (
          <button type="button" onClick={() => (selection.measured.value = [])}>
            Clear
          </button>
        ) : null}
      </div>
      {from !== undefined && to !== undefined ? <Distance from={from} to={to} /> : null}
      {isOn || count > 0 ? <p class="quiet small">{kMeasureHelp[count]}</p> : null}
    </section>
  );
}

type End = "lowest" | "highest";

function setEnd(whole: Box, end: End, axis: number, value: number): void {
  const now = clip.value ?? whole;
  const moved = now[end].map((x, i) => (i === axis ? value : x)) as unknown as Vec3;
  const next = { ...now, [end]: moved };
  if (next.lowest[axis]! <= next.highest[axis]!) clip.value = next;
}

function EndSlider({ whole, axis, end }: { whole: Box; axis: number; end: End }): JSX.Element {
  const [low, high] = [whole.lowest[axis]!, whole.highest[axis]!];
  const value = (clip.value ?? whole)[end][axis]!;
  const name = `${"xyz"[axis]} ${end === "lowest" ? "from" : "to"}`;
  return (
    <label class="section-slider">
      <span>{name}</span>
      <input
        type="range"
        min={low}
        max={high}
        step={(high - low) / 400}
        value={value}
        onInput={(event) => {
          setEnd(whole, end, axis, Number(event.currentTarget.value));
          event.currentTarget.value = String((clip.value ?? whole)[end][axis]);
        }}
      />
      <output>{`${value.toFixed(2).replace("-", "−")} mm`}</output>
    </label>
  );
}

export function SectionPanel(): JSX.Element | null {
  const whole = room.value;
  if (whole === null) return null;
  return (
    <details class="group" open={clip.value !== null}>
      <summary>
        <h2>Section</h2>
        <span class="quiet small">{clip.value === null ? "whole fabric" : "cut"}</span>
      </summary>
      {[0, 1, 2].map((axis) => (
        <div key={axis}>
          <EndSlider whole={whole} axis={axis} end="lowest" />
          <EndSlider whole={whole} axis={axis} end="highest" />
        </div>
      ))}
      <div class="buttons">
        <button type="button" disabled={clip.value === null} onClick={() => (clip.value = null)}>
          Whole fabric
        </button>
      </div>
    </details>
  );
}
