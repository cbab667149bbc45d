"""A tight wetsuit: upper body and pants, each a front and a back across both sides. Unit cm."""
import numpy as np

import pants
from curves import ACCESSORY, DART, KEY, Curve, bezier, line
from panel import Panel
from shirt import armhole
from torso import Bulge, Torso, TorsoShape, buildMirrored, level, through

UNDERBUST, BUST, CHEST, ARMPIT = 11.5, 19.0, 27.0, 24.0
SHOULDER, NECK = 15.0, 8.0  # half widths

UPPER = TorsoShape(
    rows=(
        # y from the waist, z front, z back, half width, z side
        (0.0, 9.6, -8.4, 13.6, 0.0),
        (6.0, 9.8, -8.8, 13.9, 0.0),
        (12.0, 10.2, -9.8, 14.6, 0.0),
        (19.0, 10.6, -10.8, 15.6, 0.0),
        (25.0, 10.4, -11.1, 16.4, 0.0),
        (31.0, 8.6, -10.0, 17.6, 0.0),
        (35.0, 6.2, -7.6, 18.8, 0.0),
        (38.0, 3.2, -3.8, 20.0, 0.0),
        (39.0, 0.0, 0.0, 21.0, 0.0),
    ),
    bulges=(Bulge(8.8, 19.0, 3.6, 4.8, 4.6), Bulge(8.0, 27.0, -1.0, 4.4, 5.0)),
    drop=0.3,
    reach=11.0,
)


def upperFront():
    torso = Torso(UPPER)
    t = torso.front
    waist, armpit, neck = t(0.0), t(ARMPIT), t(33.0)
    side = torso.sideSeam(np.linspace(waist, armpit, 200))
    shoulder = np.array([SHOULDER, 0.0])
    outline = [
        Curve("waist", None, line((0, waist), side[0])),
        Curve("side", None, side),
        Curve("armhole", None, armhole(torso, armpit, shoulder)),
        Curve("shoulder", None, line(shoulder, (NECK, 0))),
        Curve("neck", None, bezier((NECK, 0), (NECK - 1.2, -5), (4.0, neck), (0, neck))),
        Curve("centre_front", KEY, line((0, neck), (0, waist))),
    ]
    princess = [(11.2, 0.0), (9.6, t(29)), (8.8, t(BUST)), (7.6, t(UNDERBUST)), (6.8, waist)]
    foot = torso.sideSeam([t(15.2)])[0]
    curves = [
        Curve("chest_girth", ACCESSORY, level(t(CHEST))),
        Curve("bust_girth", ACCESSORY, level(t(BUST))),
        Curve("underbust_girth", ACCESSORY, level(t(UNDERBUST))),
        Curve("princess", ACCESSORY, through(princess)),
        Curve("bust_dart", DART, line(foot, (12.4, t(17.0)))),
        Curve("waist_dart", DART, line((10.6, waist), (10.9, t(7.5)))),
    ]
    return buildMirrored(Panel(torso, outline, curves, 658 // 2), "centre_front"), {}


def upperBack():
    torso = Torso(UPPER)
    t = torso.back
    waist, armpit, neck = t(0.0), t(ARMPIT), 3.6
    side = torso.sideSeam(np.linspace(armpit, waist, 200))
    shoulder = np.array([SHOULDER, 0.0])
    outline = [
        Curve("neck", None, bezier((0, neck), (5.0, neck), (NECK - 0.6, 2.4), (NECK, 0))),
        Curve("shoulder", None, line((NECK, 0), shoulder)),
        Curve("armhole", None, armhole(torso, armpit, shoulder)[::-1]),
        Curve("side", None, side),
        Curve("waist", None, line(side[-1], (0, waist))),
        Curve("centre_back", KEY, line((0, waist), (0, neck))),
    ]
    curves = [
        Curve("blade_girth", ACCESSORY, level(t(29.0))),
        Curve("chest_girth", ACCESSORY, level(t(BUST + 1.5))),
        Curve("underbust_girth", ACCESSORY, level(t(UNDERBUST - 1.0))),
        Curve("waist_dart", DART, line((7.0, waist), (7.6, t(16.5)))),
    ]
    return buildMirrored(Panel(torso, outline, curves, 928 // 2), "centre_back"), {}


LEG_SECTIONS = (
    # y, centre z, half width, half depth
    (0.0, -3.6, 4.4, 5.0),
    (10.0, -3.8, 4.9, 5.7),
    (24.0, -3.4, 6.3, 7.0),
    (44.0, -0.8, 6.7, 7.3),
    (58.0, 0.0, 8.5, 9.0),
    (73.0, -0.4, 9.9, 10.6),
    (98.0, -0.4, 10.2, 10.8),
)
# The waist is the upper body's.
HIP_FRONT = (
    (66.0, 0.0, 19.0, 10.8),
    (74.0, 0.0, 18.9, 10.8),
    (82.0, 0.0, 17.8, 10.9),
    (90.0, 0.0, 15.6, 10.5),
    (98.0, 0.0, 13.6, 9.6),
    (104.0, 0.0, 13.6, 9.6),
)
HIP_BACK = (
    (66.0, 0.0, 19.0, 11.4),
    (74.0, 0.0, 18.9, 11.4),
    (82.0, 0.0, 17.8, 11.0),
    (90.0, 0.0, 15.6, 9.6),
    (98.0, 0.0, 13.6, 8.4),
    (104.0, 0.0, 13.6, 8.6),
)
LEGS_FRONT = pants.Leg(
    LEG_SECTIONS, HIP_FRONT, 4.0, ((0.25, 90.0, 0.8, 0.3, 6.0), (0.5, 45.0, 0.6, 0.2, 4.0)), 10.0, 1.0
)
LEGS_BACK = pants.Leg(
    LEG_SECTIONS, HIP_BACK, 4.0, ((0.42, 81.0, 3.4, 0.26, 6.0), (0.5, 28.0, 1.0, 0.3, 7.0)), 12.0, -1.0
)


def pantsFront():
    waist = pants.WAIST
    darts = [("waist_dart", (0.66, waist), (0.68, waist - 9.0))]
    return buildMirrored(pants.panel(LEGS_FRONT, 1730 // 2, darts, "centre_front"), "centre_front"), {}


def pantsBack():
    waist, knee = pants.WAIST, pants.KNEE
    darts = [
        ("waist_dart", (0.30, waist), (0.32, waist - 11.5)),
        ("knee_dart", (1.0, knee + 5.0), (0.72, knee + 4.0)),
    ]
    return buildMirrored(pants.panel(LEGS_BACK, 1730 // 2, darts, "centre_back"), "centre_back"), {}
