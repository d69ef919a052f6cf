// Colour of the yarns: what it tells, from where to where.

import { computed } from "@preact/signals";
import type { JSX } from "preact";
import { roundFigures } from "../parts/curve_data";
import { mapGradient } from "../view3d/colour_map";
import { allEnds, colourBy, ends, fieldHead, framesRead, range, type Range } from "./colouring";
import { frameList } from "./open_run";
import { nearest } from "./shown";

const fields = computed(() => nearest.value?.head.fields ?? []);
const kNumbersAt = [0, 0.5, 1];

export function ColourBar(): JSX.Element | null {
  const field = fieldHead.value;
  if (field === null || ends.value === null) return null;
  const [lowest, highest] = ends.value;
  return (
    <div class="colour-bar" role="img" aria-label={`${field.label} from ${roundFigures(lowest)} to ${roundFigures(highest)} ${field.unit}`}>
      <div class="bar-label">{`${field.label} [${field.unit}]`}</div>
      <div class="bar" style={{ background: mapGradient("to right") }} />
      <div class="bar-numbers">
        {kNumbersAt.map((share) => (
          <span key={share}>{roundFigures(lowest + share * (highest - lowest))}</span>
        ))}
      </div>
    </div>
  );
}

function setEnd(which: "lowest" | "highest", text: string): void {
  const now = range.value;
  const value = Number(text.replace(",", ".").replace("−", "-"));
  if (now.of !== "own" || text.trim() === "" || !Number.isFinite(value)) return;
  const next = { ...now, [which]: value };
  if (next.lowest < next.highest) range.value = next;
}

function OwnEnds({ lowest, highest }: { lowest: number; highest: number }): JSX.Element {
  const unit = fieldHead.value?.unit ?? "";
  return (
    <div class="own-ends">
      <input
        type="number"
        step="any"
        aria-label={`Lowest value in ${unit}`}
        value={Number(lowest.toPrecision(5))}
        onChange={(event) => setEnd("lowest", event.currentTarget.value)}
      />
      <span class="quiet">to</span>
      <input
        type="number"
        step="any"
        aria-label={`Highest value in ${unit}`}
        value={Number(highest.toPrecision(5))}
        onChange={(event) => setEnd("highest", event.currentTarget.value)}
      />
      <span class="quiet">{unit}</span>
    </div>
  );
}

function chooseRange(of: Range["of"]): void {
  if (of !== "own") range.value = { of };
  else if (ends.value !== null) range.value = { of, lowest: ends.value[0], highest: ends.value[1] };
}

function RangeChoice(): JSX.Element {
  const isReading = range.value.of === "all" && allEnds.value === null;
  return (
    <>
      <label class="choice">
        <span>Range</span>
        <select value={range.value.of} onChange={(event) => chooseRange(event.currentTarget.value as Range["of"])}>
          <option value="frame">this frame</option>
          <option value="all">all stored frames</option>
          <option value="own">own numbers</option>
        </select>
      </label>
      {isReading ? (
        <p class="quiet small" role="status">{`Reading frames: ${framesRead.value} of ${frameList.value.length}`}</p>
      ) : null}
      {range.value.of === "own" ? <OwnEnds lowest={range.value.lowest} highest={range.value.highest} /> : null}
    </>
  );
}

/** Numbers chosen for one field mean nothing for another. */
function chooseColour(name: string): void {
  colourBy.value = name;
  if (range.value.of === "own") range.value = { of: "frame" };
}

export function ColourPanel(): JSX.Element {
  return (
    <section class="group" aria-labelledby="colour-title">
      <h2 id="colour-title">Colour</h2>
      <label class="choice">
        <span>By</span>
        <select value={colourBy.value} onChange={(event) => chooseColour(event.currentTarget.value)}>
          <option value="course">course</option>
          <option value="plain">one colour</option>
          {fields.value.map((field) => (
            <option key={field.name} value={field.name}>
              {`${field.label.toLowerCase()} [${field.unit}]`}
            </option>
          ))}
        </select>
      </label>
      {fieldHead.value === null ? null : <RangeChoice />}
      {fieldHead.value === null ? null : (
        <p class="quiet small">{`Values of ${frameName()}. Grey: not a number.`}</p>
      )}
    </section>
  );
}

export function frameName(): string {
  const index = nearest.value?.head.index;
  return index === null || index === undefined ? "the newest state" : `stored frame ${index}`;
}
