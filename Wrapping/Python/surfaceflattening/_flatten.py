# SPDX-License-Identifier: BSD-3-Clause
"""One call from a surface and its feature curves to flat pieces."""

from __future__ import annotations  # help() prints hints as they are written here

from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _core
from ._curves import Curve, curve_data, surface_data, weighted
from ._options import WARPING, read_options, with_options
from ._result import Flattening, finished

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData


@with_options(WARPING)
def flatten(
    points: ArrayLike,
    triangles: Optional[ArrayLike] = None,  # make_surface() says what is missing
    curves: Sequence[Union[Curve, ArrayLike]] = (),
    **options: Any,
) -> Flattening:
    """Flattens a surface; its boundary and feature curves keep the length of each of their edges.

    A surface is a manifold with a boundary and without handles; triangles that run the wrong way are
    turned over. The arrays given are not changed. The options are those of the command wirewarp, mean
    the same and have the same defaults. Threads may call this at the same time; help(surfaceflattening)
    says what that gains.

    Args:
        points: positions in space in any unit of length, shape (n, 3). Integers are exact up
            to 2**53 and rejected beyond it; masked values are rejected.
        triangles: ids of their corners, counted from 0, shape (m, 3); or a flat list of polygons, each
            the number of its corners and then their ids, as PyVista's `faces`.
        curves: a list of feature curves, each a :class:`Curve`, or what its `points` may be (then it is
            an accessory curve). Without curves only the boundary keeps its length.
        _OPTIONS_
        paper_method: the paper's method, scheme "global" with interior "laplacian". solver="newton"
            finds the minimum that the paper defines, "sequential" takes the paper's own steps to it, where they converge.
        progress: called with the fraction done, 0 to 1. What it raises ends the run and is raised
            again.

    Returns:
        A :class:`Flattening`: positions in the plane (in the unit of `points`), triangles, arrays,
        wires and the report as a plain dict. Points on darts and seams occur once for each side:
        its point array "vtkOriginalPointIds" leads back to `points` (-1: made by imprinting), its
        cell array "vtkOriginalCellIds" to `triangles`. Points that healing joined to another come
        last, at its place.

    Raises:
        FlatteningError: the input is rejected; it carries code, name, ids and message.
        ValueError: an argument has a wrong shape, is not one of the words, is out of range, or is
            given where the method ignores it.
        TypeError: an unknown option, or a value of another type.

    Warns:
        FlatteningWarning: there is a result, but not a sound one (not converged, a length
            error, a flipped triangle, an overlap; report["status"] says which), or a part of the
            input was left out (report["warnings"]).
    """
    data = surface_data(points, triangles)
    owner, values = read_options(weighted(data, options), "flatten")
    return finished(_core.flatten(data, [curve_data(curves, points)], owner, values, options.get("progress")), data)


@with_options(WARPING)
def flatten_polydata(
    surface: vtkPolyData,
    curves: Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]] = None,
    **options: Any,
) -> Flattening:
    """:func:`flatten` for a vtkPolyData, or a mesh of a class that derives from it, as PyVista's do.

    Args:
        surface: polygons and triangle strips; its own line cells are feature curves as well.
        curves: further feature curves: a list as for :func:`flatten`, whose ids are those of the points
            of `surface`; or a vtkPolyData of polylines with the cell arrays that
            vtkFeatureCurveAlgorithm documents (CurveType, CurveName, ...).
        options: those of :func:`flatten`.

    Returns, raises and warns as :func:`flatten` does; the arrays of `surface` are among the point
    and cell arrays of the result, and the result's to_polydata() gives meshes of the class of
    `surface`.
    """
    from ._vtk import input_of

    data, on_surface = input_of(surface, curves, ", such as a pyvista.PolyData; flatten() takes arrays")
    owner, values = read_options(weighted(data, options), "flatten_polydata")
    return finished(
        _core.flatten(data, on_surface, owner, values, options.get("progress")), data, type(surface))
