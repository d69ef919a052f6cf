// The colours of the view, from the tokens of the page's style.

import type { Vec3, ViewColours } from "./types";

function toNumbers(style: CSSStyleDeclaration, token: string): Vec3 {
  const text = style.getPropertyValue(token).trim();
  const digits = /^#([0-9a-f]{6})$/i.exec(text)?.[1];
  if (digits === undefined) throw new Error(`${token} is "${text}"; a colour as #rrggbb is needed`);
  const value = parseInt(digits, 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export function readColours(): ViewColours {
  const style = getComputedStyle(document.documentElement);
  const of = (token: string): Vec3 => toNumbers(style, token);
  return {
    back: of("--view"),
    text: of("--text"),
    courses: [of("--course-odd"), of("--course-even")],
    plain: of("--yarn"),
    unknown: of("--unknown"),
    picked: of("--picked"),
    stick: of("--stick"),
    slip: of("--slip"),
  };
}
