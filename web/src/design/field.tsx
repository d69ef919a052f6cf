// One parameter: its name, its symbol and the input with the text as it is typed.

import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Mistake, Parameter } from "../api/types";
import { design, given, isBusy, setValue } from "../state/design";
import { effectiveValue } from "./effective";
import { fieldId, focused, hovered, lit } from "./pointing";
import { stepped } from "./step_number";
import { Symbol } from "./symbol";
import { parameterTitle } from "./words";

interface InputProps {
  parameter: Parameter;
  value: string;
  wrong: boolean;
  onTyped: (typed: string) => void;
}

/** What stands in an empty input: the value that holds, or an example of what could. */
function placeholderOf(parameter: Parameter): string {
  if (parameter.need === "required") return `e.g. ${parameter.value}`;
  const effective = effectiveValue(parameter.key);
  if (parameter.need === "automatic") return effective === "" || effective === "auto" ? "auto" : `auto: ${effective}`;
  if (effective !== "") return effective;
  return parameter.need === "defaulted" ? parameter.value : "not given";
}

function TextInput({ parameter, value, wrong, onTyped }: InputProps): JSX.Element {
  const key = parameter.key;
  const step = (event: KeyboardEvent & { currentTarget: HTMLInputElement }): void => {
    if ((event.key !== "ArrowUp" && event.key !== "ArrowDown") || event.altKey || event.ctrlKey || event.metaKey) return;
    const typed = event.currentTarget.value || effectiveValue(key) || parameter.value;
    const next = stepped(typed, parameter, (event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 10 : 1));
    if (next === null) return;
    event.preventDefault();
    if (next !== event.currentTarget.value) onTyped(next);
  };
  return (
    <input
      id={fieldId(key)}
      type="text"
      value={value}
      placeholder={placeholderOf(parameter)}
      autocomplete="off"
      spellcheck={false}
      aria-invalid={wrong}
      aria-required={parameter.need === "required"}
      aria-describedby={`${fieldId(key)}-below`}
      onInput={(event) => onTyped(event.currentTarget.value)}
      onKeyDown={step}
    />
  );
}

function ChoiceInput({ parameter, value, wrong, onTyped }: InputProps): JSX.Element {
  const chosen = value || effectiveValue(parameter.key) || parameter.value;
  const words = parameter.choices.includes(chosen) ? parameter.choices : [chosen, ...parameter.choices];
  return (
    <select
      id={fieldId(parameter.key)}
      value={chosen}
      aria-invalid={wrong}
      aria-describedby={`${fieldId(parameter.key)}-below`}
      onChange={(event) => onTyped(event.currentTarget.value)}
    >
      {words.map((word) => (
        <option key={word} value={word}>
          {word}
        </option>
      ))}
    </select>
  );
}

/** The line below the input: the mistake, or what "auto" means. Its place is kept free, so that nothing moves. */
function Below({ parameter, mistake }: { parameter: Parameter; mistake: Mistake | undefined }): JSX.Element {
  const effective = effectiveValue(parameter.key);
  const isAuto = given.value[parameter.key]?.typed.trim() === "auto" && effective !== "auto" && effective !== "";
  return (
    <div id={`${fieldId(parameter.key)}-below`} class={mistake === undefined ? "below quiet" : "below wrong"}>
      {mistake !== undefined ? <span class="mistake">{mistake.message}</span> : isAuto ? <span>auto: {effective}</span> : null}
    </div>
  );
}

export function Field({ parameter }: { parameter: Parameter }): JSX.Element {
  const draft = useSignal<string | null>(null);
  const key = parameter.key;
  const typed = given.value[key]?.typed ?? "";
  const hasFocus = focused.value === key;
  // What is typed stays as it is while the field has the focus or the program has not answered yet.
  const value = draft.value !== null && (hasFocus || isBusy.value) ? draft.value : typed;
  const mistake = design.value?.mistakes.find((each) => each.key === key);
  const row = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (hasFocus && mistake !== undefined) row.current?.scrollIntoView({ block: "nearest" });
  }, [hasFocus, mistake?.message]);
  const change = (now: string): void => {
    draft.value = now;
    setValue({ key, typed: now });
  };
  const reset = (): void => {
    draft.value = null;
    setValue({ key, typed: "" });
    document.getElementById(fieldId(key))?.focus();
  };
  const Input = parameter.kind === "choice" ? ChoiceInput : TextInput;
  const canReset = parameter.need !== "required" && typed !== "";
  return (
    <div
      ref={row}
      class={`field${lit.value === key ? " lit" : ""}${parameter.kind === "text" ? " wide" : ""}`}
      onMouseEnter={() => (hovered.value = key)}
      onMouseLeave={() => (hovered.value = null)}
      onFocusIn={() => (focused.value = key)}
      onFocusOut={() => {
        focused.value = null;
        if (!isBusy.value) draft.value = null;
      }}
    >
      <label for={fieldId(key)} id={`${fieldId(key)}-label`}>
        <span>{parameterTitle(parameter)}</span> <Symbol symbol={parameter.symbol} />
      </label>
      <Input parameter={parameter} value={value} wrong={mistake !== undefined} onTyped={change} />
      <button
        type="button"
        class="plain reset"
        hidden={!canReset}
        onClick={reset}
        aria-label="Leave it out"
        aria-describedby={`${fieldId(key)}-label`}
        title="Leave it out: back to what holds if it is not given"
      >
        ↺
      </button>
      <Below parameter={parameter} mistake={mistake} />
    </div>
  );
}
