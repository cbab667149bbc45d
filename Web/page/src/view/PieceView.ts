// SPDX-License-Identifier: BSD-3-Clause
import { MOUSE, OrthographicCamera, TOUCH } from "three";
import type { Mesh } from "../engine/messages";
import { MeshCanvas, type Dot, type Line } from "./MeshCanvas";
import { triangleAt, type Place } from "./picking";

export interface Label {
  words: string;
  x: number;
  y: number;
}

/** Pixels below the pieces that the legend and the scale take. */
const legendHeight = 90;

/** The flat pieces, with their names and a scale. */
export class PieceView {
  readonly view: MeshCanvas;
  private mesh: Mesh = { points: new Float64Array(), corners: new Int32Array() };
  private labels: { element: HTMLElement; at: [number, number] }[] = [];
  private isMoved = false;
  /** Words for a length in the plane, for the scale. */
  lengthWords: (length: number) => string = String;

  constructor(canvas: HTMLCanvasElement, private readonly overlay: HTMLElement, private readonly scale: HTMLElement) {
    const camera = new OrthographicCamera(-1, 1, 1, -1, -1e6, 1e6);
    camera.position.z = 1;
    this.view = new MeshCanvas(canvas, camera, () => this.place());
    const { controls } = this.view;
    controls.enableRotate = false;
    controls.screenSpacePanning = true;
    controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    controls.addEventListener("start", () => (this.isMoved = true));
    new ResizeObserver(() => this.isMoved || this.fit()).observe(canvas.parentElement as HTMLElement);
  }

  setMesh(mesh: Mesh, colors: Float32Array, lines: Line[], labels: Label[]): void {
    this.mesh = mesh;
    this.view.setMesh(mesh, colors);
    this.view.setLines(lines);
    const elements = labels.map(({ words, x, y }) => {
      const element = document.createElement("span");
      element.textContent = words;
      return { element, at: [x, y] as [number, number] };
    });
    this.overlay.replaceChildren(...elements.map(({ element }) => element));
    this.labels = elements;
    if (!this.isMoved) {
      this.fit();
    }
  }

  setDots(dots: Dot[]): void {
    this.view.setDots(dots);
  }

  /** Shows all pieces, now and after each change until the user moves the view. */
  fit(): void {
    const { points } = this.mesh;
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (let k = 0; k < points.length; k += 3) {
      for (const axis of [0, 1]) {
        low[axis] = Math.min(low[axis], points[k + axis]);
        high[axis] = Math.max(high[axis], points[k + axis]);
      }
    }
    if (points.length === 0) {
      return;
    }
    const { camera, controls, size } = this.view;
    const ortho = camera as OrthographicCamera;
    const usable = Math.max(size.y - legendHeight - 24, size.y / 2);
    const half = Math.max(((high[1] - low[1]) * size.y) / usable / 2, (0.55 * (high[0] - low[0]) * size.y) / size.x, 1e-9);
    const aspect = size.x / size.y;
    Object.assign(ortho, { left: -half * aspect, right: half * aspect, top: half, bottom: -half, zoom: 1 });
    const [x, y] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2 - (half * legendHeight) / size.y];
    camera.position.set(x, y, 1);
    controls.target.set(x, y, 0);
    camera.updateProjectionMatrix();
    controls.update();
    this.isMoved = false;
    this.view.render();
  }

  zoom(factor: number): void {
    this.view.camera.zoom *= factor;
    this.view.camera.updateProjectionMatrix();
    this.isMoved = true;
    this.view.render();
  }

  pan(right: number, up: number): void {
    const { camera, controls } = this.view;
    const unit = this.view.unitsPerPixel();
    for (const place of [camera.position, controls.target]) {
      place.x += right * unit;
      place.y += up * unit;
    }
    this.isMoved = true;
    this.view.render();
  }

  hit(x: number, y: number): Place | null {
    const { origin } = this.view.rayAt(x, y);
    return triangleAt(this.mesh, origin[0], origin[1]);
  }

  private place(): void {
    for (const { element, at } of this.labels) {
      const { x, y } = this.view.pixelOf(at);
      element.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
    }
    const wanted = 100 * this.view.unitsPerPixel();
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = power * (wanted / power >= 5 ? 5 : wanted / power >= 2 ? 2 : 1);
    this.scale.style.width = `${length / this.view.unitsPerPixel()}px`;
    this.scale.textContent = this.mesh.points.length > 0 ? this.lengthWords(Number(length.toPrecision(3))) : "";
  }
}
