// Asks for the size of the specimens of measured curves, and tells what the program cannot read in a file.

import { signal, useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { Dialog } from "../design/dialog";
import { figures } from "../parts/curve_data";
import { widthAtStart } from "./curves";
import { details } from "../state/run_details";
import { addMeasured, type Specimens } from "./measured";
import { selectedId } from "./shown";

const files = signal<readonly File[]>([]); // that wait for an answer

export function askAbout(chosen: Iterable<File>): void {
  files.value = [...files.value, ...chosen];
}

const typedLength = (length: number | null | undefined): string => (length == null ? "" : `${figures(length)} mm`);

/** Those of the selected run; the last ones that were typed are better if there are any. */
let latest: Specimens | null = null;
function proposed(): Specimens {
  const id = selectedId.value;
  const detail = id === null ? undefined : details.value.get(id);
  return latest ?? { gaugeLength: typedLength(detail?.gauge_length), width: typedLength(id === null ? null : widthAtStart(id)) };
}

interface Refusal {
  file: File;
  message: string;
}

/** Files that the program refused, with its words. */
async function readAll(chosen: readonly File[], specimens: Specimens): Promise<Refusal[]> {
  const refusals: Refusal[] = [];
  for (const file of chosen) {
    try {
      await addMeasured(file, specimens);
    } catch (error) {
      refusals.push({ file, message: error instanceof Error ? error.message : String(error) });
    }
  }
  return refusals;
}

interface LengthProps {
  name: string;
  what: string;
  value: string;
  onInput: (typed: string) => void;
}

function LengthField({ name, what, value, onInput }: LengthProps): JSX.Element {
  return (
    <label>
      <span>{name}</span>
      <input type="text" required value={value} placeholder="100 mm" onInput={(event) => onInput(event.currentTarget.value)} />
      <span class="quiet">{what}</span>
    </label>
  );
}

function Window(): JSX.Element {
  const specimens = useSignal(proposed());
  const refusals = useSignal<readonly Refusal[]>([]);
  const isReading = useSignal(false);
  const close = (): void => {
    files.value = [];
  };
  const add = async (event: Event): Promise<void> => {
    event.preventDefault();
    if (isReading.value) return;
    isReading.value = true;
    latest = specimens.value;
    refusals.value = await readAll(files.value, specimens.value);
    isReading.value = false;
    files.value = refusals.value.map((refusal) => refusal.file);
  };
  return (
    <Dialog title="Measured curves" onClose={close}>
      <form class="measured-form" onSubmit={(event) => void add(event)}>
        <ul class="files">
          {files.value.map((file, i) => (
            <li key={i}>
              <strong>{file.name}</strong>
              {refusals.value
                .filter((refusal) => refusal.file === file)
                .map((refusal) => (
                  <p class="wrong" role="alert">
                    {refusal.message}
                  </p>
                ))}
            </li>
          ))}
        </ul>
        <p class="quiet">The size of the specimens turns displacements into strains, and forces into forces per width.</p>
        <LengthField
          name="Gauge length"
          what="between the grips"
          value={specimens.value.gaugeLength}
          onInput={(gaugeLength) => (specimens.value = { ...specimens.value, gaugeLength })}
        />
        <LengthField name="Width" what="across the pull" value={specimens.value.width} onInput={(width) => (specimens.value = { ...specimens.value, width })} />
        <div class="answers">
          <button type="submit" class="main" disabled={isReading.value}>
            Show
          </button>
          <button type="button" onClick={close}>
            Cancel
          </button>
        </div>
      </form>
    </Dialog>
  );
}

export function MeasuredDialog(): JSX.Element | null {
  return files.value.length > 0 ? <Window /> : null;
}
