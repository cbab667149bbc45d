# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and feature curves of numpy arrays."""

from __future__ import annotations  # help() prints hints as they are written here

import os
from dataclasses import dataclass
from numbers import Integral
from typing import (
    TYPE_CHECKING, Any, Callable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, cast, get_args
)

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._equality import ComparedByValue
from ._errors import ArgumentError, ArgumentTypeError
from ._options import index_of, text_of
from ._pieces import Data
from ._report import values_in
from ._types import CurveType, KeyShape

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

# In the order of vtkFeatureCurveAlgorithm.CurveTypes.
CURVE_TYPES: Tuple[CurveType, ...] = get_args(CurveType)
KEY_SHAPES: Tuple[KeyShape, ...] = get_args(KeyShape)
# Types in text files of the command alone, and what they are here.
_WORDS_OF_FILES = {
    "straight": 'it is type="key", key_shape="straight"',
    "edge": 'it is type="accessory" with the ids of all points along the border',
}
# The largest whole number below which float64 holds all of them.
_EXACT = 2**53


@dataclass(frozen=True, eq=False)
class Curve(ComparedByValue):
    """A feature curve of :func:`flatten`.

    Attributes:
        points: the curve from end to end, either ids of the surface's points, counted from 0
            (integers, shape (k,)), or positions on the surface in its unit of length (shape
            (k, 3), also of integers); they need not be vertices. k is at least 2.
        type: "accessory", length kept, shape free (default); "key", length and shape kept; "dart",
            cut open; "seam", cut through. Upper and lower case are the same.
        name: its name in messages and in the report. Default: "curve N", N its place in the list.
        key_shape: of a key curve: "surface", the shape that its angles on the surface give
            (default), or "straight".
        length_tolerance: how much lengths may differ from those on the surface, as a fraction in [0, 1).
            Default: 0, the curve is rigid.
        planar_shape: of a key curve: a polyline in the plane, shape (k, 2), whose turning angles
            the curve takes; lengths stay those on the surface. Default: none.
    """

    points: ArrayLike
    type: CurveType = "accessory"
    name: str = ""
    key_shape: KeyShape = "surface"
    length_tolerance: float = 0.0
    planar_shape: Optional[ArrayLike] = None

    def __repr__(self) -> str:
        """In a line; values may be of any kind until they are taken."""
        words, points = [str(self.type)], cast(Any, self.points)
        if str(self.key_shape) != "surface":
            words.append(str(self.key_shape))
        if self.planar_shape is not None:
            words.append("planar shape")
        if str(self.length_tolerance) not in ("0", "0.0"):
            words.append(f"length_tolerance {self.length_tolerance!r}")
        if hasattr(points, "__len__") and getattr(points, "shape", None) != ():
            words.append(f"{len(points)} points")
        return f"<Curve{f' {self.name!r}' if self.name else ''}: {', '.join(words)}>"


def _is_masked(values: Any) -> bool:
    """Whether a value is hidden behind a mask, also in arrays within lists, whose masks numpy drops."""
    if isinstance(values, (list, tuple)):
        return any(isinstance(value, (list, tuple, np.ma.MaskedArray)) and _is_masked(value)
                   for value in values)
    has_mask: Callable[[Any], bool] = np.ma.is_masked
    return has_mask(values)


def _as_array(values: Any, what: str) -> NDArray[Any]:
    """An array of any type, with no value hidden behind a mask."""
    if _is_masked(values):
        raise ArgumentError(f"{what}: some values are masked, and a masked value is none; remove what is "
                            "masked, or give the values with .filled() or .data")
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ArgumentError(f"{what} must be an array with rows of one length: {error}") from None


def as_numbers(values: Any, what: str) -> NDArray[np.float64]:
    array = _as_array(values, what)
    if np.iscomplexobj(array):
        raise ArgumentError(f"{what} must be real numbers, not {array.dtype}")
    if array.dtype.kind in "bmM":
        raise ArgumentError(f"{what} must be numbers, not {array.dtype}")
    if array.dtype.kind in "iu":
        inexact = array[(array > _EXACT) | (array < -_EXACT)]
        if inexact.size:
            raise ArgumentError(f"{what} hold the whole number {inexact[0]}; coordinates are exact up to "
                                "2**53; take a larger unit")
    try:
        return array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise ArgumentError(f"{what} must be numbers: {error}") from None


def _as_ids(values: Any, what: str) -> NDArray[np.int64]:
    array = _as_array(values, what)
    kind = array.dtype
    if kind == np.float64 and not isinstance(values, np.ndarray):
        array = np.asarray(values, object)  # ids of which one is too large are not floats
    if array.dtype == object and all(
            isinstance(value, Integral) and not isinstance(value, bool) for value in array.flat):
        too_large = [value for value in array.flat if not -2**63 <= value < 2**63]
    elif array.size and not np.issubdtype(array.dtype, np.integer):
        hint = "; .astype(int) makes ids of floats that are whole" if kind.kind == "f" else ""
        raise ArgumentError(f"{what} must be whole numbers, not {kind}{hint}")
    else:
        too_large = array[array >= 2**63].tolist() if array.dtype == np.uint64 else []
    if too_large:
        raise ArgumentError(f"{what} hold {too_large[0]}; ids are below 2**63")
    return array.astype(np.int64)


def _name_of(curve: "Curve", place: int) -> str:
    """The name as files can hold it; they end at NUL."""
    name = text_of(f"the name of curve {place}", curve.name)
    if "\0" in name:
        raise ArgumentError(f"the name of curve {place}, {name!r}, holds the character NUL")
    return name


def _polygons(faces: NDArray[np.int64]) -> Iterator[NDArray[np.int64]]:
    """Of a flat list: each the number of its corners and then their ids."""
    at = 0
    while at < len(faces):
        count = int(faces[at])
        if count < 3 or at + count >= len(faces):
            raise ArgumentError(
                f"triangles as a flat list must be polygons, each the number of its corners and then "
                f"their ids; at {at} there are {count} corners, with {len(faces) - at - 1} values left")
        yield faces[at + 1:at + 1 + count]
        at += 1 + count


def surface_data(points: ArrayLike, triangles: Optional[ArrayLike]) -> Data:
    """The arrays given as the algorithms take them, or what is wrong with them."""
    if hasattr(points, "GetDataObjectType"):
        raise ArgumentTypeError(f"points is {type(points).__name__}; it must be an array of positions. Meshes are taken by "
                                "flatten_polydata(), suggest_polydata() and make_flattenable_polydata()")
    if isinstance(points, (str, os.PathLike)):
        raise ArgumentTypeError(f"points is {points!r}; it must be an array of positions. Files are read by load_surface(): "
                                "flatten(*load_surface(path)[:3])")
    if isinstance(points, tuple) and hasattr(points, "triangles"):
        raise ArgumentTypeError("points is what load_surface() gave; give its parts: flatten(*surface[:3])")
    if triangles is None:
        raise ArgumentTypeError("triangles are missing; give the ids of their corners, shape (m, 3)")
    coordinates = as_numbers(points, "points")
    if coordinates.ndim != 2 or coordinates.shape[1] != 3:
        hint = "; add a column of zeros for z" if coordinates.shape[1:] == (2,) else ""
        raise ArgumentError(f"points must have the shape (n, 3), not {coordinates.shape}{hint}")
    corners = _as_ids(triangles, "triangles")
    flat = corners.ndim == 1 and corners.size > 0
    if not flat and (corners.ndim != 2 or corners.shape[1] != 3):
        hint = "; quads are taken as a flat list" if corners.shape[1:] == (4,) else ""
        raise ArgumentError(
            f"triangles must have the shape (m, 3), or be a flat list, not {corners.shape}{hint}")
    if not flat:
        return {"points": coordinates, "corners": corners}
    if corners.size % 4 == 0 and (corners[::4] == 3).all():
        return {"points": coordinates, "corners": corners.reshape(-1, 4)[:, 1:]}
    polygons = list(_polygons(corners))
    return {"points": coordinates, "corners": np.concatenate(polygons),
            "offsets": np.cumsum([0] + [len(polygon) for polygon in polygons])}


def _positions_of(curve: Curve, what: str, surface: NDArray[np.float64]) -> NDArray[np.float64]:
    values = _as_array(curve.points, what)
    if values.ndim == 2 and values.shape[1] == 3:
        positions = as_numbers(values, what)
    elif values.ndim == 1:
        ids = _as_ids(curve.points, f"the point ids of {what}")
        outside = ids[(ids < 0) | (ids >= len(surface))]
        if outside.size:
            raise ArgumentError(
                f"{what} names point {outside[0]}; the surface has points 0 to {len(surface) - 1}"
            )
        positions = surface[ids]
    else:
        raise ArgumentError(f"{what} must have the shape (k,) or (k, 3), not {values.shape}")
    if len(positions) < 2:
        raise ArgumentError(f"{what} has {len(positions)} points; give it at least 2")
    return positions


def _small(word: Any) -> Any:
    """A word without capitals, as the command takes it from its text files."""
    return word.lower() if isinstance(word, str) else word


def _type_of(curve: Curve, what: str) -> int:
    kind = _small(curve.type)
    if isinstance(kind, str) and kind in _WORDS_OF_FILES:
        raise ArgumentError(f"the type of {what} is {curve.type!r}, a word of the command's text files; here "
                            f"{_WORDS_OF_FILES[kind]}")
    return index_of(kind, CURVE_TYPES, f"the type of {what}")


def _tolerance_of(curve: Curve, what: str) -> float:
    try:
        return float(curve.length_tolerance)
    except (TypeError, ValueError):
        raise ArgumentError(
            f"the length_tolerance of {what} is {curve.length_tolerance!r}; it must be a number"
        ) from None


def weighted(data: Data, options: Mapping[str, Any]) -> Mapping[str, Any]:
    """The options with weights by the name of a cell array, which the surface gets where they are numbers."""
    weights = options.get("weights")
    if weights is None or isinstance(weights, str):
        return options
    numbers = as_numbers(weights, "weights")
    cells = len(data["offsets"]) - 1 if "offsets" in data else data["corners"].size // 3
    if numbers.shape != (cells,):
        raise ArgumentError(f"weights must have the shape ({cells},), a number for each triangle, not {numbers.shape}")
    data["cell_arrays"] = {**data.get("cell_arrays", {}), "Weight": numbers}
    return {**options, "weights": "Weight"}


def _demand_list(curves: Any) -> None:
    """One curve alone would be taken for a list of curves."""
    alone = isinstance(curves, (Curve, str))
    if isinstance(curves, np.ndarray) and curves.dtype != object:
        alone = curves.ndim == 1 and curves.size > 0 or curves.ndim == 2 and curves.dtype.kind == "f"
    elif isinstance(curves, tuple) and any(isinstance(value, str) for value in curves):
        raise ArgumentTypeError(f"curves is {curves!r}; put a curve with a type into brackets: [sf.Curve(points, \"dart\")]")
    elif isinstance(curves, (list, tuple, range)) and len(curves) > 0:
        alone = isinstance(curves[0], (Integral, float))
    if alone:
        raise ArgumentTypeError("curves must be a list of curves; put a single one into brackets: [curve]")


def curve_data(curves: Sequence[Union[Curve, ArrayLike]], points: ArrayLike) -> Data:
    """The curves given as the algorithms take them, or what is wrong with them; ids are those of these points."""
    surface = as_numbers(points, "points")
    _demand_list(curves)
    chains: List[NDArray[np.float64]] = []
    shapes: List[NDArray[np.float64]] = []
    rows = []
    for place, given in enumerate(curves):
        if isinstance(given, (tuple, list)) and any(isinstance(value, str) for value in given):
            raise ArgumentTypeError(f"curve {place} is {given!r}; a curve with a type is sf.Curve(points, \"dart\")")
        curve = given if isinstance(given, Curve) else Curve(given)
        # Its name also keeps a curve of two points apart from the next.
        name = _name_of(curve, place) or f"curve {place}"
        what = f"curve {place}" + (f" ({curve.name!r})" if curve.name else "")
        chains.append(_positions_of(curve, what, surface))
        rows.append((name, _type_of(curve, what), index_of(_small(curve.key_shape), KEY_SHAPES, f"the key_shape of {what}"),
                     _tolerance_of(curve, what)))
        expected = (len(chains[-1]), 2)
        shapes.append(np.full(expected, np.nan) if curve.planar_shape is None else
                      as_numbers(curve.planar_shape, f"the planar_shape of {what}"))
        if shapes[-1].shape != expected:
            raise ArgumentError(f"the planar_shape of {what} must have the shape {expected}, not {shapes[-1].shape}")
    names, types, key_shapes, tolerances = zip(*rows) if rows else ((), (), (), ())
    ends = np.cumsum([0] + [len(chain) for chain in chains])
    shaped = any(isinstance(curve, Curve) and curve.planar_shape is not None for curve in curves)
    return {
        "points": np.concatenate(chains or [np.empty((0, 3))]), "lines": [np.arange(*pair) for pair in zip(ends, ends[1:])],
        "cell_arrays": {
            "CurveName": list(names), "CurveType": np.array(types, np.int32), "KeyShape": np.array(key_shapes, np.int32),
            "LengthTolerance": np.array(tolerances, np.float64)},
        "point_arrays": {"PlanarShape": np.concatenate(shapes)} if shaped else {}}


def curves_of(data: Data) -> List[Curve]:
    """Those of polylines with the arrays that the algorithms give them."""
    arrays, planar = data["cell_arrays"], data["point_arrays"].get("PlanarShape")
    count, curves = len(data["lines"]), []
    for line, kind, name, shape, tolerance in zip(
            data["lines"], values_in(arrays, "CurveType"), values_in(arrays, "CurveName"),
            values_in(arrays, "KeyShape") or [0] * count, values_in(arrays, "LengthTolerance") or [0.0] * count):
        rows = None if planar is None else planar[line]
        curves.append(Curve(line, CURVE_TYPES[kind], name, KEY_SHAPES[shape], tolerance,
                            rows if rows is not None and np.isfinite(rows).all() else None))
    return curves


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
    from ._vtk import mesh_of_data
    mesh: vtkPolyData = mesh_of_data(surface_data(points, triangles))
    return mesh


def make_curves(curves: Sequence[Union[Curve, ArrayLike]], points: ArrayLike) -> vtkPolyData:
    """Feature curves as vtkPolyData, polylines with the arrays that the filters read.

    Args:
        curves: each a :class:`Curve`, or what its `points` may be.
        points: positions of the surface, shape (n, 3), that point ids refer to.

    Raises:
        TypeError: a name that is not a string.
        ValueError: a wrong shape or word, a point that the surface does not have, or a name with
            NUL or what UTF-8 cannot hold.
    """
    from ._vtk import mesh_of_data
    mesh: vtkPolyData = mesh_of_data(curve_data(curves, points))
    return mesh
