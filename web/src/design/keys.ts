// Keys of the page Design, and the question of the browser before unsaved changes are lost.

import { isChanged, redo, undo } from "../state/design";
import { save } from "./files";

const isText = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement && (target.isContentEditable || target.matches("input, textarea"));

function onKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || document.querySelector("dialog[open]") !== null) return;
  const key = event.key.toLowerCase();
  if (key === "s" && !event.shiftKey) {
    event.preventDefault();
    void save();
  } else if ((key === "z" || key === "y") && !isText(event.target)) {
    event.preventDefault();
    if (key === "y" || event.shiftKey) redo();
    else undo();
  }
}

/** Listens until the returned function is called. */
export function listenToKeys(): () => void {
  addEventListener("keydown", onKey);
  return () => removeEventListener("keydown", onKey);
}

addEventListener("beforeunload", (event) => {
  if (isChanged.value) event.preventDefault();
});
