// SPDX-License-Identifier: BSD-3-Clause
import type { CurveType, DrawnCurve, Report, SuggestedCut, SuggestionOptions, Unit } from "surfaceflattening";
import { typeColor } from "../Scene";
import { byId, make, option } from "./elements";
import { curveRows, curveTypes, lengthWords, percent, pieceRows, segmentKinds, sizeWords, units, verdictOf } from "./words";

export interface SidebarUse {
  setUnit(unit: Unit): void;
  setCloth(material: string, grain: string): void;
  setKind(kind: string): void;
  setUp(axis: "y" | "z"): void;
  searchLonger(): void;
  choose(curve: number): void;
  describe(curve: number, type: CurveType, name: string): void;
  mirror(curve: number): void;
  offset(curve: number, distance: number): void;
  remove(curve: number): void;
  accept(cuts: SuggestedCut[]): void;
  reject(): void;
  showPiece(piece: number): void;
}

export interface SurfaceFacts {
  name: string;
  triangles: number;
  extent: [number, number, number];
  unit: Unit;
  up: "y" | "z";
}

/** The lists at the right: surface, proposed cuts, lines and pieces. */
export class Sidebar {
  private readonly cuts = make("select", {}, option("all", "darts and seams"), option("darts", "darts"), option("seams", "seams"), option("gores", "equal strips"));
  private readonly strain = make("select", {}, option("0.02", "2 %: paper, foam"), option("0.05", "5 %: cloth", true), option("0.1", "10 %: stretch cloth"));
  private readonly pieces = make("input", { type: "number", min: "1", placeholder: "as few as fit" });

  constructor(private readonly use: SidebarUse, private readonly materials: { name: string; about: string }[]) {
    this.showCurves([], -1, "cm");
    this.showPieces(null);
  }

  /** What the user wants to be proposed. */
  search(): SuggestionOptions {
    const pieces = Math.max(0, Math.round(this.pieces.valueAsNumber || 0));
    return { cuts: this.cuts.value as SuggestionOptions["cuts"], bound: Number(this.strain.value), ...(pieces > 0 ? { pieces } : {}) };
  }

  showSurface({ name, triangles, extent, unit, up }: SurfaceFacts, material: string, grain: string): void {
    const unitBox = make("select", {}, ...(Object.keys(units) as Unit[]).map((key) => option(key, units[key].words, key === unit)));
    unitBox.addEventListener("change", () => this.use.setUnit(unitBox.value as Unit));
    const cloth = make("select", {}, option("", "any", !material),
      ...this.materials.map((known) => make("option", { value: known.name, title: known.about, selected: known.name === material }, known.name)));
    const grainBox = make("input", { value: grain, placeholder: "0", type: "number", min: "-180", max: "180", disabled: !material, title: "Degrees from upright to the warp, counter-clockwise" });
    const change = (): void => {
      grainBox.disabled = !cloth.value;
      this.use.setCloth(cloth.value, grainBox.value);
    };
    cloth.addEventListener("change", change);
    grainBox.addEventListener("change", change);
    const kind = make("select", {}, ...Object.entries(segmentKinds).map(([key, words]) => option(key, words)));
    kind.id = "kind";
    kind.addEventListener("change", () => this.use.setKind(kind.value));
    const upBox = make("select", {}, option("y", "y", up === "y"), option("z", "z", up === "z"));
    upBox.addEventListener("change", () => this.use.setUp(upBox.value as "y" | "z"));
    byId("surface-panel").replaceChildren(
      make("p", {}, make("b", {}, name), ` ${triangles.toLocaleString("en")} triangles, ${sizeWords(extent, unit)}`),
      make("label", {}, "Unit", unitBox), make("label", {}, "Up", upBox), make("label", {}, "Material", cloth), make("label", {}, "Grain, degrees", grainBox),
      make("label", {}, "New lines run", kind), make("label", {}, "Propose", this.cuts), make("label", {}, "Strain up to", this.strain),
      make("label", {}, "Pieces, about", this.pieces));
  }

  showCurves(curves: readonly DrawnCurve[], chosen: number, unit: Unit): void {
    const cards = curves.map((curve, k) => {
      const name = make("input", { value: curve.name, ariaLabel: `Name of line ${k + 1}` });
      const type = make("select", { ariaLabel: `Type of ${curve.name}` },
        ...(Object.keys(curveTypes) as CurveType[]).map((key) =>
          make("option", { value: key, selected: key === curve.type, title: curveTypes[key].about }, curveTypes[key].name)));
      const remove = make("button", { title: `Remove ${curve.name}`, ariaLabel: `Remove ${curve.name}` }, "\u00d7");
      const change = (): void => this.use.describe(k, type.value as CurveType, name.value);
      name.addEventListener("change", change);
      type.addEventListener("change", change);
      remove.addEventListener("click", () => this.use.remove(k));
      const card = make("div", { class: k === chosen ? "card chosen" : "card" },
        make("div", { class: "row" }, name, type, remove),
        make("span", { class: "quiet" }, `${lengthWords(curve.length, unit)}, ${curveTypes[curve.type].about}`),
        ...(k === chosen ? [this.copies(k, unit)] : []));
      card.style.borderLeftColor = typeColor(curve.type);
      card.addEventListener("pointerdown", () => this.use.choose(k));
      name.addEventListener("focus", () => this.use.choose(k));
      return card;
    });
    const panel = byId("curve-panel");
    // An input keeps the focus over the renewal of its list.
    const focused = Array.from(panel.querySelectorAll<HTMLElement>("input, select, button")).indexOf(document.activeElement as HTMLElement);
    panel.replaceChildren(...(cards.length > 0 ? cards : [make("p", { class: "quiet" }, "None yet. Draw one with the tools above, or let cuts be proposed.")]));
    if (focused >= 0) {
      panel.querySelectorAll<HTMLElement>("input, select, button")[focused]?.focus();
    }
  }

  /** The line again in the mirror, or at a distance. */
  private copies(curve: number, unit: Unit): HTMLElement {
    const mirror = make("button", { title: "Add its image in the surface's plane of symmetry" }, "Mirror");
    mirror.addEventListener("click", () => this.use.mirror(curve));
    const distance = make("input", { type: "number", step: "any", value: "1", ariaLabel: `Distance in ${units[unit].words}, negative on the other side` });
    const beside = make("button", { title: "Add a line at this distance from it" }, `Offset, ${unit}`);
    beside.addEventListener("click", () => this.use.offset(curve, distance.valueAsNumber || 0));
    return make("div", { class: "row" }, mirror, distance, beside);
  }

  showProposals(cuts: readonly SuggestedCut[], unit: Unit, boundMet: boolean): void {
    byId("proposal-details").hidden = cuts.length === 0;
    const all = make("button", { class: "main" }, "Accept all");
    const none = make("button", {}, "Reject all");
    const longer = make("button", { title: "Look for better cuts, for a minute or more" }, "Search longer");
    longer.addEventListener("click", () => this.use.searchLonger());
    all.addEventListener("click", () => this.use.accept([...cuts]));
    none.addEventListener("click", () => this.use.reject());
    byId("proposal-panel").replaceChildren(
      make("p", {}, boundMet ? "With these cuts the pieces fit." : "These cuts help, but some strain stays."),
      make("p", { class: "row" }, all, none, ...(boundMet ? [] : [longer])),
      ...cuts.map((cut, k) => {
        const one = make("button", { ariaLabel: `Accept ${cut.name || `cut ${k + 1}`}` }, "Accept");
        one.addEventListener("click", () => this.use.accept([cut]));
        const before = Number.isFinite(cut.strain_before) ? `strain ${percent(cut.strain_before)} before, ` : "strain ";
        const after = Number.isFinite(cut.strain_after) ? `; ${before}${percent(cut.strain_after)} after it` : "";
        const gain = lengthWords(cut.length, unit) + after;
        return make("div", { class: "card fair" }, make("div", { class: "row" },
          make("span", {}, cut.name || `${curveTypes[cut.type].name} ${k + 1}`), one), make("span", { class: "quiet" }, gain));
      }));
  }

  showPieces(report: Report | null): void {
    const rows = report ? pieceRows(report) : [];
    const cards = rows.map((row) => {
      const { name, level, words, details } = verdictOf(row);
      const show = make("button", { ariaLabel: `Show ${name}` }, "Show");
      show.addEventListener("click", () => this.use.showPiece(row.piece));
      return make("div", { class: `card ${level}` }, make("div", { class: "row" }, make("b", {}, name), make("span", {}, row.size), show),
        make("p", {}, make("b", { class: level }, words)), make("p", { class: "quiet" }, details));
    });
    const lengths = report ? curveRows(report) : [];
    const worst = Math.max(0, ...lengths.map(({ length_3d, length_2d }) => Math.abs(length_2d / length_3d - 1)));
    byId("piece-panel").replaceChildren(...(cards.length > 0 ? cards : [make("p", { class: "quiet" }, "None yet.")]),
      ...(lengths.length > 0 ? [make("p", { class: "quiet" },
        worst < 1e-6 ? `All ${lengths.length} lines have their exact length in the plane.` : `A line is ${percent(worst)} off its length in the plane.`)] : []));
  }
}
