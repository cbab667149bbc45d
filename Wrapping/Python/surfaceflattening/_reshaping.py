# SPDX-License-Identifier: BSD-3-Clause
"""A surface moved as little as it takes to lie flat with little strain."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._curves import Curve, curve_data, curves_of, surface_data
from ._equality import ComparedByValue
from ._options import read_options, with_options
from ._pieces import Data
from ._report import values_in
from ._result import Flattening, finished

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

Body = Union[None, "vtkPolyData", Tuple[ArrayLike, ArrayLike]]

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
    body: Body = None,
    **options: Any,
) -> Flattenable:
    """Moves a surface as little as it takes to lie flat with little strain, and flattens it.

    Args:
        points, triangles, curves: as for :func:`flatten`.
        _OPTIONS_
        body: a surface that is not entered, its normals outwards: points and triangles, or a vtkPolyData.
        options: the options of :func:`flatten`.

    Raises and warns as :func:`flatten` does; a bound that is not met is a FlatteningWarning.
    """
    return _moved(surface_data(points, triangles), [curve_data(curves, points)], body, "make_flattenable", options)


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
    from ._vtk import input_of

    return _moved(*input_of(surface, curves, "; make_flattenable() takes arrays"), body, "make_flattenable_polydata", options,
                  type(surface))


def body_data(body: Body) -> Optional[Data]:
    """Points and triangles, or a mesh, as the algorithms take them."""
    if body is None or isinstance(body, tuple):
        return None if body is None else surface_data(*body)
    from ._vtk import data_of
    return data_of(body, "body", ", or points and triangles")


def _moved(data: Data, curves: List[Data], body: Body, function: str, options: Mapping[str, Any],
           mesh_class: Optional[type] = None) -> Flattenable:
    owner, values = read_options(options, function, _OWNER)
    run = _core.make_flattenable(data, curves, body_data(body), owner, values, options.get("progress"))
    flattening = finished(run, data, mesh_class, 4)

    def number(name: str) -> float:
        return float(values_in(run["measures"], name)[0])

    return Flattenable(
        points=run["surface"]["points"],
        triangles=run["surface"]["corners"].reshape(-1, 3),
        shift=run["surface"]["point_arrays"]["Shift"],
        kept=run["surface"]["point_arrays"]["Kept"] != 0,
        curves=curves_of(run["curves"]),
        bound_met=number("BoundMet") != 0.0,
        strain_before=number("StrainBefore"),
        strain_after=number("StrainAfter"),
        size=number("Size"),
        shift_mean=number("ShiftMean"),
        shift_max=number("ShiftMax"),
        shift_outwards_mean=number("ShiftOutwardsMean"),
        shift_inwards_max=number("ShiftInwardsMax"),
        flattening=flattening)
