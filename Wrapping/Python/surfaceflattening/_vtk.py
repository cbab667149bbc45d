# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of any VTK as the algorithms take them, and meshes of what they give."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
try:
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    from vtkmodules.vtkCommonCore import (
        vtkBitArray, vtkDataArray, vtkIdTypeArray, vtkPoints, vtkStringArray, vtkUnsignedCharArray)
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkDataSetAttributes, vtkPolyData
except ImportError as _error:
    raise ImportError(f"meshes are made with VTK, which is not there ({_error}); pip install vtk") from _error

from ._curves import Curve, curve_data
from ._errors import ArgumentTypeError
from ._pieces import Data


def _as_text(value: Any) -> str:
    """A text of VTK, which gives bytes where they are not UTF-8."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _ids_of(array: Any) -> NDArray[np.int64]:
    """A copy, since VTK 9.6 keeps some of these arrays as a rule."""
    plain = vtkIdTypeArray()
    plain.DeepCopy(array)
    return np.asarray(vtk_to_numpy(plain), np.int64)


def _arrays_of(attributes: Any) -> Dict[str, Any]:
    """Those with a name that hold numbers or texts; views, of bits and texts copies."""
    arrays: Dict[str, Any] = {}
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(k)
        if not array.GetName():
            continue
        if isinstance(array, vtkBitArray):
            bytes_ = vtkUnsignedCharArray()
            bytes_.DeepCopy(array)
            arrays[array.GetName()] = np.array(vtk_to_numpy(bytes_), np.bool_)
        elif isinstance(array, vtkDataArray):
            arrays[array.GetName()] = np.asarray(vtk_to_numpy(array))
        elif isinstance(array, vtkStringArray) and array.GetNumberOfComponents() == 1:
            arrays[array.GetName()] = [_as_text(array.GetValue(row)) for row in range(array.GetNumberOfValues())]
    return arrays


def data_of(mesh: Any, what: str, hint: str = "") -> Data:
    """A mesh as the algorithms take it; TypeError where it is none."""
    if not isinstance(mesh, vtkPolyData):
        raise ArgumentTypeError(f"{what} is {type(mesh).__name__}; it must be a vtkPolyData{hint}")
    points, data = mesh.GetPoints(), {"vertices": mesh.GetNumberOfVerts(), "roles": {}}
    data["points"] = np.empty((0, 3)) if points is None else np.asarray(vtk_to_numpy(points.GetData()), np.float64)
    for name, cells in (("lines", mesh.GetLines()), ("strips", mesh.GetStrips()), ("corners", mesh.GetPolys())):
        if not cells.IsValid():
            data["defect"] = f"the cells of the {what} do not fit the list of their corners"
        elif name == "corners":
            data["offsets"], data["corners"] = _ids_of(cells.GetOffsetsArray()), _ids_of(cells.GetConnectivityArray())
        elif cells.GetNumberOfCells():
            data[name] = np.split(_ids_of(cells.GetConnectivityArray()), _ids_of(cells.GetOffsetsArray())[1:-1])
    for kind, arrays in (("point_arrays", mesh.GetPointData()), ("cell_arrays", mesh.GetCellData())):
        data[kind] = _arrays_of(arrays)
        for role in range(vtkDataSetAttributes.NUM_ATTRIBUTES):
            array = arrays.GetAbstractAttribute(role)
            if array is not None:
                data["roles"][kind, array.GetName() or ""] = role
    data["field_arrays"] = _arrays_of(mesh.GetFieldData())
    return data


def input_of(surface: Any, curves: Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]],
             hint: str) -> Tuple[Data, List[Data]]:
    """A mesh, and the data sets of its curves: meshes as they are, or a list, whose ids are those of its points."""
    data = data_of(surface, "surface", hint)
    if curves is None:
        return data, []
    mesh = isinstance(curves, (str, bytes, vtkDataObject)) or not isinstance(curves, Sequence)
    return data, [data_of(curves, "curves", " or a list of curves") if mesh else curve_data(curves, data["points"])]


def _to_vtk(values: NDArray[Any]) -> Any:
    """A copy; MemoryError where VTK, which ends the process for it, would find no memory."""
    values = np.ascontiguousarray(values)
    np.empty(3 * values.nbytes + (1 << 20), np.uint8)
    if values.dtype == np.bool_:
        bits = vtkBitArray()
        bits.DeepCopy(numpy_to_vtk(values.astype(np.uint8), deep=True))
        return bits
    return (numpy_to_vtkIdTypeArray if values.dtype == np.int64 else numpy_to_vtk)(values, deep=True)


def _cells(offsets: ArrayLike, connectivity: ArrayLike) -> vtkCellArray:
    result = vtkCellArray()
    result.SetData(_to_vtk(np.asarray(offsets, np.int64)), _to_vtk(np.asarray(connectivity, np.int64).ravel()))
    return result


def _add(data: Any, arrays: Mapping[str, Any]) -> None:
    for name, values in arrays.items():
        if isinstance(values, list):
            array = vtkStringArray()
            for value in values:
                array.InsertNextValue(value)
        else:
            array = _to_vtk(values)
        array.SetName(name)
        data.AddArray(array)


def mesh_of_data(data: Data, shared: Optional[vtkPolyData] = None, mesh_class: Optional[type] = None) -> Any:
    """A mesh with copies of all, as a vtkPolyData or an object of a class that derives from it; with the points of another
    mesh where one is given."""
    mesh = vtkPolyData()
    points = vtkPoints() if shared is None else shared.GetPoints()
    if shared is None:
        points.SetData(_to_vtk(data["points"]))
    mesh.SetPoints(points)
    corners = np.asarray(data.get("corners", ()))
    if corners.size:
        mesh.SetPolys(_cells(data["offsets"] if "offsets" in data else np.arange(0, corners.size + 1, 3), corners))
    if data.get("lines"):
        mesh.SetLines(_cells(np.cumsum([0] + [len(line) for line in data["lines"]]), np.concatenate(data["lines"])))
    for kind, arrays in (("point_arrays", mesh.GetPointData()), ("cell_arrays", mesh.GetCellData()),
                         ("field_arrays", mesh.GetFieldData())):
        _add(arrays, data.get(kind, {}))
    for (kind, name), role in data.get("roles", {}).items():
        (mesh.GetPointData() if kind == "point_arrays" else mesh.GetCellData()).SetActiveAttribute(name, role)
    if mesh_class is None or isinstance(mesh, mesh_class):
        return mesh
    try:
        return mesh_class(mesh)
    except TypeError:  # it takes no data set to begin with
        other: Any = mesh_class()
        other.ShallowCopy(mesh)
        return other
