#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A whole garment in one mesh: cut along its seams, flattened, and what is sewn to what.

The two sides of a seam lie on different pieces, or on the same one where it closes a tube. Both have
the length of the seam on the surface, so they can be sewn without easing.
"""

import argparse
import sys
from typing import List

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import surfaceflattening as sf


def read(path: str) -> vtkPolyData:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def bank_lengths(
    flat: vtkPolyData, seam_pairs: NDArray[np.int64]
) -> List[NDArray[np.float64]]:
    """Per row of SeamPairs the lengths of its two edges in the plane."""
    points = np.array([flat.GetPoint(k)[:2] for k in range(flat.GetNumberOfPoints())])
    first, second = seam_pairs[:, 0:2], seam_pairs[:, 2:4]
    return [np.linalg.norm(points[ids[:, 1]] - points[ids[:, 0]], axis=1) for ids in (first, second)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="triangles, a .vtp file")
    parser.add_argument("curves", help="feature curves with the garment's seams, a .vtp file")
    options = parser.parse_args()

    filter_ = sf.vtkWireWarpingFilter()
    filter_.SetInputData(read(options.surface))
    filter_.SetCurvesData(read(options.curves))
    filter_.Update()
    if filter_.IsRefused():
        sys.exit(1)  # the filter has said why
    flat = filter_.GetOutput(0)
    pairs = flat.GetFieldData().GetArray("SeamPairs")
    if pairs is None:
        sys.exit("no curve cuts this surface, so that nothing is to be sewn")
    pairs = np.array([pairs.GetTuple(k) for k in range(pairs.GetNumberOfTuples())], dtype=int)
    piece_of_cell = flat.GetCellData().GetArray("PieceId")
    piece_of_point = {}
    for cell in range(flat.GetNumberOfCells()):
        corners = flat.GetCell(cell).GetPointIds()
        for k in range(3):
            piece_of_point[corners.GetId(k)] = int(piece_of_cell.GetValue(cell))
    names = filter_.GetCurves().GetColumnByName("Name")
    first, second = bank_lengths(flat, pairs)
    print("pieces", filter_.GetPieces().GetNumberOfRows())
    for curve in np.unique(pairs[:, 4]):
        rows = pairs[:, 4] == curve
        pieces = sorted({piece_of_point[k] for k in pairs[rows][:, [0, 2]].ravel()})
        print(f"{names.GetValue(curve):20} pieces {pieces}  "
              f"lengths {first[rows].sum():.6f} {second[rows].sum():.6f}  "
              f"difference {np.abs(first[rows] - second[rows]).max():.1e}")


if __name__ == "__main__":
    main()
