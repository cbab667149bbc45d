"""A panel: a smooth surface over a plane chart, its outline and its curves, made into a mesh."""
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

from curves import DART, SEAM, arrange, insidePolygon
from triangulation import delaunay, relax


@dataclass
class Panel:
    """What is meshed.

    surface    parameters q (n x 2) -> points (n x 3)
    outline    curves that close a counter-clockwise loop; those of kind None are plain boundary,
               others are also feature curves (the centre line of a mirrored half)
    curves     feature curves inside; they may overshoot the outline
    triangles  how many triangles the panel gets, exactly; None to derive it from
    spacing    the edge length, where panels that are sewn together must share one
    chart      parameters -> plane, nearly isometric to the surface; the parameters by default
    """

    surface: Callable
    outline: list
    curves: list
    triangles: int = None
    spacing: float = None
    chart: Callable = field(default=lambda q: q)


@dataclass
class NamedCurve:
    name: str
    kind: int
    vertices: list


@dataclass
class Mesh:
    points: np.ndarray
    triangles: np.ndarray
    curves: list
    arrays: dict = field(default_factory=dict)  # further point arrays


def lowDiscrepancy(count, dimension):
    """Roberts' additive recurrence: evenly spread points in the unit cube."""
    g = 2.0
    for _ in range(60):
        g = (1 + g) ** (1 / (dimension + 1))
    alpha = (1 / g) ** np.arange(1, dimension + 1)
    return (0.5 + np.outer(np.arange(1, count + 1), alpha)) % 1.0


def areaElement(surface, q, step):
    du, dv = np.array([step[0], 0.0]), np.array([0.0, step[1]])
    a = (surface(q + du) - surface(q - du)) / (2 * step[0])
    b = (surface(q + dv) - surface(q - dv)) / (2 * step[1])
    return np.linalg.norm(np.cross(a, b), axis=1)


def candidates(panel, polygon, count):
    """Evenly spread parameters inside the outline (by area on the surface), and that area."""
    q = np.vstack([c.q for c in panel.outline])
    low, high = q.min(0), q.max(0)
    sample = lowDiscrepancy(count, 3)
    trial = low + (high - low) * sample[:, :2]
    keep = insidePolygon(polygon, panel.chart(trial))
    trial, level = trial[keep], sample[keep, 2]
    element = areaElement(panel.surface, trial, 1e-5 * (high - low))
    area = element.sum() * np.prod(high - low) / count
    return trial[level * element.max() < element], area


def sampleArc(q, surface, spacing, extra=0):
    """Points at equal distances along an arc on the surface, as parameters."""
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(surface(q), axis=0), axis=1))])
    count = max(1, int(round(length[-1] / spacing))) + extra
    target = np.linspace(0.0, length[-1], count + 1)
    out = np.column_stack([np.interp(target, length, q[:, k]) for k in range(2)])
    out[0], out[-1] = q[0], q[-1]
    return out, length[-1]


def nearestDistance(x, targets):
    out = np.empty(len(x))
    for k in range(0, len(x), 1000):
        chunk = x[k : k + 1000]
        square = (chunk**2).sum(1)[:, None] - 2 * chunk @ targets.T + (targets**2).sum(1)
        out[k : k + 1000] = np.sqrt(np.maximum(square.min(1), 0.0))
    return out


def eliminate(x, fixedCount, keepCount, radius):
    """Weighted sample elimination (Yuksel 2015): drop the most crowded samples.

    The first `fixedCount` rows stay. Returns the indices kept of the others.
    """
    reach = 2 * radius
    cell = np.floor(x / reach).astype(int)
    table = {}
    for i, c in enumerate(map(tuple, cell)):
        table.setdefault(c, []).append(i)
    offsets = [(a, b, c) for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)]
    neighbours = [None] * len(x)
    weight = np.zeros(len(x))
    for i in range(fixedCount, len(x)):
        c = cell[i]
        near = np.array([j for o in offsets for j in table.get((c[0] + o[0], c[1] + o[1], c[2] + o[2]), ())])
        d = np.linalg.norm(x[near] - x[i], axis=1)
        close = (d < reach) & (near != i)
        w = (1 - d[close] / reach) ** 8
        neighbours[i] = (near[close], w)
        weight[i] = w.sum()
    # A tiny bias decides ties, so that rounding cannot.
    weight += 1e-6 * lowDiscrepancy(len(x), 1)[:, 0]
    weight[:fixedCount] = -1.0
    for _ in range(len(x) - fixedCount - keepCount):
        i = int(np.argmax(weight))
        weight[i] = -1e9
        near, w = neighbours[i]
        weight[near] -= w
        weight[:fixedCount] = -1.0
    return np.nonzero(weight[fixedCount:] > -1e8)[0] + fixedCount


def parts(curve, arcs, stops):
    """Chain consecutive arcs of one curve; break at nodes on darts and seams and at gaps."""
    chains = []
    for arc, vertices in arcs:
        joined = chains and chains[-1][-1] == vertices[0]
        if joined and (curve.kind in (DART, SEAM) or arc.start not in stops):
            chains[-1] += vertices[1:]
        else:
            chains.append(list(vertices))
    if len(chains) == 1:
        return [NamedCurve(curve.name, curve.kind, chains[0])]
    return [NamedCurve(f"{curve.name}_{k + 1}", curve.kind, c) for k, c in enumerate(chains)]


def build(panel):
    """Mesh a panel. Returns (Mesh, parameters of its points)."""
    surface, chart = panel.surface, panel.chart
    rough = np.vstack([chart(c.q)[:-1] for c in panel.outline])
    _, area = candidates(panel, rough, 40000)
    # An equilateral triangle of edge h covers h^2 sqrt(3) / 4.
    wanted = panel.triangles or int(round(4 * area / (np.sqrt(3) * panel.spacing**2)))
    spacing = panel.spacing or np.sqrt(4 * area / (np.sqrt(3) * wanted))
    everything = panel.outline + panel.curves
    arrangement, polygon = arrange(everything, len(panel.outline), chart, spacing)

    arcs = arrangement.arcs
    sampled = [sampleArc(a.q, surface, spacing) for a in arcs]
    for arc, (_, length) in zip(arcs, sampled):
        if length < 0.45 * spacing:
            raise ValueError(f"arc of {everything[arc.curve].name} is shorter than half an edge")
    onBoundary = [i for i, a in enumerate(arcs) if a.curve < len(panel.outline)]
    boundaryCount = sum(len(sampled[i][0]) - 1 for i in onBoundary)
    # A disk has 2 interior + boundary - 2 triangles.
    odd = (wanted - boundaryCount) % 2
    if odd and panel.triangles is None:
        wanted += 1
    elif odd:
        longest = max(onBoundary, key=lambda i: round(sampled[i][1], 6))
        sampled[longest] = sampleArc(arcs[longest].q, surface, spacing, 1)
        boundaryCount += 1

    used = sorted({n for a in arcs for n in (a.start, a.end)})
    index = {n: k for k, n in enumerate(used)}
    q = [arrangement.nodes[n] for n in used]
    chains = []
    for arc, (points, _) in zip(arcs, sampled):
        first = len(q)
        q.extend(points[1:-1])
        chains.append([index[arc.start], *range(first, first + len(points) - 2), index[arc.end]])
    fixed = {(min(e), max(e)) for c in chains for e in zip(c, c[1:])}
    fixedCount = len(q)
    interior = (wanted + 2 - boundaryCount) // 2 - (fixedCount - boundaryCount)
    if interior < 0:
        raise ValueError("more curve points than the triangles allow")

    trial, _ = candidates(panel, polygon, 16 * wanted)
    wires = np.vstack([surface(sampleArc(a.q, surface, spacing / 4)[0]) for a in arcs])
    clear = nearestDistance(surface(trial), wires) > 0.6 * spacing
    q = np.vstack([np.array(q), trial[clear]])
    kept = eliminate(surface(q), fixedCount, interior, 0.62 * spacing)
    q = np.vstack([q[:fixedCount], q[kept]])

    p = chart(q)
    t = delaunay(p)
    # Thin triangles between a curved outline and its chords lie outside.
    loop = boundaryLoop([chains[i] for i in onBoundary])
    t = t[insidePolygon(p[loop], p[t].mean(1))]
    present = {(min(e), max(e)) for f in t for e in zip(f, np.roll(f, -1))}
    missing = fixed - present
    if missing:
        raise ValueError(f"{len(missing)} curve edges missing from the triangulation")
    q, t = relax(q, np.arange(fixedCount, len(q)), t, fixed, surface, chart)

    stops = {n for a in arcs if everything[a.curve].kind in (DART, SEAM) for n in (a.start, a.end)}
    named = []
    for i, curve in enumerate(everything):
        mine = [(a, c) for a, c in zip(arcs, chains) if a.curve == i]
        if mine and curve.kind is not None:
            named += parts(curve, mine, stops)
    if len(t) != wanted:
        raise ValueError(f"{len(t)} triangles in place of {wanted}")
    return Mesh(surface(q), t, named), q


def boundaryLoop(chains):
    loop = []
    for chain in chains:
        if loop and loop[-1] != chain[0]:
            raise ValueError("the outline is not closed")
        loop += chain if not loop else chain[1:]
    if loop[0] != loop[-1]:
        raise ValueError("the outline is not closed")
    return loop[:-1]


def upward(curve, points):
    """The curve from its lower end to its upper end: a key curve that runs so stands so in the plane."""
    vertices = list(curve.vertices)
    falls = points[vertices[-1], 1] < points[vertices[0], 1]
    return NamedCurve(curve.name, curve.kind, vertices[::-1] if falls else vertices)


def mirrored(mesh, centre):
    """Add the mirror image in x; `centre` lists the vertices on the plane x = 0.

    Curves that meet the inside of the centre line run through it; the others come as _left (x > 0)
    and _right.
    """
    points = mesh.points.copy()
    points[centre, 0] = 0.0
    onPlane = np.zeros(len(points), bool)
    onPlane[centre] = True
    image = np.arange(len(points))
    image[~onPlane] = len(points) + np.arange((~onPlane).sum())
    other = points[~onPlane] * [-1.0, 1.0, 1.0]
    onBorder = np.zeros(len(points), bool)
    onBorder[[centre[0], centre[-1]]] = True
    through = onPlane & ~onBorder
    curves = []
    for c in mesh.curves:
        reflected = [int(image[v]) for v in c.vertices]
        if all(onPlane[c.vertices]):
            curves.append(upward(c, points))
        elif through[c.vertices[0]]:
            curves.append(NamedCurve(c.name, c.kind, reflected[:0:-1] + list(c.vertices)))
        elif through[c.vertices[-1]]:
            curves.append(NamedCurve(c.name, c.kind, list(c.vertices) + reflected[-2::-1]))
        else:
            curves.append(NamedCurve(c.name + "_left", c.kind, c.vertices))
            curves.append(NamedCurve(c.name + "_right", c.kind, reflected))
    triangles = np.vstack([mesh.triangles, image[mesh.triangles][:, ::-1]])
    return Mesh(np.vstack([points, other]), triangles, curves)


def sewn(meshes, tolerance):
    """Join meshes at boundary points closer than the tolerance; the first mesh's points win."""
    points, index = [], []
    curves, triangles = [], []
    for mesh in meshes:
        border = boundaryVertices(mesh.triangles)
        known = np.array(points).reshape(-1, 3)
        ids = np.arange(len(points), len(points) + len(mesh.points))
        fresh = np.ones(len(mesh.points), bool)
        for v in border if len(known) else ():
            distance = np.linalg.norm(known - mesh.points[v], axis=1)
            nearest = int(np.argmin(distance))
            if distance[nearest] < tolerance:
                ids[v], fresh[v] = nearest, False
        # Two edges of the same mesh may be sewn to each other (a sleeve).
        for k, v in enumerate(border):
            for u in border[:k]:
                if fresh[u] and fresh[v] and np.linalg.norm(mesh.points[u] - mesh.points[v]) < tolerance:
                    ids[v], fresh[v] = ids[u], False
        renumber = {int(i): len(points) + k for k, i in enumerate(ids[fresh])}
        ids = np.array([renumber.get(int(i), int(i)) if i >= len(known) else int(i) for i in ids])
        points += list(mesh.points[fresh])
        triangles.append(ids[mesh.triangles])
        for c in mesh.curves:
            vertices = [int(ids[v]) for v in c.vertices]
            if not any(set(vertices) == set(other.vertices) for other in curves):
                curves.append(NamedCurve(c.name, c.kind, vertices))
    return Mesh(np.array(points), np.vstack(triangles), curves)


def boundaryVertices(t):
    edges = {(int(f[k]), int(f[(k + 1) % 3])) for f in t for k in range(3)}
    return sorted({v for e in edges if e[::-1] not in edges for v in e})
