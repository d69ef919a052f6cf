// What holds for a parameter, also where the program chooses the value.

import { design } from "../state/design";

const typed = (value: number): string => String(Number(value.toPrecision(4)));

/** The value that the program chose where the parameter is "auto", as a person types it; "" if it tells none. */
export function chosenValue(key: string): string {
  const facts = design.value?.facts ?? null;
  if (facts === null) return "";
  if (key === "loop.out_of_plane") return `${typed(facts.out_of_plane)} /mm`;
  if (key === "contact.stiffness") return `${typed(facts.contact_stiffness)} N/mm`;
  if (key === "solver.mass_scaling") return typed(facts.mass_scaling);
  return "";
}

/** The value that holds, typed; the program's own choice for "auto"; "" while there is a mistake. */
export function effectiveValue(key: string): string {
  const effective = design.value?.effective[key] ?? "";
  return effective === "auto" ? chosenValue(key) || "auto" : effective;
}
