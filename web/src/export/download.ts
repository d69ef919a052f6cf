// Files go to where the browser keeps what is downloaded.

import { useSignal } from "@preact/signals";

export function save(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000); // some browsers read it only after the click
}

export interface Action {
  isBusy: boolean;
  trouble: string; // why the last one failed
  act: (action: () => Promise<void>) => void;
}

/** For what a button does: one at a time, and what goes wrong is told beside it. */
export function useAction(): Action {
  const isBusy = useSignal(false);
  const trouble = useSignal("");
  const work = async (action: () => Promise<void>): Promise<void> => {
    if (isBusy.value) return;
    isBusy.value = true;
    trouble.value = "";
    try {
      await action();
    } catch (error) {
      trouble.value = error instanceof Error ? error.message : String(error);
    } finally {
      isBusy.value = false;
    }
  };
  return { isBusy: isBusy.value, trouble: trouble.value, act: (action) => void work(action) };
}
