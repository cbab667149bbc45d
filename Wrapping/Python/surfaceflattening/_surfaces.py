# SPDX-License-Identifier: BSD-3-Clause
"""Curves drawn on a surface, and measures of surfaces and of flat pieces."""

from __future__ import annotations  # help() prints hints as they are written here

from dataclasses import dataclass
from typing import Dict, List, Literal, Sequence, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._curves import Curve, as_numbers, surface_data
from ._equality import ComparedByValue
from ._errors import ArgumentError
from ._options import flag, index_of, number_of
from ._report import raise_refusal
from ._types import CurveType

SegmentKind = Literal["geodesic", "section", "edges", "spline"]


def draw_curve(
    points: ArrayLike, triangles: ArrayLike, through: ArrayLike, kind: SegmentKind = "geodesic", *, type: CurveType = "accessory",
    name: str = "", closed: bool = False, tight: bool = False, offset: float = 0.0
) -> List[Curve]:
    """Draws a feature curve on a surface through control points, for :func:`flatten`.

    Args:
        points, triangles: as for :func:`flatten`.
        through: control points, shape (k, 3); each means the closest point of the surface.
        kind: between them "geodesic", by the straight path; "section", in the plane through both and the normal; "edges", by the
            shortest way along edges; or "spline", smoothly through all.
        type, name: of the curve; several get numbers behind the name.
        closed: continue from the last control point to the first.
        tight: pull a closed curve tight, as a rubber band that cannot leave the surface.
        offset: draw the curve at this distance from it, measured over the surface, above 0 on the left; 0: the curve itself.

    Returns:
        The curve; at an offset several where the boundary interrupts it.

    Raises:
        FlatteningError: the surface is rejected, too few different control points, or parts that are not connected.
        ValueError, TypeError: an argument of another shape, word or type.
    """
    controls = as_numbers(through, "through")
    if controls.ndim != 2 or controls.shape[1] != 3:
        raise ArgumentError(f"through must have the shape (k, 3), not {controls.shape}")
    status, refused, places = _core.draw_curves(
        surface_data(points, triangles), [controls], index_of(kind, get_args(SegmentKind), "kind"), flag(closed, "closed"),
        flag(tight, "tight"), number_of("offset", offset))
    raise_refusal({"status": status, "refused": refused})
    return [Curve(place, type, f"{name} {k + 1}" if name and len(places) > 1 else name) for k, place in enumerate(places)]


@dataclass(frozen=True, eq=False, repr=False)
class Quality(ComparedByValue):
    """Measures of a flattening of any origin."""

    #: By the keys of :class:`PieceReport`: E_len, E_ang, E_h, E_area, strain_p95, ...
    measures: Dict[str, float]
    #: By name, a value a triangle, such as "AreaRatio".
    cell_arrays: Dict[str, NDArray[np.float64]]
    #: Boundary edges that cross in the plane: points a, b and c, d; int64, shape (k, 4).
    overlap_edges: NDArray[np.int64]

    def __repr__(self) -> str:
        words = [f"{self.measures['triangles']} triangles", f"E_len_max {self.measures['E_len_max']:.1e}",
                 f"E_area {self.measures['E_area']:.3g}", f"{len(self.overlap_edges)} overlaps"]
        return f"<Quality: {', '.join(words)}>"


def measure(points: ArrayLike, triangles: ArrayLike, positions: ArrayLike) -> Quality:
    """Measures flat positions of a surface, whatever made them.

    Args:
        points, triangles: as for :func:`flatten`; cut open as the flat surface is.
        positions: of the same points in the plane, shape (n, 2).

    Raises:
        FlatteningError: the surface is rejected, or a position is not finite.
        ValueError: an argument of another shape.
    """
    data, flat = surface_data(points, triangles), as_numbers(positions, "positions")
    if flat.shape != (len(data["points"]), 2):
        raise ArgumentError(f"positions must have the shape ({len(data['points'])}, 2), not {flat.shape}")
    status, refused, rows, cells, overlaps = _core.measure(data, {**data, "points": flat})
    raise_refusal({"status": status, "refused": refused})
    return Quality(rows[0], cells, overlaps["OverlapEdges"].reshape(-1, 4))


def developability(points: ArrayLike, triangles: ArrayLike) -> NDArray[np.float64]:
    """The angle defect around each interior point (Eq. 25), radians; 0 on the boundary; shape (n,).

    Raises:
        FlatteningError: the surface is rejected.
    """
    status, refused, arrays = _core.developability(surface_data(points, triangles))
    raise_refusal({"status": status, "refused": refused})
    values: NDArray[np.float64] = arrays["Developability"]
    return values
