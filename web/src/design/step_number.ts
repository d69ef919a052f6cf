// A step of a typed number up or down, the unit stays: "1.1 mm" -> "1.2 mm".

import type { Parameter } from "../api/types";

const kNumber = /^(\s*)([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(.*)$/;

/** One in the second digit of the number, as a power of ten: 0.1 for 7, 0.01 for 0.12, 100 for 1700. */
function powerOfStep(value: number): number {
  return value === 0 ? -1 : Math.floor(Math.log10(Math.abs(value)) + 1e-9) - 1;
}

/** The typed text after `steps` steps; null if it is no single number. Stays in the range where it is in the unit of it. */
export function stepped(typed: string, parameter: Parameter, steps: number): string | null {
  if (parameter.kind !== "quantity" && parameter.kind !== "whole number") return null;
  const [, before = "", number, after = ""] = kNumber.exec(typed) ?? [];
  if (number === undefined) return null;
  const value = Number(number);
  const power = parameter.kind === "whole number" ? 0 : powerOfStep(value);
  const typedDecimals = /e/i.test(number) ? 0 : (number.split(".")[1] ?? "").length;
  let next = Number((value + steps * 10 ** power).toFixed(Math.min(100, Math.max(0, -power, typedDecimals))));
  if (after.trim() === parameter.unit) next = inRange(next, value, parameter);
  return `${before}${next}${after}`;
}

function inRange(next: number, value: number, { least, greatest, least_excluded }: Parameter): number {
  if (greatest !== null && next > greatest) return greatest;
  if (least === null || next > least) return next;
  return least_excluded ? value : least;
}
