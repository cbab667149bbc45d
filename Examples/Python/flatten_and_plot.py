#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a piece and draws how homogeneous the distortion of its triangles is, as in Fig. 9e.

Blue is ideal; red is a triangle that grew or shrank to half its area or beyond. The filters are used
as in any VTK pipeline.
"""

import argparse
import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import surfaceflattening as sf
from picture import Picture


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="triangles, a .vtp file")
    parser.add_argument("curves", help="feature curves, a .vtp file")
    parser.add_argument("picture", help="the .png file to write")
    options = parser.parse_args()

    surface, curves = vtkXMLPolyDataReader(), vtkXMLPolyDataReader()
    surface.SetFileName(options.surface)
    curves.SetFileName(options.curves)
    panels = []
    angles, whole = sf.vtkWireWarpingFilter(), sf.vtkWireWarpingFilter()
    angles.SetSchemeToGlobal()
    for title, filter_ in (
        ("angles (global)", angles),
        ("whole piece (isometric)", whole),
        ("conformal (no length kept)", sf.vtkLeastSquaresConformalFilter()),
    ):
        filter_.SetInputConnection(surface.GetOutputPort())
        filter_.SetCurvesConnection(curves.GetOutputPort())
        filter_.Update()
        if filter_.IsRefused():
            sys.exit(1)  # the filter has said why
        flat, pieces = filter_.GetOutput(0), filter_.GetPieces()
        numbers = {name: pieces.GetValueByName(0, name).ToDouble()
                   for name in ("EdgeLengthError", "AngleErrorMean", "AreaError")}
        print(f"{title:28}", "  ".join(f"{name} {value:.3e}" for name, value in numbers.items()))
        panels.append((flat, filter_.GetOutput(1), title))

    picture = Picture(1200, 600)
    for flat, wires, title in panels:
        picture.add(flat, wires, title, "HomogeneityOfDistortion", low=1.0, high=0.5)
    picture.write(options.picture)


if __name__ == "__main__":
    main()
