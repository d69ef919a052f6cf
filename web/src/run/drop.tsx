// Files may be dropped anywhere on the page.

import { signal } from "@preact/signals";
import type { JSX } from "preact";
import { askAbout } from "./measured_dialog";

const isOver = signal(false); // files are held over the page

const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") === true;

/** Until the function that is returned is called. */
export function listenToDrops(): () => void {
  const over = (event: DragEvent): void => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    isOver.value = true;
  };
  const leave = (event: DragEvent): void => {
    if (event.relatedTarget === null) isOver.value = false;
  };
  const drop = (event: DragEvent): void => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    isOver.value = false;
    askAbout(event.dataTransfer?.files ?? []);
  };
  addEventListener("dragover", over);
  addEventListener("dragleave", leave);
  addEventListener("drop", drop);
  return () => {
    removeEventListener("dragover", over);
    removeEventListener("dragleave", leave);
    removeEventListener("drop", drop);
    isOver.value = false;
  };
}

export function DropSign(): JSX.Element | null {
  return isOver.value ? <div class="drop-sign">Drop a table with measured curves (CSV)</div> : null;
}
