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

function useFormats(): readonly ExportFormat[] {
  const formats = useSignal<readonly ExportFormat[]>([]);
  useEffect(() => {
    client
      .formats()
      .then((found) => (formats.value = found))
      .catch(noteError);
  }, []);
  return formats.value;
}

/** "jersey.inp", or of several files "jersey_0000.rad and jersey_0001.rad". */
const fileNames = (stem: string, format: ExportFormat | undefined): string => (format?.endings ?? []).map((ending) => stem + ending).join(" and ");

async function saveAll(stem: string, text: string, format: ExportFormat): Promise<void> {
  for (const ending of format.endings) save(stem + ending, await client.exportCase(text, format.name, stem, ending));
}

export function DeckCard({ subject }: { subject: Subject }): JSX.Element {
  const formats = useFormats();
  const chosen = useSignal("");
  const { isBusy, trouble, act } = useAction();
  const format = formats.find((each) => each.name === chosen.value) ?? formats[0];
  const file = `${subject.name}${format?.endings[0] ?? ""}`;
  const text = subject.caseText;
  const canSave = format !== undefined && text !== null && subject.mistake === null;
  return (
    <Card
      title="Simulation deck"
      about="The model of the case, to be simulated by another program."
      trouble={subject.mistake === null ? trouble : `The case in Design has a mistake: ${subject.mistake}`}
      terminal={onceSaved(subject)}
      command={`knitmech export ${quoted(subject.casePath)} -f ${format?.name ?? ""} -o ${quoted(file)}`}
    >
      <label class="pair">
        <span>Format</span>
        <select aria-label="Format" value={format?.name ?? ""} onChange={(event) => (chosen.value = event.currentTarget.value)}>
          {formats.map((each) => (
            <option key={each.name} value={each.name}>
              {each.label}
            </option>
          ))}
        </select>
      </label>
      <button type="button" class="main" disabled={!canSave || isBusy} onClick={() => act(() => saveAll(subject.name, text as string, format!))}>
        {isBusy ? "Writing" : `Download ${fileNames(subject.name, format)}`}
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
