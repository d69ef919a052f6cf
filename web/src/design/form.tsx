// All parameters of the case, made from the program's table, in groups that can be closed.

import { signal, useSignalEffect } from "@preact/signals";
import type { JSX } from "preact";
import type { Parameter } from "../api/types";
import { design, given, isReadable } from "../state/design";
import { parameters } from "../state/program";
import { Field } from "./field";
import { HelpLine } from "./help_line";
import { fieldId, wanted } from "./pointing";
import { isFoundBy, sectionTitle } from "./words";

const filter = signal("");
const openGroups = signal<ReadonlySet<string>>(new Set(["", "loop", "fabric", "yarn"]));
const groupsWithMore = signal<ReadonlySet<string>>(new Set());

function toggled(set: ReadonlySet<string>, name: string): ReadonlySet<string> {
  const next = new Set(set);
  if (!next.delete(name)) next.add(name);
  return next;
}

/** Optional parameters stand aside until they are given. */
const standsAside = (parameter: Parameter): boolean =>
  parameter.need === "optional" &&
  given.value[parameter.key] === undefined &&
  !design.value?.mistakes.some((mistake) => mistake.key === parameter.key);

function Rows({ name, all }: { name: string; all: Parameter[] }): JSX.Element {
  const aside = filter.value === "" ? all.filter(standsAside) : [];
  const shown = groupsWithMore.value.has(name) ? all : all.filter((parameter) => !aside.includes(parameter));
  return (
    <fieldset class="rows" id={`group-${name}`} disabled={!isReadable.value}>
      {shown.map((parameter) => (
        <Field key={parameter.key} parameter={parameter} />
      ))}
      {aside.length === 0 ? null : (
        <button
          type="button"
          class="plain more"
          aria-expanded={groupsWithMore.value.has(name)}
          onClick={() => (groupsWithMore.value = toggled(groupsWithMore.value, name))}
        >
          {groupsWithMore.value.has(name) ? "Hide what is not given" : `More: ${aside.length} not given`}
        </button>
      )}
    </fieldset>
  );
}

function Group({ name, help, all }: { name: string; help: string; all: Parameter[] }): JSX.Element {
  const mistakes = design.value?.mistakes.filter((mistake) => all.some((parameter) => parameter.key === mistake.key)).length ?? 0;
  const isOpen = filter.value !== "" || openGroups.value.has(name);
  return (
    <section class="group">
      <h2>
        <button
          type="button"
          aria-expanded={isOpen}
          aria-controls={`group-${name}`}
          title={help}
          onClick={() => (openGroups.value = toggled(openGroups.value, name))}
        >
          <span class="arrow" aria-hidden="true" />
          {sectionTitle(name)}
          {mistakes === 0 ? null : (
            <span class="count" aria-label={`${mistakes} ${mistakes === 1 ? "mistake" : "mistakes"}`}>
              {mistakes}
            </span>
          )}
        </button>
      </h2>
      {isOpen ? <Rows name={name} all={all} /> : null}
    </section>
  );
}

/** Opens what hides a wanted field and goes to it once it is there. */
function useWanted(): void {
  useSignalEffect(() => {
    const wish = wanted.value;
    if (wish === null) return;
    const parameter = parameters.value?.parameters.find((each) => each.key === wish.key);
    wanted.value = null;
    if (parameter === undefined) return;
    if (!isFoundBy(parameter, filter.peek())) filter.value = "";
    openGroups.value = new Set(openGroups.peek()).add(parameter.section);
    if (parameter.need === "optional") groupsWithMore.value = new Set(groupsWithMore.peek()).add(parameter.section);
    requestAnimationFrame(() => {
      const field = document.getElementById(fieldId(wish.key));
      field?.scrollIntoView({ block: "nearest" });
      field?.focus();
    });
  });
}

export function Form(): JSX.Element {
  useWanted();
  const table = parameters.value;
  const found = table?.parameters.filter((parameter) => isFoundBy(parameter, filter.value)) ?? [];
  return (
    <section class="form panel" aria-label="Parameters">
      <div class="filter">
        <input
          type="search"
          placeholder="Find a parameter"
          aria-label="Find a parameter by name, symbol or meaning"
          value={filter.value}
          onInput={(event) => (filter.value = event.currentTarget.value.trimStart())}
        />
      </div>
      <div class="groups">
        {table?.sections.map(({ name, help }) => {
          const all = found.filter((parameter) => parameter.section === name);
          return all.length === 0 ? null : <Group key={name} name={name} help={help} all={all} />;
        })}
        {found.length === 0 ? <p class="quiet none">No parameter has these words in its name or meaning.</p> : null}
      </div>
      <HelpLine />
    </section>
  );
}
