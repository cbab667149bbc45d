#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Flattens one piece with several sets of key curves and compares, as in Fig. 8.

Key curves keep their shape as well as their length. Which ones are keys changes the pattern, and some
sets contradict each other; then the keys are released, so that only their length is kept.
"""

import argparse
import warnings
from typing import List

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import surfaceflattening as sf
from picture import Picture


def read(path: str) -> vtkPolyData:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def keys_of(curves: vtkPolyData) -> List[str]:
    data = curves.GetCellData()
    types, names = data.GetArray("CurveType"), data.GetAbstractArray("CurveName")
    return [names.GetValue(row) for row in range(names.GetNumberOfValues())
            if types.GetTuple1(row) == sf.vtkWireWarpingFilter.KEY]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="triangles, a .vtp file")
    parser.add_argument("curves", nargs="+", help="sets of feature curves, .vtp files")
    parser.add_argument("--png", help="draw the flat pieces into this file")
    options = parser.parse_args()

    surface = read(options.surface)
    print(f"{'E_len':>9}  {'E_ang':>7}  {'E_h':>6}  {'status':18} keys")
    flats = []
    for path in options.curves:
        curves = read(path)
        keys = ", ".join(keys_of(curves)) or "none"
        for release in (False, True):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", sf.FlatteningWarning)  # the table tells the status
                report = sf.flatten_polydata(surface, curves, release_keys=release).report
            piece = report["pieces"][0]
            words = keys + (" (released)" if release else "")
            print(f"{piece['E_len']:9.2e}  {piece['E_ang']:7.4f}  {piece['E_h']:6.3f}  "
                  f"{report['status']:18} {words}")
            if report["status"] == "Ok":
                break
        if options.png:
            filter_ = sf.vtkWireWarpingFilter()
            filter_.SetInputData(surface)
            filter_.SetCurvesData(curves)
            filter_.SetReleaseKeys(release)
            filter_.Update()
            flats.append((filter_.GetOutput(0), filter_.GetOutput(1), words))

    if options.png:
        picture = Picture(300 * len(flats), 800)
        for flat, wires, title in flats:
            picture.add(flat, wires, title.replace(", ", ",\n").replace(" (", "\n("))
        picture.write(options.png)


if __name__ == "__main__":
    main()
