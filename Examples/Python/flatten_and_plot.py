#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a piece by three methods and draws how homogeneous the distortion of its triangles is, as in Fig. 9e.

Light is ideal; dark is a triangle that grew or shrank to half its area or beyond. Needs matplotlib.
"""

import argparse

from matplotlib import pyplot
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import surfaceflattening as sf


def read(path: str) -> vtkPolyData:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="triangles, a .vtp file")
    parser.add_argument("curves", help="feature curves, a .vtp file")
    parser.add_argument("picture", help="the .png file to write")
    options = parser.parse_args()

    surface, curves = read(options.surface), read(options.curves)
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 6))
    for ax, title, result in (
        (axes[0], "angles (global)", sf.flatten_polydata(surface, curves, scheme="global")),
        (axes[1], "whole piece (isometric)", sf.flatten_polydata(surface, curves)),
        (axes[2], "conformal (no length kept)", sf.flatten_polydata(surface, curves, scheme="lscm")),
    ):
        piece = result.report["pieces"][0]
        print(f"{title:28} E_len {piece['E_len']:.3e}  E_ang {piece['E_ang']:.3e}  E_area {piece['E_area']:.3e}")
        result.plot("homogeneity", ax=ax, measures=False).set_title(title)
    figure.savefig(options.picture, dpi=100)


if __name__ == "__main__":
    main()
