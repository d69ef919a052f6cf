// A chart of force-strain curves with a legend that reads them at the pointer or at the marked strain. It fills its box.

import "uplot/dist/uPlot.min.css";

import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import uPlot from "uplot";
import { theme } from "../state/theme";
import { ChartZoom, kZoomKeys, ZoomButtons } from "./chart_zoom";
import { alignedData, figures, forceAt, kPaletteSize, type Curve } from "./curve_data";

export type { Curve } from "./curve_data";

export interface CurveChartProps {
  curves: readonly Curve[];
  unit: string; // of the forces: "N", "N/mm"
  label: string; // for those who do not see the chart
  quantity?: string | undefined; // left out: "Force"
  marker?: number | null | undefined; // a strain, as a share: a line across, dots on the curves
  onPickStrain?: ((strain: number) => void) | undefined; // a click, or a drag along the chart
  reach?: number | undefined; // a strain that the chart shows in any case, so that a growing curve has its room
  zoomable?: boolean | undefined; // by wheel, drag, keys and buttons; not together with onPickStrain
}

const kFont = "12px system-ui, 'Segoe UI', 'Noto Sans', 'DejaVu Sans', sans-serif";

const token = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const paletteToken = (curve: Curve, place: number): string => `--curve-${((curve.colour ?? place) % kPaletteSize) + 1}`;

/** What the drawing looks at while it draws. */
interface Drawn {
  curves: readonly Curve[];
  marker: number | null;
  reach: number;
}

function drawMarker(plot: uPlot, drawn: Drawn): void {
  if (drawn.marker === null) return;
  const paper = plot.ctx;
  const x = Math.round(plot.valToPos(100 * drawn.marker, "x", true)) + 0.5;
  const { left, top, width, height } = plot.bbox;
  if (x < left - 1 || x > left + width + 1) return;
  paper.save();
  paper.strokeStyle = token("--text");
  paper.lineWidth = devicePixelRatio;
  paper.beginPath();
  paper.moveTo(x, top);
  paper.lineTo(x, top + height);
  paper.stroke();
  drawn.curves.forEach((curve, place) => {
    const force = forceAt(curve, drawn.marker!);
    if (force === null) return;
    paper.beginPath();
    paper.arc(x, plot.valToPos(force, "y", true), 4 * devicePixelRatio, 0, 2 * Math.PI);
    paper.fillStyle = token(paletteToken(curve, place));
    paper.fill();
    paper.strokeStyle = token("--panel");
    paper.stroke();
  });
  paper.restore();
}

function seriesOf(curves: readonly Curve[]): { series: uPlot.Series[]; bands: uPlot.Band[] } {
  const series: uPlot.Series[] = [{}];
  const bands: uPlot.Band[] = [];
  curves.forEach((curve, place) => {
    const colour = token(paletteToken(curve, place));
    const dash = curve.dashed === true ? { dash: [6, 4] } : {};
    const look = curve.thin === true ? { width: 1, alpha: 0.55 } : { width: 1.75, ...dash };
    series.push({ stroke: colour, points: { show: false }, pxAlign: 0, ...look });
    if (curve.band === undefined) return;
    bands.push({ series: [series.length, series.length + 1], fill: `color-mix(in srgb, ${colour} 18%, transparent)` });
    series.push({ points: { show: false }, width: 0, pxAlign: 0 }, { points: { show: false }, width: 0, pxAlign: 0 });
  });
  if (curves.length === 0) series.push({});
  return { series, bands };
}

function axisOf(label: string): uPlot.Axis {
  return {
    label,
    labelFont: kFont,
    font: kFont,
    labelSize: 18,
    stroke: token("--quiet"),
    grid: { stroke: token("--line"), width: 1 },
    ticks: { stroke: token("--line"), width: 1, size: 4 },
  };
}

interface PlotEvents {
  point(strain: number | null): void;
  pick: ((strain: number) => void) | null; // null: nothing can be picked
}

function followPointer(plot: uPlot, events: PlotEvents): void {
  const strainAt = (event: PointerEvent): number => {
    const { min = 0, max = 0 } = plot.scales["x"] as { min?: number; max?: number };
    const x = plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x");
    return Math.min(max, Math.max(min, x)) / 100;
  };
  plot.over.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || events.pick === null) return;
    plot.over.setPointerCapture(event.pointerId);
    events.pick(strainAt(event));
  });
  plot.over.addEventListener("pointermove", (event) => {
    if (plot.over.hasPointerCapture(event.pointerId)) events.pick?.(strainAt(event));
    events.point(strainAt(event));
  });
  plot.over.addEventListener("pointerleave", () => events.point(null));
}

const wholeForce = (low: number | null, high: number | null): uPlot.Range.MinMax =>
  low === null || high === null ? [0, 1] : uPlot.rangeNum(low, high, 0.1, true);
const wholeStrain = (low: number | null, high: number | null, reach: number): uPlot.Range.MinMax => {
  if (low === null || high === null || (low === high && reach === 0)) return [0, reach === 0 ? 1 : 100 * reach];
  return [Math.min(0, low), Math.max(high, 100 * reach)];
};

function makePlot(box: HTMLElement, props: CurveChartProps, drawn: Drawn, events: PlotEvents, zoom: ChartZoom | null): uPlot {
  const { series, bands } = seriesOf(props.curves);
  const plot = new uPlot(
    {
      width: Math.max(50, box.clientWidth),
      height: Math.max(50, box.clientHeight),
      series,
      bands,
      scales: {
        x: { time: false, range: (_, low, high) => zoom?.part?.x ?? wholeStrain(low, high, drawn.reach) },
        y: { range: (_, low, high) => zoom?.part?.y ?? wholeForce(low, high) },
      },
      axes: [
        { ...axisOf("Strain [%]"), size: 26 },
        { ...axisOf(`${props.quantity ?? "Force"} [${props.unit}]`), size: 58, values: (_, ticks) => ticks.map(tickText) },
      ],
      legend: { show: false },
      cursor: { drag: zoom === null ? { x: false, y: false } : zoom.drag, y: false, points: { show: false } },
      hooks: { draw: [(self) => drawMarker(self, drawn)] },
      padding: [8, 14, 0, 4],
    },
    alignedData(props.curves),
    box,
  );
  followPointer(plot, events);
  zoom?.take(plot);
  return plot;
}

const tickText = (value: number): string => String(Number(value.toPrecision(6))).replace("-", "−");

/** What makes a new plot necessary: not the numbers, but how many curves there are and how they look. */
function shapeOf(props: CurveChartProps): string {
  const looks = props.curves.map((curve) => [curve.id, curve.band !== undefined, curve.colour, curve.dashed, curve.thin]);
  return JSON.stringify([theme.value, props.unit, props.quantity, looks]);
}

function Legend(props: CurveChartProps & { strain: number | null }): JSX.Element {
  const { strain } = props;
  return (
    <div class="curve-legend">
      {props.curves.map((curve, place) => {
        const force = strain === null ? null : forceAt(curve, strain);
        if (curve.thin === true) return null;
        return (
          <span key={curve.id} class="curve-name" title={curve.name}>
            <i class={curve.dashed === true ? "dashed" : undefined} style={{ borderColor: `var(${paletteToken(curve, place)})` }} />
            <span>{curve.name}</span>
            {force === null ? null : <b>{`${figures(force)} ${props.unit}`}</b>}
          </span>
        );
      })}
      <span class="spread" />
      <span class="quiet">{strain === null ? "" : `at ${(100 * strain).toFixed(2)} %`}</span>
    </div>
  );
}

export function CurveChart(props: CurveChartProps): JSX.Element {
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const drawn = useRef<Drawn>({ curves: [], marker: null, reach: 0 });
  drawn.current.curves = props.curves;
  drawn.current.marker = props.marker ?? null;
  drawn.current.reach = props.reach ?? 0;
  const [pointed, setPointed] = useState<number | null>(null);
  const [zoom] = useState(() => (props.zoomable === true ? new ChartZoom() : null));
  const shape = shapeOf(props);

  useLayoutEffect(() => {
    const element = box.current as HTMLDivElement;
    const pick = latest.current.onPickStrain === undefined ? null : (strain: number) => latest.current.onPickStrain?.(strain);
    const made = makePlot(element, latest.current, drawn.current, { point: setPointed, pick }, zoom);
    plot.current = made;
    const resizing = new ResizeObserver(() => made.setSize({ width: element.clientWidth, height: element.clientHeight }));
    resizing.observe(element);
    return () => {
      resizing.disconnect();
      made.destroy();
      plot.current = null;
    };
  }, [shape]);

  useEffect(() => plot.current?.setData(alignedData(props.curves)), [props.curves, props.reach]);
  useEffect(() => plot.current?.redraw(false), [props.marker]);

  return (
    <div
      class={`curve-chart${props.onPickStrain === undefined ? "" : " pickable"}${zoom === null ? "" : " zoomable"}`}
      role={zoom === null ? "img" : "group"}
      aria-label={props.label}
    >
      <Legend {...props} strain={pointed ?? props.marker ?? null} />
      {zoom === null ? (
        <div class="curve-box" ref={box} />
      ) : (
        <>
          <div class="curve-box" ref={box} tabIndex={0} role="img" aria-label={`${props.label}. ${kZoomKeys}`} onKeyDown={zoom.onKey} />
          <ZoomButtons zoom={zoom} />
        </>
      )}
    </div>
  );
}
