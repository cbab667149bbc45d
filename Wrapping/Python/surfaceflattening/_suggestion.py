# SPDX-License-Identifier: BSD-3-Clause
"""One call from a surface to curves that let it lie flat."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._curves import CURVE_TYPES, Curve, curve_data, surface_data, weights_of
from ._equality import ComparedByValue
from ._errors import ArgumentError
from ._options import read_options, text_of, with_options
from ._pieces import Data
from ._report import values_in
from ._result import Flattening, finished
from ._types import LeftOutLine

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

_OWNER = "vtkFeatureCurveSuggestion"


@dataclass(frozen=True, eq=False)
class SuggestedCut(ComparedByValue):
    """A proposed cut or line."""

    #: As flatten() takes it.
    curve: Curve
    #: On the surface, unit of length.
    length: float
    #: By how much it lowers the mean of the squared scale factor, by forecast.
    predicted_gain: float
    #: By how much it lowers the mean rigid energy, in truth, after the cuts before it. A line's is what
    #: it costs, and negative. NaN, as strain and E_area, where the surface cannot be flattened without it,
    #: such as a closed one.
    gain: float
    #: Of a dart's mouth, or of the widest place of one inside, by forecast, unit of length.
    opening: float
    #: The largest strain on 95 % of a piece, before and after.
    strain_before: float
    strain_after: float
    #: Place of the cut that it is the mirror image of, or -1.
    mirror_of: int
    #: Mean change of area, before and after.
    E_area_before: float
    E_area_after: float


@dataclass(frozen=True, eq=False)
class MirrorPlane(ComparedByValue):
    """The plane across which a surface is its own mirror image: where normal . x = offset."""

    #: Of length 1, shape (3,).
    normal: NDArray[np.float64]
    #: Unit of length.
    offset: float


@dataclass(frozen=True, eq=False)
class MirrorAxis(ComparedByValue):
    """The line on a surface across which it is its own mirror image by lengths and angles alone.

    Such a surface is bent to one side, and its cloth is its own image all the same.
    """

    #: The points of the boundary between which it runs, shape (2, 3).
    ends: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Suggestion(ComparedByValue):
    """Proposed cuts or lines, and the surface flattened with them. A notebook shows the flat pieces with a
    table of what is proposed."""

    cuts: List[SuggestedCut]
    #: Whether the strain of every piece is within the bound.
    bound_met: bool
    #: The flat pieces with the curves given and all cuts.
    flattening: Flattening
    #: Lines that were tried and cost too much, or break what holds without them; without their points.
    left_out: List[LeftOutLine]
    #: What the proposals are mirrored across; None where the surface has no mirror, or it is not kept.
    mirror: Union[MirrorPlane, MirrorAxis, None]

    def __repr__(self) -> str:
        count = len(self.cuts)
        names = ", ".join(cut.curve.name for cut in self.cuts[:3]) + (", ..." if count > 3 else "")
        words = [f"{count} curve{'' if count == 1 else 's'}" + (f" ({names})" if count else ""),
                 "bound met" if self.bound_met else "bound not met"]
        if self.left_out:
            words.append(f"{len(self.left_out)} left out")
        return f"<Suggestion: {', '.join(words)}; {self.flattening!r}>"

    def _repr_html_(self) -> str:
        from ._html import suggestion_to_html
        return suggestion_to_html(self)


def _suggested(
    data: Data, curves: List[Data], weights: Optional[NDArray[np.float64]], function: str, options: Mapping[str, Any],
    mesh_class: Optional[type] = None
) -> Suggestion:
    owner, values = read_options({**options, "weights": None}, function, _OWNER)
    run = _core.suggest(data, curves, weights, owner, values, options.get("progress"))
    flattening = finished(run, data, mesh_class, 4)
    cuts = [
        SuggestedCut(Curve(points, CURVE_TYPES[kind], name, key_shape="straight" if shape == 1 else "surface"),
                     length, predicted, gain, opening, before, after, image - 1 if image > 0 else -1, *area)
        for points, kind, name, shape, length, predicted, gain, opening, before, after, image, *area in zip(
            run["places"], *(values_in(run["curves"], column) for column in (
                "CurveType", "CurveName", "KeyShape", "Length", "PredictedGain", "Gain", "Opening", "StrainBefore",
                "StrainAfter", "MirrorOf", "AreaErrorBefore", "AreaErrorAfter")))]
    lines = [LeftOutLine(**row) for row in run["left_out"]]
    plane, axis = values_in(run["mirror"], "MirrorPlane"), values_in(run["mirror"], "MirrorAxis")
    return Suggestion(cuts, bool(values_in(run["search"], "BoundMet")[0]), flattening, lines, (
        MirrorPlane(np.array(plane[:3]), plane[3]) if plane else MirrorAxis(np.reshape(axis, (2, 3))) if axis else None))


@with_options(_OWNER)
def suggest(
    points: ArrayLike,
    triangles: Optional[ArrayLike] = None,  # make_surface() says what is missing
    curves: Sequence[Union[Curve, ArrayLike]] = (),
    *,
    weights: Optional[ArrayLike] = None,
    **options: Any,
) -> Suggestion:
    """Proposes darts and seams with which a surface lies flat, or lines, and flattens it with them.

    The curves given stay as they are, and key curves are not cut. A surface that is closed, a tube or
    has handles is cut open first.

    Args:
        points, triangles, curves: as for :func:`flatten`.
        _OPTIONS_
        weights: how much distortion matters, a number from 0 for each triangle (of a flat list: each
            polygon), shape (m,): gains and strains of the cuts, and the bound, count each as if its area
            were multiplied by it. Only ratios count. Default: None, everywhere alike.
        options: the options of :func:`flatten`, with which the cuts are tried.

    Returns:
        A :class:`Suggestion`: the proposed curves in the order of choice, ready for :func:`flatten`
        behind those given, what each gives, and the flat pieces.

    Raises and warns as :func:`flatten` does; a bound that is not met is a FlatteningWarning.
    """
    data = surface_data(points, triangles)
    cells = len(data["offsets"]) - 1 if "offsets" in data else data["corners"].size // 3
    return _suggested(
        data, [curve_data(curves, points)], None if weights is None else weights_of(weights, cells), "suggest", options)


@with_options(_OWNER)
def suggest_polydata(
    surface: vtkPolyData,
    curves: Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]] = None,
    *,
    weights: Optional[str] = None,
    **options: Any,
) -> Suggestion:
    """:func:`suggest` for a vtkPolyData, as :func:`flatten_polydata` is :func:`flatten` for one.

    curves: as for :func:`flatten_polydata`, which takes those that are proposed as such a list.
    weights: the name of a cell array. Default: None, everywhere alike.
    """
    from ._vtk import input_of

    data, on_surface = input_of(surface, curves, "; suggest() takes arrays")
    numbers = None if weights is None else data["cell_arrays"].get(text_of("weights", weights))
    if weights is not None and np.ndim(numbers if isinstance(numbers, np.ndarray) else 0) != 1:
        raise ArgumentError(f'the surface has no cell array of numbers named "{weights}"')
    return _suggested(data, on_surface, numbers, "suggest_polydata", options, type(surface))
