#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a surface of a file and draws the pieces by what happens to the areas, with matplotlib and without VTK.

Red cloth must be eased in, blue cloth stretched. Reads OBJ, PLY, STL and OFF, and curves as the command does.
"""

import argparse

import matplotlib
import surfaceflattening as sf

matplotlib.use("Agg")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="an OBJ, PLY, STL or OFF file")
    parser.add_argument("picture", help="the .png file to write")
    parser.add_argument("--curves", help="a file of curves, beside those of the surface's own")
    options = parser.parse_args()

    surface = sf.load_surface(options.surface)
    curves = list(surface.curves)
    if options.curves:
        curves += sf.load_curves(options.curves, surface.points, surface.triangles)
    result = sf.flatten(surface.points, surface.triangles, curves)
    for piece in result.report["pieces"]:
        print(f"piece {piece['piece'] + 1}: {piece['status']}, area error {100 * piece['E_area']:.2f} %")
    result.plot("area").figure.savefig(options.picture, dpi=100)


if __name__ == "__main__":
    main()
