// What the page knows of the program, read once at the start.

import { signal } from "@preact/signals";
import * as client from "../api/client";
import type { Parameters, Program } from "../api/types";

export const program = signal<Program | null>(null);
export const parameters = signal<Parameters | null>(null);

/** Short sentences for the user, shown for some seconds at the foot of the page; wrong ones stay until they are closed. */
export interface Note {
  id: number;
  text: string;
  isWrong: boolean;
}
export const notes = signal<Note[]>([]);

let nextNote = 1;
const kSecondsOfNote = 5;

export function closeNote(id: number): void {
  notes.value = notes.value.filter((note) => note.id !== id);
}

export function note(text: string): void {
  const id = nextNote++;
  notes.value = [...notes.value, { id, text, isWrong: false }];
  setTimeout(() => closeNote(id), 1000 * kSecondsOfNote);
}

export function noteError(error: unknown): void {
  const text = error instanceof Error ? error.message : String(error);
  notes.value = [...notes.value.filter((each) => each.text !== text), { id: nextNote++, text, isWrong: true }];
}

export async function readProgram(): Promise<void> {
  [program.value, parameters.value] = await Promise.all([client.program(), client.parameters()]);
}
