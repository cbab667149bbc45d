# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and feature curves of numpy arrays as vtkPolyData."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from numbers import Integral
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# In the order of vtkFeatureCurveAlgorithm.CurveTypes.
CURVE_TYPES = ("accessory", "key", "dart", "seam")
KEY_SHAPES = ("surface", "straight")


@dataclass(frozen=True)
class Curve:
    """A feature curve of :func:`flatten`.

    Attributes:
        points: the curve from end to end, either ids of the surface's points, counted from 0
            (integers, shape (k,)), or positions on the surface in its unit of length (shape
            (k, 3)); they need not be vertices. k is at least 2.
        type: "accessory", length kept, shape free (default); "key", length and shape kept; "dart",
            cut open; "seam", cut through.
        name: its name in messages and in the report. Default: "curve N", N its place in the list.
        key_shape: of a key curve: "surface", the shape that its angles on the surface give
            (default), or "straight".
        length_tolerance: how far lengths may go from those on the surface, as a fraction in [0, 1).
            Default: 0, the curve is rigid.
        planar_shape: of a key curve: a polyline in the plane, shape (k, 2), whose turning angles
            the curve takes; lengths stay those on the surface. Default: none.
    """

    points: ArrayLike
    type: str = "accessory"
    name: str = ""
    key_shape: str = "surface"
    length_tolerance: float = 0.0
    planar_shape: Optional[ArrayLike] = None


def _demand_memory(values: NDArray[Any]) -> None:
    """MemoryError where VTK, which ends the process for it, would find no memory for a copy."""
    np.empty(3 * values.nbytes + (1 << 20), np.uint8)


def _to_vtk(values: NDArray[Any]) -> Any:
    """A copy."""
    _demand_memory(values)
    return numpy_to_vtk(values, deep=True)


def _to_vtk_ids(values: NDArray[np.int64]) -> Any:
    """A copy."""
    _demand_memory(values)
    return numpy_to_vtkIdTypeArray(values, deep=True)


def _make_points(coordinates: NDArray[np.float64]) -> vtkPoints:
    points = vtkPoints()
    points.SetData(_to_vtk(np.ascontiguousarray(coordinates)))
    return points


def _make_cells(cells: Sequence[NDArray[np.int64]]) -> vtkCellArray:
    offsets = np.cumsum([0] + [len(cell) for cell in cells], dtype=np.int64)
    connectivity = np.concatenate(cells) if cells else np.empty(0, np.int64)
    result = vtkCellArray()
    result.SetData(
        _to_vtk_ids(offsets),
        _to_vtk_ids(connectivity.astype(np.int64)),
    )
    return result


def _as_array(values: Any, what: str) -> NDArray[Any]:
    """An array of any type, with no value hidden behind a mask."""
    if np.ma.is_masked(values):
        raise ValueError(f"{what} has masked values; fill or remove them")
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{what} must be an array with rows of one length: {error}") from None


def _as_numbers(values: Any, what: str) -> NDArray[np.float64]:
    array = _as_array(values, what)
    if np.iscomplexobj(array):
        raise ValueError(f"{what} must be real numbers, not {array.dtype}")
    try:
        return array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what} must be numbers: {error}") from None


def _as_ids(values: Any, what: str) -> NDArray[np.int64]:
    array = _as_array(values, what)
    kind = array.dtype
    if kind == np.float64 and not isinstance(values, np.ndarray):
        array = np.asarray(values, object)  # ids of which one is too large are no floats
    if array.dtype == object and all(
            isinstance(value, Integral) and not isinstance(value, bool) for value in array.flat):
        too_large = [value for value in array.flat if not -2**63 <= value < 2**63]
    elif array.size and not np.issubdtype(array.dtype, np.integer):
        raise ValueError(f"{what} must be whole numbers, not {kind}")
    else:
        too_large = array[array >= 2**63].tolist() if array.dtype == np.uint64 else []
    if too_large:
        raise ValueError(f"{what} hold {too_large[0]}; ids are below 2**63")
    return array.astype(np.int64)


def _name_of(curve: "Curve", place: int) -> str:
    """The name as VTK can take it: it ends the interpreter on a lone surrogate, files end at NUL."""
    name = curve.name
    if not isinstance(name, str):
        raise TypeError(f"the name of curve {place} is {name!r}; it must be a string")
    try:
        name.encode()
    except UnicodeEncodeError as error:
        raise ValueError(
            f"the name of curve {place}, {name!r}, is no text that UTF-8 can hold: {error.reason} "
            f"at {error.start}") from None
    if "\0" in name:
        raise ValueError(f"the name of curve {place}, {name!r}, holds the character NUL")
    return name


def make_surface(points: ArrayLike, triangles: ArrayLike) -> vtkPolyData:
    """The surface as vtkPolyData, for the filters.

    Args:
        points: positions in any unit of length, shape (n, 3).
        triangles: ids of their corners, counted from 0, shape (m, 3).

    Raises:
        ValueError: another shape, or ids that are not whole numbers.
    """
    coordinates = _as_numbers(points, "points")
    if coordinates.ndim != 2 or coordinates.shape[1] != 3:
        raise ValueError(f"points must have the shape (n, 3), not {coordinates.shape}")
    corners = _as_ids(triangles, "triangles")
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise ValueError(f"triangles must have the shape (m, 3), not {corners.shape}")
    offsets = np.arange(0, corners.size + 1, 3, dtype=np.int64)
    cells = vtkCellArray()
    cells.SetData(
        _to_vtk_ids(offsets),
        _to_vtk_ids(np.ascontiguousarray(corners).ravel()),
    )
    surface = vtkPolyData()
    surface.SetPoints(_make_points(coordinates))
    surface.SetPolys(cells)
    return surface


def _positions_of(curve: Curve, what: str, surface: NDArray[np.float64]) -> NDArray[np.float64]:
    values = _as_array(curve.points, what)
    if values.ndim == 2 and values.shape[1] == 3:
        positions = _as_numbers(values, what)
    elif values.ndim == 1:
        ids = _as_ids(curve.points, f"the point ids of {what}")
        outside = ids[(ids < 0) | (ids >= len(surface))]
        if outside.size:
            raise ValueError(
                f"{what} names point {outside[0]}; the surface has points 0 to {len(surface) - 1}"
            )
        positions = surface[ids]
    else:
        raise ValueError(f"{what} must have the shape (k,) or (k, 3), not {values.shape}")
    if len(positions) < 2:
        raise ValueError(f"{what} has {len(positions)} points; give it at least 2")
    return positions


def _index_of(value: str, names: Sequence[str], what: str) -> int:
    if not isinstance(value, str) or value not in names:
        raise ValueError(f"{what} is {value!r}; it must be one of {', '.join(names)}")
    return names.index(value)


def _tolerance_of(curve: Curve, what: str) -> float:
    try:
        return float(curve.length_tolerance)
    except (TypeError, ValueError):
        raise ValueError(
            f"the length_tolerance of {what} is {curve.length_tolerance!r}; it must be a number"
        ) from None


def _strings(name: str, values: Sequence[str]) -> vtkStringArray:
    array = vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


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
    surface = _as_numbers(points, "points")
    positions, shapes, names = [], [], []
    types, key_shapes, tolerances = [], [], []
    for place, given in enumerate(curves):
        curve = given if isinstance(given, Curve) else Curve(given)
        # Its name also keeps a curve of two points apart from the next.
        name = _name_of(curve, place) or f"curve {place}"
        what = f"curve {place}" + (f" ({curve.name!r})" if curve.name else "")
        positions.append(_positions_of(curve, what, surface))
        names.append(name)
        types.append(_index_of(curve.type, CURVE_TYPES, f"the type of {what}"))
        key_shapes.append(_index_of(curve.key_shape, KEY_SHAPES, f"the key_shape of {what}"))
        tolerances.append(_tolerance_of(curve, what))
        shape = np.full((len(positions[-1]), 2), np.nan)
        if curve.planar_shape is not None:
            planar = _as_numbers(curve.planar_shape, f"the planar_shape of {what}")
            if planar.shape != shape.shape:
                raise ValueError(
                    f"the planar_shape of {what} must have the shape {shape.shape}, not {planar.shape}"
                )
            shape = planar
        shapes.append(shape)

    lines, first = [], 0
    for polyline in positions:
        lines.append(np.arange(first, first + len(polyline), dtype=np.int64))
        first += len(polyline)

    result = vtkPolyData()
    result.SetPoints(_make_points(np.concatenate(positions) if positions else np.empty((0, 3))))
    result.SetLines(_make_cells(lines))
    cell_data = result.GetCellData()
    cell_data.AddArray(_strings("CurveName", names))
    for array_name, values in (
        ("CurveType", np.array(types, np.int32)),
        ("KeyShape", np.array(key_shapes, np.int32)),
        ("LengthTolerance", np.array(tolerances, np.float64)),
    ):
        array = _to_vtk(values)
        array.SetName(array_name)
        cell_data.AddArray(array)
    if any(not np.isnan(shape).all() for shape in shapes):
        array = _to_vtk(np.concatenate(shapes))
        array.SetName("PlanarShape")
        result.GetPointData().AddArray(array)
    return result
