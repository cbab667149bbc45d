// SPDX-License-Identifier: BSD-3-Clause
// Curves as a file: JSON with nodes, to be edited again.
import type { CurveType, SegmentKind, Unit } from "surfaceflattening";
import type { StoredCurve } from "../engine/messages";
import { curveTypes, segmentKinds, units } from "../ui/words";

const format = "surfaceflattening curves";

export interface CurvesFile {
  format: typeof format;
  version: 1;
  surface: string;
  unit: Unit;
  material: string;
  grain: string;
  curves: (Omit<StoredCurve, "nodes"> & { nodes: number[] })[];
}

export function curvesFile(
  surface: string, unit: Unit, material: string, grain: string, curves: readonly StoredCurve[],
): string {
  const file: CurvesFile = {
    format, version: 1, surface, unit, material, grain,
    curves: curves.map(({ type, name, closed, kinds, nodes }) => ({ type, name, closed, kinds, nodes: Array.from(nodes) })),
  };
  return JSON.stringify(file, null, 1);
}

/** Throws an Error that says what is wrong. */
export function readCurvesFile(name: string, text: string): CurvesFile {
  let file: CurvesFile;
  try {
    file = JSON.parse(text) as CurvesFile;
  } catch (error) {
    throw new Error(`${name}: invalid JSON: ${(error as Error).message}`);
  }
  if (file?.format !== format || file.version !== 1 || !Array.isArray(file.curves) || !(file.unit in units)) {
    throw new Error(`${name}: not a file of curves that this page has saved`);
  }
  file.curves.forEach(({ type, nodes, kinds, closed }, k) => {
    const isWhole = Array.isArray(nodes) && nodes.length % 3 === 0 && nodes.every(Number.isFinite) &&
      (type as CurveType) in curveTypes && Array.isArray(kinds) &&
      kinds.every((kind: SegmentKind) => kind in segmentKinds) && kinds.length === nodes.length / 3 - (closed ? 0 : 1);
    if (!isWhole) {
      throw new Error(`${name}: curve ${k + 1} is not complete`);
    }
  });
  return file;
}

export function download(name: string, content: BlobPart, type: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
