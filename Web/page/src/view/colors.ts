// SPDX-License-Identifier: BSD-3-Clause
// A diverging map that is straight in Oklab (B. Ottosson, 2020), so that equal steps look equal: blue where the value
// is below zero, near white at zero, red above.

type Color = readonly [number, number, number];

/** Lightness, a and b. */
const low: Color = [0.42, -0.04, -0.15];
const middle: Color = [0.95, 0, 0.005];
const high: Color = [0.42, 0.14, 0.07];

/** Linear red, green and blue of a place between -1 and 1. */
export function linearColor(place: number): Color {
  const t = Math.min(1, Math.abs(place));
  const end = place < 0 ? low : high;
  const [L, a, b] = middle.map((value, k) => value + t * (end[k] - value));
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const clamped = (value: number): number => Math.min(1, Math.max(0, value));
  return [
    clamped(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    clamped(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    clamped(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

export function cssColor(place: number): string {
  const encoded = linearColor(place).map((value) =>
    Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055)));
  return `rgb(${encoded.join(" ")})`;
}

/** Three numbers a point. \param range of the map's ends; values that are not numbers are gray */
export function colorsOf(values: ArrayLike<number>, range: number): Float32Array {
  const steps = Array.from({ length: 257 }, (_, k) => linearColor(k / 128 - 1));
  const colors = new Float32Array(3 * values.length);
  for (let k = 0; k < values.length; ++k) {
    const place = Math.min(1, Math.max(-1, values[k] / range));
    colors.set(Number.isFinite(place) ? steps[Math.round(128 * (place + 1))] : [0.4, 0.4, 0.4], 3 * k);
  }
  return colors;
}

/** The values of triangles as means at their points. */
export function atPoints(corners: Int32Array, values: Float64Array, count: number): Float64Array {
  const sums = new Float64Array(count);
  const uses = new Float64Array(count);
  for (let c = 0; c < corners.length; ++c) {
    sums[corners[c]] += values[Math.floor(c / 3)];
    ++uses[corners[c]];
  }
  return sums.map((sum, p) => sum / uses[p]);
}

/** A range for a legend: 1, 2 or 5 times a power of ten, that holds 98 % of the values. */
export function rangeOf(values: Float64Array): number {
  const sorted = values.map(Math.abs).filter(Number.isFinite).sort();
  const most = Math.max(sorted[Math.floor(0.98 * (sorted.length - 1))] ?? 0, 1e-3);
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([1, 2, 5].find((step) => step * power >= most * (1 - 1e-9)) ?? 10);
}
