"""Left leg panels of a pair of pants, and the leg surface that the wetsuit uses too. Unit cm; y up
from the ankle, z to the front, x to the left.

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
    """Sections by height and what shapes them.

    leg    rows of y, centre z, half width, half depth of the leg
    hip    rows of y, centre z, half width, half depth of the hip
    gap    distance of the inner edge from the plane x = 0 at the ankle
    bulges rows of u, y, height, width in u, width in y: swellings outwards
    fork   height over the crotch in which the section turns into the hip's
    side   +1 front, -1 back
    """

    leg: tuple
    hip: tuple
    gap: float
    bulges: tuple
    fork: float
    side: float


LEG_SECTIONS = (
    (0.0, -3.0, 6.8, 7.4),
    (24.0, -2.6, 7.6, 8.1),
    (44.0, -0.6, 8.6, 8.8),
    (58.0, 0.2, 9.8, 10.2),
    (73.0, -0.5, 10.9, 11.6),
    (98.0, -0.5, 11.1, 11.8),
)
HIP_SECTIONS = (
    (66.0, -0.6, 20.8, 12.7),
    (74.0, -0.6, 20.7, 12.7),
    (82.0, -0.6, 19.8, 12.5),
    (90.0, -0.3, 17.8, 11.6),
    (98.0, 0.0, 15.8, 10.6),
    (104.0, 0.0, 15.0, 10.2),
)
FRONT = Leg(LEG_SECTIONS, HIP_SECTIONS, 3.0, ((0.30, 91.0, 1.0, 0.30, 6.0),), fork=11.0, side=1.0)
BACK = Leg(LEG_SECTIONS, HIP_SECTIONS, 3.0, ((0.42, 82.0, 3.2, 0.26, 6.5),), fork=13.0, side=-1.0)


def smoothRamp(x, width):
    """0 for x << 0, x for x >> 0, with a round corner."""
    return 0.5 * (x + np.sqrt(x * x + width * width))


class LegSurface:
    def __init__(self, leg):
        self.leg = leg
        columns = lambda rows: np.array(rows).T
        y, z, a, b = columns(leg.leg)
        self.legZ, self.legA, self.legB = (naturalSpline(y, v) for v in (z, a, b))
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
        legX = self.leg.gap * np.maximum(1 - y / CROTCH, 0.0) ** 2 + a + a * np.sin(psi)
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
        for u0, y0, height, widthU, widthY in self.leg.bulges:
            swell = height * np.exp(-0.5 * (((u - u0) / widthU) ** 2 + ((y - y0) / widthY) ** 2))
            z = z + self.leg.side * swell
        return np.column_stack([x, y, z])

    def width(self, y):
        """Length of the section, by chords."""
        u = np.linspace(0, 1, 41)
        out = np.empty_like(y)
        for k, height in enumerate(y):
            x = self(np.column_stack([u, np.full_like(u, height)]))
            out[k] = np.linalg.norm(np.diff(x, axis=0), axis=1).sum()
        return out


GIRTHS = (("hip", HIP), ("crotch", CROTCH), ("midthigh", MIDTHIGH), ("knee", KNEE), ("midcalf", MIDCALF))


def panel(leg, triangles, darts, centre=None):
    """darts: (name, (u, y) on the boundary, (u, y) of the tip). Where a name `centre` is given, the
    edge over the crotch becomes the key curve of that name, and the leg's grainline accessory."""
    surface = LegSurface(leg)
    heights = np.linspace(HEM - 5, WAIST + 5, 60)
    width = naturalSpline(heights, surface.width(heights))

    def chart(q):
        # The sign keeps the chart counter-clockwise seen from outside.
        return np.column_stack([leg.side * (q[:, 0] - 0.5) * width(q[:, 1]), q[:, 1]])

    corners = [(0, HEM), (1, HEM), (1, WAIST), (0, WAIST), (0, CROTCH), (0, HEM)]
    names = [None, None, None, centre, None]
    if leg.side < 0:
        corners, names = corners[::-1], names[::-1]
    outline = [
        Curve(name or "outline", KEY if name else None, line(a, b))
        for name, a, b in zip(names, corners, corners[1:])
    ]
    curves = [Curve("grainline", ACCESSORY if centre else KEY, line((0.5, HEM), (0.5, WAIST)))]
    curves += [Curve(name, ACCESSORY, line((0, y), (1, y))) for name, y in GIRTHS]
    curves += [Curve(name, DART, line(foot, tip)) for name, foot, tip in darts]
    return Panel(surface, outline, curves, triangles, chart=chart)


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
    return finish(panel(FRONT, 1729, [("waist_dart", (0.68, WAIST), (0.68, WAIST - 10.0))]))


def back():
    darts = [
        ("waist_dart_inner", (0.28, WAIST), (0.29, WAIST - 12.0)),
        ("waist_dart_outer", (0.70, WAIST), (0.69, WAIST - 11.0)),
    ]
    return finish(panel(BACK, 1729, darts))
