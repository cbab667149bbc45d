"""A loose shirt: front, back, and the shoulder piece (yoke) that lies between them. Unit cm."""
import numpy as np

from curves import ACCESSORY, DART, KEY, Curve, bezier, line
from panel import Panel
from torso import Bulge, Torso, TorsoShape, buildMirrored, level, through

HEM, WAIST, DART_FOOT, BUST, ARMPIT = 0.0, 20.0, 31.0, 37.0, 41.0
BLADE = 44.0
FRONT_YOKE, BACK_YOKE = 53.6, 51.0  # heights of the yoke's seams on the centre line
SHOULDER, NECK = 17.6, 7.0  # half widths

SHAPE = TorsoShape(
    rows=(
        # y, z front, z back, half width, z side
        (0.0, 12.2, -12.6, 19.6, 0.0),
        (10.0, 12.0, -11.6, 18.6, 0.0),
        (20.0, 10.8, -9.2, 16.2, 0.0),
        (30.0, 11.4, -10.4, 17.2, 0.0),
        (37.0, 12.3, -11.6, 18.2, 0.0),
        (44.0, 11.9, -11.5, 18.8, 0.0),
        (50.0, 9.6, -9.9, 20.0, 0.0),
        (54.0, 6.4, -7.0, 21.6, 0.0),
        (56.5, 3.1, -3.4, 23.0, 0.0),
        (57.3, 0.0, 0.0, 24.0, 0.0),
    ),
    bulges=(Bulge(9.3, 36.5, 2.6, 5.2, 5.0), Bulge(8.5, 44.5, -1.1, 4.6, 5.5)),
)


def armhole(torso, t, top):
    """From the armpit to the shoulder."""
    start = torso.sideSeam([t])[0]
    toward = 1.0 if top[1] > t else -1.0
    return bezier(start, start + [-6.0, toward * 1.5], (top[0] - 1.6, top[1] - toward * 7.0), top)


def front():
    torso = Torso(SHAPE)
    t = torso.front
    hem, armpit, yoke, neck = t(HEM), t(ARMPIT), t(FRONT_YOKE), t(48.5)
    side = torso.sideSeam(np.linspace(hem, armpit, 200))
    shoulder = np.array([SHOULDER - 0.6, yoke])
    outline = [
        Curve("hem", None, line((0, hem), side[0])),
        Curve("side", None, side),
        Curve("armhole", None, armhole(torso, armpit, shoulder)),
        Curve("yoke", None, line(shoulder, (NECK, yoke))),
        Curve("neck", None, bezier((NECK, yoke), (NECK - 0.8, yoke - 4), (4.0, neck), (0, neck))),
        Curve("centre_front", KEY, line((0, neck), (0, hem))),
    ]
    princess = [(11.8, yoke), (10.2, t(45)), (9.3, t(BUST)), (8.4, t(28)), (8.0, t(WAIST)), (9.8, hem)]
    foot = torso.sideSeam([t(DART_FOOT)])[0]
    curves = [
        Curve("bust_girth", ACCESSORY, level(t(BUST))),
        Curve("waist_girth", ACCESSORY, level(t(WAIST))),
        Curve("princess", ACCESSORY, through(princess)),
        Curve("bust_dart", DART, line(foot, (12.6, t(34.8)))),
    ]
    return buildMirrored(Panel(torso, outline, curves, 1414 // 2), "centre_front"), {}


def back():
    torso = Torso(SHAPE)
    t = torso.back
    hem, armpit, yoke = t(HEM), t(ARMPIT), t(BACK_YOKE)
    side = torso.sideSeam(np.linspace(armpit, hem, 200))
    shoulder = np.array([SHOULDER, yoke])
    outline = [
        Curve("yoke", None, line((0, yoke), shoulder)),
        Curve("armhole", None, armhole(torso, armpit, shoulder)[::-1]),
        Curve("side", None, side),
        Curve("hem", None, line(side[-1], (0, hem))),
        Curve("centre_back", KEY, line((0, hem), (0, yoke))),
    ]
    curves = [
        Curve("blade_girth", ACCESSORY, level(t(BLADE))),
        Curve("waist_girth", ACCESSORY, level(t(WAIST))),
        Curve("waist_dart", DART, through([(9.8, hem), (8.8, t(WAIST)), (8.6, t(35.0))])),
    ]
    return buildMirrored(Panel(torso, outline, curves, 1234 // 2), "centre_back"), {}


def shoulder():
    torso = Torso(SHAPE)
    fore, aft, neck = torso.front(FRONT_YOKE), torso.back(BACK_YOKE), 4.2
    outline = [
        Curve("front_yoke", None, line((NECK, fore), (SHOULDER - 0.6, fore))),
        Curve("armhole", None, line((SHOULDER - 0.6, fore), (SHOULDER, aft))),
        Curve("back_yoke", None, line((SHOULDER, aft), (0, aft))),
        Curve("centre_back", KEY, line((0, aft), (0, neck))),
        Curve("neck", None, bezier((0, neck), (5.0, neck), (NECK + 0.6, 0.0), (NECK, fore))),
    ]
    curves = [Curve("shoulder_seam", ACCESSORY, line((0, 0), (30, 0)))]
    return buildMirrored(Panel(torso, outline, curves, 182 // 2), "centre_back"), {}
