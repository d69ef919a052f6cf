// The case that is being edited: its text is the truth, the form and the drawings follow it. Every change goes to the
// program, which answers with the text, the values in it, the mistakes, the facts and the centrelines.

import { batch, computed, signal } from "@preact/signals";
import type { Blob } from "../api/blob";
import * as client from "../api/client";
import type { CaseText, Design, Edit, GivenValue, LoopDrawing } from "../api/types";
import { noteError } from "./program";
import { forgetSteps, remember, stepBack, stepForth } from "./undo";

export const text = signal("");
export const path = signal<string | null>(null); // of the file in the folder; null: never saved
export const stamp = signal<string | null>(null); // of that file as it was read or saved
export const savedText = signal(""); // as it was opened or saved
export const design = signal<Design | null>(null); // of the latest text that was answered
export const fabric = signal<Blob<Design> | null>(null); // the latest with centrelines; stays while there is a mistake
export const loop = signal<LoopDrawing | null>(null); // the latest that could be drawn
export const given = signal<Record<string, GivenValue>>({}); // of the latest text that could be read
export const isReadable = signal(true); // whether the present text is a case file at all, right or wrong
export const fabricGeneration = signal(0); // counts the fabrics
export const generation = signal(0); // counts the answers; the drawings have followed when it is on their elements
export const isBusy = signal(false); // whether a change waits for its answer
export const opened = signal(0); // counts the cases that were opened

export const isChanged = computed(() => text.value !== savedText.value);

let asked = 0; // number of the latest request
let answered = 0;
let pending: Edit[] = []; // edits of the form that wait for the answer before them
let waiting: (() => void)[] = []; // for all changes to be answered

function take(answer: Blob<Design>, edit: Edit | undefined): void {
  batch(() => {
    if (edit !== undefined && answer.head.text !== text.value) remember(text.value, edit.key);
    text.value = answer.head.text;
    design.value = answer.head;
    isReadable.value = answer.head.mistakes.length === 0 || Object.keys(answer.head.given).length > 0;
    if (isReadable.value) given.value = answer.head.given;
    if (answer.head.loop !== null) loop.value = answer.head.loop;
    if (answer.head.fabric !== null) {
      fabric.value = answer;
      fabricGeneration.value += 1;
    }
    generation.value += 1;
  });
}

async function askOnce(): Promise<void> {
  const edit = pending.shift();
  const before = text.value;
  const number = asked;
  const ofCase = opened.value;
  const answer = await client.design({ text: before, fabric: true, ...(edit === undefined ? {} : { edit }) });
  answered = number;
  if (ofCase !== opened.value) return; // another case is there; what was asked for it follows
  if (text.value === before) {
    take(answer, edit);
  } else if (edit !== undefined && !pending.some((later) => later.key === edit.key)) {
    pending.unshift(edit); // The user typed in the text meanwhile: the edit is done again on the new text.
  }
}

/** Asks for the design of the present text; edits are done one after the other, none is lost. */
async function ask(): Promise<void> {
  if (isBusy.value) return;
  isBusy.value = true;
  try {
    while (pending.length > 0 || answered < asked) await askOnce();
  } catch (error) {
    answered = asked;
    pending = [];
    noteError(error);
  } finally {
    isBusy.value = false;
    for (const goOn of waiting.splice(0)) goOn();
  }
}

/** Done when the text has all changes of the form. */
export function whenSettled(): Promise<void> {
  return isBusy.value ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
}

function put(now: string): void {
  text.value = now;
  asked += 1;
  void ask();
}

/** A new text, typed by the user. */
export function setText(now: string): void {
  if (now === text.value) return;
  remember(text.value, "text");
  put(now);
}

/** A value typed into the form. A later one of the same key takes the place of one that still waits. */
export function setValue(edit: Edit): void {
  pending = [...pending.filter((each) => each.key !== edit.key), edit];
  asked += 1;
  void ask();
}

export function undo(): void {
  const before = stepBack(text.value);
  if (before !== null) put(before);
}

export function redo(): void {
  const after = stepForth(text.value);
  if (after !== null) put(after);
}

/** Another case in place of the present one. */
export function open(what: CaseText): void {
  batch(() => {
    path.value = what.path;
    stamp.value = what.stamp;
    savedText.value = what.text;
    opened.value += 1;
  });
  pending = [];
  forgetSteps();
  put(what.text);
}

/** The present text is that of a file now. */
export function noteSaved(where: string, saved: string, mark: string): void {
  batch(() => {
    path.value = where;
    savedText.value = saved;
    stamp.value = mark;
  });
}
