// Light or dark: as the computer has it, until the user chooses.

import { computed, effect, signal } from "@preact/signals";

export type Theme = "light" | "dark";

const kStored = "knitmech.theme";
const system = matchMedia("(prefers-color-scheme: dark)");
const systemTheme = signal<Theme>(system.matches ? "dark" : "light");
system.addEventListener("change", (event) => {
  systemTheme.value = event.matches ? "dark" : "light";
});

const stored = localStorage.getItem(kStored);
const chosen = signal<Theme | null>(stored === "light" || stored === "dark" ? stored : null);

export const theme = computed<Theme>(() => chosen.value ?? systemTheme.value);

effect(() => {
  document.documentElement.dataset["theme"] = theme.value;
});

export function toggleTheme(): void {
  chosen.value = theme.value === "light" ? "dark" : "light";
  localStorage.setItem(kStored, chosen.value);
}
