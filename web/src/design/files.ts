// New, open, save and run: what the tool bar does with the case.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import type { CaseText } from "../api/types";
import { design, given, isChanged, noteSaved, open, path, stamp, text, whenSettled } from "../state/design";
import { note, noteError, program } from "../state/program";
import { goTo, noteView } from "../state/route";
import { askName, choose } from "./questions";

export const isOpening = signal(false); // the window with the cases is there
export const isStarting = signal(false); // a run is being started

/** "First loop: jersey of 5 wales" -> "first-loop-jersey-of-5-wales", a name that every system takes. */
export function safeName(words: string): string {
  const plain = words.normalize("NFKD").replace(/[\u0300-\u036f]/g, "").toLowerCase();
  return plain.replace(/[^a-z0-9]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 48).replace(/-+$/, "") || "case";
}

/** Name of the case for a run or a file: that of its file, of its folder if the file is case.toml, else its title. */
export function nameOfCase(): string {
  const parts = (path.value ?? "").split("/");
  const file = (parts.at(-1) ?? "").replace(/\.toml$/, "");
  if (file === "case" && parts.length > 1) return safeName(parts.at(-2) ?? "");
  return safeName(file !== "" ? file : (given.value["title"]?.typed ?? ""));
}

/** Says what goes wrong instead of throwing. */
async function carefully(action: () => Promise<void>): Promise<void> {
  try {
    await action();
  } catch (error) {
    noteError(error);
  }
}

async function mayLeave(): Promise<boolean> {
  await whenSettled();
  if (!isChanged.value) return true;
  const answer = await choose("Unsaved changes", "The present case has changes that are not saved.", ["Save first", "Drop the changes"]);
  if (answer === "Save first") return save();
  return answer !== null;
}

/** Opens what is read, after asking about unsaved changes. */
export function openFrom(read: () => Promise<CaseText>): Promise<void> {
  return carefully(async () => {
    if (!(await mayLeave())) return;
    const found = await read();
    isOpening.value = false;
    open(found);
    showPath();
  });
}

export const openNew = (): Promise<void> => openFrom(client.template);

/** The address names the file, so that a link or a reload finds it again. */
function showPath(): void {
  noteView("design", path.value === null ? {} : { case: path.value });
}

/** Writes the text; false if another file, or another version of this one, is there. */
async function write(where: string, mark: string | null): Promise<string | null> {
  const written = text.value;
  try {
    const saved = await client.saveCase({ path: where, text: written, stamp: mark });
    noteSaved(where, written, saved.stamp);
    showPath();
    note(`Saved ${where}.`);
    return null;
  } catch (error) {
    if (error instanceof client.Refused && error.status === 409) return error.message;
    throw error;
  }
}

async function saveUnderName(words: string): Promise<boolean> {
  let why = words;
  let proposed = path.value ?? `${nameOfCase()}.toml`;
  for (;;) {
    const name = await askName("Save the case", why, proposed);
    if (name === null) return false;
    const where = name.endsWith(".toml") ? name : `${name}.toml`;
    const conflict = await write(where, null);
    if (conflict === null) return true;
    why = conflict;
    proposed = where;
  }
}

/** The file is not as it was read: another program wrote it. */
async function settleConflict(where: string, why: string): Promise<boolean> {
  const answer = await choose("The file has changed", why, ["Save under another name", "Reload from the file"]);
  if (answer === "Save under another name") return saveUnderName("Give the case another name.");
  if (answer === "Reload from the file") open(await client.readCase(where));
  return false;
}

async function saveNow(): Promise<boolean> {
  await whenSettled();
  const where = path.value;
  if (where === null) return saveUnderName(`The case is written into ${program.value?.folder ?? "the folder"}.`);
  const conflict = await write(where, stamp.value);
  return conflict === null || settleConflict(where, conflict);
}

/** True if the case is saved then. */
export async function save(): Promise<boolean> {
  try {
    return await saveNow();
  } catch (error) {
    noteError(error);
    return false;
  }
}

export function saveAs(): Promise<void> {
  return carefully(async () => {
    await whenSettled();
    await saveUnderName("The case is written under another name; the present file stays as it is.");
  });
}

export async function startRun(): Promise<void> {
  if (isStarting.value) return;
  isStarting.value = true;
  await carefully(async () => {
    await whenSettled();
    if (design.value === null || design.value.mistakes.length > 0) return;
    const { id } = await client.startRun({ text: text.value, name: nameOfCase() });
    goTo("run", { runs: id });
  });
  isStarting.value = false;
}
