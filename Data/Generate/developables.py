"""Exactly developable triangulated surfaces with their exact unrolling.

Each is a strip of plane facets between consecutive rulings, so the angles at every interior vertex
sum to 2 pi however a facet is triangulated. `ExactUnrolling` places the facets one after another
in the plane z = 0. Distances along a ruling grow geometrically where rulings converge, which keeps
the triangles' shape.
"""
import numpy as np

from curves import ACCESSORY, KEY
from panel import Mesh, NamedCurve

# Cylinder: an arc of a circle, the upright rulings split in equal levels.
CYLINDER = dict(radius=10.0, arc=np.radians(200.0), height=30.0, columns=24, rows=20)
# Cone: a frustum of a right circular cone cut open, radii measured along the slant.
CONE = dict(half_angle=np.radians(25.0), arc=np.radians(260.0), inner=24.0, outer=50.0, columns=28, rows=12)
# Tangent developable: tangents of a helix x = (r cos w, r sin w, pitch w / 2 pi), on its positive
# side, between two distances from the edge of regression.
TANGENT = dict(radius=8.0, pitch=30.0, arc=np.radians(150.0), inner=12.0, outer=42.0, columns=30, rows=15)


def grid(columns, rows, flat):
    """Ids of a (columns + 1) x (rows + 1) grid, and its triangles by the shorter diagonals; equal
    ones alternate."""
    ids = np.arange((columns + 1) * (rows + 1)).reshape(columns + 1, rows + 1)
    triangles = []
    for i in range(columns):
        for j in range(rows):
            a, b, c, d = ids[i, j], ids[i + 1, j], ids[i + 1, j + 1], ids[i, j + 1]
            ac, bd = np.linalg.norm(flat[a] - flat[c]), np.linalg.norm(flat[b] - flat[d])
            equal = abs(ac - bd) < 1e-9 * ac
            if (i + j) % 2 if equal else ac < bd:
                triangles += [(a, b, c), (a, c, d)]
            else:
                triangles += [(a, b, d), (b, c, d)]
    return ids, np.array(triangles)


def gridCurves(ids, names):
    """The middle ruling as key curve and two accessory curves across all rulings."""
    columns, rows = ids.shape[0] - 1, ids.shape[1] - 1
    return [
        NamedCurve(names[0], KEY, list(ids[columns // 2, :])),
        NamedCurve(names[1], ACCESSORY, list(ids[:, rows // 3])),
        NamedCurve(names[2], ACCESSORY, list(ids[:, (2 * rows) // 3])),
    ]


def assemble(points, flat, columns, rows, names):
    ids, triangles = grid(columns, rows, flat)
    flat = np.column_stack([flat, np.zeros(len(flat))])
    return Mesh(points, triangles, gridCurves(ids, names), {"ExactUnrolling": flat})


def cylinder(radius, arc, height, columns, rows):
    chord = 2 * radius * np.sin(0.5 * arc / columns)
    points, flat = [], []
    for i in range(columns + 1):
        w = arc * (i / columns - 0.5)
        for j in range(rows + 1):
            y = height * j / rows
            points.append((radius * np.sin(w), y, radius * np.cos(w)))
            flat.append((chord * i, y))
    names = ("middle_ruling", "lower_girth", "upper_girth")
    return assemble(np.array(points), np.array(flat), columns, rows, names)


def cone(half_angle, arc, inner, outer, columns, rows):
    # The apex angle of a facet: its chord at unit slant is 2 sin(half_angle) sin(step / 2).
    facet = 2 * np.arcsin(np.sin(half_angle) * np.sin(0.5 * arc / columns))
    points, flat = [], []
    for i in range(columns + 1):
        w = arc * (i / columns - 0.5)
        ruling = np.array([np.sin(half_angle) * np.sin(w), -np.cos(half_angle), np.sin(half_angle) * np.cos(w)])
        v = facet * (i - 0.5 * columns)
        for j in range(rows + 1):
            r = outer * (inner / outer) ** (j / rows)
            points.append(r * ruling)
            flat.append((r * np.sin(v), -r * np.cos(v)))
    names = ("middle_ruling", "lower_girth", "upper_girth")
    return assemble(np.array(points), np.array(flat), columns, rows, names)


def tangentDevelopable(radius, pitch, arc, inner, outer, columns, rows):
    # Rulings lie along the edges of a polygon inscribed in the helix; two consecutive ones meet at
    # a vertex of the polygon, so the facet between them is plane.
    w = arc * np.arange(columns + 2) / columns
    edge = np.column_stack([radius * np.cos(w), radius * np.sin(w), pitch * w / (2 * np.pi)])
    step = np.diff(edge, axis=0)
    length = np.linalg.norm(step, axis=1)
    ruling = step / length[:, None]
    turn = np.arctan2(
        np.linalg.norm(np.cross(ruling[:-1], ruling[1:]), axis=1), (ruling[:-1] * ruling[1:]).sum(1)
    )
    heading = np.concatenate([[0.0], np.cumsum(turn)])
    direction = np.column_stack([np.cos(heading), np.sin(heading)])
    flatEdge = np.vstack([[0.0, 0.0], np.cumsum(length[:, None] * direction, axis=0)])
    points, flat = [], []
    for i in range(columns + 1):
        for j in range(rows + 1):
            r = inner * (outer / inner) ** (j / rows)
            points.append(edge[i] + r * ruling[i])
            flat.append(flatEdge[i] + r * direction[i])
    names = ("middle_ruling", "inner_curve", "outer_curve")
    mesh = assemble(np.array(points), np.array(flat), columns, rows, names)
    # Columns turn counter-clockwise in the plane while r grows outwards: orient as the unrolling.
    mesh.triangles = mesh.triangles[:, ::-1]
    return mesh


def make():
    return {
        "cylinder": cylinder(**CYLINDER),
        "cone": cone(**CONE),
        "tangent_developable": tangentDevelopable(**TANGENT),
    }
