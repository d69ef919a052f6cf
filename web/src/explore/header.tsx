// The head of the side panel: the run, and what can be taken away.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { figures } from "../parts/curve_data";
import type { FabricViewHandle } from "../parts/fabric_view";
import { note, noteError } from "../state/program";
import { newestFirst } from "../state/runs";
import { ends, fieldHead } from "./colouring";
import { opened } from "./open_run";
import { captioned, download } from "./picture";
import { force, shown } from "./shown";
import { addressNow, chooseRun, runId } from "./view_words";
import { percent } from "./words";

const kPictureRatio = 2;

async function savePicture(view: FabricViewHandle | null): Promise<void> {
  const run = opened.value;
  const now = shown.value;
  if (view === null || run === null || now === null) return;
  const field = fieldHead.value;
  const bar =
    field === null || ends.value === null
      ? null
      : { label: `${field.label} [${field.unit}]`, lowest: ends.value[0], highest: ends.value[1] };
  const ofForce = force.value === null ? "" : `, force ${figures(force.value)} N`;
  const caption = { title: run.title, facts: `strain ${percent(now.strain)}${ofForce}`, bar };
  try {
    const picture = await captioned(view.picture(kPictureRatio), caption, kPictureRatio);
    download(picture, `${run.id}-${(100 * now.strain).toFixed(1)}-percent.png`);
  } catch (error) {
    noteError(error);
  }
}

async function copyLink(): Promise<void> {
  try {
    await navigator.clipboard.writeText(addressNow());
    note("The link to this view is copied.");
  } catch {
    noteError(new Error("The browser did not let the link be copied; it stands in the address bar."));
  }
}

export function Header({ view }: { view: { current: FabricViewHandle | null } }): JSX.Element {
  const [isSaving, setSaving] = useState(false);
  const runs = newestFirst.value.filter((run) => run.frames > 0 || run.live > 0 || run.id === runId.value);
  const save = (): void => {
    setSaving(true);
    void savePicture(view.current).finally(() => setSaving(false));
  };
  return (
    <section class="group" aria-label="Run">
      <label class="choice">
        <span>Run</span>
        <select value={runId.value ?? ""} onChange={(event) => chooseRun(event.currentTarget.value)}>
          {runs.map((run) => (
            <option key={run.id} value={run.id}>
              {run.id}
            </option>
          ))}
        </select>
      </label>
      <p class="run-title">{opened.value?.title ?? ""}</p>
      <div class="buttons">
        <button type="button" onClick={save} disabled={isSaving || shown.value === null} title="Save the view as a PNG with its caption">
          Save picture
        </button>
        <button type="button" onClick={() => void copyLink()} title="A link that restores this view">
          Copy link
        </button>
      </div>
    </section>
  );
}
