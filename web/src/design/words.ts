// How parameters and numbers are written for people.

import type { Parameter } from "../api/types";

const kSections: Record<string, string> = {
  "": "Case",
  loop: "Loop",
  fabric: "Fabric",
  yarn: "Yarn",
  edge_yarn: "Edge yarn",
  contact: "Contact",
  test: "Test",
  solver: "Solver",
  output: "Output",
};
const kNames: Record<string, string> = {
  elements_per_erc: "Elements per ERC",
  poissons_ratio: "Poisson's ratio",
  youngs_modulus: "Young's modulus",
};
const kGreek: Record<string, string> = { rho: "ρ", nu: "ν", mu: "μ", theta: "θ" };

function sentenceCase(name: string): string {
  const words = name.replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

export const sectionTitle = (name: string): string => kSections[name] ?? sentenceCase(name);
export const parameterTitle = (parameter: Parameter): string => kNames[parameter.name] ?? sentenceCase(parameter.name);

/** "R1" as R with the index 1, "d_f" as d with the index f, "rho" as the Greek letter; "EA" stays as it is. */
export function symbolParts(symbol: string): { letter: string; index: string } {
  const [, letter = symbol, index = ""] = /^([A-Za-z]+?)_?(\d+|(?<=_)\w+)?$/.exec(symbol) ?? [];
  return { letter: kGreek[letter] ?? letter, index };
}

/** Whether the words stand in the name, symbol, key or help of a parameter, in any order. */
export function isFoundBy(parameter: Parameter, filter: string): boolean {
  const searched = [parameterTitle(parameter), parameter.symbol, parameter.key, parameter.help].join(" ").toLowerCase();
  return filter
    .toLowerCase()
    .split(/\s+/)
    .every((word) => searched.includes(word));
}

const withUnit = (value: number, unit: string): string => `${plain(value)}${unit === "" ? "" : ` ${unit}`}`;

/** "above 0 to 1000 mm"; "" where every value is allowed. */
export function rangeOf({ least, greatest, least_excluded, unit, kind }: Parameter): string {
  if (least === null || greatest === null) return "";
  const each = kind === "list of quantities" ? "each " : "";
  return `${each}${least_excluded ? "above" : "from"} ${plain(least)} to ${withUnit(greatest, unit)}`;
}

/** What holds if the parameter is not given. */
export function defaultOf({ need, value }: Parameter): string {
  if (need === "required") return value === "" ? "required" : `required, for example ${value}`;
  if (need === "defaulted") return `${value} if not given`;
  if (need === "automatic") return "auto if not given";
  return value === "" ? "may be left out" : `may be left out; for example ${value}`;
}

const kSuperscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

function powerOfTen(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((digit) => kSuperscripts[Number(digit)]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** A number with up to `digits` digits and without zeros at its end: 17.29, 0.01637, 5·10⁻⁶. */
export function significant(value: number, digits = 4): string {
  if (value === 0) return "0";
  const [mantissa = "", exponent = ""] = value.toExponential(digits - 1).split("e");
  const power = Number(exponent);
  if (power >= -4 && power < 6) return String(Number(value.toPrecision(digits))).replace("-", "−");
  const factor = String(Number(mantissa)).replace("-", "−");
  return factor === "1" ? powerOfTen(power) : `${factor}·${powerOfTen(power)}`;
}

function plain(value: number): string {
  return value >= 1e6 ? significant(value) : String(value);
}

/** "about 12 seconds" */
export function duration(seconds: number): string {
  if (seconds < 1) return "less than a second";
  const counted = (count: number, unit: string): string => `${count} ${unit}${count === 1 ? "" : "s"}`;
  if (seconds < 90) return `about ${counted(Math.round(seconds), "second")}`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 90) return `about ${counted(minutes, "minute")}`;
  const hours = Math.round(minutes / 60);
  return hours < 48 ? `about ${counted(hours, "hour")}` : `about ${counted(Math.round(hours / 24), "day")}`;
}
