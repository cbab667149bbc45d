#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Joins pieces and their curves into a collection, a block a piece, that a filter flattens in one go.

In a collection each block carries its curves as line cells of its own.
"""

import argparse
import os

from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter, vtkXMLPolyDataReader


def read(path: str) -> vtkPolyData:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def join(surface: vtkPolyData, curves: vtkPolyData) -> vtkPolyData:
    """One vtkPolyData of the surface's triangles and the curves' lines."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for data in (surface, curves):
        points.InsertPoints(points.GetNumberOfPoints(), data.GetNumberOfPoints(), 0, data.GetPoints())
    lines = vtkCellArray()
    lines.Append(curves.GetLines(), surface.GetNumberOfPoints())
    # Values a cell: those of the lines come first.
    types, names = vtkIntArray(), vtkStringArray()
    types.SetName("CurveType")
    names.SetName("CurveName")
    for cell in range(curves.GetNumberOfLines()):
        types.InsertNextValue(int(curves.GetCellData().GetArray("CurveType").GetValue(cell)))
        names.InsertNextValue(curves.GetCellData().GetAbstractArray("CurveName").GetValue(cell))
    for _ in range(surface.GetNumberOfPolys()):
        types.InsertNextValue(0)
        names.InsertNextValue("")
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    result.SetPolys(surface.GetPolys())
    result.GetCellData().AddArray(types)
    result.GetCellData().AddArray(names)
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("collection", help="the .vtm file to write")
    parser.add_argument("pieces", nargs="+", metavar="SURFACE.vtp,CURVES.vtp")
    options = parser.parse_args()

    collection = vtkMultiBlockDataSet()
    for block, pair in enumerate(options.pieces):
        surface, curves = pair.split(",")
        collection.SetBlock(block, join(read(surface), read(curves)))
        name = os.path.splitext(os.path.basename(surface))[0]
        collection.GetMetaData(block).Set(vtkCompositeDataSet.NAME(), name)
    writer = vtkXMLMultiBlockDataWriter()
    writer.SetDataModeToBinary()  # Debian's ParaView 5.11 cannot read appended data
    writer.SetInputData(collection)
    writer.SetFileName(options.collection)
    if not writer.Write():
        parser.exit(1)
    print(f"{options.collection}: {collection.GetNumberOfBlocks()} pieces")


if __name__ == "__main__":
    main()
