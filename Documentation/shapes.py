# SPDX-License-Identifier: BSD-3-Clause
"""Ten closed shapes by formula, as OBJ files: what suggestions.md cuts."""

import math
import os

import numpy as np

OCTAHEDRON = ([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
              [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
BOX = ([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)],
       [(0, 3, 1), (0, 2, 3), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
        (2, 7, 3), (2, 6, 7), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)])


def halved(points, triangles, times):
    """The mesh with the edges of all triangles halved again and again."""
    points = [np.array(p, float) for p in points]
    for _ in range(times):
        middles, cells = {}, []
        for a, b, c in triangles:
            corners = []
            for edge in ((a, b), (b, c), (c, a)):
                key = tuple(sorted(edge))
                if key not in middles:
                    middles[key] = len(points)
                    points.append((points[key[0]] + points[key[1]]) / 2)
                corners.append(middles[key])
            ab, bc, ca = corners
            cells += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = cells
    return np.array(points), triangles


def round_about(profile, columns=48):
    """A surface of revolution: (radius, height) from pole to pole."""
    points, rows, triangles = [], [], []
    for radius, height in profile:
        count = columns if radius > 1e-9 else 1
        angles = 2 * math.pi * np.arange(count) / count
        rows.append(len(points) + np.resize(np.arange(count), columns))
        points += [(radius * math.cos(a), radius * math.sin(a), height) for a in angles]
    for low, high in zip(rows, rows[1:]):
        for k in range(columns):
            a, b, c, d = low[k - 1], low[k], high[k], high[k - 1]
            triangles += [t for t in ((a, b, c), (a, c, d)) if len(set(t)) == 3]
    return np.array(points), triangles


def on_sphere(radius):
    """A surface that is seen whole from its center; the radius depends on the direction."""
    points, triangles = halved(*OCTAHEDRON, 4)
    directions = points / np.linalg.norm(points, axis=1)[:, None]
    return directions * np.array([radius(d) for d in directions])[:, None], triangles


def bump(direction, x, y, z, width):
    place = np.array((x, y, z)) / math.sqrt(x * x + y * y + z * z)
    return math.exp(-(math.acos(max(-1.0, min(1.0, direction @ place))) / width)**2)


def head(d):
    """With a snout ahead and an ear on each side."""
    return 10 + 5 * bump(d, 1, 0, -0.2, 0.45) + 4 * (bump(d, 0, 1, 1, 0.3) + bump(d, 0, -1, 1, 0.3))


def shapes():
    """By name, points and triangles."""
    scale = lambda mesh, x, y, z: (mesh[0] * (x, y, z), mesh[1])
    ball = on_sphere(lambda d: 10.0)
    bottle = [(5 * (1 - s) + 2 * s + 0.5 * math.sin(6 * s) if 0 < s < 1 else 0.0, 24 * s) for s in np.linspace(0, 1, 60)]
    cushion = lambda d: 12 / (d[0]**6 + d[1]**6 + (3 * abs(d[2]))**3)**(1 / 5)
    ring_points, ring_triangles = [], []
    for i in range(48):
        for j in range(24):
            u, v = 2 * math.pi * i / 48, 2 * math.pi * j / 24
            ring_points.append(((12 + 4 * math.cos(v)) * math.cos(u), (12 + 4 * math.cos(v)) * math.sin(u), 4 * math.sin(v)))
            a, b = 24 * i + j, 24 * ((i + 1) % 48) + j
            c, d = 24 * ((i + 1) % 48) + (j + 1) % 24, 24 * i + (j + 1) % 24
            ring_triangles += [(a, b, c), (a, c, d)]
    return {
        "ball": ball,
        "pebble": scale(ball, 1.3, 0.8, 1.7),
        "bottle": round_about(bottle),
        "can": round_about([(6 * s / 8, 0) for s in range(9)] + [(6, 14 * s / 20) for s in range(1, 20)] +
                           [(6 * s / 8, 14) for s in range(8, -1, -1)]),
        "cone": round_about([(7 * s / 10, 0) for s in range(11)] + [(7 - 7 * s / 20, 16 * s / 20) for s in range(1, 21)]),
        "box": scale(halved(*BOX, 3), 12, 8, 5),
        "cushion": on_sphere(cushion),
        "bean": bent(scale(ball, 2.0, 0.9, 0.9)),
        "ring": (np.array(ring_points), ring_triangles),
        "head": on_sphere(head),
    }


def bent(mesh):
    """Round an axis beside it, as a bean is."""
    points, triangles = mesh
    turn = points[:, 0] / 18
    arm = 18 - points[:, 1]
    return np.stack((arm * np.sin(turn), 18 - arm * np.cos(turn), points[:, 2]), axis=1), triangles


def write(folder):
    for name, (points, triangles) in shapes().items():
        with open(os.path.join(folder, name + ".obj"), "w", encoding="ascii") as file:
            file.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in points)
            file.writelines("f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)
