// SPDX-License-Identifier: BSD-3-Clause
import type { CurveType, DrawnCurve, SegmentKind, Unit } from "surfaceflattening";
import type { EngineClient } from "./engine/EngineClient";
import type { EditorState } from "./engine/messages";
import type { Scene } from "./Scene";
import { byId } from "./ui/elements";
import { lengthWords, snapTargets } from "./ui/words";

export type Tool = "select" | CurveType;

/** Pixels within which a pointer takes a node, a curve, or what it snaps to. */
const grip = 12;

export interface DrawToolUse {
  editor(): EngineClient;
  /** Takes what a command has made. \param live while something is dragged */
  apply(state: EditorState, live: boolean): void;
  choose(curve: number, node: number): void;
  unit(): Unit;
  fail(error: unknown): void;
}

/** Draws and changes curves by mouse, pen, touch and keys; one finger or the left button beside the surface turns it. */
export class DrawTool {
  tool: Tool = "select";
  kind: SegmentKind = "geodesic";
  freehand = false;
  private curves: readonly DrawnCurve[] = [];
  /** The curve that is being drawn, or -1. */
  private drawing = -1;
  private dragged: { curve: number; node: number; isMoved: boolean } | null = null;
  private stroke: number[] | null = null;
  private pressed: { x: number; y: number; id: number } | null = null;
  private readonly fingers = new Set<number>();
  private busy = false;
  private nextMove: (() => Promise<void>) | null = null;
  private keys = { x: 0, y: 0 };

  constructor(private readonly scene: Scene, private readonly use: DrawToolUse) {
    const { canvas } = scene.surface.view;
    // Before the controls, which turn the surface.
    const first = { capture: true };
    canvas.addEventListener("pointerdown", (event) => this.press(event), first);
    canvas.addEventListener("pointermove", (event) => this.move(event), first);
    canvas.addEventListener("pointerup", (event) => this.release(event), first);
    canvas.addEventListener("pointercancel", (event) => this.release(event), first);
    canvas.addEventListener("pointerleave", () => this.scene.setCursor(null, null));
    canvas.addEventListener("dblclick", (event) => this.doubleClick(event));
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("blur", () => (byId("cross").hidden = true));
  }

  setTool(tool: Tool): void {
    void this.end();
    this.tool = tool;
    this.scene.setCursor(null, null);
    this.hint(tool === "select" ? "" : this.freehand ? "Draw a stroke on the surface." : "Click the points of the line; Enter or a double click ends it.");
  }

  setCurves(curves: readonly DrawnCurve[]): void {
    this.curves = curves;
    if (this.drawing >= curves.length) {
      this.drawing = -1;
    }
  }

  isDrawing(): boolean {
    return this.drawing >= 0;
  }

  /** Ends the curve that is being drawn; one of a single point goes. */
  async end(): Promise<void> {
    const curve = this.drawing;
    this.drawing = -1;
    this.scene.setCursor(null, null);
    if (curve >= 0 && this.curves[curve]?.nodes.length < 6) {
      await this.run(this.use.editor().call("removeCurve", curve), false);
    } else if (curve >= 0) {
      this.use.choose(curve, -1);
    }
  }

  private hint(words: string): void {
    byId("hint").textContent = words;
  }

  private async run(command: Promise<EditorState>, live: boolean): Promise<boolean> {
    try {
      const state = await command;
      this.use.apply(state, live);
      return state.status.code === 0;
    } catch (error) {
      this.use.fail(error);
      return false;
    }
  }

  private reach(event: { altKey: boolean }): number {
    return event.altKey ? 0 : grip * this.scene.surface.view.unitsPerPixel();
  }

  private press(event: PointerEvent): void {
    this.fingers.add(event.pointerId);
    if (event.button !== 0 || this.fingers.size > 1) {
      return;
    }
    this.pressed = { x: event.offsetX, y: event.offsetY, id: event.pointerId };
    const hit = this.scene.surface.hit(event.offsetX, event.offsetY);
    if (this.tool === "select") {
      const node = this.nodeAt(event.offsetX, event.offsetY);
      if (node) {
        this.use.choose(node.curve, node.node);
        this.dragged = { ...node, isMoved: false };
        void this.use.editor().call("group", true);
        this.scene.surface.view.controls.enabled = false;
      } else {
        const curve = this.curveAt(event.offsetX, event.offsetY);
        if (curve) {
          this.use.choose(curve.curve, -1);
        }
      }
    } else if (hit && this.freehand) {
      this.stroke = [...hit.position];
      this.scene.surface.view.controls.enabled = false;
    } else if (hit) {
      this.scene.surface.view.controls.enabled = false;
    }
  }

  private move(event: PointerEvent): void {
    const { offsetX: x, offsetY: y } = event;
    const hit = this.scene.surface.hit(x, y);
    const reach = this.reach(event);
    if (this.dragged) {
      const { curve, node } = this.dragged;
      this.dragged.isMoved ||= this.pressed !== null && Math.hypot(x - this.pressed.x, y - this.pressed.y) > 2;
      if (hit && this.dragged.isMoved) {
        this.latest(async () => {
          await this.run(this.use.editor().call("moveNode", curve, node, hit.position, reach), true);
          this.hint(lengthWords(this.curves[curve]?.length ?? 0, this.use.unit()));
        });
      }
    } else if (this.stroke && hit) {
      this.stroke.push(...hit.position);
      this.scene.setStroke(this.stroke);
    } else if (this.tool !== "select" && !this.freehand && hit && event.buttons === 0) {
      this.latest(() => this.preview(hit.position, reach));
    }
    if (event.buttons === 0) {
      this.scene.point(this.scene.isFlat() ? hit : null);
    }
  }

  private release(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.scene.surface.view.controls.enabled = true;
    const { pressed, dragged, stroke } = this;
    this.pressed = this.dragged = this.stroke = null;
    if (dragged) {
      this.latest(async () => {
        await this.run(this.use.editor().call("group", false), false);
        this.hint("");
      });
    } else if (stroke && stroke.length > 6) {
      const tolerance = 3 * this.scene.surface.view.unitsPerPixel();
      this.scene.setStroke([]);
      void this.run(this.use.editor().call("addStroke", this.tool as CurveType, stroke, tolerance), false)
        .then((done) => done && this.use.choose(this.curves.length - 1, -1));
    } else if (pressed && pressed.id === event.pointerId && this.tool !== "select" && !this.freehand) {
      // A drag is no click: it turned the surface, or it was two fingers.
      if (Math.hypot(event.offsetX - pressed.x, event.offsetY - pressed.y) < 6 && this.fingers.size === 0) {
        void this.click(event.offsetX, event.offsetY, this.reach(event));
      }
    }
  }

  /** Sets a node of the curve that is being drawn. */
  private async click(x: number, y: number, reach: number): Promise<void> {
    const hit = this.scene.surface.hit(x, y);
    if (!hit) {
      return;
    }
    const curve = this.drawing;
    if (curve < 0) {
      const count = this.curves.length;
      if (await this.run(this.use.editor().call("startCurve", this.tool as CurveType, hit.position, reach), true)) {
        this.drawing = count;
        this.use.choose(count, 0);
        this.hint("Click the next point.");
      }
      return;
    }
    const { nodes } = this.curves[curve];
    const near = (node: number): boolean => {
      const pixel = this.scene.surface.view.pixelOf(nodes.slice(3 * node, 3 * node + 3));
      return Math.hypot(pixel.x - x, pixel.y - y) < 8;
    };
    const count = nodes.length / 3;
    if (count > 2 && near(0)) {
      this.drawing = -1;
      await this.run(this.use.editor().call("setClosed", curve, true), false);
    } else if (near(count - 1)) {
      await this.end();
    } else if (await this.run(this.use.editor().call("insertNode", curve, count, hit.position, reach, this.kind), false)) {
      this.use.choose(curve, count);
      this.hint(`${lengthWords(this.curves[curve].length, this.use.unit())}. Enter ends the line.`);
    }
  }

  private async preview(place: number[], reach: number): Promise<void> {
    try {
      const { point, target } = await this.use.editor().call("snap", place, reach, this.drawing);
      const nodes = this.curves[this.drawing]?.nodes;
      this.scene.setCursor(Array.from(point), nodes ? nodes.slice(-3) : null);
      if (this.drawing < 0 || target > 0) {
        this.hint(target > 0 ? `Point ${snapTargets[target]}` : "Click the points of the line.");
      }
    } catch (error) {
      this.use.fail(error);
    }
  }

  private doubleClick(event: MouseEvent): void {
    if (this.drawing >= 0) {
      void this.end();
      return;
    }
    const at = this.tool === "select" ? this.curveAt(event.offsetX, event.offsetY) : null;
    const hit = this.scene.surface.hit(event.offsetX, event.offsetY);
    if (at && hit) {
      void this.run(this.use.editor().call("insertNode", at.curve, at.segment + 1, hit.position, 0, this.curves[at.curve].kinds[at.segment]), false)
        .then((done) => done && this.use.choose(at.curve, at.segment + 1));
    }
  }

  private key(event: KeyboardEvent): void {
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = arrows[event.key];
    const { surface } = this.scene;
    const cross = byId("cross");
    if (step && this.tool === "select") {
      surface.turn(step[0] * 0.12, -step[1] * 0.12);
    } else if (step) {
      if (cross.hidden) {
        this.keys = { x: surface.view.size.x / 2, y: surface.view.size.y / 2 };
      }
      const pixels = event.shiftKey ? 1 : 12;
      this.keys = { x: this.keys.x + step[0] * pixels, y: this.keys.y + step[1] * pixels };
      cross.hidden = false;
      cross.style.transform = `translate(${this.keys.x}px, ${this.keys.y}px)`;
      const hit = surface.hit(this.keys.x, this.keys.y);
      if (hit) {
        this.latest(() => this.preview(hit.position, this.reach(event)));
      }
    } else if (event.key === " " && this.tool !== "select" && !cross.hidden) {
      void this.click(this.keys.x, this.keys.y, this.reach(event));
    } else {
      return;
    }
    event.preventDefault();
  }

  /** Runs the last of the moves that came while one was under way. */
  private latest(move: () => Promise<void>): void {
    this.nextMove = move;
    if (this.busy) {
      return;
    }
    this.busy = true;
    void (async () => {
      while (this.nextMove) {
        const next = this.nextMove;
        this.nextMove = null;
        await next();
      }
      this.busy = false;
    })();
  }

  private nodeAt(x: number, y: number): { curve: number; node: number } | null {
    let best = grip;
    let found: { curve: number; node: number } | null = null;
    const { view } = this.scene.surface;
    const hit = this.scene.surface.hit(x, y);
    this.curves.forEach(({ nodes }, curve) => {
      for (let node = 0; 3 * node < nodes.length; ++node) {
        const place = nodes.slice(3 * node, 3 * node + 3);
        const pixel = view.pixelOf(place);
        const distance = Math.hypot(pixel.x - x, pixel.y - y);
        // One behind the surface is not meant.
        const isHidden = hit && Math.hypot(...hit.position.map((value, axis) => value - place[axis])) > 4 * grip * view.unitsPerPixel();
        if (distance < best && !isHidden) {
          best = distance;
          found = { curve, node };
        }
      }
    });
    return found;
  }

  /** The curve at a pixel, and which of its segments. */
  private curveAt(x: number, y: number): { curve: number; segment: number } | null {
    let best = grip;
    let found: { curve: number; segment: number } | null = null;
    const { view } = this.scene.surface;
    const hit = this.scene.surface.hit(x, y);
    this.curves.forEach(({ points, nodes, kinds }, curve) => {
      let segment = 0;
      for (let k = 0; k + 3 < points.length; k += 3) {
        const next = 3 * (segment + 1);
        if (segment + 1 < kinds.length && [0, 1, 2].every((axis) => points[k + axis] === nodes[next + axis])) {
          ++segment;
        }
        const [a, b] = [view.pixelOf(points.slice(k, k + 3)), view.pixelOf(points.slice(k + 3, k + 6))];
        const length = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
        const t = length > 0 ? Math.min(1, Math.max(0, ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / length)) : 0;
        const distance = Math.hypot(a.x + t * (b.x - a.x) - x, a.y + t * (b.y - a.y) - y);
        const isHidden = hit && Math.hypot(...hit.position.map((value, axis) => value - points[k + axis])) > 8 * grip * view.unitsPerPixel();
        if (distance < best && !isHidden) {
          best = distance;
          found = { curve, segment };
        }
      }
    });
    return found;
  }
}
