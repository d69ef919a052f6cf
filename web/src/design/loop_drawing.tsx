// The ERC in plan, true to scale, with the loop and the course that it belongs to pale around it.

import { signal, useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { LoopDrawing } from "../api/types";
import { design, isReadable, loop } from "../state/design";
import { LoopDimensions } from "./loop_dimensions";
import { above, ercPoints, pathOf, planOf, type Plan, type Point, type Size } from "./plan";
import { SideView } from "./side_view";

const showsPoints = signal(true);

type Half = { side: 1 | -1; wales: number };
const kCourse: Half[] = [-1, 0, 1].flatMap((wales) => [-1, 1].map((side): Half => ({ side: side as 1 | -1, wales })));

function Yarn({ points, plan, kind }: { points: Point[]; plan: Plan; kind: string }): JSX.Element | null {
  if (points.length < 2) return null;
  const d = pathOf(points, plan);
  return (
    <>
      <path class="casing" d={d} stroke-width={plan.band + 4} />
      <path class={`yarn ${kind} edge`} d={d} stroke-width={plan.band} />
      <path class={`yarn ${kind}`} d={d} stroke-width={Math.max(plan.band - 1.6, 0.6)} />
    </>
  );
}

/** The pale surroundings fade towards the sides and above the head. */
function Fades({ drawn, plan }: { drawn: LoopDrawing; plan: Plan }): JSX.Element {
  const [left, top] = plan.at(-drawn.width, drawn.height / 2);
  const [right, bottom] = plan.at(drawn.width, -drawn.height / 2);
  const area = { x: left, y: top - 16, width: right - left, height: bottom - top + 16 + 2 * plan.band + 8 };
  const share = Math.min(0.2, 40 / area.height);
  return (
    <defs>
      <linearGradient id="fade-across">
        <stop offset="0" stop-color="#000" />
        <stop offset="0.22" stop-color="#fff" />
        <stop offset="0.78" stop-color="#fff" />
        <stop offset="1" stop-color="#000" />
      </linearGradient>
      <linearGradient id="fade-up" x1="0" y1="0" x2="0" y2="1">
        <stop offset="0" stop-color="#000" />
        <stop offset={share} stop-color="#fff" />
      </linearGradient>
      <mask id="across" maskUnits="userSpaceOnUse" {...area}>
        <rect {...area} fill="url(#fade-across)" />
      </mask>
      <mask id="up" maskUnits="userSpaceOnUse" {...area}>
        <rect {...area} fill="url(#fade-up)" />
      </mask>
    </defs>
  );
}

/** The lower course lies in front below the height T/2, the upper one above it. */
function Surroundings({ drawn, plan, inFront }: { drawn: LoopDrawing; plan: Plan; inFront: boolean }): JSX.Element {
  const T = drawn.course_spacing;
  const upper = T === null ? [] : kCourse.map(({ side, wales }) => ercPoints(drawn, side, wales, 1));
  return (
    <g mask="url(#across)">
      <g mask="url(#up)">
        {upper.map((points, i) => (
          <Yarn key={i} points={inFront ? above(points, (T ?? 0) / 2) : points} plan={plan} kind="neighbour" />
        ))}
      </g>
      {inFront
        ? null
        : kCourse
            .filter(({ side, wales }) => wales !== 0 || side === -1)
            .map(({ side, wales }) => (
              <Yarn
                key={`${side} ${wales}`}
                points={ercPoints(drawn, side, wales, 0)}
                plan={plan}
                kind={wales === 0 ? "mirrored" : "neighbour"}
              />
            ))}
    </g>
  );
}

type PointName = keyof LoopDrawing["points"];
const kPlaces: Record<PointName, { dx: number; dy: number; anchor: "start" | "end" }> = {
  P1: { dx: -7, dy: -7, anchor: "end" },
  P2: { dx: 7, dy: -6, anchor: "start" },
  P3: { dx: 9, dy: 4, anchor: "start" },
  P4: { dx: -9, dy: 4, anchor: "end" },
  P5: { dx: -7, dy: 15, anchor: "end" },
  P6: { dx: 7, dy: 15, anchor: "start" },
  P7: { dx: -4, dy: 18, anchor: "start" },
  P8: { dx: -4, dy: -9, anchor: "start" },
};

function ControlPoints({ drawn, plan }: { drawn: LoopDrawing; plan: Plan }): JSX.Element {
  return (
    <g class="points">
      {(Object.keys(kPlaces) as PointName[]).map((name) => {
        const [x, y] = plan.at(...drawn.points[name]);
        const { dx, dy, anchor } = kPlaces[name];
        return (
          <g key={name}>
            {name === "P7" || name === "P8" ? <path d={`M${x - 4} ${y}h8M${x} ${y - 4}v8`} /> : <circle cx={x} cy={y} r="3" />}
            <text x={x + dx} y={y + dy} text-anchor={anchor}>
              {name}
            </text>
          </g>
        );
      })}
    </g>
  );
}

function Drawing({ drawn, size }: { drawn: LoopDrawing; size: Size }): JSX.Element {
  const plan = planOf(drawn, size);
  return (
    <svg width={size.width} height={size.height} role="img" aria-label="The ERC in plan with its dimensions">
      <Fades drawn={drawn} plan={plan} />
      <Surroundings drawn={drawn} plan={plan} inFront={false} />
      <Yarn points={ercPoints(drawn, 1, 0, 0)} plan={plan} kind="erc" />
      <Surroundings drawn={drawn} plan={plan} inFront />
      <SideView drawn={drawn} plan={plan} />
      <LoopDimensions loop={drawn} plan={plan} />
      {showsPoints.value ? <ControlPoints drawn={drawn} plan={plan} /> : null}
    </svg>
  );
}

export function LoopPanel(): JSX.Element {
  const place = useRef<HTMLDivElement>(null);
  const size = useSignal<Size | null>(null);
  useLayoutEffect(() => {
    const box = place.current as HTMLDivElement;
    const observer = new ResizeObserver(() => (size.value = { width: box.clientWidth, height: box.clientHeight }));
    observer.observe(box);
    return () => observer.disconnect();
  }, []);
  const isOld = design.value !== null && design.value.loop === null;
  return (
    <section class="panel drawing" aria-label="The loop">
      <header>
        <h2>Loop</h2>
        <span class="quiet">the ERC in plan, mm, on the yarn's centreline</span>
        <span class="spread" />
        <button type="button" class="small" aria-pressed={showsPoints.value} onClick={() => (showsPoints.value = !showsPoints.value)}>
          Points
        </button>
      </header>
      <div class={isOld ? "sheet old" : "sheet"} ref={place} data-test="loop-drawing">
        {loop.value === null || size.value === null ? null : <Drawing drawn={loop.value} size={size.value} />}
        {isOld ? (
          <p class="over">
            {isReadable.value ? "No loop has these measures. This is the last one." : "This is the loop as it was before the mistake."}
          </p>
        ) : null}
      </div>
    </section>
  );
}
