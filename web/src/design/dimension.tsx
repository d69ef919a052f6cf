// The parts of a dimension in the drawing of the loop, in px.

import type { ComponentChildren, JSX } from "preact";
import type { Point } from "./plan";
import { goToField, hovered, lit } from "./pointing";
import { SvgSymbol } from "./symbol";

const kTip = { length: 8, half: 2.8 };

export function Line({ from, to, thin = false }: { from: Point; to: Point; thin?: boolean }): JSX.Element {
  return <line class={thin ? "thin" : ""} x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />;
}

function Tip({ from, to }: { from: Point; to: Point }): JSX.Element | null {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length === 0) return null;
  const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const back: Point = [to[0] - kTip.length * ux, to[1] - kTip.length * uy];
  const corners = [to, [back[0] - kTip.half * uy, back[1] + kTip.half * ux], [back[0] + kTip.half * uy, back[1] - kTip.half * ux]];
  return <polygon points={corners.map((corner) => corner.join(",")).join(" ")} />;
}

/** A line with a tip at its end, or at both. */
export function Arrow({ from, to, both = false }: { from: Point; to: Point; both?: boolean }): JSX.Element {
  return (
    <>
      <Line from={from} to={to} />
      <line class="hit" x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      <Tip from={from} to={to} />
      {both ? <Tip from={to} to={from} /> : null}
    </>
  );
}

const kRoomForArrows = 30; // px, below which the arrows of a dimension come from outside
const kOutside = 20; // px

/** Between two points: from inside if there is room, else from outside. */
export function Span({ from, to }: { from: Point; to: Point }): JSX.Element {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length >= kRoomForArrows) return <Arrow from={from} to={to} both />;
  const [ux, uy] = length === 0 ? [1, 0] : [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  return (
    <>
      <Arrow from={[from[0] - kOutside * ux, from[1] - kOutside * uy]} to={from} />
      <Arrow from={[to[0] + kOutside * ux, to[1] + kOutside * uy]} to={to} />
    </>
  );
}

interface LabelProps {
  at: Point;
  symbol: string;
  value: string;
  anchor?: "start" | "middle" | "end";
}

export function Label({ at, symbol, value, anchor = "start" }: LabelProps): JSX.Element {
  return (
    <text class="label" x={at[0]} y={at[1]} text-anchor={anchor}>
      <SvgSymbol symbol={symbol} />
      <tspan class="value" dx="4">
        {value}
      </tspan>
    </text>
  );
}

interface DimensionProps {
  of: string | null; // key of its parameter; null: it follows from others
  words: string;
  children: ComponentChildren;
}

/** All parts of one dimension; it is lit with its field and leads to it. */
export function Dimension({ of, words, children }: DimensionProps): JSX.Element {
  if (of === null) {
    return (
      <g class="dimension follows">
        <title>{words}</title>
        {children}
      </g>
    );
  }
  return (
    <g
      class={lit.value === of ? "dimension lit" : "dimension"}
      data-test={`dimension-${of}`}
      onMouseEnter={() => (hovered.value = of)}
      onMouseLeave={() => (hovered.value = null)}
      onClick={() => goToField(of)}
    >
      <title>{words}</title>
      {children}
    </g>
  );
}
