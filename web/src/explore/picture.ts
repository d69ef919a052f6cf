// The view as a PNG with its caption burnt in: title, strain, force, and the colour bar of the field.

import { roundFigures } from "../parts/curve_data";
import { mapColour } from "../view3d/colour_map";

export interface Caption {
  title: string;
  facts: string; // "strain 12.3 %, force 0.02 N"
  bar: { label: string; lowest: number; highest: number } | null;
}

const kFamily = "system-ui, 'Segoe UI', 'Noto Sans', 'DejaVu Sans', sans-serif";

function drawBar(paper: CanvasRenderingContext2D, bar: NonNullable<Caption["bar"]>, right: number, top: number, unit: number): void {
  const width = 16 * unit;
  const left = right - width;
  const columns = Math.round(width);
  for (let i = 0; i < columns; ++i) {
    const [r, g, b] = mapColour(i / (columns - 1)).map((x) => Math.round(255 * x));
    paper.fillStyle = `rgb(${r} ${g} ${b})`;
    paper.fillRect(left + i, top + 1.3 * unit, 1.5, 0.7 * unit);
  }
  paper.fillStyle = token("--text");
  paper.textAlign = "center";
  paper.fillText(bar.label, (left + right) / 2, top + 0.9 * unit);
  paper.textAlign = "left";
  paper.fillText(roundFigures(bar.lowest), left, top + 3.1 * unit);
  paper.textAlign = "right";
  paper.fillText(roundFigures(bar.highest), right, top + 3.1 * unit);
}

const token = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** ratio: pixels of the view per px of the page. */
export async function captioned(view: HTMLCanvasElement, caption: Caption, ratio: number): Promise<Blob> {
  const unit = 13 * ratio; // size of the letters
  const foot = Math.round(4.4 * unit);
  const page = document.createElement("canvas");
  page.width = view.width;
  page.height = view.height + foot;
  const paper = page.getContext("2d");
  if (paper === null) throw new Error("The browser has no canvas to draw the picture on.");
  paper.fillStyle = token("--panel");
  paper.fillRect(0, 0, page.width, page.height);
  paper.drawImage(view, 0, 0);
  paper.font = `600 ${unit}px ${kFamily}`;
  paper.fillStyle = token("--text");
  const room = page.width - 2 * unit - (caption.bar === null ? 0 : 18 * unit);
  paper.fillText(caption.title, unit, view.height + 1.8 * unit, room);
  paper.font = `${unit}px ${kFamily}`;
  paper.fillText(caption.facts, unit, view.height + 3.3 * unit, room);
  if (caption.bar !== null) drawBar(paper, caption.bar, page.width - unit, view.height + 0.5 * unit, unit);
  return new Promise((resolve, reject) =>
    page.toBlob((blob) => (blob === null ? reject(new Error("The picture is too large for the browser.")) : resolve(blob)), "image/png"),
  );
}

/** Hands a file to the user. */
export function download(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
