# SPDX-License-Identifier: BSD-3-Clause
"""Between numpy and VTK: arrays of both, meshes, tables, texts, and runs of filters, readers and writers."""

from __future__ import annotations

import os
import warnings
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
try:
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    from vtkmodules.vtkCommonCore import (
        VTK_CHAR, vtkBitArray, vtkCharArray, vtkPoints, vtkStringArray, vtkUnsignedCharArray)
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData
except ImportError as _error:
    raise ImportError(f"meshes are made with VTK, which is not there ({_error}); pip install vtk") from _error

from ._curves import CURVE_TYPES, KEY_SHAPES, Curve, curve_rows, surface_of
from ._errors import ArgumentTypeError, FlatteningError, MissingFileError
from ._options import WARPING, read_options, text_of
from ._report import Status, error_of, raise_refusal, warn_of
from ._result import Flattening, flattening_of
from ._types import Report


def as_text(value: Any) -> str:
    """A text of VTK, which gives bytes where they are no UTF-8."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def remedies_of(source: Any) -> List[Tuple[str, str]]:
    """The ways out that a filter or writer found for its last run."""
    names, subjects = source.GetStatusRemedies(), source.GetStatusRemedySubjects()
    return [(names.GetValue(k), as_text(subjects.GetValue(k)))
            for k in range(names.GetNumberOfValues())]


def texts_of(array: vtkStringArray) -> List[str]:
    """A string array as Python values."""
    return [as_text(array.GetValue(row)) for row in range(array.GetNumberOfValues())]


def values_of(field: Any, name: str) -> List[Any]:
    """An array of one component as Python values; empty where there is none."""
    array = field.GetAbstractArray(name)
    if array is None:
        return []
    if isinstance(array, vtkStringArray):
        return texts_of(array)
    values: List[Any] = vtk_to_numpy(array).tolist()
    return values


def table_of_arrays(data: Any) -> Dict[str, List[Any]]:
    """Arrays with a name as Python values."""
    names = [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())]
    return {name: values_of(data, name) for name in names if name}


def table_of(table: Any) -> Dict[str, List[Any]]:
    """The columns of a vtkTable."""
    return table_of_arrays(table.GetRowData())


def coordinates_of(mesh: vtkPolyData) -> NDArray[np.float64]:
    """A view of the points."""
    return np.asarray(vtk_to_numpy(mesh.GetPoints().GetData()), np.float64)


def corners_of(mesh: vtkPolyData) -> NDArray[np.int64]:
    """A view of the triangles."""
    return np.asarray(vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()), np.int64).reshape(-1, 3)


def numbers_of(data: Any, name: str) -> NDArray[Any]:
    """A view of an array that is there."""
    return np.asarray(vtk_to_numpy(data.GetArray(name)))


def points_of_cell(mesh: vtkPolyData, cell: int) -> List[int]:
    """Ids."""
    ids = mesh.GetCell(cell).GetPointIds()
    return [ids.GetId(k) for k in range(ids.GetNumberOfIds())]


def demand_memory(size: int) -> None:
    """MemoryError where VTK, which ends the process for it, would find no memory for so many bytes."""
    np.empty(3 * size + (1 << 20), np.uint8)


def to_vtk(values: NDArray[Any], deep: bool = True) -> Any:
    """A copy, or an array that has the same memory."""
    demand_memory(values.nbytes if deep else 0)
    return numpy_to_vtk(values, deep=deep)


def to_vtk_ids(values: NDArray[np.int64], deep: bool = True) -> Any:
    """A copy, or an array that has the same memory."""
    demand_memory(values.nbytes if deep else 0)
    return numpy_to_vtkIdTypeArray(values, deep=deep)


def make_points(coordinates: NDArray[np.float64], deep: bool = True) -> vtkPoints:
    """A copy, or points in the same memory."""
    points = vtkPoints()
    points.SetData(to_vtk(np.ascontiguousarray(coordinates), deep))
    return points


def _cells(offsets: NDArray[np.int64], connectivity: NDArray[np.int64]) -> vtkCellArray:
    result = vtkCellArray()
    result.SetData(to_vtk_ids(offsets.astype(np.int64)), to_vtk_ids(connectivity.astype(np.int64)))
    return result


def make_cells(cells: Sequence[NDArray[np.int64]]) -> vtkCellArray:
    """Cells of any number of points."""
    return _cells(np.cumsum([0] + [len(cell) for cell in cells]), np.concatenate(cells) if cells else np.empty(0, np.int64))


def make_triangles(corners: NDArray[np.int64]) -> vtkCellArray:
    """Cells of three corners each."""
    cells = vtkCellArray()
    cells.SetData(
        to_vtk_ids(np.arange(0, corners.size + 1, 3, dtype=np.int64)),
        to_vtk_ids(np.ascontiguousarray(corners).ravel()),
    )
    return cells


def named(name: str, array: Any) -> Any:
    """The array, with a name."""
    array.SetName(name)
    return array


def strings(name: str, values: Sequence[str]) -> vtkStringArray:
    """An array of texts."""
    array = vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


class Parts(NamedTuple):
    """The outputs of vtkWireWarpingFilter, with all of their arrays."""

    flat: vtkPolyData
    wires: vtkPolyData
    cut: vtkPolyData


def copy_of(mesh: vtkPolyData, mesh_class: Optional[type] = None) -> Any:
    """A deep copy, as a vtkPolyData or as an object of a class that derives from it."""
    demand_memory(1024 * mesh.GetActualMemorySize())
    copy = vtkPolyData()
    copy.DeepCopy(mesh)
    if mesh_class is None or isinstance(copy, mesh_class):
        return copy
    try:
        return mesh_class(copy)
    except TypeError:  # it takes no data set to begin with
        other: Any = mesh_class()
        other.ShallowCopy(copy)
        return other


def _add(data: Any, arrays: Mapping[str, Any], deep: bool = True) -> None:
    for name, values in arrays.items():
        if isinstance(values, list):
            data.AddArray(strings(name, values))
        elif len(values) > 0 or data.IsA("vtkDataSetAttributes"):
            array = np.ascontiguousarray(values)
            data.AddArray(named(name, (to_vtk_ids if array.dtype == np.int64 else to_vtk)(array, deep)))


def parts_of(result: Flattening) -> Parts:
    """The outputs of vtkWireWarpingFilter for a result: its own, or made of its arrays, whose memory they have."""
    if result._parts is not None:
        return result._parts
    flat, wires, cut = vtkPolyData(), vtkPolyData(), vtkPolyData()
    flat.SetPoints(make_points(np.column_stack([result.positions, np.zeros(len(result.positions))])))
    cut.SetPoints(make_points(result.points, deep=False))
    wires.SetPoints(flat.GetPoints())
    wires.SetLines(make_cells([wire.vertices for wire in result.wires]))
    for mesh in (flat, cut):
        mesh.SetPolys(make_triangles(result.triangles))
        _add(mesh.GetCellData(), result.cell_arrays, deep=False)
        mesh.GetCellData().SetActiveScalars("HomogeneityOfDistortion")
    for mesh in (flat, wires, cut):
        _add(mesh.GetPointData(), result.point_arrays, deep=False)
    _add(cut.GetPointData(), {"FlatPositions": result.positions}, deep=False)
    cut.GetPointData().SetActiveTCoords("FlatPositions")
    _add(wires.GetCellData(), result._wire_arrays, deep=False)
    wires.GetCellData().SetActiveScalars("WireKind")
    _add(flat.GetFieldData(), result._field_arrays, deep=False)
    return Parts(flat, wires, cut)


def mesh_of_data(data: Mapping[str, Any], shared: Optional[vtkPolyData] = None) -> vtkPolyData:
    """A mesh of points, polygons, lines and arrays, with the points of another mesh where one is given."""
    mesh = vtkPolyData()
    mesh.SetPoints(shared.GetPoints() if shared is not None else make_points(data["points"]))
    if "offsets" in data and len(data["offsets"]) > 1:
        mesh.SetPolys(_cells(data["offsets"], data["corners"]))
    if data.get("lines"):
        mesh.SetLines(make_cells(data["lines"]))
    _add(mesh.GetPointData(), data.get("point_arrays", {}))
    _add(mesh.GetCellData(), data.get("cell_arrays", {}))
    _add(mesh.GetFieldData(), data.get("field_arrays", {}))
    return mesh


def as_numpy(array: Any) -> NDArray[Any]:
    """A view; of bits a copy."""
    if isinstance(array, vtkBitArray):
        bytes_ = vtkUnsignedCharArray()
        bytes_.DeepCopy(array)
        return np.array(vtk_to_numpy(bytes_), np.bool_)
    return np.asarray(vtk_to_numpy(array))


def arrays_of(attributes: Any) -> Dict[str, NDArray[Any]]:
    result = {}
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(index)  # None for strings
        if array is not None and array.GetName():
            result[array.GetName()] = as_numpy(array)
    return result


def bytes_of(mesh: vtkPolyData) -> bytes:
    from vtkmodules.vtkParallelCore import vtkCommunicator
    named, buffer = vtkPolyData(), vtkCharArray()
    named.ShallowCopy(mesh)
    for data in (named.GetPointData(), named.GetCellData()):
        for k in reversed(range(data.GetNumberOfArrays())):
            if not data.GetArrayName(k):
                data.RemoveArray(k)  # it would get a name
    vtkCommunicator.MarshalDataObject(named, buffer)
    return bytes(vtk_to_numpy(buffer))


def status_of(source: Any) -> Status:
    """How the last run of a filter, writer or reader ended."""
    name = source.GetStatusName() if hasattr(source, "GetStatusName") else "InvalidFile"
    remedies = remedies_of(source) if hasattr(source, "GetStatusRemedies") else []
    is_filter = hasattr(source, "GetStatusIdKind")
    return (source.GetStatusCode() if is_filter else -1, name,
            as_text(source.GetStatusDefect()) if hasattr(source, "GetStatusDefect") else "",
            vtk_to_numpy(source.GetStatusIds()).tolist() if is_filter else [],
            source.GetStatusIdKind() if is_filter else "", remedies)


def mesh_of(content: bytes) -> vtkPolyData:
    """That of which :func:`bytes_of` are these."""
    from vtkmodules.vtkParallelCore import vtkCommunicator
    mesh = vtkPolyData()
    vtkCommunicator.UnMarshalDataObject(
        numpy_to_vtk(np.frombuffer(content, np.int8), array_type=VTK_CHAR), mesh)
    return mesh


def silence(algorithm: Any) -> None:
    """Errors and warnings are exceptions and warnings here, instead of lines on stderr."""
    for source in (algorithm, algorithm.GetExecutive()):
        for event in ("ErrorEvent", "WarningEvent"):
            source.AddObserver(event, _ignore)


def _ignore(*_: Any) -> None:
    """A function that refers to nothing."""


def update(filter_: Any, progress: Optional[Callable[[float], Any]] = None, finishes: bool = False) -> None:
    """Updates the filter; its messages become exceptions and warnings instead of lines on stderr.

    finishes: after KeyboardInterrupt the filter may end with what it has found so far.
    """
    raised: List[BaseException] = []

    def tell(*_: Any) -> None:
        # VTK would print what escapes from here and go on.
        try:
            if progress is not None and not raised:
                progress(filter_.GetProgress())
        except BaseException as error:  # also KeyboardInterrupt
            raised.append(error)
            filter_.AbortExecuteOn()

    silence(filter_)
    tag = filter_.AddObserver("ProgressEvent", tell)
    try:
        filter_.Update()
    finally:
        filter_.RemoveObserver(tag)  # it refers to the filter
    found = finishes and raised and isinstance(raised[0], KeyboardInterrupt) and not filter_.IsRefused()
    if raised and not found:
        raise raised[0]
    run = run_of(filter_)
    raise_refusal(run)
    warn_of(run, 3)


def run_of(filter_: Any) -> Dict[str, Any]:
    """What a filter says of its last run."""
    return {"status": status_of(filter_), "refused": filter_.IsRefused(), "warnings": texts_of(filter_.GetStatusWarnings())}


def arrays_of_parts(parts: Parts) -> Dict[str, Any]:
    """Those that a result has, but tables."""
    flat, wires, cut = parts
    cells, fields = wires.GetCellData(), flat.GetFieldData()
    return {
        "positions": coordinates_of(flat)[:, :2], "triangles": corners_of(flat), "points": coordinates_of(cut),
        "point_arrays": arrays_of(flat.GetPointData()), "cell_arrays": arrays_of(flat.GetCellData()),
        "field_arrays": arrays_of(fields), "wires": [
            np.array(points_of_cell(wires, row), np.int64) for row in range(wires.GetNumberOfCells())],
        "wire_arrays": table_of_arrays(cells)}


def result_of(filter_: Any, mesh_class: type) -> Flattening:
    """The outputs of a filter that has flattened."""
    parts = Parts(*(filter_.GetOutput(port) for port in range(3)))
    given = arrays_of_parts(parts)
    given["tables"] = {name: table_of(table) for name, table in (
        ("pieces", filter_.GetPieces()), ("curves", filter_.GetCurves()),
        ("angle_iterations", filter_.GetAngleIterations()),
        ("isometric_iterations", filter_.GetIsometricIterations()), ("releases", filter_.GetReleases()),
        ("piece_remedies", filter_.GetPieceRemedies()), ("left_out", filter_.GetLeftOutPieces()))}
    given["seconds"] = filter_.GetSeconds()
    return flattening_of(run_of(filter_), given, parts, mesh_class)


def unpickled(flat: bytes, wires: bytes, cut: bytes, report: Report, mesh_class: type) -> Flattening:
    """A result of a mesh, of which bytes_of() was sent."""
    parts = Parts(*map(mesh_of, (flat, wires, cut)))
    parts.wires.SetPoints(parts.flat.GetPoints())  # as the filter gives them
    return flattening_of({}, arrays_of_parts(parts), parts, mesh_class, report)


def make_filter(options: Mapping[str, Any], function: str, owner: str = WARPING) -> Any:
    """A filter with these options, or an exception that names the wrong one."""
    from . import vtkFiltersFlattening

    owner, values = read_options(options, function, owner)
    filter_ = getattr(vtkFiltersFlattening, owner)()
    filter_.CachingOff()  # it runs once
    set_properties(filter_, values)
    return filter_


_ADDERS = {"CurveTolerances": "AddCurveTolerance", "CurveEases": "AddCurveEase", "Preferences": "AddPreference",
           "KeptCurves": "AddKeptCurve"}


def set_properties(filter_: Any, values: Mapping[str, Any]) -> None:
    """Sets properties and lists to values that are known to be right."""
    for property_, value in values.items():
        if property_ in _ADDERS:
            for row in value:
                getattr(filter_, _ADDERS[property_])(*row)
        elif hasattr(filter_, "Set" + property_):  # a scheme of its own has not all of them
            getattr(filter_, "Set" + property_)(value)


def make_surface(points: ArrayLike, triangles: Optional[ArrayLike]) -> vtkPolyData:
    """The surface as vtkPolyData, for the filters.

    Args:
        points: positions in any unit of length, shape (n, 3). Whole numbers are coordinates as well.
        triangles: ids of their corners, counted from 0, shape (m, 3); or a flat list of polygons, each
            the number of its corners and then their ids, as PyVista's `faces`.

    Raises:
        ValueError: another shape, ids that are not whole numbers, masked values, or whole numbers as
            coordinates beyond 2**53.
    """
    coordinates, corners, offsets = surface_of(points, triangles)
    surface = vtkPolyData()
    surface.SetPoints(make_points(coordinates))
    surface.SetPolys(make_triangles(corners) if offsets is None else _cells(offsets, corners))
    return surface


def make_curves(curves: Sequence[Union[Curve, ArrayLike]], points: ArrayLike) -> vtkPolyData:
    """Feature curves as vtkPolyData, polylines with the arrays that the filters read.

    Args:
        curves: each a :class:`Curve`, or what its `points` may be.
        points: positions of the surface, shape (n, 3), that point ids refer to.

    Raises:
        TypeError: a name that is no string.
        ValueError: a wrong shape or word, a point that the surface does not have, or a name with
            NUL or what UTF-8 cannot hold.
    """
    rows = curve_rows(curves, points)
    ends = np.cumsum([0] + [len(row.positions) for row in rows])
    result = vtkPolyData()
    result.SetPoints(make_points(np.concatenate([row.positions for row in rows] or [np.empty((0, 3))])))
    result.SetLines(_cells(ends, np.arange(ends[-1])))
    _add(result.GetCellData(), {
        "CurveName": [row.name for row in rows],
        "CurveType": np.array([row.type for row in rows], np.int32),
        "KeyShape": np.array([row.key_shape for row in rows], np.int32),
        "LengthTolerance": np.array([row.tolerance for row in rows], np.float64)})
    if any(row.planar_shape is not None for row in rows):
        _add(result.GetPointData(), {"PlanarShape": np.concatenate([
            np.full((len(row.positions), 2), np.nan) if row.planar_shape is None else row.planar_shape for row in rows])})
    return result


def make_curves_of(data: vtkPolyData) -> List[Curve]:
    """The polylines of a filter's curves, with the arrays that it gives them."""
    table, planar = table_of_arrays(data.GetCellData()), data.GetPointData().GetArray("PlanarShape")
    curves = []
    for cell, (kind, name, shape, tolerance) in enumerate(zip(*(
            table.get(column, []) for column in ("CurveType", "CurveName", "KeyShape", "LengthTolerance")))):
        chain = points_of_cell(data, cell)
        rows = None if planar is None else as_numpy(planar)[chain]
        curves.append(Curve(chain, CURVE_TYPES[kind], name, KEY_SHAPES[shape], tolerance,
                            rows if rows is not None and np.isfinite(rows).all() else None))
    return curves


def triangulated(mesh: vtkPolyData) -> Tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Points and triangles, as the filters divide polygons and strips."""
    from .vtkFiltersFlattening import vtkFlatteningAlgorithm

    triangles = vtkPolyData()
    vtkFlatteningAlgorithm.Triangulate(mesh, triangles)
    if triangles.GetNumberOfPoints() == 0:
        return np.empty((0, 3)), np.empty((0, 3), np.int64)
    return coordinates_of(triangles), corners_of(triangles)


def demand_polydata(data: Any, what: str, hint: str = "") -> None:
    """TypeError where the pipeline would print an error and give no result."""
    if not isinstance(data, vtkPolyData):
        raise ArgumentTypeError(f"{what} is {type(data).__name__}; it must be a vtkPolyData{hint}")


def curves_on(
    surface: vtkPolyData, curves: Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]]
) -> Optional[vtkPolyData]:
    """Feature curves of a mesh, as they are or made from a list, whose ids are those of its points."""
    if curves is None or isinstance(curves, vtkPolyData):
        return curves
    if isinstance(curves, (str, bytes, vtkDataObject)) or not isinstance(curves, Sequence):
        demand_polydata(curves, "curves", " or a list of curves")
    points = surface.GetPoints()
    return make_curves(
        curves, np.empty((0, 3)) if points is None else coordinates_of(surface))
