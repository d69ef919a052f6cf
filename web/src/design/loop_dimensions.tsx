// The dimensions of the loop, each at what it measures.

import type { JSX } from "preact";
import type { LoopDrawing } from "../api/types";
import { Arrow, Dimension, Label, Line, Span } from "./dimension";
import { onLeg, type Plan, type Point } from "./plan";
import { significant } from "./words";

interface Props {
  loop: LoopDrawing;
  plan: Plan;
}

const moved = ([x, y]: Point, dx: number, dy: number): Point => [x + dx, y + dy];

function Height({ loop: { height: H, width: L }, plan: { at } }: Props): JSX.Element {
  const x = at(L, 0)[0] + 18;
  const [top, bottom] = [at(0, H / 2), at(L / 2, -H / 2)];
  return (
    <Dimension of="loop.height" words="Height of the loop, from the middle of the head to the middle of the foot">
      <Line from={top} to={[x + 5, top[1]]} thin />
      <Line from={bottom} to={[x + 5, bottom[1]]} thin />
      <Arrow from={[x, bottom[1]]} to={[x, top[1]]} both />
      <Label at={[x + 7, at(0, 0)[1] + 4]} symbol="H" value={significant(H)} />
    </Dimension>
  );
}

function CourseSpacing({ loop: { height: H, width: L, course_spacing: T }, plan: { at } }: Props): JSX.Element | null {
  if (T === null) return null;
  const x = at(-L, 0)[0] - 18;
  const [lower, upper] = [at(-L / 2, -H / 2), at(-L / 2, T - H / 2)];
  return (
    <Dimension of="fabric.course_spacing" words="Distance between neighbouring courses, from foot to foot">
      <Line from={lower} to={[x - 5, lower[1]]} thin />
      <Line from={upper} to={[x - 5, upper[1]]} thin />
      <Arrow from={[x, lower[1]]} to={[x, upper[1]]} both />
      <Label at={[x - 7, (lower[1] + upper[1]) / 2 + 4]} symbol="T" value={significant(T)} anchor="end" />
    </Dimension>
  );
}

function Width({ loop: { height: H, width: L }, plan: { at } }: Props): JSX.Element {
  const [left, right] = [at(-L / 2, -H / 2), at(L / 2, -H / 2)];
  const y = left[1] + 46;
  return (
    <Dimension of="loop.width" words="Width of a stitch, the spacing of the wales, from foot to foot">
      <Line from={left} to={[left[0], y + 5]} thin />
      <Line from={right} to={[right[0], y + 5]} thin />
      <Arrow from={[left[0], y]} to={[right[0], y]} both />
      <Label at={[(left[0] + right[0]) / 2, y - 6]} symbol="L" value={significant(L)} anchor="middle" />
    </Dimension>
  );
}

interface FlatProps {
  of: string;
  symbol: string;
  words: string;
  length: number; // mm
  from: Point; // px
  to: Point;
  away: number; // px, from the yarn to the line; negative: upwards
}

function Flat({ of, symbol, words, length, from, to, away }: FlatProps): JSX.Element {
  const end = Math.sign(away) * 5;
  const value: Point = [Math.max(from[0], to[0]) + 24, from[1] + away + 4];
  return (
    <Dimension of={of} words={words}>
      <Line from={from} to={moved(from, 0, away + end)} thin />
      <Line from={to} to={moved(to, 0, away + end)} thin />
      <Span from={moved(from, 0, away)} to={moved(to, 0, away)} />
      <Label at={value} symbol={symbol} value={significant(length)} />
    </Dimension>
  );
}

interface RadiusProps {
  of: string;
  symbol: string;
  words: string;
  radius: number; // mm
  middle: [number, number]; // mm
  angle: number; // rad, of the arrow
  plan: Plan;
}

function Radius({ of, symbol, words, radius, middle, angle, plan }: RadiusProps): JSX.Element {
  const from = plan.at(...middle);
  const to = plan.at(middle[0] + radius * Math.cos(angle), middle[1] + radius * Math.sin(angle));
  const isRight = Math.cos(angle) > 0;
  return (
    <Dimension of={of} words={words}>
      <Arrow from={from} to={to} />
      <Label at={moved(from, isRight ? -9 : 9, 4)} symbol={symbol} value={significant(radius)} anchor={isRight ? "end" : "start"} />
    </Dimension>
  );
}

function Diameter({ loop, plan }: Props): JSX.Element {
  const { P3, P4 } = loop.points;
  const [x, y] = plan.at(...onLeg(loop, 0.66));
  const length = Math.hypot(P4[0] - P3[0], P4[1] - P3[1]) || 1;
  // Across the leg, in px, where y points down.
  const [nx, ny] = [(P3[1] - P4[1]) / length, (P4[0] - P3[0]) / -length];
  const half = plan.band / 2;
  const left: Point = [x - half * nx, y + half * ny];
  const right: Point = [x + half * nx, y - half * ny];
  return (
    <Dimension of="yarn.diameter" words="Diameter of the yarn">
      <Span from={left} to={right} />
      <Label at={[left[0] - 25, left[1] + 4]} symbol="D" value={significant(loop.diameter)} anchor="end" />
    </Dimension>
  );
}

function LegAngle({ loop, plan }: Props): JSX.Element {
  const [x, y] = plan.at(...onLeg(loop, 0.36));
  const angle = (loop.theta1_degrees * Math.PI) / 180;
  const r = 26;
  const end: Point = [x + r * Math.cos(angle), y + r * Math.sin(angle)];
  return (
    <Dimension of={null} words="Inclination of the leg against the course; above 90 degrees it leans back under the head">
      <Line from={[x, y]} to={[x + r + 14, y]} thin />
      <path class="arc" d={`M${x + r} ${y}A${r} ${r} 0 0 1 ${end[0]} ${end[1]}`} />
      <Label at={[x + r + 6, y + 18]} symbol="theta" value={`${significant(loop.theta1_degrees)}°`} />
    </Dimension>
  );
}

export function LoopDimensions({ loop, plan }: Props): JSX.Element {
  const { P1, P2, P5, P6, P7, P8 } = loop.points;
  return (
    <g class="dimensions">
      <Height loop={loop} plan={plan} />
      <CourseSpacing loop={loop} plan={plan} />
      <Width loop={loop} plan={plan} />
      <Flat
        of="loop.head_flat"
        symbol="l1"
        words="Half the length of the flat top of the head"
        length={loop.head_flat}
        from={plan.at(...P1)}
        to={plan.at(...P2)}
        away={-22}
      />
      <Flat
        of="loop.foot_flat"
        symbol="l2"
        words="Half the length of the flat bottom of the foot"
        length={loop.foot_flat}
        from={plan.at(...P5)}
        to={plan.at(...P6)}
        away={22}
      />
      <Radius
        of="loop.head_radius"
        symbol="R1"
        words="Radius of the head arc, of the yarn's centreline"
        radius={loop.head_radius}
        middle={P7}
        angle={0.6}
        plan={plan}
      />
      <Radius
        of="loop.foot_radius"
        symbol="R2"
        words="Radius of the foot arc, of the yarn's centreline"
        radius={loop.foot_radius}
        middle={P8}
        angle={Math.PI + 0.6}
        plan={plan}
      />
      <Diameter loop={loop} plan={plan} />
      <LegAngle loop={loop} plan={plan} />
    </g>
  );
}
