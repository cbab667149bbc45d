# SPDX-License-Identifier: BSD-3-Clause
"""Results as vtkPolyData again, with the arrays of vtkWireWarpingFilter's outputs."""

from typing import TYPE_CHECKING, Any, Sequence, Type, get_args

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import (
    CURVE_TYPES, make_cells, make_points, make_triangles, named, strings, to_vtk, to_vtk_ids)
from ._options import word_of
from ._report import PIECE_INTEGERS, PIECE_NUMBERS
from ._types import Part

if TYPE_CHECKING:
    from ._result import Flattening

_IDS = ("PieceId", "WirePatchId", "WarpingOrder", "vtkOriginalCellIds", "vtkOriginalPointIds")


def _array(name: str, values: NDArray[Any]) -> Any:
    if name in _IDS:
        return named(name, to_vtk_ids(values.astype(np.int64)))
    if values.dtype == np.bool_:
        values = values.astype(np.uint8)
    return named(name, to_vtk(np.ascontiguousarray(values)))


def _ids(name: str, values: Sequence[int]) -> Any:
    return named(name, to_vtk_ids(np.array(values, np.int64)))


def _with_triangles(result: "Flattening", points: NDArray[np.float64]) -> vtkPolyData:
    mesh = vtkPolyData()
    mesh.SetPoints(make_points(points))
    mesh.SetPolys(make_triangles(result.triangles))
    for data, arrays in ((mesh.GetPointData(), result.point_arrays),
                         (mesh.GetCellData(), result.cell_arrays)):
        for name, values in arrays.items():
            data.AddArray(_array(name, values))
    return mesh


def _in_plane(result: "Flattening") -> NDArray[np.float64]:
    return np.column_stack([result.positions, np.zeros(len(result.positions))])


def _flat(result: "Flattening") -> vtkPolyData:
    mesh = _with_triangles(result, _in_plane(result))
    field = mesh.GetFieldData()
    pieces: Any = result.report["pieces"]
    for key, name in PIECE_INTEGERS.items():
        field.AddArray(_ids(name, [piece[key] for piece in pieces]))
    for key, name in PIECE_NUMBERS.items():
        field.AddArray(_array(name, np.array([piece[key] for piece in pieces], np.float64)))
    field.AddArray(strings("Status", [piece["status"] for piece in pieces]))
    field.AddArray(strings("RunStatus", [result.report["status"]]))
    for name, rows in (("SeamPairs", result.seam_pairs), ("OverlapEdges", result.overlap_edges)):
        if len(rows):  # as in the filter's output, a list without rows is no array
            field.AddArray(named(name, to_vtk_ids(np.ascontiguousarray(rows))))
    if len(result.seam_closed):
        field.AddArray(_array("SeamClosed", result.seam_closed))
    return mesh


def _wires(result: "Flattening") -> vtkPolyData:
    mesh = vtkPolyData()
    mesh.SetPoints(make_points(_in_plane(result)))
    mesh.SetLines(make_cells([wire.vertices for wire in result.wires]))
    cells, wires = mesh.GetCellData(), result.wires
    types = [CURVE_TYPES.index(wire.type) if wire.type in CURVE_TYPES else -1 for wire in wires]
    kinds = [-2 if wire.type == "connector" else kind for wire, kind in zip(wires, types)]
    cells.AddArray(_array("CurveType", np.array(types, np.int32)))
    cells.AddArray(_array("WireKind", np.array(kinds, np.int32)))
    cells.AddArray(_ids("CurveId", [wire.curve for wire in wires]))
    cells.AddArray(strings("CurveName", [wire.name for wire in wires]))
    cells.AddArray(_ids("PieceId", [wire.piece for wire in wires]))
    for name, flags in (("Boundary", [wire.boundary for wire in wires]),
                        ("Connector", [wire.type == "connector" for wire in wires])):
        cells.AddArray(_array(name, np.array(flags, np.uint8)))
    for name, values in (("RestLength", [wire.rest_length for wire in wires]),
                         ("FlatLength", [wire.flat_length for wire in wires]),
                         ("LengthError", [wire.length_error for wire in wires])):
        cells.AddArray(_array(name, np.array(values, np.float64)))
    names = [curve["name"] for curve in result.report["curves"]]
    if names:
        mesh.GetFieldData().AddArray(strings("CurveNames", names))
    return mesh


def _cut(result: "Flattening") -> vtkPolyData:
    mesh = _with_triangles(result, result.points)
    mesh.GetPointData().SetTCoords(_array("FlatPositions", result.positions))
    return mesh


def to_polydata(result: "Flattening", part: Part, mesh_class: Type[Any] = vtkPolyData) -> Any:
    """A part of the result as a vtkPolyData, or as an object of a class that derives from it."""
    part = word_of(part, get_args(Part), "part")
    mesh = {"flat": _flat, "wires": _wires, "cut": _cut}[part](result)
    if isinstance(mesh, mesh_class):
        return mesh
    try:
        return mesh_class(mesh)
    except TypeError:  # it takes no data set to begin with
        copy = mesh_class()
        copy.ShallowCopy(mesh)
        return copy
