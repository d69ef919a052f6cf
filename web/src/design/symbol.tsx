// The symbol of a parameter, in italics with its index.

import type { JSX } from "preact";
import { symbolParts } from "./words";

export function Symbol({ symbol }: { symbol: string }): JSX.Element | null {
  if (symbol === "") return null;
  const { letter, index } = symbolParts(symbol);
  return (
    <i class="symbol">
      {letter}
      {index === "" ? null : <sub>{index}</sub>}
    </i>
  );
}

/** The same in a drawing, where there is no <sub>. */
export function SvgSymbol({ symbol }: { symbol: string }): JSX.Element {
  const { letter, index } = symbolParts(symbol);
  return (
    <>
      <tspan class="letter">{letter}</tspan>
      {index === "" ? null : (
        <>
          <tspan class="index" dy="3">
            {index}
          </tspan>
          <tspan dy="-3">{"\u200b"}</tspan>
        </>
      )}
    </>
  );
}
