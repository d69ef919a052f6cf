// The window in which a case is chosen: those of the folder and the examples.

import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import * as client from "../api/client";
import type { Cases, CaseText } from "../api/types";
import { noteError } from "../state/program";
import { Dialog } from "./dialog";
import { isOpening, openFrom } from "./files";

interface Choice {
  name: string;
  title: string;
  read: () => Promise<CaseText>;
}

function List({ title, choices, none }: { title: string; choices: Choice[]; none: string }): JSX.Element {
  return (
    <section>
      <h3>{title}</h3>
      {choices.length === 0 ? <p class="quiet">{none}</p> : null}
      <ul>
        {choices.map(({ name, title: words, read }) => (
          <li key={name}>
            <button type="button" class="plain" onClick={() => void openFrom(read)}>
              <span>{words === "" ? name : words}</span>
              <span class="quiet">{name}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Window(): JSX.Element {
  const cases = useSignal<Cases | null>(null);
  const close = (): void => {
    isOpening.value = false;
  };
  useEffect(() => {
    client
      .cases()
      .then((found) => (cases.value = found))
      .catch((error: unknown) => {
        noteError(error);
        close();
      });
  }, []);
  const ofFolder = cases.value?.cases.map(({ path, title }) => ({ name: path, title, read: () => client.readCase(path) }));
  const examples = cases.value?.examples.map(({ name, title }) => ({ name, title, read: () => client.example(name) }));
  return (
    <Dialog title="Open a case" onClose={close}>
      <div class="cases">
        {ofFolder === undefined || examples === undefined ? (
          <p class="quiet">Looking for cases.</p>
        ) : (
          <>
            <List title="In the folder" choices={ofFolder} none="There is no case in the folder yet." />
            <List title="Examples" choices={examples} none="There are no examples." />
          </>
        )}
      </div>
      <div class="answers">
        <button type="button" onClick={close}>
          Cancel
        </button>
      </div>
    </Dialog>
  );
}

export function OpenDialog(): JSX.Element | null {
  return isOpening.value ? <Window /> : null;
}
