#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens sixty shapes by formula (saddles, bowls, vases, sleeves, bags, helmets, lasts, bellows),
each as a regular and an irregular mesh in three resolutions, with no, one or two accessory curves:

    Testing/Benchmark/shapes.py [--wirewarp build/bin/wirewarp] [--sizes 16 32 64] [--only NAME] [--untimed]

Prints a row for each run and fails where a triangle is turned over, where a shape that the plane has room for
(see `verdict` in Documentation/choosing.md) does not end Ok, or where a run takes more processor time than its
number of triangles allows: 3 s at 5,000, 30 s at 70,000 on two cores.
"""
import argparse
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "Command"))
import command  # noqa: E402  - it lies in another folder

# Each family maps (u, v) in [-1, 1]^2 to space by a parameter; seven or eight values each.


def saddle(u, v, a):
    return u, v, a * (u * u - v * v)


def bowl(u, v, a):
    return u, v, a * (1 - u * u) * (1 - v * v)


def vase(u, v, a):
    radius = 1 + a * math.sin(2.2 * v + 0.4)
    return radius * math.cos(2.6 * u), radius * math.sin(2.6 * u), 1.5 * v


def sleeve(u, v, a):
    # A tube that is cut open along one side, tapered and bent at the elbow.
    radius, bend = 0.5 - 0.15 * v, a * v
    out = radius * math.cos(3.0 * u)
    along = (math.sin(bend) / a if a else v) * 1.5
    back = (1 - math.cos(bend)) / a * 1.5 if a else 0.0
    return along - out * math.sin(bend), back + out * math.cos(bend), radius * math.sin(3.0 * u)


def bag(u, v, a):
    # Between a sheet and a pocket: a flat bottom with steep sides.
    depth = (1 - u ** 4) * (1 - v ** 4)
    return u, v, a * depth


def helmet(u, v, a):
    # A cap of an ellipsoid: the square onto a disk, the disk onto the cap.
    x, y = u * math.sqrt(1 - v * v / 2), v * math.sqrt(1 - u * u / 2)
    r = math.hypot(x, y)
    s = math.sin(a * r) / r if r else a
    return 1.2 * s * x, s * y, math.cos(a * r)


def last(u, v, a):
    # A shoe's upper: an arch that narrows and rises towards the heel.
    width = 0.5 + 0.15 * math.cos(2.5 * u)
    height = 0.35 + a * (1 + math.tanh(2 * u)) / 2
    return 1.4 * u, width * math.sin(1.5 * v), height * math.cos(1.5 * v)


def bellows(u, v, a):
    return u, v, a * math.sin(4 * math.pi * u) * (1 + 0.5 * v)


FAMILIES = [
    (saddle, (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8)),
    (bowl, (0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 2.0)),
    (vase, (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4)),
    (sleeve, (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)),
    (bag, (0.1, 0.2, 0.3, 0.4, 0.5, 0.8, 1.5)),
    (helmet, (0.4, 0.6, 0.8, 1.0, 1.2, 1.6, 2.2, 2.8)),
    (last, (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)),
    (bellows, (0.02, 0.04, 0.06, 0.08, 0.1, 0.15, 0.2)),
]


def mesh(family, parameter, n, irregular):
    """Points and triangles of (n + 1)^2 grid points, n even."""
    chance = random.Random(n)

    def place(i, j):
        u, v = 2 * i / n - 1, 2 * j / n - 1
        if irregular and 0 < i < n and 0 < j < n:
            u += 0.5 / n * chance.uniform(-1, 1)
            v += 0.5 / n * chance.uniform(-1, 1)
        return family(u, v, parameter)
    return command.grid(n, n, place, other=lambda i, j: chance.random() < 0.5 if irregular else (i + j) % 2)


def curves(n, count):
    middle = n // 2
    lines = [[j * (n + 1) + middle for j in range(n + 1)], [middle * (n + 1) + i for i in range(n + 1)]]
    return "".join(f"accessory line{k} {' '.join(map(str, lines[k]))}\n" for k in range(count))


def allowed(triangles):
    """Seconds on one core: 3 at 5,000, 30 on two at 70,000."""
    return 3.0 * max(1.0, (triangles / 5000) ** 1.1)


def run(wirewarp, folder, points, triangles, text):
    surface, lines = os.path.join(folder, "surface.obj"), os.path.join(folder, "curves.txt")
    for path, content in ((surface, command.obj(points, triangles)), (lines, text)):
        with open(path, "w", encoding="ascii") as file:
            file.write(content)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([wirewarp, surface] + ([lines] if text else []) + ["-o", folder], check=False,
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        piece = json.load(file)["pieces"][0]
    return result.returncode, after.ru_utime - before.ru_utime, piece


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--wirewarp", default="build/bin/wirewarp")
    parser.add_argument("--sizes", type=int, nargs="+", default=[16, 32, 64])
    parser.add_argument("--only", default="")
    parser.add_argument("--untimed", action="store_true", help="runs may take any time")
    options = parser.parse_args()
    faults = runs = 0
    print("shape  value  n  mesh  curves  exit  status  iterations  E_area  E_h  flips  E_len_max  s")
    for family, values in FAMILIES:
        for number, value in enumerate(values):
            for n in options.sizes if options.only in family.__name__ else []:
                for irregular in (False, True):
                    points, triangles = mesh(family, value, n, irregular)
                    with tempfile.TemporaryDirectory() as folder:
                        code, seconds, piece = run(
                            options.wirewarp, folder, points, triangles, curves(n, number % 3))
                    runs += 1
                    room = not piece["verdict"]
                    fault = (piece["flipped"] > 0 or (room and piece["status"] not in ("Ok", "Overlap"))
                             or (seconds > allowed(len(triangles)) and not options.untimed))
                    faults += fault
                    print(family.__name__, value, n, "irregular" if irregular else "regular", number % 3,
                          code, piece["status"], piece["iterations"], f"{piece['E_area']:.4f}",
                          f"{piece['E_h']:.3f}", piece["flipped"], f"{piece['E_len_max']:.0e}",
                          f"{seconds:.2f}", "FAULT" if fault else "", flush=True)
    print(f"{runs} runs, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
