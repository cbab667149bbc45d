// SPDX-License-Identifier: BSD-3-Clause
// The engine on a thread of its own. Each worker has one surface; a new surface gets a new worker, so that the
// memory of the old one is free.
import clipper from "clipper-lib";
import { load } from "surfaceflattening";
import type {
  Curve, CurveType, DataSet, Editor, Engine, Flattening, FlatteningOptions, PatternFile, SegmentKind, Status, SuggestionOptions, Surface, Unit,
} from "surfaceflattening";
import type {
  EditorState, FlatPieces, FlatteningAnswer, News, OpenedSurface, Proposal, StoredCurve, WorkerReply, WorkerRequest,
} from "./messages";

/** New for each reply, with whose buffers it is handed over. */
const fine = (): Status => ({ code: 0, name: "Ok", message: "", ids: new Int32Array(), kind: "" });
const curveTypes: CurveType[] = ["accessory", "key", "dart", "seam"];

export type PatternEnding = "pdf" | "svg" | "dxf" | "plt" | "json" | "csv";
export type PatternOptions = Record<string, string | number | boolean>;

export class EngineSession {
  private surface: Surface | null = null;
  private editor: Editor | null = null;
  private flattening: Flattening | null = null;

  constructor(private readonly engine: Engine, private readonly tell: (news: News) => void) {}

  open(name: string, bytes: Uint8Array): OpenedSurface {
    const surface = this.engine.readSurface(name, bytes);
    this.surface = surface;
    const { points, corners } = surface.arrays();
    const defects = surface.developability();
    let problem = "";
    try {
      this.editor = this.engine.edit(surface);
    } catch (error) {
      problem = (error as Error).message;
    }
    return {
      points, corners, problem,
      unit: surface.unit(),
      likelyUnit: surface.likelyUnit(),
      curves: curvesOf(surface.curves("")),
      developability: defects && defects.Developability,
    };
  }

  setUnit(unit: Unit): void {
    this.opened().setUnit(unit);
  }

  materials(): { name: string; about: string }[] {
    return this.engine.materials();
  }

  readCurves(name: string, bytes: Uint8Array): StoredCurve[] {
    return curvesOf(this.engine.readCurves(this.opened(), name, bytes));
  }

  flatten(curves: Curve[], options: FlatteningOptions): FlatteningAnswer {
    const start = performance.now();
    this.keep(this.opened().flatten(curves, options, (progress) => this.tell({ progress })));
    return this.answer(start);
  }

  suggest(curves: Curve[], options: SuggestionOptions): Proposal {
    const start = performance.now();
    const { flattening, cuts, boundMet } = this.opened().suggest(
      curves, options, (progress) => this.tell({ progress }), (preview) => this.tell({ preview }));
    this.keep(flattening);
    return { ...this.answer(start), cuts, boundMet };
  }

  /** A file of the pieces flattened last. */
  async pattern(ending: PatternEnding, options: PatternOptions): Promise<{ bytes: Uint8Array; warnings: string[] }> {
    if (ending !== "pdf") {
      return checked(this.flattened().pattern(ending, options));
    }
    const { PdfCanvas } = await import("../files/PdfCanvas");
    const canvas = await PdfCanvas.create(String(options.name));
    const { warnings } = checked(this.flattened().pattern(ending, options, canvas));
    return { bytes: await canvas.bytes(), warnings };
  }

  addCurves(curves: StoredCurve[]): EditorState {
    return this.edit((editor) => {
      let status = fine();
      editor.beginGroup();
      for (const { type, name, nodes, kinds, closed } of curves) {
        const added = editor.add(type, name, nodes, kinds, closed);
        status = status.code === 0 ? added : status;
      }
      editor.endGroup();
      return status;
    });
  }

  addStroke(type: CurveType, places: number[], tolerance: number): EditorState {
    return this.edit((editor) => {
      editor.beginGroup();
      const status = editor.addStroke(places, tolerance);
      if (status.code === 0) {
        editor.describe(editor.curves().length - 1, type, "");
      }
      editor.endGroup();
      return status;
    });
  }

  /** Within reach of something that it snaps to, a node lies there; 0: nowhere. */
  startCurve(type: CurveType, place: number[], reach: number): EditorState {
    return this.edit((editor) => editor.add(type, "", this.snapped(place, reach, -1), [], false));
  }

  insertNode(curve: number, node: number, place: number[], reach: number, kind: SegmentKind): EditorState {
    return this.edit((editor) => editor.insertNode(curve, node, this.snapped(place, reach, curve), kind));
  }

  moveNode(curve: number, node: number, place: number[], reach: number): EditorState {
    return this.edit((editor) => editor.moveNode(curve, node, this.snapped(place, reach, curve)));
  }

  removeNode(curve: number, node: number): EditorState {
    return this.edit((editor) => editor.removeNode(curve, node));
  }

  describe(curve: number, type: CurveType, name: string): EditorState {
    return this.edit((editor) => editor.describe(curve, type, name));
  }

  addImage(curve: number): EditorState {
    return this.edit((editor) => editor.addImage(curve));
  }

  addOffset(curve: number, distance: number): EditorState {
    return this.edit((editor) => editor.addOffset(curve, distance));
  }

  removeCurve(curve: number): EditorState {
    return this.edit((editor) => editor.remove(curve));
  }

  setClosed(curve: number, closed: boolean): EditorState {
    return this.edit((editor) => editor.setClosed(curve, closed));
  }

  step(direction: "undo" | "redo"): EditorState {
    return this.edit((editor) => void (direction === "undo" ? editor.undo() : editor.redo()));
  }

  /** Until it ends, all commands are undone as one. */
  group(begins: boolean): EditorState {
    return this.edit((editor) => void (begins ? editor.beginGroup() : editor.endGroup()));
  }

  snap(place: number[], reach: number, exceptCurve: number): { point: Float64Array; target: number } {
    return this.drawn().snap(place, reach, exceptCurve);
  }

  memory(): number {
    return this.engine.memory();
  }

  private snapped(place: number[], reach: number, exceptCurve: number): ArrayLike<number> {
    return reach > 0 ? this.snap(place, reach, exceptCurve).point : place;
  }

  private edit(command: (editor: Editor) => Status | void): EditorState {
    const editor = this.drawn();
    const status = command(editor) ?? fine();
    return { status, curves: editor.curves(), canUndo: editor.canUndo(), canRedo: editor.canRedo() };
  }

  private answer(start: number): FlatteningAnswer {
    const flattening = this.flattened();
    const pieces = piecesOf(flattening);
    return { report: flattening.report(), pieces, milliseconds: performance.now() - start };
  }

  private keep(flattening: Flattening): void {
    this.flattening?.delete();
    this.flattening = flattening;
  }

  private opened(): Surface {
    return this.surface ?? missing("open a surface first");
  }

  private drawn(): Editor {
    return this.editor ?? missing("no curve can be drawn on this surface");
  }

  private flattened(): Flattening {
    return this.flattening ?? missing("there are no flat pieces yet");
  }
}

function checked(file: PatternFile): PatternFile {
  if (file.status.code !== 0) {
    throw new Error(file.status.message);
  }
  return file;
}

function missing(what: string): never {
  throw new Error(what);
}

/** Polylines of a file as curves along edges, with a node at each end and at each sharp bend. */
function curvesOf(data: DataSet): StoredCurve[] {
  const { CurveType: types, CurveName: names, KeyShape: shapes } = data.cellArrays;
  return data.lines.map((line, k) => {
    const at = (id: number): number[] => Array.from(data.points.subarray(3 * id, 3 * id + 3));
    const type = Number(types?.[k] ?? 0);
    const closed = line.length > 3 && line[0] === line[line.length - 1];
    const ids = closed ? line.subarray(0, -1) : line;
    const nodes = Array.from(ids).flatMap(at);
    const count = ids.length - (closed ? 0 : 1);
    return {
      type: type === 1 && shapes?.[k] === 1 ? "straight" : curveTypes[type],
      name: String(names?.[k] ?? ""),
      closed,
      nodes,
      kinds: Array<SegmentKind>(count).fill("geodesic"),
    };
  });
}

function piecesOf(flattening: Flattening): FlatPieces | null {
  const flat = flattening.flat();
  const cut = flattening.cut();
  const wires = flattening.wires();
  if (!flat || !cut || !wires) {
    return null;
  }
  const { CurveType: types, CurveName: names, Boundary: boundary, Connector: connector } = wires.cellArrays;
  const drawn = wires.lines.map((line, k) => ({
    points: Float64Array.from(Array.from(line).flatMap((id) => Array.from(wires.points.subarray(3 * id, 3 * id + 3)))),
    type: Number(types[k]),
    name: String(names[k]),
    boundary: Number(boundary[k]) !== 0,
  }));
  return {
    points: flat.points,
    corners: flat.corners,
    space: cut.points,
    pieceIds: flat.cellArrays.PieceId as Int32Array,
    areaRatios: flat.cellArrays.AreaRatio as Float64Array,
    developability: flat.pointArrays.Developability as Float64Array,
    wires: drawn.filter((_, k) => !Number(connector[k])),
  };
}

/** The buffers of all typed arrays in a value, which can be handed over without a copy. */
function buffersOf(value: unknown, found: Set<ArrayBuffer> = new Set()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) {
    found.add(value.buffer as ArrayBuffer);
  } else if (value && typeof value === "object") {
    Object.values(value).forEach((item) => buffersOf(item, found));
  }
  return found;
}

let session: Promise<EngineSession>;
let current = 0;

function reply(message: WorkerReply): void {
  postMessage(message, { transfer: [...buffersOf(message)] });
}

addEventListener("message", async ({ data }: MessageEvent<WorkerRequest>) => {
  if ("module" in data) {
    session = load({
      clipper,
      instantiateWasm: (imports, use) => {
        WebAssembly.instantiate(data.module, imports).then(use);
        return {};
      },
    }).then((engine) => new EngineSession(engine, (news) => reply({ id: current, ...news })));
    return;
  }
  try {
    const target = await session;
    current = data.id;
    const method = target[data.call as keyof EngineSession] as (...given: unknown[]) => unknown;
    reply({ id: data.id, result: await method.apply(target, data.given) });
  } catch (error) {
    const words = error instanceof Error ? error.message : String(error);
    const full = error instanceof RangeError || /memory|bad_alloc/i.test(words);
    reply({ id: data.id, error: full ? "The browser has not enough memory for this surface. Reduce its triangles." : words });
  }
});
