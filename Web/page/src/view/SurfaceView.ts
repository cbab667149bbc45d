// SPDX-License-Identifier: BSD-3-Clause
import { Box3, PerspectiveCamera, Vector3 } from "three";
import type { Mesh } from "../engine/messages";
import { MeshCanvas, type Dot, type Line } from "./MeshCanvas";
import { firstHit, positionOf, type Place } from "./picking";

export type Side = "front" | "back" | "left" | "right" | "top";

const sides: Record<Side, [number, number, number]> = {
  front: [0, 0, 1], back: [0, 0, -1], left: [1, 0, 0], right: [-1, 0, 0], top: [0, 1, 0.001],
};

/** The surface in space, turned like on a turntable. */
export class SurfaceView {
  readonly view: MeshCanvas;
  private mesh: Mesh = { points: new Float64Array(), corners: new Int32Array() };
  private readonly box = new Box3();
  /** Triangles turn the other way round. */
  private isInverted = false;

  constructor(canvas: HTMLCanvasElement, onDrawn: () => void) {
    this.view = new MeshCanvas(canvas, new PerspectiveCamera(30), onDrawn);
  }

  /** \param isNew another surface, at which the camera looks from the side to which most of it turns */
  setMesh(mesh: Mesh, colors: Float32Array, isNew: boolean): void {
    this.mesh = mesh;
    this.view.setMesh(mesh, colors);
    if (isNew) {
      this.box.makeEmpty();
      for (let k = 0; k < mesh.points.length; k += 3) {
        this.box.expandByPoint(new Vector3(mesh.points[k], mesh.points[k + 1], mesh.points[k + 2]));
      }
      this.isInverted = isTurnedInward(mesh, this.box.getCenter(new Vector3()));
      const facing = meanNormal(mesh);
      // A surface that would face upward stands upright with z up; a tube faces nowhere.
      this.setUp(Math.abs(facing.y) > Math.max(0.4, Math.abs(facing.x), Math.abs(facing.z)) ? "z" : "y");
      const turned = facing.applyEuler(this.view.content.rotation);
      this.lookFrom(turned.z < -0.5 ? "back" : "front");
    }
  }

  setUp(axis: "y" | "z"): void {
    this.view.content.rotation.x = axis === "z" ? -Math.PI / 2 : 0;
    this.view.content.updateMatrixWorld();
    this.lookFrom("front");
  }

  up(): "y" | "z" {
    return this.view.content.rotation.x === 0 ? "y" : "z";
  }

  setMarks(lines: Line[], dots: Dot[]): void {
    this.view.setLines(lines);
    this.view.setDots(dots);
  }

  lookFrom(side: Side): void {
    const { camera, controls, size } = this.view;
    const box = this.box.clone().applyMatrix4(this.view.content.matrixWorld);
    const center = box.getCenter(new Vector3());
    const extent = box.getSize(new Vector3());
    const flat = new Vector3(...sides[side]);
    const wide = side === "left" || side === "right" ? extent.z : extent.x;
    const high = side === "top" ? extent.z : extent.y;
    const half = 0.55 * Math.max(high, wide * (size.y / size.x), 1e-9);
    const depth = extent.dot(new Vector3(Math.abs(flat.x), Math.abs(flat.y), Math.abs(flat.z))) / 2;
    const distance = half / Math.tan((15 * Math.PI) / 180) + depth;
    camera.position.copy(center).addScaledVector(flat, distance);
    (camera as PerspectiveCamera).near = distance / 100;
    (camera as PerspectiveCamera).far = distance * 10 + extent.length();
    camera.updateProjectionMatrix();
    controls.target.copy(center);
    controls.update();
    this.view.render();
  }

  /** Turns by angles, in radians. */
  turn(around: number, up: number): void {
    const { camera, controls } = this.view;
    const arm = camera.position.clone().sub(controls.target);
    const radius = arm.length();
    const polar = Math.min(Math.PI - 0.01, Math.max(0.01, Math.acos(arm.y / radius) - up));
    const azimuth = Math.atan2(arm.x, arm.z) - around;
    camera.position.setFromSphericalCoords(radius, polar, azimuth).add(controls.target);
    controls.update();
    this.view.render();
  }

  zoom(factor: number): void {
    const { camera, controls } = this.view;
    camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
    controls.update();
    this.view.render();
  }

  /** What a pixel shows of the surface. */
  hit(x: number, y: number): (Place & { position: [number, number, number] }) | null {
    const { origin, direction } = this.view.rayAt(x, y);
    const place = firstHit(this.mesh, origin, direction, this.isInverted);
    return place && { ...place, position: positionOf(this.mesh.points, this.mesh.corners, place) };
  }
}

/** Whether most of the surface turns its front to a point in its middle. */
function isTurnedInward({ points, corners }: Mesh, middle: Vector3): boolean {
  let volume = 0;
  for (let c = 0; c < corners.length; c += 3) {
    const [a, b, d] = [0, 1, 2].map((k) => new Vector3().fromArray(points, 3 * corners[c + k]).sub(middle));
    volume += a.dot(b.cross(d));
  }
  return volume < 0;
}

/** Of all triangles, weighted by their areas; as long as the surface is plane. */
function meanNormal({ points, corners }: Mesh): Vector3 {
  const sum = new Vector3();
  let areas = 0;
  for (let c = 0; c < corners.length; c += 3) {
    const [a, b, d] = [0, 1, 2].map((k) => new Vector3().fromArray(points, 3 * corners[c + k]));
    const normal = b.sub(a).cross(d.sub(a));
    areas += normal.length();
    sum.add(normal);
  }
  return sum.divideScalar(areas || 1);
}
