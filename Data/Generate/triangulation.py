"""Triangulation of given points: Delaunay in the plane, then flips and smoothing on the surface."""
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def delaunay(p):
    """Delaunay triangles of plane points, counter-clockwise, with the convex hull complete."""
    low, high = p.min(0), p.max(0)
    centre, radius = 0.5 * (low + high), np.hypot(*(high - low))
    angle = 2 * np.pi * (np.arange(11) + 0.3) / 11
    frame = centre + 2 * radius * np.column_stack([np.cos(angle), np.sin(angle)])
    xyz = np.zeros((len(p) + len(frame), 3))
    xyz[:, :2] = np.vstack([p, frame])
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(xyz, deep=True))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    mesher = vtk.vtkDelaunay2D()
    mesher.SetInputData(data)
    mesher.SetTolerance(1e-9)
    mesher.Update()
    t = vtk_to_numpy(mesher.GetOutput().GetPolys().GetData()).reshape(-1, 4)[:, 1:].copy()
    t = t[(t < len(p)).all(1)]
    flip = signedAreas(p, t) < 0
    t[flip] = t[flip][:, ::-1]
    return t


def signedAreas(p, t):
    a, b = p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]]
    return 0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def areas(x, t):
    return 0.5 * np.linalg.norm(np.cross(x[t[:, 1]] - x[t[:, 0]], x[t[:, 2]] - x[t[:, 0]]), axis=1)


def cornerAngles(x, t):
    """Angles of each triangle at its three corners, by the stable arctangent form."""
    out = np.empty(t.shape)
    for k in range(3):
        a = x[t[:, (k + 1) % 3]] - x[t[:, k]]
        b = x[t[:, (k + 2) % 3]] - x[t[:, k]]
        out[:, k] = np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1))
    return out


def edgeTable(t):
    """Rows (u, v, triangle, opposite vertex) for each half-edge u -> v."""
    parts = [
        np.column_stack([t[:, k], t[:, (k + 1) % 3], np.arange(len(t)), t[:, (k + 2) % 3]]) for k in range(3)
    ]
    return np.vstack(parts)


def flipToDelaunay(p, x, t, fixed, rounds=20):
    """Flip edges whose opposite angles on the surface sum to more than pi; `fixed` edges stay.

    A flip must keep the triangles positive in the chart p. The margin makes ties deterministic.
    """
    margin = 1e-6
    for _ in range(rounds):
        table = {(int(u), int(v)): (int(f), int(w)) for u, v, f, w in edgeTable(t)}
        angle = cornerAngles(x, t)
        opposite = {}
        for f in range(len(t)):
            for k in range(3):
                opposite[(int(t[f, k]), int(t[f, (k + 1) % 3]))] = angle[f, (k + 2) % 3]
        candidates = []
        for (u, v), (f, w) in table.items():
            if u < v and (v, u) in table and (u, v) not in fixed:
                excess = opposite[(u, v)] + opposite[(v, u)] - np.pi
                if excess > margin:
                    candidates.append((-round(excess, 9), u, v))
        touched = set()
        count = 0
        for _, u, v in sorted(candidates):
            (f, w), (g, z) = table[(u, v)], table[(v, u)]
            if f in touched or g in touched or (w, z) in table or (z, w) in table:
                continue
            pair = np.array([[w, z, v], [z, w, u]])
            if signedAreas(p, pair).min() <= 0:
                continue
            t[f], t[g] = pair
            touched.update((f, g))
            count += 1
        if not count:
            break
    return t


def relax(q, movable, t, fixed, surface, chart, rounds=40):
    """Move free points towards the area-weighted centre of their triangles on the surface."""
    step = 1e-5 * (q.max(0) - q.min(0))
    for _ in range(rounds):
        x, p = surface(q), chart(q)
        t = flipToDelaunay(p, x, t, fixed, rounds=3)
        area = areas(x, t)
        centre = x[t].mean(1)
        total, weight = np.zeros_like(x), np.zeros(len(x))
        for k in range(3):
            np.add.at(total, t[:, k], area[:, None] * centre)
            np.add.at(weight, t[:, k], area)
        pull = (total / weight[:, None] - x)[movable]
        free = q[movable]
        columns = []
        for k in range(2):
            d = np.zeros(2)
            d[k] = step[k]
            columns.append((surface(free + d) - surface(free - d)) / (2 * step[k]))
        a, b = columns
        aa, ab, bb = (a * a).sum(1), (a * b).sum(1), (b * b).sum(1)
        ap, bp = (a * pull).sum(1), (b * pull).sum(1)
        det = aa * bb - ab * ab
        move = np.column_stack([bb * ap - ab * bp, aa * bp - ab * ap]) / det[:, None]
        trial = q.copy()
        trial[movable] = free + move
        for _ in range(8):
            bad = np.unique(t[signedAreas(chart(trial), t) < 0.05 * np.abs(signedAreas(p, t))])
            if not len(bad):
                break
            trial[bad] = 0.5 * (trial[bad] + q[bad])
        else:
            trial[bad] = q[bad]
        if signedAreas(chart(trial), t).min() <= 0:
            break
        q = trial
    return q, flipToDelaunay(chart(q), surface(q), t, fixed)
