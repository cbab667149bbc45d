// SPDX-License-Identifier: BSD-3-Clause
import type { FlatteningOptions, SuggestionOptions } from "./options";

export type { FlatteningOptions, SuggestionOptions };
export type CurveType = "accessory" | "key" | "straight" | "dart" | "seam";
export type SegmentKind = "geodesic" | "section" | "edges" | "spline";
export type Unit = "mm" | "cm" | "m" | "inch";
export type Values = Float64Array | Int32Array | Uint8Array | string[];

/** A feature curve on the surface: x, y, z of its points one after the other. */
export interface Curve {
  points: Float64Array;
  type?: CurveType;
  name?: string;
  /** How far lengths may go from those on the surface, a fraction. */
  tolerance?: number;
}

/** Points, triangles, polylines and arrays by name, as vtkWireWarpingFilter documents them. */
export interface DataSet {
  points: Float64Array;
  corners: Int32Array;
  lines: Int32Array[];
  pointArrays: Record<string, Values>;
  cellArrays: Record<string, Values>;
  fieldArrays: Record<string, Values>;
}

export interface Status {
  /** 0: nothing is wrong. */
  code: number;
  name: string;
  message: string;
  ids: Int32Array;
  /** What the ids are of. */
  kind: string;
}

/** The keys of report.json. */
export interface Report {
  status: Status;
  /** There is no result. */
  refused: boolean;
  warnings: string[];
  pieces?: Record<string, unknown>[];
  curves?: Record<string, unknown>[];
  left_out?: Record<string, unknown>[];
  seconds?: Record<string, number>;
}

export interface PatternFile {
  status: Status;
  warnings: string[];
  bytes: Uint8Array;
}

/** Draws pages, in millimeters, y down from the upper left corner of the paper. */
export interface PageCanvas {
  beginPage(width: number, height: number): void;
  endPage(): void;
  /** Between save() and restore() transformations and clips are local. */
  save(): void;
  restore(): void;
  translate(x: number, y: number): void;
  scale(factor: number): void;
  clip(x: number, y: number, width: number, height: number): void;
  pen(red: number, green: number, blue: number, width: number, dashes: number[]): void;
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  curveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void;
  rectangle(x: number, y: number, width: number, height: number): void;
  closePath(): void;
  stroke(isFilled: boolean): void;
  /** y: middle of the text's height; anchor: 0 start, 0.5 middle, 1 end; angle: anti-clockwise. */
  text(words: string, x: number, y: number, height: number, anchor: number, angle: number): void;
}

/** Objects live in the module's memory until delete(). */
interface Owned {
  delete(): void;
}

export interface Flattening extends Owned {
  report(): Report;
  flat(): DataSet | null;
  wires(): DataSet | null;
  /** The cut surface in space, point for point like flat(). */
  cut(): DataSet | null;
  /** A pattern at true scale. Options: those of write_pattern() of the Python package, and date. */
  pattern(ending: "svg" | "dxf" | "plt" | "json" | "csv", options?: Record<string, number | string | boolean>): PatternFile;
  /** The pages of a PDF, at 1:1, drawn on a canvas; there are no bytes. */
  pattern(ending: "pdf", options: Record<string, number | string | boolean>, canvas: PageCanvas): PatternFile;
}

export interface SuggestedCut extends Required<Pick<Curve, "points" | "type" | "name">> {
  length: number;
  strain_before: number;
  strain_after: number;
}

/** Called with the fraction done; false ends the run. */
export type Progress = (fraction: number) => boolean | void;

/** Called with the cuts found so far, whenever they change: x, y, z of the points of each. */
export type Preview = (lines: Float64Array[]) => void;

export interface Surface extends Owned {
  arrays(): DataSet;
  unit(): Unit | "";
  setUnit(unit: Unit | ""): void;
  /** In which the surface has the size of what people wear. */
  likelyUnit(): Unit;
  /** Those of the surface's own file. */
  curves(path: ""): DataSet;
  /** The angle defect at each point, or null where the surface is refused. */
  developability(): { Developability: Float64Array } | null;
  flatten(curves?: Curve[], options?: FlatteningOptions, progress?: Progress): Flattening;
  suggest(curves?: Curve[], options?: SuggestionOptions, progress?: Progress, preview?: Preview): {
    flattening: Flattening;
    cuts: SuggestedCut[];
    boundMet: boolean;
  };
}

export interface DrawnCurve extends Required<Pick<Curve, "points" | "type" | "name">> {
  closed: boolean;
  nodes: Float64Array;
  kinds: SegmentKind[];
  length: number;
}

/** Draws curves by commands that can be undone. A place is x, y, z; the closest point counts. */
export interface Editor extends Owned {
  curves(): DrawnCurve[];
  /** target: 0 nothing, 1 boundary, 2 corner, 3 vertex, 4 curve, 5 tip of a dart, 6 mirror. */
  snap(place: ArrayLike<number>, reach: number, exceptCurve: number): { point: Float64Array; target: number };
  add(type: CurveType, name: string, nodes: ArrayLike<number>, kinds: SegmentKind | SegmentKind[], closed: boolean): Status;
  /** A smooth curve along a stroke by hand, up to a tolerance in space. */
  addStroke(places: ArrayLike<number>, tolerance: number): Status;
  /** The curve's image in the surface's plane of symmetry. */
  addImage(curve: number): Status;
  /** A curve at a distance from one, on its left where the distance is positive. */
  addOffset(curve: number, distance: number): Status;
  describe(curve: number, type: CurveType, name: string): Status;
  remove(curve: number): Status;
  moveNode(curve: number, node: number, place: ArrayLike<number>): Status;
  insertNode(curve: number, node: number, place: ArrayLike<number>, kind: SegmentKind): Status;
  removeNode(curve: number, node: number): Status;
  setClosed(curve: number, closed: boolean): Status;
  undo(): void;
  redo(): void;
  canUndo(): boolean;
  canRedo(): boolean;
  /** Until endGroup() all commands are undone as one. */
  beginGroup(): void;
  endGroup(): void;
}

export interface Option {
  name: string;
  words: string[];
  /** 0 flag, 1 whole number, 2 number, 3 word, 4 text, 5 list, 6 ids, 7 numbers. */
  type: number;
  default: string;
  range: string;
  label: string;
  help: string;
  ofSuggestion: boolean;
}

export interface Engine {
  /** Reads OBJ, PLY, STL or OFF. */
  readSurface(name: string, bytes: Uint8Array): Surface;
  makeSurface(points: ArrayLike<number>, triangles: ArrayLike<number>, unit?: Unit | ""): Surface;
  /** Reads CSV, DXF, OBJ or text. */
  readCurves(surface: Surface, name: string, bytes: Uint8Array): DataSet;
  /** Throws where the surface is rejected. */
  edit(surface: Surface): Editor;
  options(): Option[];
  materials(): { name: string; about: string }[];
  /** Bytes that the module has taken from the system. */
  memory(): number;
}

/**
 * Errors of all calls: what is wrong, as an Error with a message for people. Seam allowances and lays on cloth need
 * clipper: the default export of the npm package clipper-lib.
 */
export function load(settings?: { clipper?: object; wasmBinary?: ArrayBuffer | Uint8Array; locateFile?: (name: string) => string; instantiateWasm?: (imports: WebAssembly.Imports, use: (instance: WebAssembly.Instance) => void) => object }): Promise<Engine>;
