// The fabric of the selected run, or those of all shown runs beside each other, seen from the same place.

import { signal } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { figures } from "../parts/curve_data";
import type { Box, CameraState, FabricViewHandle, Vec3 } from "../parts/fabric_view";
import { mapGradient } from "../view3d/colour_map";
import { viewNames } from "../view3d/types";
import { colourWord, kColours, scaleOf, setColour, type Scale } from "./colouring";
import { fabrics } from "./fabrics";
import { instantText, RunFabric } from "./run_fabric";
import { areBeside, kMostBeside, setWords, shown, watched } from "./shown";

/** From where all fabrics are seen that are shown beside each other; undefined: from the front, all of them whole. */
const commonCamera = signal<CameraState | undefined>(undefined);

/** Around all of them, so that one scale holds for all. */
function commonRoom(ids: readonly string[]): Box | undefined {
  const rooms = ids.flatMap((id) => fabrics.value.get(id)?.room ?? []);
  const first = rooms[0];
  if (first === undefined) return undefined;
  const ends = (pick: (...values: number[]) => number, of: keyof Box): Vec3 => [0, 1, 2].map((axis) => pick(...rooms.map((room) => room[of][axis]!))) as unknown as Vec3;
  return { lowest: ends(Math.min, "lowest"), highest: ends(Math.max, "highest") };
}

/** The range of a colour bar without zeros that tell nothing. */
const endText = (value: number): string => figures(value).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");

function ColourBar({ scale }: { scale: Scale }): JSX.Element {
  const { field, lowest, highest } = scale;
  return (
    <div class="scale-bar" role="img" aria-label={`${field.label} from ${endText(lowest)} to ${endText(highest)} ${field.unit}`}>
      <span>{endText(lowest)}</span>
      <i style={{ background: mapGradient("to right") }} />
      <span>{`${endText(highest)} ${field.unit}`}</span>
    </div>
  );
}

function ColourChoice(): JSX.Element {
  return (
    <label class="colour-choice">
      <span>Colour</span>
      <select aria-label="Colour" value={colourWord()} onChange={(event) => setColour(event.currentTarget.value)}>
        {kColours.map((each) => (
          <option key={each.word} value={each.word}>
            {each.words}
          </option>
        ))}
      </select>
    </label>
  );
}

function BesideButton(): JSX.Element {
  const canBeBeside = shown.value.length > 1;
  return (
    <button
      type="button"
      aria-pressed={areBeside.value}
      disabled={!canBeBeside}
      onClick={() => setWords({ beside: areBeside.value ? "" : "yes" })}
      title={canBeBeside ? "The fabrics of all shown runs, seen from the same place" : "Tick several runs in the list to see them side by side"}
    >
      Side by side
    </button>
  );
}

/** One row of buttons for all views beside each other: they follow the first one. */
function CommonViews({ first }: { first: { current: FabricViewHandle | null } }): JSX.Element {
  return (
    <div class="common-views" role="toolbar" aria-label="View of all fabrics">
      {viewNames.map((name) => (
        <button key={name} type="button" class="plain" onClick={() => first.current?.show(name)} title={`Seen from: ${name}`}>
          {name.charAt(0).toUpperCase() + name.slice(1)}
        </button>
      ))}
      <button type="button" class="plain" onClick={() => first.current?.showWhole()} title="The whole fabrics">
        Fit
      </button>
    </div>
  );
}

function Beside({ first, scale }: { first: { current: FabricViewHandle | null }; scale: Scale | null }): JSX.Element {
  const ids = watched.value.map((run) => run.id);
  const rooms = ids.map((id) => fabrics.value.get(id)?.room);
  const room = useMemo(() => commonRoom(ids), rooms);
  useEffect(() => {
    commonCamera.value = undefined;
  }, ids);
  return (
    <div class="views beside">
      {watched.value.map((run, place) => (
        <div key={`${run.id} of ${ids.join()}`} class="view">
          <div class="view-name">
            <strong>{run.id}</strong>
            <span class="quiet">{instantText(run)}</span>
          </div>
          <RunFabric
            run={run}
            scale={scale}
            room={room}
            camera={commonCamera.value}
            onCamera={(camera) => (commonCamera.value = camera)}
            handle={place === 0 ? first : undefined}
          />
        </div>
      ))}
    </div>
  );
}

export function FabricPanel(): JSX.Element {
  const first = useRef<FabricViewHandle | null>(null);
  const run = watched.value[0];
  const scale = scaleOf(watched.value);
  const isCut = areBeside.value && shown.value.length > kMostBeside;
  return (
    <section class="panel fabrics" aria-label={areBeside.value ? "Fabrics side by side" : "The fabric of the selected run"}>
      <header>
        <h2>{areBeside.value ? "Fabrics" : "Fabric"}</h2>
        <span class="quiet instant">{isCut ? `the first ${kMostBeside} of ${shown.value.length}` : areBeside.value || run === undefined ? "" : instantText(run)}</span>
        <span class="spread" />
        {areBeside.value ? <CommonViews first={first} /> : null}
        {scale === null ? null : <ColourBar scale={scale} />}
        <ColourChoice />
        <BesideButton />
      </header>
      {areBeside.value ? (
        <Beside first={first} scale={scale} />
      ) : (
        <div class="views">
          <div class="view">{run === undefined ? null : <RunFabric key={run.id} run={run} scale={scale} />}</div>
        </div>
      )}
    </section>
  );
}
