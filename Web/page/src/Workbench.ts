// SPDX-License-Identifier: BSD-3-Clause
import type { Curve, DrawnCurve, Report, SegmentKind, SuggestedCut, Unit } from "surfaceflattening";
import { DrawTool, type Tool } from "./DrawTool";
import { Cancelled, EngineClient } from "./engine/EngineClient";
import { LiveFlattening, type Care } from "./engine/LiveFlattening";
import type { EditorState, FlatteningAnswer, OpenedSurface, StoredCurve } from "./engine/messages";
import { curvesFile, download, readCurvesFile } from "./files/curvesFile";
import { Scene } from "./Scene";
import { askPattern, askUnit, type PatternChoice } from "./ui/dialogs";
import { byId } from "./ui/elements";
import { Sidebar } from "./ui/Sidebar";
import { isSound, pieceRows, verdictOf } from "./ui/words";

/** Surfaces with more triangles are flattened on request only. */
const mostTriangles = 200_000;
const largestFile = 400e6;
/** Some ten seconds, and a minute or two. */
const shortSearch = 20;
const longSearch = 150;

/** The surface, its curves and its flat pieces: what is open, and what the user may do with it. */
export class Workbench {
  readonly scene = new Scene();
  private editor: EngineClient;
  private readonly live: LiveFlattening;
  private readonly draw: DrawTool;
  private sidebar!: Sidebar;
  private name = "";
  private surface: OpenedSurface | null = null;
  private extent: [number, number, number] = [0, 0, 0];
  private unit: Unit = "cm";
  private material = "";
  private grain = "";
  private curves: readonly DrawnCurve[] = [];
  private chosen = { curve: -1, node: -1 };
  report: Report | null = null;
  private ghosts: SuggestedCut[] = [];
  private isSaved = true;
  private opening = 0;
  /** Of the last answer, and how many drafts were shown: for tests and the curious. */
  milliseconds = 0;
  drafts = 0;

  constructor(private readonly module: WebAssembly.Module) {
    this.editor = new EngineClient(module);
    this.live = new LiveFlattening(new EngineClient(module), (answer, care) => this.take(answer, care), (error) => this.fail(error));
    this.draw = new DrawTool(this.scene, {
      editor: () => this.editor,
      apply: (state, isLive) => this.apply(state, isLive),
      choose: (curve, node) => this.choose(curve, node),
      unit: () => this.unit,
      fail: (error) => this.fail(error),
    });
    byId("pieces").addEventListener("pointermove", (event) => this.scene.point(this.scene.pieces.hit(event.offsetX, event.offsetY)));
    addEventListener("beforeunload", (event) => this.isSaved || event.preventDefault());
  }

  async start(): Promise<void> {
    const materials = await this.editor.call("materials");
    this.sidebar = new Sidebar({
      setUnit: (unit) => void this.setUnit(unit),
      setCloth: (material, grain) => this.setCloth(material, grain),
      setKind: (kind) => (this.draw.kind = kind as SegmentKind),
      setUp: (axis) => this.scene.surface.setUp(axis),
      searchLonger: () => void this.propose(longSearch),
      choose: (curve) => this.choose(curve, -1),
      describe: (curve, type, name) => this.edit(this.editor.call("describe", curve, type, name)),
      mirror: (curve) => this.edit(this.editor.call("addImage", curve)),
      offset: (curve, distance) => this.edit(this.editor.call("addOffset", curve, distance)),
      remove: (curve) => this.edit(this.editor.call("removeCurve", curve)),
      accept: (cuts) => this.accept(cuts),
      reject: () => this.showGhosts([], true),
      showPiece: (piece) => this.scene.showPiece(piece),
    }, materials);
    this.say("Open a mesh, or try an example.");
  }

  /** Opens a surface, or curves on the surface that is open. */
  async open(name: string, content: Promise<ArrayBuffer>): Promise<void> {
    ++this.opening;
    try {
      const bytes = new Uint8Array(await content);
      if (/\.(json|csv|dxf|txt)$/i.test(name)) {
        await this.openCurves(name, bytes);
        return;
      }
      if (bytes.length > largestFile) {
        throw new Error(`${name} has ${Math.round(bytes.length / 1e6)} MB, more than a browser can take. Reduce its triangles (for example in Blender or MeshLab).`);
      }
      this.say(`Reading ${name}`);
      // What is open stays where the file is broken.
      const editor = new EngineClient(this.module);
      const surface = await editor.call("open", name, bytes).catch((error: Error) => {
        editor.end();
        throw error;
      });
      this.editor.end();
      this.editor = editor;
      await this.openSurface(name, bytes, surface);
    } catch (error) {
      this.fail(error);
    } finally {
      --this.opening;
    }
  }

  setTool(tool: Tool): void {
    this.draw.setTool(tool);
  }

  setFreehand(on: boolean): void {
    this.draw.freehand = on;
  }

  /** Whether nothing is under way. */
  isSettled(): boolean {
    return this.opening === 0 && !this.editor.isBusy() && this.live.isIdle();
  }

  lines(): { type: string; name: string; length: number; nodes: number }[] {
    return this.curves.map(({ type, name, length, nodes }) => ({ type, name, length, nodes: nodes.length / 3 }));
  }

  /** Bytes that the engines have taken. */
  async memory(): Promise<number> {
    return await this.editor.call("memory") + await this.live.memory();
  }

  endCurve(): void {
    void this.draw.end();
  }

  step(direction: "undo" | "redo"): void {
    if (this.surface) {
      this.edit(this.editor.call("step", direction));
    }
  }

  removeChosen(): void {
    const { curve, node } = this.chosen;
    if (curve >= 0) {
      this.chosen = { curve: node >= 0 ? curve : -1, node: -1 };
      this.edit(node >= 0 ? this.editor.call("removeNode", curve, node) : this.editor.call("removeCurve", curve));
    }
  }

  /** \param work of the search, in millions of steps on one triangle */
  async propose(work = shortSearch): Promise<void> {
    const bar = byId<HTMLProgressElement>("progress");
    try {
      bar.hidden = byId("cancel").hidden = false;
      bar.removeAttribute("value");
      this.say("Looking for cuts");
      const options = { ...this.sidebar.search(), release_trials: false, max_work: work };
      const found = await this.live.suggest(this.flattenable(), options, (news) => {
        "progress" in news ? bar.value = news.progress : this.scene.setGhosts(this.ghosts = news.preview.map(previewed));
      });
      this.take(found, "full");
      this.showGhosts(found.cuts, found.boundMet);
      if (found.cuts.length === 0 && !found.report.refused) {
        this.say(found.boundMet ? "No cut is needed." : "No cut was found that helps.");
      }
    } catch (error) {
      this.fail(error);
    } finally {
      bar.hidden = byId("cancel").hidden = true;
    }
  }

  /** Cuts found so far stay proposed. */
  async cancel(): Promise<void> {
    await this.live.cancel();
    this.showGhosts(this.ghosts, false);
    this.say("Cancelled.");
  }

  save(): void {
    if (this.surface) {
      const text = curvesFile(this.name, this.unit, this.material, this.grain, this.curves);
      download(`${this.title()}_lines.json`, text, "application/json");
      this.setSaved(true);
    }
  }

  askPattern(): void {
    if (this.report && !this.report.refused) {
      askPattern(this.title(), (choice) => this.writePattern(choice));
    }
  }

  private title(): string {
    return this.name.replace(/\.[^.]*$/, "");
  }

  private async writePattern({ format, name, paper, allowance }: PatternChoice): Promise<string> {
    const options = { name, paper, allowance, date: new Date().toISOString().slice(0, 10) };
    const { bytes, warnings } = await this.live.pattern(format, options);
    const types = { pdf: "application/pdf", svg: "image/svg+xml", dxf: "image/vnd.dxf", plt: "application/vnd.hp-hpgl", json: "application/json" };
    download(`${name || this.title()}.${format}`, bytes as BlobPart, types[format]);
    return warnings.join(" ");
  }

  private async openSurface(name: string, bytes: Uint8Array, surface: OpenedSurface): Promise<void> {
    this.name = name;
    this.surface = surface;
    this.curves = [];
    this.report = null;
    this.chosen = { curve: -1, node: -1 };
    this.extent = extentOf(surface.points);
    byId("welcome").hidden = true;
    this.scene.open(surface);
    this.showGhosts([], true);
    this.sidebar.showPieces(null);
    this.sidebar.showCurves([], -1, this.unit);
    this.unit = surface.unit || surface.likelyUnit;
    this.showSurface();
    this.unit = surface.unit || await askUnit(name, this.extent, surface.likelyUnit);
    this.scene.setUnit(this.unit);
    this.showSurface();
    this.setSaved(true);
    const triangles = surface.corners.length / 3;
    this.say(`Flattening ${name}`);
    await this.live.setSurface(name, bytes, this.unit, triangles);
    await this.editor.call("setUnit", this.unit);
    this.enable();
    if (triangles > mostTriangles) {
      this.say(`${name} has ${triangles.toLocaleString("en")} triangles. Reduce it to at most ${mostTriangles.toLocaleString("en")} ` +
        "(for example in Blender or MeshLab); larger ones take many minutes here.", true);
    } else if (surface.curves.length > 0 && !surface.problem) {
      this.apply(await this.editor.call("addCurves", surface.curves), false);
    } else {
      this.live.ask([], "full");
    }
  }

  private async openCurves(name: string, bytes: Uint8Array): Promise<void> {
    if (!this.surface) {
      throw new Error(`${name} has lines. Open their surface first.`);
    }
    let curves: readonly StoredCurve[];
    if (/\.json$/i.test(name)) {
      const file = readCurvesFile(name, new TextDecoder().decode(bytes));
      curves = file.curves;
      this.material = file.material;
      this.grain = file.grain;
      await this.setUnit(file.unit);
    } else {
      curves = await this.editor.call("readCurves", name, bytes);
    }
    this.apply(await this.editor.call("addCurves", [...curves]), false);
  }

  private async setUnit(unit: Unit): Promise<void> {
    this.unit = unit;
    this.scene.setUnit(unit);
    this.showSurface();
    await this.editor.call("setUnit", unit);
    await this.live.setUnit(unit);
    this.setCloth(this.material, this.grain);
  }

  private setCloth(material: string, grain: string): void {
    this.material = material;
    this.grain = grain;
    this.live.options = material ? { material, ...(grain ? { grain: [grain] } : {}) } : {};
    this.refresh("full");
  }

  private showSurface(): void {
    const triangles = (this.surface?.corners.length ?? 0) / 3;
    this.sidebar.showSurface({ name: this.name, triangles, extent: this.extent, unit: this.unit, up: this.scene.surface.up() }, this.material, this.grain);
  }

  private flattenable(): Curve[] {
    return this.curves.filter(({ points }) => points.length >= 6)
      .map(({ points, type, name }) => ({ points, type, name }));
  }

  private edit(command: Promise<EditorState>): void {
    command.then((state) => this.apply(state, false), (error) => this.fail(error));
  }

  private apply(state: EditorState, isLive: boolean): void {
    this.curves = state.curves;
    if (this.chosen.curve >= state.curves.length) {
      this.chosen = { curve: -1, node: -1 };
    }
    this.draw.setCurves(state.curves);
    this.scene.setCurves(state.curves);
    this.sidebar.showCurves(state.curves, this.chosen.curve, this.unit);
    byId<HTMLButtonElement>("undo").disabled = !state.canUndo;
    byId<HTMLButtonElement>("redo").disabled = !state.canRedo;
    if (state.status.code !== 0) {
      this.say(state.status.message, true);
      return;
    }
    this.setSaved(!state.canUndo);
    this.refresh(isLive ? "draft" : "full");
  }

  private refresh(care: Care): void {
    if (this.surface && this.surface.corners.length / 3 <= mostTriangles) {
      this.live.ask(this.flattenable(), care);
    }
  }

  private choose(curve: number, node: number): void {
    const isOther = curve !== this.chosen.curve;
    this.chosen = { curve, node };
    this.scene.choose(curve, node);
    if (isOther) {
      this.sidebar.showCurves(this.curves, curve, this.unit);
    }
  }

  private take({ report, pieces, milliseconds }: FlatteningAnswer, care: Care): void {
    this.milliseconds = milliseconds;
    this.drafts += care === "draft" ? 1 : 0;
    if (report.refused && care === "draft") {
      return;
    }
    this.report = report;
    this.scene.setPieces(pieces, report, care);
    if (care === "full") {
      this.sidebar.showPieces(report);
      this.sayVerdict(report);
    }
    this.enable();
  }

  private sayVerdict(report: Report): void {
    const rows = [...pieceRows(report)].sort((a, b) => Number(isSound(a)) - Number(isSound(b)) || b.strain_p95 - a.strain_p95);
    if (report.refused || rows.length === 0) {
      const closed = /closed/.test(report.status.message) ? " Propose cuts opens it." : "";
      this.say(`This surface cannot be flattened: ${report.status.message}.${closed}`, true);
      return;
    }
    const { name, words, details } = verdictOf(rows[0]);
    const said = `${rows.length > 1 ? `${rows.length} pieces; worst: ` : ""}${name} ${words}. ${details}`;
    const warnings = report.warnings.filter((warning) => !/^piece \d+: /.test(warning)); // the list of pieces has their words
    this.say([said, ...warnings].join(". "));
  }

  private showGhosts(cuts: SuggestedCut[], boundMet: boolean): void {
    this.scene.setGhosts(cuts);
    this.sidebar.showProposals(cuts, this.unit, boundMet);
    this.ghosts = cuts;
  }

  /** Proposed cuts become curves, by one step of undo; the others stay proposals. */
  private accept(cuts: SuggestedCut[]): void {
    const stored = cuts.map(({ type, name, points }): StoredCurve => ({
      type, name, closed: false, nodes: points, kinds: Array<SegmentKind>(points.length / 3 - 1).fill("geodesic"),
    }));
    this.edit(this.editor.call("addCurves", stored));
    this.showGhosts(this.ghosts.filter((cut) => !cuts.includes(cut)), true);
  }

  private enable(): void {
    const isFlat = this.report !== null && !this.report.refused;
    byId<HTMLButtonElement>("pattern").disabled = !isFlat;
    byId<HTMLButtonElement>("propose").disabled = byId<HTMLButtonElement>("save").disabled = this.surface === null;
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-tool], #freehand")) {
      button.disabled = this.surface !== null && this.surface.problem !== "" && button.dataset.tool !== "select";
    }
  }

  private setSaved(saved: boolean): void {
    this.isSaved = saved;
    document.title = `${saved ? "" : "* "}${this.name ? `${this.name} - ` : ""}SurfaceFlattening`;
  }

  private say(words: string, isProblem = false): void {
    const line = byId("verdict");
    line.textContent = words;
    line.classList.toggle("problem", isProblem);
  }

  private fail(error: unknown): void {
    if (!(error instanceof Cancelled)) {
      this.say(error instanceof Error ? error.message : String(error), true);
    }
  }
}

/** A cut that is found while the search goes on. */
function previewed(points: Float64Array): SuggestedCut {
  let length = 0;
  for (let k = 3; k < points.length; k += 3) {
    length += Math.hypot(points[k] - points[k - 3], points[k + 1] - points[k - 2], points[k + 2] - points[k - 1]);
  }
  return { points, type: "seam", name: "", length, strain_before: NaN, strain_after: NaN };
}

function extentOf(points: Float64Array): [number, number, number] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  points.forEach((value, k) => {
    low[k % 3] = Math.min(low[k % 3], value);
    high[k % 3] = Math.max(high[k % 3], value);
  });
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
}
