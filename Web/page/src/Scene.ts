// SPDX-License-Identifier: BSD-3-Clause
import type { DrawnCurve, Report, SuggestedCut, Unit } from "surfaceflattening";
import type { FlatPieces, OpenedSurface } from "./engine/messages";
import type { Care } from "./engine/LiveFlattening";
import { byId } from "./ui/elements";
import { curveTypes, lengthWords, percent, pieceRows } from "./ui/words";
import { atPoints, colorsOf, cssColor, rangeOf } from "./view/colors";
import type { Dot, Line } from "./view/MeshCanvas";
import { PieceView } from "./view/PieceView";
import { positionOf, type Place } from "./view/picking";
import { SurfaceView } from "./view/SurfaceView";

const wireColors = ["accessory", "key", "dart", "seam"] as const;
const isDark = matchMedia("(prefers-color-scheme: dark)");

/** What both views show: the surface with its curves, the flat pieces with their wires, and places that belong together. */
export class Scene {
  readonly surface: SurfaceView;
  readonly pieces: PieceView;
  private opened: OpenedSurface | null = null;
  private flat: FlatPieces | null = null;
  private report: Report | null = null;
  private curves: readonly DrawnCurve[] = [];
  private ghosts: readonly SuggestedCut[] = [];
  private chosen: { curve: number; node: number } = { curve: -1, node: -1 };
  private cursor: number[] | null = null;
  private pointed: { space: number[]; plane: number[] } | null = null;
  private range = 1;
  private keepsRange = false;
  private rubber: number[] | null = null;

  constructor() {
    this.surface = new SurfaceView(byId<HTMLCanvasElement>("surface"), () => {});
    this.pieces = new PieceView(byId<HTMLCanvasElement>("pieces"), byId("labels"), byId("scale"));
    byId("color").addEventListener("change", () => {
      this.keepsRange = false;
      this.paint(false);
    });
    isDark.addEventListener("change", () => this.paint(false));
    byId("legend-bar").style.background =
      `linear-gradient(to right, ${Array.from({ length: 17 }, (_, k) => cssColor(k / 8 - 1)).join(", ")})`;
  }

  open(surface: OpenedSurface): void {
    Object.assign(this, { opened: surface, flat: null, report: null, curves: [], ghosts: [], cursor: null, pointed: null, rubber: null });
    this.choose(-1, -1);
    this.pieces.setMesh({ points: new Float64Array(), corners: new Int32Array() }, new Float32Array(), [], []);
    this.paint(true);
    this.pieces.fit();
  }

  setUnit(unit: Unit): void {
    this.pieces.lengthWords = (length) => lengthWords(length, unit);
    this.pieces.view.render();
  }

  /** A draft keeps the range of the colors, which would jump. */
  setPieces(flat: FlatPieces | null, report: Report, care: Care): void {
    this.keepsRange = care === "draft";
    this.flat = flat;
    this.report = report;
    this.pointed = null;
    this.paint(false);
  }

  setCurves(curves: readonly DrawnCurve[]): void {
    this.curves = curves;
    this.mark();
  }

  setGhosts(cuts: readonly SuggestedCut[]): void {
    this.ghosts = cuts;
    this.mark();
  }

  choose(curve: number, node: number): void {
    this.chosen = { curve, node };
    this.mark();
  }

  /** Where the next node would lie, and the end of the curve from which it would be drawn. */
  setCursor(place: number[] | null, from: ArrayLike<number> | null): void {
    this.cursor = place;
    this.rubber = place && from ? [...Array.from(from), ...place] : null;
    this.mark();
  }

  setStroke(places: number[]): void {
    this.rubber = places;
    this.mark();
  }

  /** Shows the same place in both views. */
  point(place: Place | null): void {
    const { flat } = this;
    this.pointed = place && flat && { space: positionOf(flat.space, flat.corners, place), plane: positionOf(flat.points, flat.corners, place) };
    this.mark();
    this.pieces.setDots(this.pointed ? [{ place: this.pointed.plane, color: lineColor("--poor"), size: 11 }] : []);
  }

  /** Marks the middle of a piece. */
  showPiece(piece: number): void {
    const triangle = this.flat?.pieceIds.indexOf(piece) ?? -1;
    if (triangle >= 0) {
      this.point({ triangle, weights: [1 / 3, 1 / 3, 1 / 3] });
    }
  }

  /** The place that is shown in both views. */
  pointedPlace(): { space: number[]; plane: number[] } | null {
    return this.pointed;
  }

  isFlat(): boolean {
    return this.flat !== null;
  }

  private paint(isNew: boolean): void {
    const { opened, flat } = this;
    if (!opened) {
      return;
    }
    const ofArea = byId<HTMLSelectElement>("color").value === "area" && flat !== null;
    const mesh = flat ? { points: flat.space, corners: flat.corners } : opened;
    const values = ofArea ? atPoints(flat.corners, flat.areaRatios.map((ratio) => 1 - ratio), flat.points.length / 3)
      : (flat ?? opened).developability ?? new Float64Array(mesh.points.length / 3);
    if (!ofArea || !this.keepsRange) {
      this.range = ofArea ? Math.max(0.02, rangeOf(values)) : rangeOf(values);
    }
    const { range } = this;
    const colors = colorsOf(values, range);
    this.surface.setMesh(mesh, colors, isNew);
    byId("legend").hidden = false;
    const words = ofArea ? [`ease in ${percent(range)}`, `stretch ${percent(range)}`]
      : [`saddle -${range.toPrecision(1)}`, `dome ${range.toPrecision(1)} rad`];
    byId("legend-low").textContent = words[0];
    byId("legend-high").textContent = words[1];
    if (flat) {
      this.pieces.setMesh(flat, colors, this.wireLines(flat), this.labels(flat));
    }
    this.mark();
  }

  private wireLines(flat: FlatPieces): Line[] {
    return flat.wires.map(({ points, type, boundary }) =>
      ({ points, color: type < 0 || (boundary && type === 0) ? lineColor("--outline") : typeColor(wireColors[type]), width: boundary || type > 1 ? 2.2 : 1.6 }));
  }

  private labels(flat: FlatPieces): { words: string; x: number; y: number }[] {
    const rows = pieceRows(this.report as Report);
    const sums = rows.map(() => [0, 0, 0]);
    for (let t = 0; t < flat.pieceIds.length; ++t) {
      const sum = sums[flat.pieceIds[t]];
      const p = 3 * flat.corners[3 * t];
      if (sum) {
        sum[0] += flat.points[p];
        sum[1] += flat.points[p + 1];
        ++sum[2];
      }
    }
    return rows.length < 2 && !rows[0]?.name ? []
      : rows.map((row, k) => ({ words: row.name || `${row.piece + 1}`, x: sums[k][0] / sums[k][2], y: sums[k][1] / sums[k][2] }));
  }

  private mark(): void {
    const { curve: chosen, node } = this.chosen;
    const lines: Line[] = this.curves.map(({ points, type }, k) => ({ points, color: typeColor(type), width: k === chosen ? 5 : 3 }));
    lines.push(...this.ghosts.map(({ points }) => ({ points, color: lineColor("--ghost"), width: 4, dashed: true })));
    if (this.rubber) {
      lines.push({ points: this.rubber, color: lineColor("--quiet"), width: 1.5 });
    }
    const dots: Dot[] = [];
    this.curves.forEach(({ nodes, type }, k) => {
      for (let n = 0; (k === chosen || nodes.length < 6) && 3 * n < nodes.length; ++n) {
        dots.push({ place: nodes.slice(3 * n, 3 * n + 3), color: k === chosen && n === node ? lineColor("--poor") : typeColor(type), size: n === node && k === chosen ? 12 : 8 });
      }
    });
    if (this.cursor) {
      dots.push({ place: this.cursor, color: lineColor("--poor"), size: 9 });
    }
    if (this.pointed) {
      dots.push({ place: this.pointed.space, color: lineColor("--poor"), size: 11 });
    }
    this.surface.setMarks(lines, dots);
  }
}

/** A color of the style sheet. */
function lineColor(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function typeColor(type: keyof typeof curveTypes): string {
  return isDark.matches ? curveTypes[type].darkColor : curveTypes[type].color;
}
