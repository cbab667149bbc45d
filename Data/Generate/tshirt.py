"""A whole T-shirt as one mesh: front, back and two sleeves, open at neck, hem and sleeve ends.

Its seams are curves of type 3; cut along them it falls into four disks. Unit cm.
"""
import numpy as np

from curves import ACCESSORY, KEY, SEAM, Curve, bezier, line
from panel import Mesh, NamedCurve, Panel, build, sewn, upward
from torso import Bulge, Torso, TorsoShape, buildMirrored, level

HEM, WAIST, CHEST, ARMPIT = 0.0, 22.0, 38.0, 41.0
SHOULDER, NECK = 19.5, 8.0  # half widths
SPACING = 2.3  # edge length

SHAPE = TorsoShape(
    rows=(
        # y, z front, z back, half width, z side
        (0.0, 12.4, -12.4, 20.4, 0.0),
        (12.0, 12.0, -11.6, 19.8, 0.0),
        (22.0, 11.6, -10.6, 19.2, 0.0),
        (30.0, 12.2, -11.0, 19.6, 0.0),
        (38.0, 13.0, -12.0, 20.4, 0.0),
        (45.0, 12.2, -12.0, 21.2, 0.0),
        (51.0, 9.6, -10.2, 22.6, 0.0),
        (55.5, 5.8, -6.4, 24.2, 0.0),
        (57.6, 2.6, -2.9, 25.2, 0.0),
        (58.2, 0.0, 0.0, 26.0, 0.0),
    ),
    bulges=(Bulge(9.0, 39.0, 1.0, 5.5, 6.0), Bulge(9.0, 46.0, -1.2, 5.0, 6.0)),
)

# The sleeve: direction of the arm, length along it, radii of its end, fullness between.
ARM = np.array([0.74, -np.sqrt(1 - 0.74**2), 0.0])
LENGTH, END_UP, END_ACROSS, FULLNESS = 24.0, 7.6, 8.4, 0.8


def armhole(torso, t):
    """From the armpit to the end of the shoulder seam."""
    start = torso.sideSeam([t])[0]
    toward = -1.0 if t > 0 else 1.0
    return bezier(start, start + [-6.5, 0.0], (SHOULDER - 0.8, -toward * 8.0), (SHOULDER, 0.0), 600)


def front(torso):
    t = torso.front
    hem, armpit, neck = t(HEM), t(ARMPIT), t(49.5)
    side = torso.sideSeam(np.linspace(hem, armpit, 600))
    outline = [
        Curve("hem", None, line((0, hem), side[0])),
        Curve("side_seam", SEAM, side),
        Curve("armhole_front", SEAM, armhole(torso, armpit)),
        Curve("shoulder_seam", SEAM, line((SHOULDER, 0), (NECK, 0))),
        Curve("neck", None, bezier((NECK, 0), (NECK - 1.0, -5), (4.5, neck), (0, neck))),
        Curve("centre_front", KEY, line((0, neck), (0, hem))),
    ]
    curves = [
        Curve("chest_girth_front", ACCESSORY, level(t(CHEST))),
        Curve("waist_girth_front", ACCESSORY, level(t(WAIST))),
    ]
    return buildMirrored(Panel(torso, outline, curves, spacing=SPACING), "centre_front")


def back(torso):
    t = torso.back
    hem, armpit, neck = t(HEM), t(ARMPIT), 3.8
    side = torso.sideSeam(-np.linspace(-hem, -armpit, 600))[::-1]
    outline = [
        Curve("neck", None, bezier((0, neck), (5.0, neck), (NECK - 0.6, 2.4), (NECK, 0))),
        Curve("shoulder_seam", SEAM, line((NECK, 0), (SHOULDER, 0))),
        Curve("armhole_back", SEAM, armhole(torso, armpit)[::-1]),
        Curve("side_seam", SEAM, side),
        Curve("hem", None, line(side[-1], (0, hem))),
        Curve("centre_back", KEY, line((0, hem), (0, neck))),
    ]
    curves = [
        Curve("chest_girth_back", ACCESSORY, level(t(CHEST))),
        Curve("waist_girth_back", ACCESSORY, level(t(WAIST))),
    ]
    return buildMirrored(Panel(torso, outline, curves, spacing=SPACING), "centre_back")


class Sleeve:
    """Ruled from the armhole to an ellipse, with some fullness. Parameters: c round the sleeve, 0
    and 1 under the arm, 0.25 in front, 0.5 on top; r from the armhole (0) to the end (1)."""

    def __init__(self, torso):
        self.halves = [torso(armhole(torso, torso.front(ARMPIT))), torso(armhole(torso, torso.back(ARMPIT)))]
        self.up = np.array([-ARM[1], ARM[0], 0.0])
        self.middle = 0.5 * (self.halves[0][0] + self.halves[0][-1])
        self.end = self.middle + LENGTH * ARM

    def armholeAt(self, c):
        out = np.empty((len(c), 3))
        for half, fraction, use in ((0, 2 * c, c <= 0.5), (1, 2 - 2 * c, c > 0.5)):
            x = self.halves[half]
            length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(x, axis=0), axis=1))])
            target = np.clip(fraction[use], 0, 1) * length[-1]
            out[use] = np.column_stack([np.interp(target, length, x[:, k]) for k in range(3)])
        return out

    def ends(self, c):
        angle = 2 * np.pi * c
        rim = -np.cos(angle)[:, None] * END_UP * self.up
        rim[:, 2] += END_ACROSS * np.sin(angle)
        return self.armholeAt(c), self.end + rim

    def __call__(self, q):
        c, r = q[:, 0], q[:, 1]
        a, b = self.ends(c)
        angle = 2 * np.pi * c
        outward = -np.cos(angle)[:, None] * self.up
        outward[:, 2] += np.sin(angle)
        return (1 - r)[:, None] * a + r[:, None] * b + FULLNESS * np.sin(np.pi * r)[:, None] * outward

    def chart(self, q):
        c, r = q[:, 0], q[:, 1]
        a, b = self.ends(np.clip(c, 0, 1))
        girth = (1 - r) * 44.0 + r * 50.0
        return np.column_stack([(0.5 - c) * girth, (r - 1) * np.linalg.norm(b - a, axis=1)])


def sleeve(torso):
    surface = Sleeve(torso)
    outline = [
        Curve("armhole_back", SEAM, line((1, 0), (0.5, 0), 600)),
        Curve("armhole_front", SEAM, line((0.5, 0), (0, 0), 600)),
        Curve("underarm_seam", SEAM, line((0, 0), (0, 1))),
        Curve("end", None, line((0, 1), (1, 1), 600)),
        Curve("underarm_seam", SEAM, line((1, 1), (1, 0))),
    ]
    curves = [
        Curve("sleeve_grainline", KEY, line((0.5, 0), (0.5, 1))),
        Curve("sleeve_girth", ACCESSORY, line((0, 0.55), (1, 0.55), 600)),
    ]
    mesh, _ = build(Panel(surface, outline, curves, spacing=SPACING, chart=surface.chart))
    rising = [upward(c, mesh.points) for c in mesh.curves]
    named = lambda tail: [NamedCurve(c.name + tail, c.kind, c.vertices) for c in rising]
    left = Mesh(mesh.points, mesh.triangles, named("_left"))
    right = Mesh(mesh.points * [-1.0, 1.0, 1.0], mesh.triangles[:, ::-1], named("_right"))
    return left, right


def make():
    torso = Torso(SHAPE)
    return sewn([front(torso), back(torso), *sleeve(torso)], 0.02 * SPACING), {}
