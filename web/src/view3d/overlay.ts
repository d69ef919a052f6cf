// What is written over the picture: scale bar, directions of the axes, measured lengths.

import type { Projection } from "./camera";
import type { Mark, Vec3, ViewColours } from "./types";

const kMargin = 16; // px
const kArrow = 26;
const kFont = "12px system-ui, 'Segoe UI', 'Noto Sans', 'DejaVu Sans', sans-serif";

export const cssColour = (colour: Vec3, alpha = 1): string =>
  `rgb(${colour.map((x) => Math.round(255 * x)).join(" ")} / ${alpha})`;

/** The largest of 1, 2, 5 times a power of ten that is not above a number. */
export function roundBelow(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1) * power;
}

/** Text with an edge in the colour behind it, so that it can be read over yarn. */
function write(paper: CanvasRenderingContext2D, text: string, x: number, y: number, colours: ViewColours): void {
  paper.lineWidth = 4;
  paper.lineJoin = "round";
  paper.strokeStyle = cssColour(colours.back, 0.85);
  paper.strokeText(text, x, y);
  paper.fillStyle = cssColour(colours.text);
  paper.fillText(text, x, y);
}

function line(paper: CanvasRenderingContext2D, points: readonly (readonly [number, number])[], style: string, width: number): void {
  paper.beginPath();
  points.forEach(([x, y]) => paper.lineTo(x, y));
  paper.strokeStyle = style;
  paper.lineWidth = width;
  paper.stroke();
}

function drawScaleBar(paper: CanvasRenderingContext2D, projection: Projection, colours: ViewColours): void {
  const length = roundBelow((0.22 * projection.width) / projection.pixelsPerMm);
  const right = projection.width - kMargin;
  const left = right - length * projection.pixelsPerMm;
  const y = projection.height - kMargin;
  const shape = [[left, y - 5], [left, y], [right, y], [right, y - 5]] as const;
  line(paper, shape, cssColour(colours.back, 0.85), 5);
  line(paper, shape, cssColour(colours.text), 1.5);
  paper.textAlign = "right";
  const text = length >= 0.01 ? `${Number(length.toPrecision(1))} mm` : `${Number((1000 * length).toPrecision(1))} µm`;
  write(paper, text, right, y - 9, colours);
}

function drawAxes(paper: CanvasRenderingContext2D, projection: Projection, colours: ViewColours): void {
  const { right, up, towards } = projection.axes;
  const middle = [kMargin + kArrow + 6, projection.height - kMargin - kArrow - 6] as const;
  paper.textAlign = "center";
  paper.textBaseline = "middle";
  const axes = ["x", "y", "z"].map((name, i) => ({ name, across: right[i]!, upright: up[i]!, depth: towards[i]! }));
  for (const axis of axes.sort((a, b) => a.depth - b.depth)) {
    const end = [middle[0] + kArrow * axis.across, middle[1] - kArrow * axis.upright] as const;
    line(paper, [middle, end], cssColour(colours.back, 0.85), 4);
    line(paper, [middle, end], cssColour(colours.text, axis.depth < -0.05 ? 0.5 : 1), 1.5);
    const beyond = Math.hypot(axis.across, axis.upright) < 0.25 ? [-9, 9] : [9 * axis.across, -9 * axis.upright];
    write(paper, axis.name, end[0] + beyond[0]!, end[1] + beyond[1]!, colours);
  }
  paper.textBaseline = "alphabetic";
}

function drawMark(paper: CanvasRenderingContext2D, projection: Projection, mark: Mark, colours: ViewColours): void {
  const from = projection.placeOf(mark.from);
  const to = mark.to === null ? null : projection.placeOf(mark.to);
  if (to !== null) {
    line(paper, [from, to], cssColour(colours.back, 0.85), 5);
    line(paper, [from, to], cssColour(colours.picked), 2);
  }
  for (const [x, y] of to === null ? [from] : [from, to]) {
    paper.beginPath();
    paper.arc(x, y, 4, 0, 2 * Math.PI);
    paper.fillStyle = cssColour(colours.picked);
    paper.fill();
    paper.strokeStyle = cssColour(colours.back);
    paper.lineWidth = 1.5;
    paper.stroke();
  }
  if (mark.text === "") return;
  const beside = to === null ? from : [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] as const;
  paper.textAlign = "left";
  write(paper, mark.text, beside[0] + 10, beside[1] - 8, colours);
}

export interface OverlayParts {
  marks: readonly Mark[];
  picked: Vec3 | null; // a ring around the picked place
}

export function drawOverlay(
  canvas: HTMLCanvasElement,
  projection: Projection,
  colours: ViewColours,
  ratio: number,
  parts: OverlayParts,
): void {
  const paper = canvas.getContext("2d");
  if (paper === null) return;
  paper.setTransform(ratio, 0, 0, ratio, 0, 0);
  paper.clearRect(0, 0, projection.width, projection.height);
  paper.font = kFont;
  drawAxes(paper, projection, colours);
  if (projection.state.orthographic) drawScaleBar(paper, projection, colours);
  for (const mark of parts.marks) drawMark(paper, projection, mark, colours);
  if (parts.picked !== null) {
    const [x, y] = projection.placeOf(parts.picked);
    for (const [style, width] of [[cssColour(colours.back, 0.9), 5], [cssColour(colours.picked), 2]] as const) {
      paper.beginPath();
      paper.arc(x, y, 13, 0, 2 * Math.PI);
      paper.strokeStyle = style;
      paper.lineWidth = width;
      paper.stroke();
    }
  }
}
