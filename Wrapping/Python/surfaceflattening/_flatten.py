# SPDX-License-Identifier: BSD-3-Clause
"""One call from a surface and its feature curves to flat pieces."""

from __future__ import annotations  # help() prints hints as they are written here

import warnings
from typing import Any, Callable, List, Mapping, Optional, Sequence, Union

from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import Curve, curves_on, demand_polydata, make_curves, make_surface
from ._errors import FlatteningError, FlatteningWarning
from ._options import make_filter, with_options
from ._remedies import make_message
from ._report import as_text, remedies_of, texts_of
from ._result import Flattening, make_result
from .vtkFiltersFlattening import vtkWireWarpingFilter


def _update(filter_: Any, progress: Optional[Callable[[float], Any]], finishes: bool = False) -> None:
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

    tags = [filter_.AddObserver(event, lambda *_: None) for event in ("ErrorEvent", "WarningEvent")]
    tags.append(filter_.AddObserver("ProgressEvent", tell))
    try:
        filter_.Update()
    finally:
        for tag in tags:
            filter_.RemoveObserver(tag)  # they refer to the filter
    found = finishes and raised and isinstance(raised[0], KeyboardInterrupt) and not filter_.IsRefused()
    if raised and not found:
        raise raised[0]

    name = filter_.GetStatusName()
    remedies = remedies_of(filter_)
    message = make_message(as_text(filter_.GetStatusDefect()), remedies)
    if filter_.IsRefused():
        ids = vtk_to_numpy(filter_.GetStatusIds()).tolist()
        raise FlatteningError(
            filter_.GetStatusCode(), name, ids, message, filter_.GetStatusIdKind(), remedies)
    for warning in texts_of(filter_.GetOutput(0).GetFieldData(), "RunWarnings"):
        warnings.warn(warning, FlatteningWarning, stacklevel=4)
    if filter_.GetStatusCode() != vtkWireWarpingFilter.OK:
        warnings.warn(f"{name}: {message}", FlatteningWarning, stacklevel=4)


def _run(surface: vtkPolyData, curves: Optional[vtkPolyData], options: Mapping[str, Any],
         function: str) -> Flattening:
    filter_ = make_filter(options, function)
    filter_.SetInputData(surface)
    if curves is not None:
        filter_.SetCurvesData(curves)
    _update(filter_, options.get("progress"))
    return make_result(
        filter_.GetOutput(0), filter_.GetOutput(1), filter_.GetOutput(2), type(surface))


@with_options
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
        points: positions in space in any unit of length, shape (n, 3). Integers are taken for what they
            are, up to 2**53; masked values are refused.
        triangles: ids of their corners, counted from 0, shape (m, 3); or a flat list of polygons, each
            the number of its corners and then their ids, as PyVista's `faces`.
        curves: a list of feature curves, each a :class:`Curve`, or what its `points` may be (then it is
            an accessory curve). Without curves only the boundary keeps its length.
        scheme: how boundary and curves get their shape: "isometric", wires and interior together,
            which distorts least; "global", all angles together (Eq. 13 of the paper);
            "progressive", wire-patch by wire-patch (Algorithm 2); "lscm", for comparison, keeps no
            length.
        solver: how the angles are solved for: "newton" or "sequential", the paper's. "isometric"
            only starts from that solution; "lscm" has no use for it.
        interior: how points between the wires are placed: "arap", as rigid as possible;
            "laplacian", Eq. 11; "relaxation", the paper's iteration for it. "isometric" only
            starts there; "lscm" has no use for it.
        paper_method: the paper's method, scheme "global" with interior "laplacian". "newton" finds the
            minimum that the paper asks for, solver="sequential" by the paper's steps, where they
            converge.
        release_keys: treat key curves as accessory curves.
        release_trials: "global" and "isometric": try what a release of a curve would bring where a
            piece lies poorly, which takes up to six flattenings of it, by "isometric" for not
            much more than two seconds; False: report["pieces"] rank the curves to release by their
            sensitivity alone.
        close_cuts: close darts and other cuts as far as their banks would lie over each other, at
            the price of more distortion; False: they overlap, which breaks a promise.
        dart_legs: how the legs of a dart lie: "free", as the piece distorts least, so that they fit when
            sewn but may miss each other when folded; "straight"; or "mirrored", both the mean of free
            ones. Legs that are not free fold on each other exactly, at the price of more distortion.
        skip_closed: leave out pieces that cannot be laid flat, since they have no boundary or have
            handles, and flatten the others, with a warning; report["left_out"] names them. False:
            the surface is refused for them.
        energy: "isometric": what deforming the sheet costs: "rigid", as rigid as possible, or
            "dirichlet", symmetric Dirichlet, which forbids flipped triangles.
        area_bias: "isometric" with "rigid": above 0 a change of area costs more than one of angle
            (stiff sheet), below 0 less (stretchy sheet), in [-0.99, 0.99].
        angle_weight: "isometric": weight of the wires' bending against the sheet, in [0, 100].
        material: what the pieces are cut from: a name of :func:`materials`, or the path of a JSON file
            with its numbers. "isometric" keeps the strains of its threads small and within its
            limits as far as lengths allow; other schemes only measure them.
        grain: how pieces lie on it: degrees from the upright of the piece (its first key curve, else
            its long side) to the warp, counter-clockwise; the name of a curve along which the warp
            runs, or "NAME:DEGREES" at an angle from it, or a list of them, of which each piece takes
            the first that it has; or "free", where the material is strained least.
        tolerance: how far the lengths of curves may go, by name, each a fraction in [0, 1), in place of
            their own length_tolerance.
        ease: by how much curves are longer in one of their pieces than on the surface, and than what they
            are sewn to: {"cap": 0.03}, or {("cap", 1): 0.03} where the curve lies in several pieces
            (counted from 0). Each needs a tolerance as large, and takes the place of what the curve has
            by cell arrays LengthEase and EasedPiece.
        coincident_points: whether points with equal coordinates are one: "automatic", only where
            hardly any two triangles share a point; "join", always; "keep", never.
        split_triangles: split triangles where a curve does not run along edges; False: refuse it.
        imprint_tolerance: greatest distance of a curve from the surface, as a fraction of the
            diagonal of the surface's bounding box, in [0, 1].
        snap_tolerance: a curve's point or crossing nearer to a vertex or an edge than this fraction
            of the mean edge length, or of the longest edge there where that is shorter, moves onto
            it, in [0, 0.5].
        arrange: turn pieces upright and lay them in rows; False: leave them where they arise.
        spacing: space between the bounding boxes of arranged pieces, as a fraction of the largest
            side of one, in [0, 1e6].
        pins: "lscm": ids of the two points that are pinned; -1: the boundary points farthest apart.
        max_iterations: most iterations of the solver, a piece.
        closure_tolerance: the solver stops when no loop of wires is open by more than this fraction of
            the perimeter, and
        optimality_tolerance: no entry of the gradient of the Lagrangian is larger.
        max_length_error: largest relative error of a wire's edge that is no broken promise.
        relaxation_factor: interior "relaxation": factor tau of Eq. 12, in (0, 2).
        relaxation_movement: "relaxation" stops when no point moves farther than this fraction of the
            mean wire edge.
        relaxation_min_iterations: fewest iterations of "relaxation",
        relaxation_max_iterations: and most.
        rigid_tolerance: interior "arap" stops when the energy falls by less than this fraction of itself.
        rigid_iterations: most iterations of "arap".
        isometric_tolerance: scheme "isometric" stops when the relative gradient of the Lagrangian is
            smaller.
        isometric_iterations: most iterations of "isometric".
        progress: called with the fraction done, 0 to 1. What it raises ends the run and is raised
            again.

    Returns:
        A :class:`Flattening`: positions in the plane (in the unit of `points`), triangles, arrays,
        wires and the report as a plain dict. Points on darts and seams occur once for each side:
        its point array "vtkOriginalPointIds" leads back to `points` (-1: made by imprinting), its
        cell array "vtkOriginalCellIds" to `triangles`.

    Raises:
        FlatteningError: the input is refused; it carries code, name, ids and message.
        ValueError: an argument has a wrong shape, is not one of the words, is out of range, or is
            given where the method has no use for it.
        TypeError: an unknown option, or a value of another type.

    Warns:
        FlatteningWarning: there is a result, but a promise is broken (not converged, a length
            error, a flipped triangle, an overlap; report["status"] says which), or a part of the
            input was left out (report["warnings"]).
    """
    return _run(make_surface(points, triangles), make_curves(curves, points), options, "flatten")


@with_options
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
    demand_polydata(surface, "surface", ", such as a pyvista.PolyData; flatten() takes arrays")
    return _run(surface, curves_on(surface, curves), options, "flatten_polydata")
