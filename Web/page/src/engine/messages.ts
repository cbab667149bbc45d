// SPDX-License-Identifier: BSD-3-Clause
// What the page and its workers send each other.
import type { DrawnCurve, Report, Status, SuggestedCut, Unit } from "surfaceflattening";

export interface Mesh {
  /** x, y, z of each point. */
  points: Float64Array;
  /** Three ids a triangle. */
  corners: Int32Array;
}

export interface OpenedSurface extends Mesh {
  unit: Unit | "";
  likelyUnit: Unit;
  /** Those of the surface's own file. */
  curves: StoredCurve[];
  /** Angle defect at each point; null where the surface is rejected. */
  developability: Float64Array | null;
  /** Why no curve can be drawn; empty where one can. */
  problem: string;
}

/** A curve as files keep it: nodes and what runs between them. */
export type StoredCurve = Pick<DrawnCurve, "type" | "name" | "closed" | "kinds"> & { nodes: ArrayLike<number> };

export interface FlatWire {
  points: Float64Array;
  type: number;
  name: string;
  boundary: boolean;
}

/** Flat pieces; `space` has each of their points on the surface. */
export interface FlatPieces extends Mesh {
  space: Float64Array;
  /** Of each triangle: its piece, and its area in the plane over that on the surface. */
  pieceIds: Int32Array;
  areaRatios: Float64Array;
  /** Angle defect of the surface at each point. */
  developability: Float64Array;
  wires: FlatWire[];
}

export interface FlatteningAnswer {
  report: Report;
  pieces: FlatPieces | null;
  /** Of the run in the worker. */
  milliseconds: number;
}

export interface Proposal extends FlatteningAnswer {
  cuts: SuggestedCut[];
  boundMet: boolean;
}

export interface EditorState {
  status: Status;
  curves: DrawnCurve[];
  canUndo: boolean;
  canRedo: boolean;
}

export type WorkerRequest = { module: WebAssembly.Module } | { id: number; call: string; given: unknown[] };
/** What is known before a call has its result: the fraction done, or the cuts found so far. */
export type News = { progress: number } | { preview: Float64Array[] };
export type WorkerReply =
  | ({ id: number } & News)
  | { id: number; result: unknown }
  | { id: number; error: string };
