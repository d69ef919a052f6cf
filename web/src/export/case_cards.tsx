// What comes of a case alone: the deck for another program, and its file.

import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import * as client from "../api/client";
import type { ExportFormat } from "../api/types";
import { noteError } from "../state/program";
import { Card, quoted } from "./card";
import { save, useAction } from "./download";
import type { Subject } from "./subject";

const onceSaved = (subject: Subject): string => (subject.isSaved ? "The same in a terminal:" : "The same in a terminal, when the case is saved under this name:");

function useFormats(kind: ExportFormat["kind"]): readonly ExportFormat[] {
  const formats = useSignal<readonly ExportFormat[]>([]);
  useEffect(() => {
    client
      .formats()
      .then((found) => (formats.value = found))
      .catch(noteError);
  }, []);
  return formats.value.filter((format) => format.kind === kind);
}

/** "jersey.inp", or of several files "jersey_0000.rad and jersey_0001.rad". */
const fileNames = (stem: string, format: ExportFormat | undefined): string => (format?.endings ?? []).map((ending) => stem + ending).join(" and ");

interface ChooserProps {
  formats: readonly ExportFormat[];
  format: ExportFormat | undefined;
  onChoose: (name: string) => void;
}

function FormatChooser({ formats, format, onChoose }: ChooserProps): JSX.Element {
  return (
    <label class="pair">
      <span>Format</span>
      <select aria-label="Format" value={format?.name ?? ""} onChange={(event) => onChoose(event.currentTarget.value)}>
        {formats.map((each) => (
          <option key={each.name} value={each.name}>
            {each.label}
          </option>
        ))}
      </select>
    </label>
  );
}

export function DeckCard({ subject }: { subject: Subject }): JSX.Element {
  const formats = useFormats("deck");
  const chosen = useSignal("");
  const { isBusy, trouble, act } = useAction();
  const format = formats.find((each) => each.name === chosen.value) ?? formats[0];
  const text = subject.caseText;
  const canSave = format !== undefined && text !== null && subject.mistake === null;
  const saveAll = async (): Promise<void> => {
    for (const ending of format?.endings ?? []) {
      save(subject.name + ending, await client.exportCase(text ?? "", format?.name ?? "", subject.name, ending));
    }
  };
  return (
    <Card
      title="Simulation deck"
      about="The model of the case, to be simulated by another program."
      trouble={subject.mistake === null ? trouble : `The case in Design has a mistake: ${subject.mistake}`}
      terminal={onceSaved(subject)}
      command={`knitmech export ${quoted(subject.casePath)} -f ${format?.name ?? ""} -o ${quoted(`${subject.name}${format?.endings[0] ?? ""}`)}`}
    >
      <FormatChooser formats={formats} format={format} onChoose={(name) => (chosen.value = name)} />
      <button type="button" class="main" disabled={!canSave || isBusy} onClick={() => act(saveAll)}>
        {isBusy ? "Writing" : `Download ${fileNames(subject.name, format)}`}
      </button>
    </Card>
  );
}

/** The yarns as they are at the start, or at a stored strain of a run. */
export function GeometryCard({ subject }: { subject: Subject }): JSX.Element {
  const formats = useFormats("geometry");
  const chosen = useSignal("");
  const frame = useSignal("");
  const { isBusy, trouble, act } = useAction();
  const format = formats.find((each) => each.name === chosen.value) ?? formats[0];
  const frames = subject.detail?.frame_list ?? [];
  const last = frames[frames.length - 1];
  const index = frames.some((each) => String(each.index) === frame.value) ? frame.value : String(last?.index ?? "");
  const file = fileNames(subject.name, format);
  const isRun = subject.run !== null;
  const canSave = format !== undefined && (isRun ? last !== undefined : subject.caseText !== null && subject.mistake === null);
  const saveAll = async (): Promise<void> => {
    for (const ending of format?.endings ?? []) {
      const words = { format: format?.name ?? "", frame: index, ending };
      save(
        subject.name + ending,
        isRun
          ? await client.bytesAt(client.geometryAddress(subject.run?.id ?? "", words))
          : await client.exportCase(subject.caseText ?? "", words.format, subject.name, ending),
      );
    }
  };
  const source = isRun ? `${quoted(subject.casePath.replace(/\/case\.toml$/, ""))} --frame ${index}` : quoted(subject.casePath);
  return (
    <Card
      title="Geometry"
      about={isRun ? "The yarns as tubes or lines, in the shape of a stored frame." : "The yarns as tubes or lines, as they are knitted."}
      trouble={isRun || subject.mistake === null ? trouble : `The case in Design has a mistake: ${subject.mistake}`}
      terminal={isRun ? "The same in a terminal:" : onceSaved(subject)}
      command={`knitmech export ${source} -f ${format?.name ?? ""} -o ${quoted(file)}`}
    >
      <FormatChooser formats={formats} format={format} onChoose={(name) => (chosen.value = name)} />
      {isRun ? (
        <label class="pair">
          <span>Frame</span>
          <select aria-label="Frame of the geometry" value={index} onChange={(event) => (frame.value = event.currentTarget.value)}>
            {frames.map((each) => (
              <option key={each.index} value={each.index}>
                {(100 * each.strain).toFixed(1)} %
              </option>
            ))}
          </select>
        </label>
      ) : null}
      <button type="button" class="main" disabled={!canSave || isBusy} onClick={() => act(saveAll)}>
        {isBusy ? "Writing" : `Download ${file}`}
      </button>
    </Card>
  );
}

export function CaseCard({ subject }: { subject: Subject }): JSX.Element {
  const text = subject.caseText;
  const file = `${subject.name}.toml`;
  return (
    <Card
      title="Case file"
      about={subject.run === null ? "The case as it stands in Design, with its comments." : "The case of the run, with every default filled in."}
      terminal={subject.isSaved ? "To read it in a terminal:" : "To read it in a terminal, when the case is saved under this name:"}
      command={`knitmech check ${quoted(subject.casePath)}`}
    >
      <button type="button" class="main" disabled={text === null} onClick={() => save(file, new Blob([text as string], { type: "text/plain" }))}>
        Download {file}
      </button>
    </Card>
  );
}
