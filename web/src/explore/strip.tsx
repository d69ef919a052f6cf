// The foot of the page: to go through the strain, and the curve of the run.

import { computed } from "@preact/signals";
import type { JSX } from "preact";
import { CurveChart } from "../parts/curve_chart";
import { figures } from "../parts/curve_data";
import { runs } from "../state/runs";
import { curve, frameList, opened } from "./open_run";
import { force, goToStrain, isLive, isPlaying, shown, stepFrame, strain, togglePlay } from "./shown";
import { percent } from "./words";

const kSteps = 500; // of the slider, over all strains

const curves = computed(() => (curve.value === null ? [] : [curve.value]));

/** Which stored frames the picture comes from. */
const source = computed(() => {
  const now = shown.value;
  if (now === null) return "";
  if (now.before.head.index === null) return "as it is now";
  if (now.after === null) return `stored frame ${now.before.head.index}`;
  return `between stored frames ${now.before.head.index} and ${now.after.head.index}`;
});

function Marks({ first, last }: { first: number; last: number }): JSX.Element {
  return (
    <div class="frame-marks" aria-hidden="true">
      {frameList.value.map((frame) => (
        <i key={frame.index} style={{ left: `${(100 * (frame.strain - first)) / (last - first || 1)}%` }} />
      ))}
    </div>
  );
}

function Slider(): JSX.Element {
  const first = frameList.value[0]?.strain ?? 0;
  const last = frameList.value.at(-1)?.strain ?? 0;
  const now = Math.min(last, shown.value?.strain ?? strain.value);
  return (
    <div class="strain-slider">
      <input
        type="range"
        min={100 * first}
        max={100 * last}
        step={Math.max((100 * (last - first)) / kSteps, 1e-9)}
        value={100 * now}
        disabled={frameList.value.length < 2}
        aria-label="Strain"
        aria-valuetext={`${percent(now)}, ${source.value}`}
        onInput={(event) => goToStrain(Number(event.currentTarget.value) / 100)}
      />
      <Marks first={first} last={last} />
    </div>
  );
}

function LiveButton(): JSX.Element | null {
  const head = runs.value.get(opened.value?.id ?? "");
  if (head === undefined || !head.active) return null;
  return (
    <button
      type="button"
      aria-pressed={isLive.value}
      disabled={head.live === 0}
      title="Follow the run as it goes on"
      onClick={() => (isLive.value = !isLive.value)}
    >
      Live
    </button>
  );
}

function Reading(): JSX.Element {
  const now = shown.value;
  return (
    <div class="strain-reading" role="status">
      <b>{now === null ? "" : percent(now.strain)}</b>
      <b>{force.value === null ? "" : `${figures(force.value)} N`}</b>
      <span class="quiet" data-test="frame-source">
        {source.value}
      </span>
    </div>
  );
}

function Icon({ path }: { path: string }): JSX.Element {
  return (
    <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
      <path d={path} fill="currentColor" />
    </svg>
  );
}

export function Strip(): JSX.Element {
  const isStill = frameList.value.length < 2;
  return (
    <section class="explore-strip" aria-label="Strain and curve">
      <div class="scrub">
        <button type="button" onClick={() => stepFrame(-1)} disabled={isStill} aria-label="Stored frame before" title="Stored frame before">
          <Icon path="M3 2h2v12H3zM13 2v12L6 8z" />
        </button>
        <button type="button" class="play" onClick={togglePlay} disabled={isStill} aria-label={isPlaying.value ? "Pause" : "Play"} title={isPlaying.value ? "Pause" : "Play"}>
          <Icon path={isPlaying.value ? "M4 2h3v12H4zM9 2h3v12H9z" : "M4 2l9 6-9 6z"} />
        </button>
        <button type="button" onClick={() => stepFrame(1)} disabled={isStill} aria-label="Next stored frame" title="Next stored frame">
          <Icon path="M11 2h2v12h-2zM3 2v12l7-6z" />
        </button>
        <Slider />
        <LiveButton />
        <Reading />
      </div>
      <div class="explore-curve">
        {curves.value.length === 0 ? null : (
          <CurveChart
            curves={curves.value}
            unit="N"
            label="Force over strain, with a mark at the shown strain"
            marker={shown.value?.strain ?? null}
            onPickStrain={goToStrain}
          />
        )}
      </div>
    </section>
  );
}
