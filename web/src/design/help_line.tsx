// What the parameter is that the user looks at: its place at the foot of the form is always the same.

import type { JSX } from "preact";
import { isReadable } from "../state/design";
import { parameters } from "../state/program";
import { focused, hovered } from "./pointing";
import { Symbol } from "./symbol";
import { defaultOf, parameterTitle, rangeOf } from "./words";

export function HelpLine(): JSX.Element {
  const key = focused.value ?? hovered.value;
  const parameter = parameters.value?.parameters.find((each) => each.key === key);
  return (
    <div class="help-line" aria-live="off">
      {!isReadable.value ? (
        <p>The case file cannot be read as it stands. The form shows what it said before and waits until the text is mended.</p>
      ) : parameter === undefined ? (
        <p class="quiet">
          A quantity carries its unit, as in 7 mm. Arrow up and down change a number; with Shift in larger steps.
        </p>
      ) : (
        <>
          <p class="head">
            <strong>{parameterTitle(parameter)}</strong> <Symbol symbol={parameter.symbol} />
            <code class="quiet">{parameter.key}</code>
          </p>
          <p class="what">{parameter.help}</p>
          <p class="quiet">{[rangeOf(parameter), defaultOf(parameter)].filter((words) => words !== "").join(" · ")}</p>
        </>
      )}
    </div>
  );
}
