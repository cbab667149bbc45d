# SPDX-License-Identifier: BSD-3-Clause
"""A surface moved as little as it takes to lie flat with little strain."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import CURVE_TYPES, KEY_SHAPES, Curve
from ._equality import ComparedByValue
from ._options import with_options
from ._result import Flattening
from ._vtk import (
    coordinates_of, corners_of, curves_on, demand_polydata, make_curves, make_filter, make_surface, numbers_of, points_of_cell,
    result_of, update, values_of)

_OWNER = "vtkMakeFlattenable"


@dataclass(frozen=True, eq=False)
class Flattenable(ComparedByValue):
    """A surface that was moved until it lies flat with little strain, and its flat pieces."""

    #: Where the points lie; those of the surface given, behind them those at which curves cross
    #: edges. float64, shape (n, 3).
    points: NDArray[np.float64]
    #: int64, shape (m, 3).
    triangles: NDArray[np.int64]
    #: From the design to the moved surface; float64, shape (n, 3).
    shift: NDArray[np.float64]
    #: Which points were not to be moved; bool, shape (n,).
    kept: NDArray[np.bool_]
    #: The curves on the moved surface, ready for :func:`flatten`.
    curves: List[Curve]
    #: Whether the strain of every piece is within the bound.
    bound_met: bool
    #: The largest strain on 95 % of a piece, before and after.
    strain_before: float
    strain_after: float
    #: Root of the area of the design, unit of length.
    size: float
    #: How far the points were moved: mean and maximum, by area; unit of length.
    shift_mean: float
    shift_max: float
    #: The mean, by area, of the part of the shift along the normals of the design; below 0 inwards.
    shift_outwards_mean: float
    #: How far a point was moved inwards, at most; 0: none was.
    shift_inwards_max: float
    #: The flat pieces of the moved surface.
    flattening: Flattening

    def __repr__(self) -> str:
        return (f"<Flattenable: moved by at most {self.shift_max:.4g}, strain {self.strain_before:.3g} -> "
                f"{self.strain_after:.3g}, bound {'met' if self.bound_met else 'not met'}; {self.flattening!r}>")


@with_options(_OWNER)
def make_flattenable(
    points: ArrayLike,
    triangles: Optional[ArrayLike] = None,  # make_surface() says what is missing
    curves: Sequence[Union[Curve, ArrayLike]] = (),
    *,
    body: Optional[vtkPolyData] = None,
    **options: Any,
) -> Flattenable:
    """Moves a surface as little as it takes to lie flat with little strain, and flattens it.

    Args:
        points, triangles, curves: as for :func:`flatten`.
        _OPTIONS_
        body: a surface that is not entered, its normals outwards, such as :func:`make_surface` makes of
            points and triangles.
        options: the options of :func:`flatten`.

    Raises and warns as :func:`flatten` does; a bound that is not met is a FlatteningWarning.
    """
    return _make_flattenable(make_surface(points, triangles), make_curves(curves, points), body, **options)


@with_options(_OWNER)
def make_flattenable_polydata(
    surface: vtkPolyData,
    curves: Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]] = None,
    *,
    body: Optional[vtkPolyData] = None,
    **options: Any,
) -> Flattenable:
    """:func:`make_flattenable` for a vtkPolyData, as :func:`flatten_polydata` is :func:`flatten` for
    one."""
    demand_polydata(surface, "surface", "; make_flattenable() takes arrays")
    return _make_flattenable(surface, curves_on(surface, curves), body, **options)


def _curves_of(data: vtkPolyData) -> List[Curve]:
    cells = data.GetCellData()
    kinds, names = values_of(cells, "CurveType"), values_of(cells, "CurveName")
    shapes, tolerances = values_of(cells, "KeyShape"), values_of(cells, "LengthTolerance")
    planar = data.GetPointData().GetArray("PlanarShape")
    curves = []
    for cell, kind in enumerate(kinds):
        chain = points_of_cell(data, cell)
        rows = None if planar is None else numbers_of(data.GetPointData(), "PlanarShape")[chain]
        planar_shape = rows if rows is not None and np.isfinite(rows).all() else None
        curves.append(Curve(
            chain, CURVE_TYPES[kind], names[cell], KEY_SHAPES[shapes[cell]], tolerances[cell],
            planar_shape))
    return curves


def _make_flattenable(
    surface: vtkPolyData, curves: Optional[vtkPolyData], body: Optional[vtkPolyData], **options: Any
) -> Flattenable:
    if body is not None:
        demand_polydata(body, "body")
    filter_ = make_filter(options, "make_flattenable", _OWNER)
    filter_.SetInputData(surface)
    if curves is not None:
        filter_.SetCurvesData(curves)
    if body is not None:
        filter_.SetBodyData(body)
    update(filter_, options.get("progress"))
    flattening = result_of(filter_, type(surface))
    moved = filter_.GetOutput(5)
    measures, arrays = filter_.GetOutputDataObject(9).GetRowData(), moved.GetPointData()

    def number(name: str) -> float:
        return float(values_of(measures, name)[0])

    return Flattenable(
        points=coordinates_of(moved),
        triangles=corners_of(moved),
        shift=numbers_of(arrays, "Shift"),
        kept=numbers_of(arrays, "Kept") != 0,
        curves=_curves_of(filter_.GetOutput(6)),
        bound_met=number("BoundMet") != 0.0,
        strain_before=number("StrainBefore"),
        strain_after=number("StrainAfter"),
        size=number("Size"),
        shift_mean=number("ShiftMean"),
        shift_max=number("ShiftMax"),
        shift_outwards_mean=number("ShiftOutwardsMean"),
        shift_inwards_max=number("ShiftInwardsMax"),
        flattening=flattening)
