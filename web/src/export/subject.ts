// What is exported: the case in Design, or a run.

import { computed } from "@preact/signals";
import type { RunDetail, RunHead } from "../api/types";
import { nameOfCase } from "../design/files";
import { design, generation, path, text } from "../state/design";
import { noteView, route } from "../state/route";
import { details } from "../state/run_details";
import { runs } from "../state/runs";

export interface Subject {
  name: string; // of files, without an extension
  caseText: string | null; // null: not read yet
  casePath: string; // in the folder, for command lines
  isSaved: boolean; // the file at casePath is there
  mistake: string | null; // why the case cannot be exported
  run: RunHead | null; // null: the case in Design
  detail: RunDetail | null;
}

/** The folder of a run as a person types it in the folder of the page. */
export const runFolder = (id: string): string => `results/${id}`;

export const runId = computed(() => (route.value.page === "export" ? route.value.words.get("run") : null));

export const chooseSubject = (id: string): void => noteView("export", id === "" ? {} : { run: id });

function ofDesign(): Subject {
  const name = nameOfCase();
  return {
    name,
    caseText: generation.value === 0 ? null : text.value,
    casePath: path.value ?? `${name}.toml`,
    isSaved: path.value !== null,
    mistake: design.value?.mistakes[0]?.message ?? null,
    run: null,
    detail: null,
  };
}

/** Null while the run is not known. */
export const subject = computed<Subject | null>(() => {
  const id = runId.value;
  if (id === null || id === undefined) return ofDesign();
  const run = runs.value.get(id);
  if (run === undefined) return null;
  const detail = details.value.get(id) ?? null;
  return { name: id, caseText: detail?.case_text ?? null, casePath: `${runFolder(id)}/case.toml`, isSaved: true, mistake: null, run, detail };
});
