// Questions to the user that an action waits for: a choice, or a name.

import { signal, useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { Dialog } from "./dialog";

interface Question {
  title: string;
  words: string;
  choices: string[]; // the first one is the usual one
  name: string | null; // proposed; null: no name is asked for
  answer: (choice: string | null, name: string) => void;
}

const question = signal<Question | null>(null);

function put(asked: Omit<Question, "answer">): Promise<{ choice: string | null; name: string }> {
  return new Promise((resolve) => {
    question.value = {
      ...asked,
      answer: (choice, name) => {
        question.value = null;
        resolve({ choice, name });
      },
    };
  });
}

/** One of the choices; null if the user wants none. */
export async function choose(title: string, words: string, choices: string[]): Promise<string | null> {
  return (await put({ title, words, choices, name: null })).choice;
}

/** A name for a file; null if the user wants none. */
export async function askName(title: string, words: string, proposed: string): Promise<string | null> {
  const { choice, name } = await put({ title, words, choices: ["Save"], name: proposed });
  return choice === null ? null : name;
}

function Asked({ asked }: { asked: Question }): JSX.Element {
  const name = useSignal(asked.name ?? "");
  const isReady = asked.name === null || name.value.trim() !== "";
  return (
    <Dialog title={asked.title} onClose={() => asked.answer(null, "")}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          if (isReady) asked.answer(asked.choices[0] ?? null, name.value.trim());
        }}
      >
        <p>{asked.words}</p>
        {asked.name === null ? null : (
          <label class="asked-name">
            File in the folder
            <input
              type="text"
              autofocus
              spellcheck={false}
              value={name.value}
              onInput={(event) => (name.value = event.currentTarget.value)}
              onFocus={(event) => event.currentTarget.select()}
            />
          </label>
        )}
        <div class="answers">
          {asked.choices.map((choice, i) => (
            <button
              key={choice}
              type={i === 0 ? "submit" : "button"}
              class={i === 0 ? "main" : ""}
              disabled={!isReady}
              onClick={i === 0 ? undefined : () => asked.answer(choice, name.value.trim())}
            >
              {choice}
            </button>
          ))}
          <button type="button" onClick={() => asked.answer(null, "")}>
            Cancel
          </button>
        </div>
      </form>
    </Dialog>
  );
}

export function Questions(): JSX.Element | null {
  return question.value === null ? null : <Asked asked={question.value} />;
}
