// By what the yarns of the fabrics are coloured. Fabrics beside each other have the same ends of the colour map.

import type { FieldHead, RunHead } from "../api/types";
import type { FabricColouring } from "../view3d/types";
import { fabrics, type WatchedFabric } from "./fabrics";
import { setWords, wordOf } from "./shown";

export const kColours = [
  { word: "course", words: "Courses" },
  { word: "contact_force", words: "Contact force" },
  { word: "axial_force", words: "Axial force" },
] as const;

export const colourWord = (): string => kColours.find((each) => each.word === wordOf("colour"))?.word ?? "course";
export const setColour = (word: string): void => setWords({ colour: word === "course" ? "" : word });

export interface Scale {
  field: FieldHead; // that of one of the fabrics, for its words
  lowest: number;
  highest: number;
}

/** Of all views of these runs so far; null while the colours tell no quantity. */
export function scaleOf(watched: readonly RunHead[]): Scale | null {
  const scales = watched.flatMap(({ id }): Scale[] => {
    const fabric = fabrics.value.get(id);
    const field = fabric?.frame?.head.fields.find((each) => each.name === colourWord());
    if (fabric === undefined || field === undefined) return [];
    const [lowest, highest] = fabric.ranges.get(field.name) ?? [field.lowest, field.highest];
    return [{ field, lowest, highest }];
  });
  const first = scales[0];
  if (first === undefined) return null;
  const lowest = Math.min(...scales.map((scale) => scale.lowest));
  return { field: first.field, lowest, highest: Math.max(...scales.map((scale) => scale.highest)) };
}

export function colouringOf(fabric: WatchedFabric, scale: Scale | null): FabricColouring {
  const field = scale === null ? undefined : fabric.frame?.head.fields.find((each) => each.name === scale.field.name);
  if (scale === null || field === undefined || fabric.frame === null) return { by: colourWord() === "course" ? "course" : "plain" };
  return { by: "field", values: fabric.frame.floats(field.name), ofElements: field.of_elements, lowest: scale.lowest, highest: scale.highest };
}
