// SPDX-License-Identifier: BSD-3-Clause
// What the page says of units, curves and pieces.
import type { CurveType, Report, SegmentKind, Unit } from "surfaceflattening";

export const units: Record<Unit, { words: string; metres: number }> = {
  mm: { words: "millimeters", metres: 0.001 },
  cm: { words: "centimeters", metres: 0.01 },
  m: { words: "meters", metres: 1 },
  inch: { words: "inches", metres: 0.0254 },
};

export const curveTypes: Record<CurveType, { name: string; about: string; color: string; darkColor: string; key: string }> = {
  accessory: { name: "Length line", about: "keeps its length", color: "#177a2b", darkColor: "#5fd07a", key: "L" },
  key: { name: "Shape line", about: "keeps its length and its shape", color: "#c2201f", darkColor: "#ff8178", key: "K" },
  straight: { name: "Straight line", about: "keeps its length and is straight when flat", color: "#a0149a", darkColor: "#f08af0", key: "T" },
  dart: { name: "Dart", about: "is cut open", color: "#1c4fd8", darkColor: "#8cb4ff", key: "D" },
  seam: { name: "Seam", about: "is cut through and parts pieces", color: "#8a5a00", darkColor: "#f0b84c", key: "S" },
};

export const segmentKinds: Record<SegmentKind, string> = {
  geodesic: "tight over the surface",
  section: "in a plane",
  edges: "along mesh edges",
  spline: "smooth",
};

export const snapTargets = ["", "on the edge", "on a corner", "on a mesh point", "on a line", "on the tip of a dart", "on the mirror plane"];

export function percent(fraction: number): string {
  const value = 100 * fraction;
  return `${Math.abs(value) < 0.95 ? value.toFixed(1) : value.toFixed(value < 9.95 ? 1 : 0)} %`;
}

/** The factor to a unit in which a length has few digits, and its name; inches stay. */
function readable(length: number, unit: Unit): [number, string] {
  const metres = length * units[unit].metres;
  const [factor, name] = metres >= 3 ? [1, "m"] : metres >= 0.01 ? [100, "cm"] : [1000, "mm"];
  return unit === "inch" ? [1, "in"] : [factor * units[unit].metres, name];
}

export function lengthWords(length: number, unit: Unit): string {
  const [factor, name] = readable(length, unit);
  return `${Number((length * factor).toPrecision(4))} ${name}`;
}

/** Extents as "39.2 x 53.0 x 13.7 cm". */
export function sizeWords(extent: readonly number[], unit: Unit): string {
  const [factor, name] = readable(Math.max(...extent), unit);
  return `${extent.map((side) => (side * factor).toPrecision(3)).join(" x ")} ${name}`;
}

/** What a size is like, for who is asked for a unit. */
export function likeness(metres: number): string {
  const likes: [number, string][] = [
    [0.005, "smaller than a button"], [0.06, "like a coin or a button"], [0.25, "like a shoe or a mask"], [0.9, "like a shirt"],
    [2.2, "like a person"], [8, "like a tent or a boat"],
  ];
  return likes.find(([most]) => metres < most)?.[1] ?? "larger than a house";
}

export interface PieceRow {
  piece: number;
  name: string;
  status: string;
  size: string;
  ease: string;
  verdict: string;
  strain_p95: number;
  E_area: number;
  E_len_max: number;
  triangles: number;
}

export interface CurveRow {
  name: string;
  type: string;
  length_3d: number;
  length_2d: number;
}

export interface Verdict {
  name: string;
  level: "good" | "fair" | "poor";
  words: string;
  /** The engine's own words: what is eased, where. */
  details: string;
}

export function pieceRows(report: Report): PieceRow[] {
  return (report.pieces ?? []) as unknown as PieceRow[];
}

export function curveRows(report: Report): CurveRow[] {
  return (report.curves ?? []) as unknown as CurveRow[];
}

/** What is wrong with a piece, by its status. */
const troubles: Record<string, string> = {
  NotConverged: "has no good flat shape yet: part it by a seam",
  IncompatibleKeys: "has straight lines that contradict each other: release one",
  LengthError: "has lines that cannot keep their length: add a dart or a seam",
  FlippedTriangles: "is folded in places: add a dart or a seam there",
  Overlap: "lies over itself: part it by a seam",
  BeyondLimits: "strains the material too much: add a dart or a seam",
};

export function isSound(row: PieceRow): boolean {
  return !(row.status in troubles);
}

/** Whether a piece fits, for who cuts and sews it. */
export function verdictOf(row: PieceRow): Verdict {
  const strain = row.strain_p95;
  const [level, words]: [Verdict["level"], string] =
    strain < 0.005 ? ["good", "lies flat as it is"]
    : strain < 0.05 ? ["good", `fits: nearly all of it is strained by less than ${percent(strain)}`]
    : strain < 0.1 ? ["fair", `fits a material that gives: strain up to ${percent(strain)}`]
    : ["poor", `is strained by up to ${percent(strain)}: add a dart or a seam where the color is strongest`];
  const trouble = troubles[row.status];
  return {
    name: row.name || `Piece ${row.piece + 1}`,
    level: trouble ? "poor" : level,
    words: trouble ?? words,
    details: [row.verdict, strain < 0.005 ? "" : row.ease].filter(Boolean).join(". "),
  };
}
