// The right side: mistakes, and below them the values or the case file.

import { signal } from "@preact/signals";
import type { JSX } from "preact";
import type { Mistake } from "../api/types";
import { design } from "../state/design";
import { parameters } from "../state/program";
import { CaseText } from "./case_text";
import { goToField } from "./pointing";
import { Values } from "./values";
import { parameterTitle, sectionTitle } from "./words";

type Tab = "values" | "text";
const tabs: { name: Tab; title: string }[] = [
  { name: "values", title: "Values" },
  { name: "text", title: "Case file" },
];
const shownTab = signal<Tab>("values");

/** A mistake of a value leads to its field, another one to the case file. */
function goTo(mistake: Mistake): void {
  if (mistake.key !== null) goToField(mistake.key);
  else shownTab.value = "text";
}

function Where({ mistake }: { mistake: Mistake }): JSX.Element | null {
  const parameter = parameters.value?.parameters.find((each) => each.key === mistake.key);
  if (parameter === undefined) return null;
  return (
    <strong>
      {sectionTitle(parameter.section)}: {parameterTitle(parameter)}
    </strong>
  );
}

function Mistakes({ mistakes }: { mistakes: Mistake[] }): JSX.Element {
  return (
    <ul class="mistakes" aria-label="Mistakes">
      {mistakes.map((mistake) => (
        <li key={`${mistake.key} ${mistake.line} ${mistake.message}`}>
          <button type="button" onClick={() => goTo(mistake)}>
            <Where mistake={mistake} />
            {mistake.message}
            {mistake.line === null ? null : <span class="quiet"> Line {mistake.line}</span>}
          </button>
        </li>
      ))}
    </ul>
  );
}

function Tabs(): JSX.Element {
  const move = (event: KeyboardEvent): void => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    shownTab.value = shownTab.value === "values" ? "text" : "values";
    document.getElementById(`tab-${shownTab.value}`)?.focus();
  };
  return (
    <div class="tabs" role="tablist" aria-label="Values and case file">
      {tabs.map(({ name, title }) => (
        <button
          key={name}
          type="button"
          role="tab"
          id={`tab-${name}`}
          aria-selected={shownTab.value === name}
          aria-controls="tab-panel"
          tabIndex={shownTab.value === name ? 0 : -1}
          onClick={() => (shownTab.value = name)}
          onKeyDown={move}
        >
          {title}
        </button>
      ))}
    </div>
  );
}

export function SidePanel(): JSX.Element {
  const mistakes = design.value?.mistakes ?? [];
  return (
    <section class={`panel side shows-${shownTab.value}`} aria-label="Values and case file">
      <Tabs />
      {mistakes.length === 0 ? null : <Mistakes mistakes={mistakes} />}
      <div class="tab-panel" id="tab-panel" role="tabpanel" aria-labelledby={`tab-${shownTab.value}`}>
        {shownTab.value === "values" ? <Values /> : <CaseText />}
      </div>
    </section>
  );
}
