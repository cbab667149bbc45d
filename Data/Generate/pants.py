"""Left leg panels of a pair of pants. Unit cm; y up from the ankle, z to the front, x to the left.

A horizontal section of a panel is a half ellipse round the leg below the crotch and a quarter of
the hip's ellipse above; in between the one turns into the other, fastest at the inner edge, which
gives the crotch curve and its extension. Parameters: u from the inner edge (0) to the side seam
(1), and the height y.
"""
from dataclasses import dataclass

import numpy as np

from curves import ACCESSORY, DART, KEY, Curve, line, naturalSpline
from panel import NamedCurve, Panel, build

WAIST, HIP, CROTCH, MIDTHIGH, KNEE, MIDCALF, HEM = 98.0, 82.0, 73.0, 58.0, 44.0, 24.0, 0.0


@dataclass(frozen=True)
class Leg:
    """Sections by height. leg: y, centre z, half width, half depth; gap: y, inner edge's x;
    hip: y, centre z, half width, half depth."""

    leg: tuple
    gap: tuple
    hip: tuple
    bulge: tuple  # u, y, height, width in u, width in y
    fork: float  # height over the crotch in which the section turns into the hip's
    side: float = 1.0  # +1 front, -1 back


BODY_LEG = (
    # y, centre z, half width, half depth
    (0.0, -3.0, 7.6, 8.2),
    (24.0, -2.6, 8.6, 9.0),
    (44.0, -0.6, 9.6, 9.6),
    (58.0, 0.2, 11.2, 11.4),
    (73.0, -0.5, 12.6, 13.2),
    (98.0, -0.5, 12.8, 13.4),
)
GAP = ((0.0, 3.2), (24.0, 2.2), (44.0, 1.3), (58.0, 0.6), (73.0, 0.0), (98.0, 0.0))
HIP_SECTIONS = (
    (66.0, -0.8, 23.5, 13.0),
    (74.0, -0.8, 23.4, 13.0),
    (82.0, -0.8, 22.2, 12.8),
    (90.0, -0.4, 19.8, 11.8),
    (98.0, 0.0, 17.6, 10.6),
    (104.0, 0.0, 16.8, 10.2),
)
FRONT = Leg(BODY_LEG, GAP, HIP_SECTIONS, (0.30, 91.0, 1.0, 0.30, 6.0), fork=11.0)
BACK = Leg(BODY_LEG, GAP, HIP_SECTIONS, (0.42, 82.0, 3.4, 0.26, 6.5), fork=13.0, side=-1.0)


def smoothRamp(x, width):
    """0 for x << 0, x for x >> 0, with a round corner."""
    return 0.5 * (x + np.sqrt(x * x + width * width))


class LegSurface:
    def __init__(self, leg):
        self.leg = leg
        columns = lambda rows: np.array(rows).T
        y, z, a, b = columns(leg.leg)
        self.legZ, self.legA, self.legB = (naturalSpline(y, v) for v in (z, a, b))
        y, x = columns(leg.gap)
        self.gap = naturalSpline(y, x)
        y, z, a, b = columns(leg.hip)
        self.hipZ, self.hipA, self.hipB = (naturalSpline(y, v) for v in (z, a, b))

    def weight(self, u, y):
        """How much of the hip's section: 0 on the leg, 1 on the hip; the change starts abruptly
        at the inner edge (the crotch) and softly at the side seam."""
        softness = 2.0 + 9.0 * u
        t = smoothRamp(y - CROTCH, softness) / self.leg.fork
        return 1 - np.exp(-1.9 * t)

    def __call__(self, q):
        u, y = q[:, 0], q[:, 1]
        psi = np.pi * (u - 0.5)
        a = self.legA(y)
        legX = self.gap(y) + a + a * np.sin(psi)
        legZ = self.legZ(y) + self.leg.side * self.legB(y) * np.cos(psi)
        # The quarter ellipse runs faster at its flat end: ease the angle to even the speed.
        ratio = self.hipB(y) / self.hipA(y)
        chi = 0.5 * np.pi * u
        chi = chi + 0.25 * (ratio - 1) * np.sin(2 * chi)
        hipX = self.hipA(y) * np.sin(chi)
        hipZ = self.hipZ(y) + self.leg.side * self.hipB(y) * np.cos(chi)
        w = self.weight(u, y)
        x = (1 - w) * legX + w * hipX
        z = (1 - w) * legZ + w * hipZ
        u0, y0, height, su, sy = self.leg.bulge
        swell = height * np.exp(-0.5 * (((u - u0) / su) ** 2 + ((y - y0) / sy) ** 2))
        return np.column_stack([x, y, z + self.leg.side * swell])

    def width(self, y):
        """Length of the section, by chords."""
        u = np.linspace(0, 1, 41)
        out = np.empty_like(y)
        for k, height in enumerate(y):
            x = self(np.column_stack([u, np.full_like(u, height)]))
            out[k] = np.linalg.norm(np.diff(x, axis=0), axis=1).sum()
        return out


def panel(leg, triangles, darts):
    """darts: (name, u at the waist, length)."""
    surface = LegSurface(leg)
    heights = np.linspace(HEM - 5, WAIST + 5, 60)
    width = naturalSpline(heights, surface.width(heights))
    mirror = leg.side  # keeps the chart counter-clockwise seen from outside

    def chart(q):
        return np.column_stack([mirror * (q[:, 0] - 0.5) * width(q[:, 1]), q[:, 1]])

    corners = [(0, HEM), (1, HEM), (1, WAIST), (0, WAIST), (0, CROTCH)]
    if leg.side < 0:
        corners = corners[::-1]
    outline = [Curve("outline", None, line(a, b)) for a, b in zip(corners, corners[1:] + corners[:1])]
    girths = [("hip", HIP), ("crotch", CROTCH), ("midthigh", MIDTHIGH), ("knee", KNEE), ("midcalf", MIDCALF)]
    curves = [Curve("grainline", KEY, line((0.5, HEM), (0.5, WAIST)))]
    curves += [Curve(name, ACCESSORY, line((0, y), (1, y))) for name, y in girths]
    curves += [Curve(name, DART, line((u, WAIST), (u, WAIST - depth))) for name, u, depth in darts]
    return Panel(surface, outline, curves, triangles, chart)


def curveSets(mesh, q):
    """Sets 2 and 3: the grainline in two parts that meet at mid-thigh, other keys."""
    grain = next(c for c in mesh.curves if c.name == "grainline")
    split = int(np.argmin(np.abs(q[grain.vertices, 1] - MIDTHIGH)))
    lower, upper = grain.vertices[: split + 1], grain.vertices[split:]
    others = [c for c in mesh.curves if c.name != "grainline"]

    def withKeys(keys):
        out = [NamedCurve("grainline_lower", KEY, lower), NamedCurve("grainline_upper", ACCESSORY, upper)]
        return out + [NamedCurve(c.name, KEY if c.name in keys else c.kind, c.vertices) for c in others]

    return {"set2": withKeys({"midthigh"}), "set3": withKeys({"midthigh", "midcalf"})}


def finish(panelToBuild):
    mesh, q = build(panelToBuild)
    return mesh, curveSets(mesh, q)


def front():
    return finish(panel(FRONT, 1729, [("waist_dart", 0.68, 10.0)]))


def back():
    return finish(panel(BACK, 1729, [("waist_dart_inner", 0.28, 12.0), ("waist_dart_outer", 0.70, 11.0)]))
