// The part of a chart that is looked at: a drag takes a box, a drag with Shift moves, the wheel zooms about the pointer, a
// double click shows the whole again. What comes while a part is shown leaves it as it is.

import { signal } from "@preact/signals";
import type { JSX } from "preact";
import uPlot from "uplot";

type Span = [number, number];
interface Part {
  x: Span;
  y: Span;
}

const kStep = 1.5; // of a zoom by key or button
const kShift = 0.15; // of the width, of a move by key
const kLeastBox = 8; // px; a smaller drag is a click
const kDeepest = 1e-4; // of the whole

export const kZoomKeys = "Keys: arrows move, + and - zoom, 0 shows the whole.";

const around = ([low, high]: Span, middle: number, factor: number): Span => [middle + (low - middle) * factor, middle + (high - middle) * factor];
const moved = ([low, high]: Span, by: number): Span => [low + by, high + by];
const middleOf = ([low, high]: Span): number => (low + high) / 2;

export class ChartZoom {
  part: Part | null = null; // null: the whole
  readonly isPart = signal(false);
  readonly drag: uPlot.Cursor.Drag = { x: true, y: true, uni: 24, dist: kLeastBox, setScale: false };
  private plot: uPlot | null = null;

  /** Works on this plot from now on. */
  take(plot: uPlot): void {
    this.plot = plot;
    plot.hooks.setSelect = [...(plot.hooks.setSelect ?? []), () => this.showSelected()];
    plot.over.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    plot.over.addEventListener("dblclick", () => this.showWhole());
    plot.over.addEventListener("mousedown", (event) => event.shiftKey && event.button === 0 && this.beginMove(event), { capture: true });
  }

  showWhole = (): void => this.show(null);

  zoom(factor: number): void {
    const now = this.now();
    if (now !== null) this.show({ x: around(now.x, middleOf(now.x), factor), y: around(now.y, middleOf(now.y), factor) });
  }

  zoomIn = (): void => this.zoom(1 / kStep);
  zoomOut = (): void => this.zoom(kStep);

  onKey = (event: KeyboardEvent): void => {
    const action = this.actionOf(event.key);
    if (action === null || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  };

  private actionOf(key: string): (() => void) | null {
    const actions: Record<string, () => void> = {
      "+": this.zoomIn,
      "=": this.zoomIn,
      "-": this.zoomOut,
      "0": this.showWhole,
      ArrowLeft: () => this.move(-kShift, 0),
      ArrowRight: () => this.move(kShift, 0),
      ArrowUp: () => this.move(0, kShift),
      ArrowDown: () => this.move(0, -kShift),
    };
    return actions[key] ?? null;
  }

  private now(): Part | null {
    const { x, y } = this.plot?.scales ?? {};
    if (x?.min == null || x.max == null || y?.min == null || y.max == null) return null;
    return { x: [x.min, x.max], y: [y.min, y.max] };
  }

  private show(part: Part | null): void {
    const strains = this.plot?.data[0] ?? [];
    const whole = (strains.at(-1) ?? 1) - (strains[0] ?? 0);
    if (part !== null && part.x[1] - part.x[0] < kDeepest * whole) return; // numbers have no more figures than that
    this.part = part;
    this.isPart.value = part !== null;
    this.plot?.setData(this.plot.data, true);
  }

  /** By shares of what is shown. */
  private move(right: number, up: number): void {
    const now = this.now();
    if (now === null) return;
    this.show({ x: moved(now.x, right * (now.x[1] - now.x[0])), y: moved(now.y, up * (now.y[1] - now.y[0])) });
  }

  private showSelected(): void {
    const plot = this.plot;
    if (plot === null || (plot.select.width < kLeastBox && plot.select.height < kLeastBox)) return;
    const { left, top, width, height } = plot.select;
    const part: Part = {
      x: [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")],
      y: [plot.posToVal(top + height, "y"), plot.posToVal(top, "y")],
    };
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.show(part);
  }

  private onWheel(event: WheelEvent): void {
    const plot = this.plot;
    const now = this.now();
    if (plot === null || now === null) return;
    event.preventDefault();
    const box = plot.over.getBoundingClientRect();
    const factor = Math.exp(Math.max(-0.5, Math.min(0.5, event.deltaY / 400)));
    this.show({
      x: around(now.x, plot.posToVal(event.clientX - box.left, "x"), factor),
      y: around(now.y, plot.posToVal(event.clientY - box.top, "y"), factor),
    });
  }

  private beginMove(event: MouseEvent): void {
    const begin = this.now();
    const plot = this.plot;
    if (begin === null || plot === null) return;
    event.stopImmediatePropagation(); // no box
    event.preventDefault();
    const perPixel = { x: (begin.x[1] - begin.x[0]) / plot.over.clientWidth, y: (begin.y[1] - begin.y[0]) / plot.over.clientHeight };
    const onMove = (now: MouseEvent): void =>
      this.show({
        x: moved(begin.x, (event.clientX - now.clientX) * perPixel.x),
        y: moved(begin.y, (now.clientY - event.clientY) * perPixel.y),
      });
    const onUp = (): void => {
      removeEventListener("mousemove", onMove);
      removeEventListener("mouseup", onUp);
    };
    addEventListener("mousemove", onMove);
    addEventListener("mouseup", onUp);
  }
}

export function ZoomButtons({ zoom }: { zoom: ChartZoom }): JSX.Element {
  return (
    <div class="zoom-buttons" role="toolbar" aria-label="Part of the chart that is shown">
      <button type="button" onClick={zoom.zoomIn} aria-label="Zoom in" title="Zoom in (+); or drag a box, or turn the wheel">
        +
      </button>
      <button type="button" onClick={zoom.zoomOut} aria-label="Zoom out" title="Zoom out (-)">
        −
      </button>
      <button type="button" onClick={zoom.showWhole} disabled={!zoom.isPart.value} title="Show the whole chart (0, or a double click). Drag with Shift to move">
        Whole
      </button>
    </div>
  );
}
