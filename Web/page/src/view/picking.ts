// SPDX-License-Identifier: BSD-3-Clause
// Places on meshes. All triangles are looked at: one pass over 100,000 takes about a millisecond, and no tree has to
// be built again after every edit.
import type { Mesh } from "../engine/messages";

export interface Place {
  triangle: number;
  /** Weights of the triangle's corners. */
  weights: [number, number, number];
}

/**
 * Where a ray first meets a mesh, if it meets it from outside: an inner wall seen through an opening is no target.
 * \param isInverted triangles turn clockwise, seen from outside
 */
export function firstHit(
  mesh: Mesh, origin: ArrayLike<number>, direction: ArrayLike<number>, isInverted: boolean,
): Place | null {
  const { points, corners } = mesh;
  const [ox, oy, oz] = [origin[0], origin[1], origin[2]];
  const [dx, dy, dz] = [direction[0], direction[1], direction[2]];
  let nearest = Infinity;
  let found: Place | null = null;
  for (let c = 0; c < corners.length; c += 3) {
    const a = 3 * corners[c];
    const b = 3 * corners[c + 1];
    const d = 3 * corners[c + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[d] - points[a], vy = points[d + 1] - points[a + 1], vz = points[d + 2] - points[a + 2];
    const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    const det = ux * px + uy * py + uz * pz;
    if (det === 0) {
      continue;
    }
    const tx = ox - points[a], ty = oy - points[a + 1], tz = oz - points[a + 2];
    const u = (tx * px + ty * py + tz * pz) / det;
    if (u < 0 || u > 1) {
      continue;
    }
    const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
    const v = (dx * qx + dy * qy + dz * qz) / det;
    const t = (vx * qx + vy * qy + vz * qz) / det;
    if (v < 0 || u + v > 1 || t <= 0 || t >= nearest) {
      continue;
    }
    nearest = t;
    found = det > 0 !== isInverted ? { triangle: c / 3, weights: [1 - u - v, u, v] } : null;
  }
  return found;
}

/** The triangle of a plane mesh in which a place lies. */
export function triangleAt(mesh: Mesh, x: number, y: number): Place | null {
  const { points, corners } = mesh;
  for (let c = 0; c < corners.length; c += 3) {
    const a = 3 * corners[c];
    const b = 3 * corners[c + 1];
    const d = 3 * corners[c + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1];
    const vx = points[d] - points[a], vy = points[d + 1] - points[a + 1];
    const det = ux * vy - uy * vx;
    const px = x - points[a], py = y - points[a + 1];
    const u = (px * vy - py * vx) / det;
    const v = (ux * py - uy * px) / det;
    if (u >= 0 && v >= 0 && u + v <= 1) {
      return { triangle: c / 3, weights: [1 - u - v, u, v] };
    }
  }
  return null;
}

export function positionOf(points: Float64Array, corners: Int32Array, { triangle, weights }: Place): [number, number, number] {
  const sum = (axis: number): number =>
    weights.reduce((total, weight, k) => total + weight * points[3 * corners[3 * triangle + k] + axis], 0);
  return [sum(0), sum(1), sum(2)];
}
