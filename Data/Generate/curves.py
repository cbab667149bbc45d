"""Feature curves on a panel: types, and the arrangement of boundary and curves into arcs.

Everything here happens in the panel's chart, a plane that is nearly isometric to the surface.
Curves may overshoot the boundary; what lies outside is dropped. A curve that crosses a dart or a
seam is listed in parts that end on it.
"""
from dataclasses import dataclass, field

import numpy as np

ACCESSORY, KEY, DART, SEAM = 0, 1, 2, 3


@dataclass
class Curve:
    """A polyline in parameters q, dense enough to stand for the smooth curve."""

    name: str
    kind: int
    q: np.ndarray


@dataclass
class Arc:
    """Part of a curve between two consecutive nodes of the arrangement."""

    curve: int
    start: int
    end: int
    q: np.ndarray


@dataclass
class Arrangement:
    nodes: list = field(default_factory=list)  # parameters q of each node
    arcs: list = field(default_factory=list)


def line(start, end, count=200):
    w = np.linspace(0.0, 1.0, count)[:, None]
    return (1 - w) * np.asarray(start, float) + w * np.asarray(end, float)


def bezier(p0, p1, p2, p3, count=200):
    w = np.linspace(0.0, 1.0, count)[:, None]
    p0, p1, p2, p3 = (np.asarray(p, float) for p in (p0, p1, p2, p3))
    return (1 - w) ** 3 * p0 + 3 * w * (1 - w) ** 2 * p1 + 3 * w**2 * (1 - w) * p2 + w**3 * p3


def naturalSpline(x, y):
    """Natural cubic spline through (x, y) as a function; straight beyond the ends."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    n = len(x)
    h = np.diff(x)
    a = np.zeros((n, n))
    b = np.zeros(n)
    a[0, 0] = a[-1, -1] = 1.0
    for i in range(1, n - 1):
        a[i, i - 1 : i + 2] = h[i - 1], 2 * (h[i - 1] + h[i]), h[i]
        b[i] = 6 * ((y[i + 1] - y[i]) / h[i] - (y[i] - y[i - 1]) / h[i - 1])
    m = np.linalg.solve(a, b)
    slope0 = (y[1] - y[0]) / h[0] - h[0] * m[1] / 6
    slope1 = (y[-1] - y[-2]) / h[-1] + h[-1] * m[-2] / 6

    def evaluate(t):
        t = np.asarray(t, float)
        i = np.clip(np.searchsorted(x, t) - 1, 0, n - 2)
        u, v = x[i + 1] - t, t - x[i]
        inside = (m[i] * u**3 + m[i + 1] * v**3) / (6 * h[i])
        inside += (y[i] / h[i] - m[i] * h[i] / 6) * u + (y[i + 1] / h[i] - m[i + 1] * h[i] / 6) * v
        return np.where(
            t < x[0], y[0] + slope0 * (t - x[0]), np.where(t > x[-1], y[-1] + slope1 * (t - x[-1]), inside)
        )

    return evaluate


def crossings(p, r):
    """Positions (index + fraction) on polylines p and r where their segments cross."""
    d, e = np.diff(p, axis=0), np.diff(r, axis=0)
    w = r[None, :-1] - p[:-1, None]
    cross = lambda a, b: a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    den = cross(d[:, None], e[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        u = cross(w, e[None]) / den
        v = cross(w, d[:, None]) / den
    i, j = np.nonzero((np.abs(den) > 1e-30) & (u >= 0) & (u <= 1) & (v >= 0) & (v <= 1))
    return list(zip(i + u[i, j], j + v[i, j]))


def touches(p, r, tolerance):
    """Ends of p that lie on r within the tolerance, as crossings() gives them."""
    found = []
    e = np.diff(r, axis=0)
    length2 = np.maximum((e**2).sum(1), 1e-300)
    for position, x in ((0.0, p[0]), (len(p) - 1.0, p[-1])):
        u = np.clip(((x - r[:-1]) * e).sum(1) / length2, 0, 1)
        distance = np.linalg.norm(r[:-1] + u[:, None] * e - x, axis=1)
        j = int(np.argmin(distance))
        if distance[j] < tolerance:
            found.append((position, j + u[j]))
    return found


def at(polyline, position):
    i = min(int(position), len(polyline) - 2)
    w = position - i
    return (1 - w) * polyline[i] + w * polyline[i + 1]


def between(polyline, a, b):
    """The part of a polyline between two positions."""
    inner = polyline[int(np.floor(a)) + 1 : int(np.ceil(b))]
    return np.vstack([at(polyline, a), inner, at(polyline, b)])


def insidePolygon(polygon, p):
    """Even-odd test of many points."""
    inside = np.zeros(len(p), bool)
    a, b = polygon, np.roll(polygon, -1, axis=0)
    for (x0, y0), (x1, y1) in zip(a, b):
        if y0 == y1:
            continue
        hit = (y0 > p[:, 1]) != (y1 > p[:, 1])
        inside ^= hit & (p[:, 0] < x0 + (p[:, 1] - y0) * (x1 - x0) / (y1 - y0))
    return inside


def arrange(curves, boundaryCount, chart, spacing):
    """Split the curves (the first `boundaryCount` are the boundary loop) at their crossings."""
    charted = [chart(c.q) for c in curves]
    polygon = np.vstack([c[:-1] for c in charted[:boundaryCount]])
    result = Arrangement()
    charted_nodes = []

    def nodeAt(curve, position):
        p = at(charted[curve], position)
        for k, other in enumerate(charted_nodes):
            if np.hypot(*(other - p)) < 0.1 * spacing:
                return k
        charted_nodes.append(p)
        result.nodes.append(at(curves[curve].q, position))
        return len(charted_nodes) - 1

    events = [[] for _ in curves]
    for i in range(len(curves)):
        for position in (0.0, len(curves[i].q) - 1.0):
            events[i].append((position, nodeAt(i, position)))
    for i in range(len(curves)):
        for j in range(i):
            hits = crossings(charted[j], charted[i])
            hits += touches(charted[j], charted[i], 0.05 * spacing)
            hits += [(v, u) for u, v in touches(charted[i], charted[j], 0.05 * spacing)]
            for u, v in hits:
                node = nodeAt(j, u)
                events[j].append((u, node))
                events[i].append((v, node))
    for i, curve in enumerate(curves):
        ordered = sorted(events[i])
        for (u0, n0), (u1, n1) in zip(ordered, ordered[1:]):
            if n0 == n1:
                continue
            middle = at(charted[i], 0.5 * (u0 + u1))[None]
            if i >= boundaryCount and not insidePolygon(polygon, middle)[0]:
                continue
            q = between(curve.q, u0, u1)
            q[0], q[-1] = result.nodes[n0], result.nodes[n1]
            result.arcs.append(Arc(i, n0, n1, q))
    return result, polygon
