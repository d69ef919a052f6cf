// A picture of a stored frame, drawn by the program, with the words of knitmech render.

import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import * as client from "../api/client";
import type { RunDetail, RunHead } from "../api/types";
import { viewNames } from "../view3d/types";
import { Card, quoted } from "./card";
import { save } from "./download";
import { runFolder } from "./subject";

const kColours: readonly { word: string; words: string }[] = [
  { word: "plain", words: "Plain" },
  { word: "course", words: "Courses" },
  { word: "contact", words: "Contact force" },
  { word: "axial-force", words: "Axial force" },
  { word: "axial-strain", words: "Axial strain" },
  { word: "shear-force", words: "Shear force" },
  { word: "bending-moment", words: "Bending moment" },
  { word: "torque", words: "Torque" },
  { word: "curvature", words: "Curvature" },
  { word: "out-of-plane", words: "Out of plane" },
];
const kPause = 350; // ms without a change, after which the picture is drawn

interface Wanted {
  frame: string;
  colour: string;
  view: string;
  width: string; // px; "": as the fabric asks for
  height: string;
}

interface Drawn {
  content: Blob;
  address: string; // of the picture in the page
  words: string; // what it was drawn of
}

/** The words that are given, for an address or a command line. */
const given = (wanted: Wanted): [string, string][] => Object.entries(wanted).filter(([, value]) => value !== "");

function Choice(props: { name: string; value: string; choices: readonly (readonly [string, string])[]; onChange: (value: string) => void }): JSX.Element {
  return (
    <label class="pair">
      <span>{props.name}</span>
      <select aria-label={props.name} value={props.value} onChange={(event) => props.onChange(event.currentTarget.value)}>
        {props.choices.map(([value, words]) => (
          <option key={value} value={value}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}

function Pixels(props: { name: string; value: string; placeholder: string; onChange: (value: string) => void }): JSX.Element {
  return (
    <label class="pair">
      <span>{props.name}</span>
      <input
        type="text"
        inputMode="numeric"
        value={props.value}
        placeholder={props.placeholder}
        onInput={(event) => props.onChange(event.currentTarget.value.trim())}
      />
    </label>
  );
}

interface Preview {
  drawn: Drawn | null;
  trouble: string;
}

/** Draws the picture when the words have come to rest. */
function usePicture(id: string, wanted: Wanted | null): Preview {
  const drawn = useSignal<Drawn | null>(null);
  const trouble = useSignal("");
  const words = wanted === null ? "" : JSON.stringify([id, wanted]);
  useEffect(() => {
    if (wanted === null) return;
    const stop = new AbortController();
    const draw = async (): Promise<void> => {
      try {
        const content = await client.bytesAt(client.pictureAddress(id, Object.fromEntries(given(wanted))), stop.signal);
        if (drawn.value !== null) URL.revokeObjectURL(drawn.value.address);
        drawn.value = { content, address: URL.createObjectURL(content), words };
        trouble.value = "";
      } catch (error) {
        if (stop.signal.aborted) return;
        trouble.value = error instanceof Error ? error.message : String(error);
      }
    };
    const timer = setTimeout(() => void draw(), drawn.value === null ? 0 : kPause);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, [words]);
  useEffect(() => () => void (drawn.value === null ? undefined : URL.revokeObjectURL(drawn.value.address)), []);
  return { drawn: drawn.value?.words === words || trouble.value === "" ? drawn.value : null, trouble: trouble.value };
}

export function PictureCard({ run, detail }: { run: RunHead; detail: RunDetail | null }): JSX.Element {
  const chosen = useSignal<Wanted>({ frame: "", colour: "contact", view: "front", width: "", height: "" });
  const frames = detail?.frame_list ?? [];
  const frame = frames.find(({ index }) => String(index) === chosen.value.frame)?.index ?? frames.at(-1)?.index;
  const wanted = frame === undefined ? null : { ...chosen.value, frame: String(frame) };
  const { drawn, trouble } = usePicture(run.id, wanted);
  const isNew = wanted !== null && drawn?.words === JSON.stringify([run.id, wanted]);
  const change = (changed: Partial<Wanted>): void => {
    chosen.value = { ...chosen.value, ...changed };
  };
  const file = wanted === null ? "" : `${run.id}-frame-${wanted.frame}-${wanted.colour}-${wanted.view}.png`;
  const options = wanted === null ? "" : given(wanted).map(([name, value]) => `--${name} ${quoted(value)}`).join(" ");
  return (
    <Card
      title="Picture"
      about="A stored frame in true proportions, with a scale, drawn by the program."
      trouble={trouble}
      command={`knitmech render ${quoted(runFolder(run.id))} ${options} -o ${quoted(file)}`}
      size="wide"
    >
      <div class="picture">
        <div class="choices">
          <Choice
            name="Frame"
            value={wanted?.frame ?? ""}
            choices={frames.map(({ index, strain }) => [String(index), `${index}, at ${(100 * strain).toFixed(1)} %`])}
            onChange={(value) => change({ frame: value })}
          />
          <Choice name="Colour" value={chosen.value.colour} choices={kColours.map(({ word, words }) => [word, words])} onChange={(colour) => change({ colour })} />
          <Choice name="View" value={chosen.value.view} choices={viewNames.map((name) => [name, name.charAt(0).toUpperCase() + name.slice(1)])} onChange={(view) => change({ view })} />
          <Pixels name="Width [px]" value={chosen.value.width} placeholder="automatic" onChange={(width) => change({ width })} />
          <Pixels name="Height [px]" value={chosen.value.height} placeholder="1400" onChange={(height) => change({ height })} />
          <button type="button" class="main" disabled={!isNew} onClick={() => save(file, drawn!.content)} title={file}>
            Download PNG
          </button>
        </div>
        <div class={isNew ? "preview" : "preview old"} data-test="picture" data-words={isNew ? options : ""}>
          {drawn === null ? <span class="quiet">{trouble === "" ? "Drawing." : ""}</span> : <img src={drawn.address} alt={`Frame of ${run.id}: ${options}`} />}
        </div>
      </div>
    </Card>
  );
}
