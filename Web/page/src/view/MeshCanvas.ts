// SPDX-License-Identifier: BSD-3-Clause
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, Mesh as ThreeMesh,
  MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, PerspectiveCamera, Points, PointsMaterial, Scene, Vector2, Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Mesh } from "../engine/messages";

export interface Line {
  points: ArrayLike<number>;
  color: string;
  /** Pixels. */
  width: number;
  dashed?: boolean;
}

export interface Dot {
  place: ArrayLike<number>;
  color: string;
  size: number;
}

/** A canvas with a mesh, lines and dots, which follows its element's size and is drawn only after changes. */
export class MeshCanvas {
  private readonly scene = new Scene();
  /** What is shown; the world around it has y up. */
  readonly content = new Group();
  readonly controls: OrbitControls;
  private readonly renderer: WebGLRenderer;
  private readonly surface = new ThreeMesh(new BufferGeometry());
  private lines: LineSegments2[] = [];
  private dots: Points[] = [];
  private requested = false;
  readonly size = new Vector2(1, 1);

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly camera: PerspectiveCamera | OrthographicCamera,
    private readonly onDrawn: () => void = () => {},
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    const options = { vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    this.surface.material = camera instanceof PerspectiveCamera ? new MeshLambertMaterial(options) : new MeshBasicMaterial(options);
    const lamp = new DirectionalLight(0xffffff, 2.2);
    lamp.position.set(0.4, 0.7, 1);
    camera.add(lamp);
    this.content.add(this.surface);
    this.scene.add(camera, new AmbientLight(0xffffff, 1.2), this.content);
    this.controls = new OrbitControls(camera, canvas);
    this.controls.addEventListener("change", () => this.render());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement as HTMLElement);
    this.resize();
  }

  setMesh({ points, corners }: Mesh, colors: Float32Array): void {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(corners), 1));
    geometry.computeVertexNormals();
    this.surface.geometry.dispose();
    this.surface.geometry = geometry;
    this.render();
  }

  setLines(lines: Line[]): void {
    for (const line of this.lines) {
      line.geometry.dispose();
      line.material.dispose();
    }
    this.content.remove(...this.lines);
    this.lines = lines.filter(({ points }) => points.length >= 6).map(({ points, color, width, dashed }) => {
      const segments: number[] = [];
      for (let k = 3; k < points.length; k += 3) {
        for (let axis = -3; axis < 3; ++axis) {
          segments.push(points[k + axis]);
        }
      }
      const material = new LineMaterial({ color: new Color(color).getHex(), linewidth: width, dashed: Boolean(dashed) });
      material.resolution.copy(this.size);
      const line = new LineSegments2(new LineSegmentsGeometry().setPositions(segments), material);
      if (dashed) {
        line.computeLineDistances();
        const unit = this.unitsPerPixel();
        material.dashSize = 6 * unit;
        material.gapSize = 4 * unit;
      }
      return line;
    });
    if (this.lines.length > 0) {
      this.content.add(...this.lines);
    }
    this.render();
  }

  setDots(dots: Dot[]): void {
    for (const dot of this.dots) {
      dot.geometry.dispose();
      (dot.material as PointsMaterial).dispose();
    }
    this.content.remove(...this.dots);
    this.dots = dots.map(({ place, color, size }) => {
      const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(place), 3));
      const material = new PointsMaterial({ color, size: size * this.renderer.getPixelRatio(), sizeAttenuation: false, depthTest: false });
      return new Points(geometry, material);
    });
    if (this.dots.length > 0) {
      this.content.add(...this.dots);
    }
    this.render();
  }

  /** Size of a pixel at what the view turns round. */
  unitsPerPixel(): number {
    const { camera } = this;
    if (camera instanceof OrthographicCamera) {
      return (camera.top - camera.bottom) / camera.zoom / this.size.y;
    }
    const distance = camera.position.distanceTo(this.controls.target);
    return (2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / this.size.y;
  }

  /** The pixel of a place, from the canvas's upper left. */
  pixelOf(place: ArrayLike<number>): { x: number; y: number } {
    this.camera.updateMatrixWorld();
    const seen = this.content.localToWorld(new Vector3(place[0], place[1], place[2] ?? 0)).project(this.camera);
    return { x: ((seen.x + 1) / 2) * this.size.x, y: ((1 - seen.y) / 2) * this.size.y };
  }

  /** A ray of sight through a pixel, in the mesh's own coordinates. */
  rayAt(x: number, y: number): { origin: number[]; direction: number[] } {
    this.camera.updateMatrixWorld();
    const at = (depth: number): Vector3 =>
      this.content.worldToLocal(new Vector3((2 * x) / this.size.x - 1, 1 - (2 * y) / this.size.y, depth).unproject(this.camera));
    const near = at(-1);
    return { origin: near.toArray(), direction: at(0.9).sub(near).normalize().toArray() };
  }

  render(): void {
    if (!this.requested) {
      this.requested = true;
      requestAnimationFrame(() => {
        this.requested = false;
        this.renderer.render(this.scene, this.camera);
        this.onDrawn();
      });
    }
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement as HTMLElement;
    this.size.set(Math.max(1, clientWidth), Math.max(1, clientHeight));
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(this.size.x, this.size.y, false);
    const aspect = this.size.x / this.size.y;
    if (this.camera instanceof PerspectiveCamera) {
      this.camera.aspect = aspect;
    } else {
      const half = (this.camera.top - this.camera.bottom) / 2;
      this.camera.left = -half * aspect;
      this.camera.right = half * aspect;
    }
    this.camera.updateProjectionMatrix();
    this.lines.forEach(({ material }) => material.resolution.copy(this.size));
    this.render();
  }
}
