# SPDX-License-Identifier: BSD-3-Clause
"""One call from a surface to curves that let it lie flat."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import CURVE_TYPES, Curve, weights_of
from ._equality import ComparedByValue
from ._options import with_options
from ._report import rows_of
from ._result import Flattening
from ._vtk import (
    add_weights, coordinates_of, curves_on, demand_polydata, make_curves, make_filter, make_surface, points_of_cell, result_of,
    table_of, update, values_of)

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
class LeftOutLine(ComparedByValue):
    """A line that was tried and is not proposed."""

    name: str
    #: "key" or "accessory".
    type: str
    length: float
    #: What it costs, as SuggestedCut.gain.
    gain: float
    E_area_before: float
    E_area_after: float
    strain_before: float
    strain_after: float
    #: It breaks no promise, but costs too much.
    sound: bool


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


def _make_suggestion(filter_: Any, flattening: Flattening) -> Suggestion:
    curves = filter_.GetOutput(5)
    cells = curves.GetCellData()
    kinds, names = values_of(cells, "CurveType"), values_of(cells, "CurveName")
    shapes = values_of(cells, "KeyShape")
    ranks, mirrors = values_of(cells, "Rank"), values_of(cells, "MirrorOf")
    numbers = [values_of(cells, name) for name in (
        "Length", "PredictedGain", "Gain", "Opening", "StrainBefore", "StrainAfter",
        "AreaErrorBefore", "AreaErrorAfter")]
    cuts = []
    for cell, rank in enumerate(ranks):
        if rank < 1:
            continue
        points = coordinates_of(curves)[points_of_cell(curves, cell)]
        length, predicted, gain, opening, before, after, *area = (
            column[cell] for column in numbers)
        cuts.append(SuggestedCut(
            Curve(points, CURVE_TYPES[kinds[cell]], names[cell],
                  key_shape="straight" if shapes[cell] == 1 else "surface"), length, predicted, gain, opening,
            before, after, mirrors[cell] - 1 if mirrors[cell] > 0 else -1, *area))
    field = curves.GetFieldData()
    met = values_of(filter_.GetOutputDataObject(6).GetRowData(), "BoundMet")
    left_out = [LeftOutLine(**row) for row in rows_of(table_of(filter_.GetLeftOutLines()), {
        "name": "Name", "type": "Type", "length": "Length", "gain": "Gain", "E_area_before": "AreaErrorBefore",
        "E_area_after": "AreaErrorAfter", "strain_before": "StrainBefore", "strain_after": "StrainAfter",
        "sound": "Sound"})]
    plane, axis = values_of(field, "MirrorPlane"), values_of(field, "MirrorAxis")
    mirror = (MirrorPlane(np.array(plane[:3]), plane[3]) if plane
              else MirrorAxis(np.reshape(axis, (2, 3))) if axis else None)
    return Suggestion(cuts, bool(met[0]), flattening, left_out, mirror)


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
            were so many times as large. Only ratios count. Default: None, everywhere alike.
        options: the options of :func:`flatten`, with which the cuts are tried.

    Returns:
        A :class:`Suggestion`: the proposed curves in the order of choice, ready for :func:`flatten`
        behind those given, what each gives, and the flat pieces.

    Raises and warns as :func:`flatten` does; a bound that is not met is a FlatteningWarning.
    """
    surface = make_surface(points, triangles)
    return _suggest(
        surface, make_curves(curves, points), weights=None if weights is None else add_weights(
            surface, weights_of(weights, surface.GetNumberOfCells())), **options)


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
    demand_polydata(surface, "surface", "; suggest() takes arrays")
    return _suggest(surface, curves_on(surface, curves), weights=weights, **options)


def _suggest(surface: vtkPolyData, curves: Optional[vtkPolyData], **options: Any) -> Suggestion:
    filter_ = make_filter(options, "suggest", _OWNER)
    filter_.SetInputData(surface)
    if curves is not None:
        filter_.SetCurvesData(curves)
    update(filter_, options.get("progress"), finishes=filter_.GetSuggestedCuts() != filter_.LINES)
    return _make_suggestion(filter_, result_of(filter_, type(surface)))
