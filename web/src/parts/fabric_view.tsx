// The fabric in 3-D, yarn by yarn. New positions of the same fabric leave the camera where it is.

import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { FabricHead } from "../api/types";
import { theme } from "../state/theme";
import { Stage } from "../view3d/stage";
import { readColours } from "../view3d/theme_colours";
import {
  viewNames,
  type Box,
  type CameraState,
  type ClipBox,
  type ContactLayer,
  type FabricColouring,
  type Highlight,
  type Mark,
  type Picked,
  type ViewName,
} from "../view3d/types";

export type { Box, CameraState, ClipBox, ContactLayer, FabricColouring, Highlight, Mark, Picked, Vec3, ViewName } from "../view3d/types";

/** What a page can ask of the view. */
export interface FabricViewHandle {
  show(view: ViewName): void;
  showWhole(): void;
  /** The picture as it stands, with scale bar and marks; ratio: its pixels per px of the page, 2 for print. */
  picture(ratio: number): HTMLCanvasElement;
}

export interface FabricViewProps {
  fabric: FabricHead;
  positions: Float32Array; // 3 a node
  course: Int32Array;
  wale: Int32Array;
  generation: number; // of these positions; on the root as data-generation once it is drawn
  label: string; // for those who do not see the view
  colour?: FabricColouring | undefined; // left out: courses told apart
  broken?: Int32Array | undefined; // elements that leave a gap
  contacts?: ContactLayer | undefined;
  clip?: ClipBox | undefined;
  highlight?: Highlight | undefined;
  marks?: readonly Mark[] | undefined;
  room?: Box | undefined; // what the whole view shows; left out: the fabric as it is when it first comes
  view?: ViewName | undefined; // from where at first; left out: from the front
  camera?: CameraState | undefined; // another one than onCamera told last is gone to
  onCamera?: ((camera: CameraState) => void) | undefined; // when it has come to rest
  onPick?: ((picked: Picked | null) => void) | undefined; // a click; null: on nothing
  dimmed?: boolean | undefined; // what is shown is not what is wanted
  handle?: { current: FabricViewHandle | null } | undefined;
}

const kCourses: FabricColouring = { by: "course" };
const kNoMarks: readonly Mark[] = [];
const kKeysHelp =
  "Drag to turn, with Shift to move, wheel to zoom. Keys: arrows turn, Shift and arrows move, + and - zoom, 0 shows the whole fabric.";

const kViewTitles: Record<ViewName, string> = {
  front: "Front",
  back: "Back",
  side: "Side",
  top: "Top",
  oblique: "Oblique",
};

/** How far the toolbar reaches down into the view [px]; a page may place it outside. */
function coveredBy(root: HTMLElement): number {
  const toolbar = root.querySelector(".view-toolbar");
  if (toolbar === null) return 0;
  return Math.max(0, toolbar.getBoundingClientRect().bottom - root.getBoundingClientRect().top);
}

interface ToolbarProps {
  stage: Stage | null;
  orthographic: boolean;
}

function Toolbar({ stage, orthographic }: ToolbarProps): JSX.Element {
  return (
    <div class="view-toolbar" role="toolbar" aria-label="View">
      {viewNames.map((name) => (
        <button key={name} type="button" onClick={() => stage?.show(name)} title={`Seen from: ${name}`}>
          {kViewTitles[name]}
        </button>
      ))}
      <button type="button" onClick={() => stage?.showWhole()} title="The whole fabric (0)">
        Fit
      </button>
      <button
        type="button"
        aria-pressed={!orthographic}
        onClick={() => stage?.setOrthographic(!orthographic)}
        title="With perspective, or at the same scale everywhere"
      >
        Perspective
      </button>
    </div>
  );
}

export function FabricView(props: FabricViewProps): JSX.Element {
  const root = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const overlay = useRef<HTMLCanvasElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const [stage, setStage] = useState<Stage | null>(null);
  const [trouble, setTrouble] = useState("");
  const [orthographic, setOrthographic] = useState(props.camera?.orthographic ?? true);
  const colours = useMemo(readColours, [theme.value]);

  useEffect(() => {
    const element = root.current as HTMLDivElement;
    let made: Stage;
    try {
      made = new Stage(canvas.current as HTMLCanvasElement, overlay.current as HTMLCanvasElement, props.view ?? "front", {
        camera: (state) => {
          setOrthographic(state.orthographic);
          latest.current.onCamera?.(state);
        },
        pick: (picked) => latest.current.onPick?.(picked),
        drawn: (generation, milliseconds, elements) => {
          const data = element.dataset;
          data["generation"] = String(generation);
          data["frameMs"] = milliseconds.toFixed(2);
          data["elements"] = String(elements);
        },
        covered: () => coveredBy(element),
        lost: (isLost) => setTrouble(isLost ? "The graphics of this computer were interrupted; the view comes back by itself." : ""),
      });
    } catch {
      setTrouble("The fabric cannot be drawn: this browser has no WebGL 2, or it is switched off.");
      return;
    }
    setStage(made);
    return () => made.dispose();
  }, []);

  useLayoutEffect(() => {
    stage?.update({
      fabric: props.fabric,
      positions: props.positions,
      course: props.course,
      wale: props.wale,
      colouring: props.colour ?? kCourses,
      broken: props.broken,
      contacts: props.contacts,
      clip: props.clip,
      highlight: props.highlight,
      marks: props.marks ?? kNoMarks,
      room: props.room,
      camera: props.camera,
      colours,
      generation: props.generation,
    });
  });

  useEffect(() => {
    if (props.handle === undefined || stage === null) return;
    const handle = props.handle;
    handle.current = {
      show: (view) => stage.show(view),
      showWhole: () => stage.showWhole(),
      picture: (ratio) => stage.picture(ratio),
    };
    return () => {
      handle.current = null;
    };
  }, [stage, props.handle]);

  return (
    <div class={props.dimmed === true ? "fabric-view dimmed" : "fabric-view"} ref={root} data-test="fabric-view">
      <canvas ref={canvas} tabIndex={0} role="img" aria-label={props.label} aria-description={kKeysHelp} />
      <canvas ref={overlay} class="view-overlay" aria-hidden="true" />
      {trouble === "" ? (
        <Toolbar stage={stage} orthographic={orthographic} />
      ) : (
        <p class="view-trouble" role="alert">
          {trouble}
        </p>
      )}
    </div>
  );
}
