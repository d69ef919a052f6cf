// The map from numbers to colours: indigo, blue, teal, green, yellow, with a lightness in Oklab that rises evenly, so that
// equal steps of a field look equal, also in grey. It is the one of the program's pictures.

interface HuePoint {
  value: number;
  chroma: number;
  hue: number; // degrees
}

const kHues: readonly HuePoint[] = [
  { value: 0.0, chroma: 0.15, hue: 285 },
  { value: 0.25, chroma: 0.115, hue: 250 },
  { value: 0.5, chroma: 0.1, hue: 205 },
  { value: 0.75, chroma: 0.14, hue: 155 },
  { value: 1.0, chroma: 0.165, hue: 100 },
];
const kDarkest = 0.4; // Oklab lightness at 0
const kLightest = 0.88; // Oklab lightness at 1
export const kMapSize = 256;

const between = (a: number, b: number, share: number): number => a + (b - a) * share;

function toSrgb(linear: number): number {
  const x = Math.min(1, Math.max(0, linear));
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}

function fromOklab(lightness: number, a: number, b: number): [number, number, number] {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    toSrgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    toSrgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    toSrgb(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** sRGB, 0 to 1, of a value from 0 to 1. */
export function mapColour(value: number): [number, number, number] {
  const t = Math.min(1, Math.max(0, value));
  const above = Math.max(1, kHues.findIndex((point) => t <= point.value));
  const low = kHues[above - 1] as HuePoint;
  const high = kHues[above] as HuePoint;
  const share = (t - low.value) / (high.value - low.value);
  const chroma = between(low.chroma, high.chroma, share);
  const hue = (between(low.hue, high.hue, share) * Math.PI) / 180;
  return fromOklab(between(kDarkest, kLightest, t), chroma * Math.cos(hue), chroma * Math.sin(hue));
}

/** The map as pixels, RGBA. */
export function mapPixels(): Uint8Array {
  const pixels = new Uint8Array(4 * kMapSize);
  for (let i = 0; i < kMapSize; ++i) {
    const colour = mapColour(i / (kMapSize - 1));
    pixels.set([...colour.map((x) => Math.round(255 * x)), 255], 4 * i);
  }
  return pixels;
}

/** The map as a gradient of a style sheet, lowest first. */
export function mapGradient(direction: string): string {
  const stops = Array.from({ length: 17 }, (_, i) => {
    const [r, g, b] = mapColour(i / 16).map((x) => Math.round(255 * x));
    return `rgb(${r} ${g} ${b})`;
  });
  return `linear-gradient(${direction}, ${stops.join(", ")})`;
}
