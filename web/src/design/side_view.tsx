// The ERC from the side, beside its plan and in the same scale: how deep the loop is, which is what p says.

import type { JSX } from "preact";
import type { LoopDrawing } from "../api/types";
import { Dimension, Label, Line, Span } from "./dimension";
import { effectiveValue } from "./effective";
import type { Plan, Point } from "./plan";

export function SideView({ drawn, plan }: { drawn: LoopDrawing; plan: Plan }): JSX.Element {
  const { height: H, width: L, path } = drawn;
  const depth = Math.max(...path.map(([, , z]) => -z));
  const front = plan.at(L, 0)[0] + 88 + plan.band / 2;
  // The front of the fabric is at the left, so that the view is the plan turned about a line along y.
  const places = path.map(([, y, z]): Point => [front - z * plan.scale, plan.at(0, y)[1]]);
  const d = places.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
  const [top, bottom] = [plan.at(0, H / 2)[1], plan.at(0, -H / 2)[1]];
  const back = front + depth * plan.scale;
  const p = effectiveValue("loop.out_of_plane").split(" ")[0] ?? "";
  return (
    <g class="side-view">
      <path class="yarn erc edge" d={d} stroke-width={plan.band} />
      <path class="yarn erc" d={d} stroke-width={Math.max(plan.band - 1.6, 0.6)} />
      <Dimension of="loop.out_of_plane" words="Depth of the loop: z = -p y², y from the middle of its height">
        <Line from={[front, top - 27]} to={[front, bottom]} thin />
        <Line from={[back, top - 27]} to={[back, top]} thin />
        <Span from={[front, top - 22]} to={[back, top - 22]} />
        <Label at={[back + 10, (top + bottom) / 2 - 2]} symbol="p" value={p} />
        <text class="formula" x={back + 10} y={(top + bottom) / 2 + 15}>
          z = −p y²
        </text>
      </Dimension>
      <text class="quiet-text" x={(front + back) / 2} y={bottom + 24} text-anchor="middle">
        from the side
      </text>
    </g>
  );
}
