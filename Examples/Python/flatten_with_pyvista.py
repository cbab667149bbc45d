#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a mesh that PyVista reads, and draws surface and flat pieces by what happens to the areas.

Red cloth must be eased in, blue cloth stretched. Needs PyVista 0.48 or later for the Python of this VTK, as
Debian unstable has it.
"""

import argparse

import pyvista


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="a mesh that PyVista reads")
    parser.add_argument("curves", help="feature curves, a .vtp file")
    parser.add_argument("picture", help="the .png file to write")
    options = parser.parse_args()

    mesh, curves = pyvista.read(options.surface), pyvista.read(options.curves)
    result = mesh.flattening.flatten(curves)  # surfaceflattening adds mesh.flattening to PyVista
    for piece in result.report["pieces"]:
        print(f"piece {piece['piece'] + 1}: {piece['status']}, area error {100 * piece['E_area']:.2f} %")

    plotter = pyvista.Plotter(shape=(1, 2), off_screen=True, window_size=(1200, 600))
    for column, part in enumerate(("cut", "flat")):
        plotter.subplot(0, column)
        plotter.add_mesh(result.to_polydata(part), scalars="AreaRatio", cmap="coolwarm", clim=(0.8, 1.2))
        plotter.add_mesh(result.to_polydata("wires") if part == "flat" else curves, color="black", line_width=3)
        if part == "flat":
            plotter.view_xy()
    plotter.screenshot(options.picture)


if __name__ == "__main__":
    main()
