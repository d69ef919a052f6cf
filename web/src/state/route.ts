// Where the page is: "#/explore?run=jersey&frame=3". A link with it restores the view.

import { signal } from "@preact/signals";

export type PageName = "design" | "run" | "explore" | "export";
export const pageNames: readonly PageName[] = ["design", "run", "explore", "export"];

export interface Route {
  page: PageName;
  words: URLSearchParams;
}

function read(): Route {
  const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?", 2);
  const page = pageNames.find((name) => name === path) ?? "design";
  return { page, words: new URLSearchParams(query) };
}

export const route = signal<Route>(read());
addEventListener("hashchange", () => {
  route.value = read();
});

export function addressOf(page: PageName, words: Record<string, string> = {}): string {
  const query = new URLSearchParams(words).toString();
  return `#/${page}${query === "" ? "" : `?${query}`}`;
}

export function goTo(page: PageName, words: Record<string, string> = {}): void {
  location.hash = addressOf(page, words);
}

/** Writes the view into the address without a step in the browser's history. */
export function noteView(page: PageName, words: Record<string, string>): void {
  history.replaceState(null, "", addressOf(page, words));
  route.value = read();
}
