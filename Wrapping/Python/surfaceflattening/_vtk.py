# SPDX-License-Identifier: BSD-3-Clause
"""Between numpy and VTK: arrays of both, tables, texts, and runs of filters, readers and writers."""

from __future__ import annotations

import os
import warnings
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Type, Union, get_args

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    VTK_CHAR, vtkBitArray, vtkCharArray, vtkPoints, vtkStringArray, vtkUnsignedCharArray)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ._errors import ArgumentError, ArgumentTypeError, FileError, FlatteningError, FlatteningWarning, MissingFileError, OutOfMemoryError
from ._options import word_of
from ._remedies import make_message
from ._types import Part
from .vtkFiltersFlattening import vtkFlatteningAlgorithm

Row = Dict[str, Any]

_TRUTH_VALUES = (
    "overlaps_complete", "repaired", "released", "exact", "one_way", "sound", "converged", "several_shapes")
_KINDS: Dict[str, Type[FlatteningError]] = {
    "FileNotWritten": FileError, "FileNotFound": MissingFileError, "OutOfMemory": OutOfMemoryError}


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


def rows_of(table: Any, columns: Dict[str, str]) -> List[Row]:
    """The rows of a vtkTable, with some of its columns by other names; none where one is not there."""
    values = [values_of(table.GetRowData(), name) for name in columns.values()]
    rows = [dict(zip(columns, row)) for row in zip(*values)]
    for row in rows:
        row.update((key, bool(row[key])) for key in _TRUTH_VALUES if key in row)
    return rows


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


def to_vtk(values: NDArray[Any]) -> Any:
    """A copy."""
    demand_memory(values.nbytes)
    return numpy_to_vtk(values, deep=True)


def to_vtk_ids(values: NDArray[np.int64]) -> Any:
    """A copy."""
    demand_memory(values.nbytes)
    return numpy_to_vtkIdTypeArray(values, deep=True)


def make_points(coordinates: NDArray[np.float64]) -> vtkPoints:
    """A copy."""
    points = vtkPoints()
    points.SetData(to_vtk(np.ascontiguousarray(coordinates)))
    return points


def make_cells(cells: Sequence[NDArray[np.int64]]) -> vtkCellArray:
    """Cells of any number of points."""
    offsets = np.cumsum([0] + [len(cell) for cell in cells], dtype=np.int64)
    connectivity = np.concatenate(cells) if cells else np.empty(0, np.int64)
    result = vtkCellArray()
    result.SetData(
        to_vtk_ids(offsets),
        to_vtk_ids(connectivity.astype(np.int64)),
    )
    return result


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


def text_of(what: str, value: Any) -> str:
    """A string that VTK can hold, or an error that names what it is."""
    if not isinstance(value, str):
        raise ArgumentTypeError(f"{what} = {value!r} must be a string")
    try:
        value.encode()  # VTK ends the interpreter on a lone surrogate
    except UnicodeEncodeError as error:
        raise ArgumentError(f"{what} = {value!r} is no text that UTF-8 can hold: {error.reason}") from None
    return value


class Parts(NamedTuple):
    """The outputs of vtkWireWarpingFilter, with all of their arrays."""

    flat: vtkPolyData
    wires: vtkPolyData
    cut: vtkPolyData

    def copy(self, part: Part, mesh_class: Type[Any] = vtkPolyData) -> Any:
        """A deep copy of one, as a vtkPolyData or as an object of a class that derives from it."""
        mesh: vtkPolyData = getattr(self, word_of(part, get_args(Part), "part"))
        demand_memory(1024 * mesh.GetActualMemorySize())
        copy = vtkPolyData()
        copy.DeepCopy(mesh)
        if isinstance(copy, mesh_class):
            return copy
        try:
            return mesh_class(copy)
        except TypeError:  # it takes no data set to begin with
            other = mesh_class()
            other.ShallowCopy(copy)
            return other


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


def id_rows(field_data: Any, name: str, components: int) -> NDArray[np.int64]:
    array = field_data.GetAbstractArray(name)
    if array is None:
        return np.empty((0, components), np.int64)
    return np.asarray(vtk_to_numpy(array), np.int64).reshape(-1, components)


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


def error_of(source: Any, message: str = "") -> FlatteningError:
    """The error of the last run of a filter, writer or reader, or the warning that it is worth."""
    name = source.GetStatusName() if hasattr(source, "GetStatusName") else "InvalidFile"
    remedies = remedies_of(source) if hasattr(source, "GetStatusRemedies") else []
    is_filter = hasattr(source, "GetStatusIdKind")
    return _KINDS.get(name, FlatteningError)(
        source.GetStatusCode() if is_filter else -1, name, ids_of(source) if is_filter else [],
        message or make_message(as_text(source.GetStatusDefect()), remedies),
        source.GetStatusIdKind() if is_filter else "", remedies)


def mesh_of(content: bytes) -> vtkPolyData:
    """That of which :func:`bytes_of` are these."""
    from vtkmodules.vtkParallelCore import vtkCommunicator
    mesh = vtkPolyData()
    vtkCommunicator.UnMarshalDataObject(
        numpy_to_vtk(np.frombuffer(content, np.int8), array_type=VTK_CHAR), mesh)
    return mesh


def ids_of(filter_: Any) -> List[int]:
    """The offending elements of its last run."""
    ids: List[int] = vtk_to_numpy(filter_.GetStatusIds()).tolist()
    return ids


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

    if filter_.IsRefused():
        raise error_of(filter_)
    for warning in texts_of(filter_.GetStatusWarnings()):
        warnings.warn(warning, FlatteningWarning, stacklevel=4)
    if filter_.GetStatusCode() != vtkFlatteningAlgorithm.OK:
        warnings.warn(str(error_of(filter_)), FlatteningWarning, stacklevel=4)


def read_file(reader: Any, path: Union[str, os.PathLike[str]]) -> None:
    """Updates a reader, or raises what it says."""
    silence(reader)
    reader.SetFileName(text_of("path", os.fspath(path)))
    reader.Update()
    message = as_text(reader.GetErrorMessage())
    if message:
        missing = not os.path.exists(path)
        raise MissingFileError(-1, "FileNotFound", [], message) if missing else error_of(reader, message)
