// What can be done with the case, and whether it is saved and can be run.

import type { JSX } from "preact";
import { design, given, isChanged, path, redo, undo } from "../state/design";
import { canRedo, canUndo } from "../state/undo";
import { isOpening, isStarting, openNew, save, saveAs, startRun } from "./files";
import { goToField } from "./pointing";

function State(): JSX.Element {
  const title = given.value["title"]?.typed ?? "";
  return (
    <div class="state">
      <strong title={title}>{title}</strong>
      <span class="quiet" title={path.value ?? ""}>
        {path.value ?? "not in a file yet"}
      </span>
      <span class={isChanged.value ? "unsaved on" : "unsaved"} role="status">
        {isChanged.value ? "unsaved changes" : ""}
      </span>
    </div>
  );
}

function RunButton(): JSX.Element {
  const mistakes = design.value?.mistakes ?? [];
  const first = mistakes[0];
  const key = mistakes.find((mistake) => mistake.key !== null)?.key ?? null;
  const count = mistakes.length === 1 ? "1 mistake" : `${mistakes.length} mistakes`;
  return (
    <>
      {first === undefined ? null : (
        <button type="button" class="plain wrong" id="why-not" disabled={key === null} onClick={() => key !== null && goToField(key)}>
          {count} to mend first
        </button>
      )}
      <button
        type="button"
        class="main run"
        disabled={design.value === null || first !== undefined || isStarting.value}
        aria-describedby={first === undefined ? undefined : "why-not"}
        title={first === undefined ? "Run this case" : first.message}
        onClick={() => void startRun()}
      >
        Run
      </button>
    </>
  );
}

export function ToolBar(): JSX.Element {
  return (
    <div class="tool-bar" role="toolbar" aria-label="Case">
      <button type="button" onClick={() => void openNew()} title="A new case, from the template">
        New
      </button>
      <button type="button" onClick={() => (isOpening.value = true)}>
        Open…
      </button>
      <button type="button" onClick={() => void save()} title="Ctrl+S">
        Save
      </button>
      <button type="button" onClick={() => void saveAs()}>
        Save as…
      </button>
      <span class="divider" />
      <button type="button" class="plain" disabled={!canUndo.value} onClick={undo} aria-label="Undo" title="Undo (Ctrl+Z)">
        ↶
      </button>
      <button type="button" class="plain" disabled={!canRedo.value} onClick={redo} aria-label="Redo" title="Redo (Ctrl+Shift+Z)">
        ↷
      </button>
      <State />
      <RunButton />
    </div>
  );
}
