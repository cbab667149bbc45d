"""A tight wetsuit: upper body and pants, each a front and a back across both sides. Unit cm."""
import numpy as np

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
