# SPDX-License-Identifier: BSD-3-Clause
"""One call from a surface and its feature curves to flat pieces."""

from __future__ import annotations  # help() prints hints as they are written here

import inspect
import warnings
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union

from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import Curve, make_curves, make_surface
from ._errors import FlatteningError, FlatteningWarning
from ._remedies import make_message
from ._result import Flattening, as_text, make_result, texts_of
from .vtkFiltersFlattening import vtkWireWarpingFilter

# The words of the command wirewarp, in the order of the filter's enumerations.
SCHEMES = ("progressive", "global", "isometric", "lscm")
ENERGIES = ("rigid", "dirichlet")
SOLVERS = ("newton", "sequential")
INTERIORS = ("laplacian", "relaxation", "arap")
COINCIDENT_POINTS = ("automatic", "join", "keep")


def _set(filter_: Any, option: str, property_: str, value: Any) -> None:
    """Sets a property; the filter clamps what is out of range, here it is refused."""
    try:
        getattr(filter_, "Set" + property_)(value)
    except TypeError as error:
        raise TypeError(f"{option} = {value!r}: {error}") from None
    except OverflowError as error:
        raise ValueError(f"{option} = {value!r} is out of range: {error}") from None
    kept = getattr(filter_, "Get" + property_)()
    if kept != value:
        raise ValueError(f"{option} = {value!r} is out of range; the nearest value is {kept!r}")


def _set_word(filter_: Any, option: str, property_: str, value: str, words: Sequence[str]) -> None:
    if value not in words:
        raise ValueError(f"{option} is {value!r}; it must be one of {', '.join(words)}")
    getattr(filter_, "Set" + property_)(words.index(value))


def _default(option: str) -> Any:
    return inspect.signature(flatten).parameters[option].default


def _method_of_the_paper(scheme: str, interior: str) -> Tuple[str, str]:
    """Scheme and interior of the paper; the others must not ask for anything else."""
    pair = {"scheme": (scheme, "global"), "interior": (interior, "laplacian")}
    for option, (given, papers) in pair.items():
        if given not in (papers, _default(option)):
            raise ValueError(f"{option} = {given!r} and paper_method=True contradict each other")
    return "global", "laplacian"


def _refuse_idle(
    scheme: str, energy: str, arrange: bool, given: Dict[str, Any]
) -> None:
    """An option that the method has no use for means something else than it does."""
    lengths = ("solver", "interior", "max_iterations", "max_length_error")
    scopes = (
        (lengths, scheme != "lscm", "schemes that keep lengths, not for 'lscm'"),
        (("release_trials",), scheme in ("isometric", "global"),
         f"schemes 'isometric' and 'global', not for {scheme!r}"),
        (("energy", "area_bias", "angle_weight"), scheme == "isometric",
         f"scheme='isometric', not for {scheme!r}"),
        (("area_bias",), energy == "rigid", f"energy='rigid', not for {energy!r}"),
        (("pins",), scheme == "lscm", f"scheme='lscm', not for {scheme!r}"),
        (("spacing",), arrange, "arrange=True"),
    )
    for options, holds, condition in scopes:
        for option in options:
            if not holds and given[option] != _default(option):
                raise ValueError(f"{option} = {given[option]!r} is for {condition}; leave one of them out")


def _run(filter_: Any, progress: Optional[Callable[[float], Any]]) -> None:
    """Updates the filter; its messages become exceptions and warnings instead of lines on stderr."""
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
    if raised:
        raise raised[0]

    name = filter_.GetStatusName()
    names, subjects = filter_.GetStatusRemedies(), filter_.GetStatusRemedySubjects()
    remedies = [(names.GetValue(k), as_text(subjects.GetValue(k)))
                for k in range(names.GetNumberOfValues())]
    message = make_message(as_text(filter_.GetStatusDefect()), remedies)
    if filter_.IsRefused():
        ids = vtk_to_numpy(filter_.GetStatusIds()).tolist()
        raise FlatteningError(
            filter_.GetStatusCode(), name, ids, message, filter_.GetStatusIdKind(), remedies)
    for warning in texts_of(filter_.GetOutput(0).GetFieldData(), "RunWarnings"):
        warnings.warn(warning, FlatteningWarning, stacklevel=4)
    if filter_.GetStatusCode() != vtkWireWarpingFilter.OK:
        warnings.warn(f"{name}: {message}", FlatteningWarning, stacklevel=4)


def _flatten(
    surface: vtkPolyData,
    curves: Optional[vtkPolyData],
    *,
    scheme: str = "isometric",
    solver: str = "newton",
    interior: str = "arap",
    paper_method: bool = False,
    release_keys: bool = False,
    release_trials: bool = True,
    close_cuts: bool = False,
    skip_closed: bool = False,
    energy: str = "rigid",
    area_bias: float = 0.0,
    angle_weight: float = 5.0,
    coincident_points: str = "automatic",
    split_triangles: bool = True,
    imprint_tolerance: float = 1e-5,
    snap_tolerance: float = 1e-3,
    arrange: bool = True,
    spacing: float = 0.05,
    pins: Tuple[int, int] = (-1, -1),
    max_iterations: int = 300,
    max_length_error: float = 1e-9,
    progress: Optional[Callable[[float], Any]] = None,
) -> Flattening:
    for data, what in ((surface, "surface"), (curves, "curves")):
        # The pipeline would print an error and give no result.
        if not isinstance(data, vtkPolyData) and (data is not None or what == "surface"):
            raise TypeError(f"{what} is {type(data).__name__}; it must be a vtkPolyData")
    if paper_method:
        scheme, interior = _method_of_the_paper(scheme, interior)
    _refuse_idle(scheme, energy, arrange, {
        "solver": solver, "interior": interior, "max_iterations": max_iterations,
        "max_length_error": max_length_error, "release_trials": bool(release_trials), "energy": energy, "area_bias": area_bias,
        "angle_weight": angle_weight, "pins": tuple(pins) if isinstance(pins, Iterable) else pins, "spacing": spacing})
    filter_ = vtkWireWarpingFilter()
    filter_.CachingOff()  # it runs once
    _set_word(filter_, "scheme", "Scheme", scheme, SCHEMES)
    _set_word(filter_, "solver", "Solver", solver, SOLVERS)
    _set_word(filter_, "interior", "Interior", interior, INTERIORS)
    _set_word(
        filter_, "coincident_points", "CoincidentPoints", coincident_points, COINCIDENT_POINTS
    )
    _set(filter_, "release_keys", "ReleaseKeys", bool(release_keys))
    _set(filter_, "release_trials", "ReleaseTrials", bool(release_trials))
    _set(filter_, "close_cuts", "CloseCuts", bool(close_cuts))
    _set(filter_, "skip_closed", "SkipClosed", bool(skip_closed))
    _set_word(filter_, "energy", "DistortionEnergy", energy, ENERGIES)
    _set(filter_, "area_bias", "AreaBias", area_bias)
    _set(filter_, "angle_weight", "AngleWeight", angle_weight)
    _set(filter_, "split_triangles", "SplitTriangles", bool(split_triangles))
    _set(filter_, "imprint_tolerance", "ImprintTolerance", imprint_tolerance)
    _set(filter_, "snap_tolerance", "SnapTolerance", snap_tolerance)
    _set(filter_, "arrange", "Arrange", bool(arrange))
    _set(filter_, "spacing", "Spacing", spacing)
    _set(filter_, "pins", "ConformalPins", tuple(pins) if isinstance(pins, Iterable) else pins)
    _set(filter_, "max_iterations", "MaximumIterations", max_iterations)
    _set(filter_, "max_length_error", "MaximumLengthError", max_length_error)
    filter_.SetInputData(surface)
    if curves is not None:
        filter_.SetCurvesData(curves)
    _run(filter_, progress)
    return make_result(*(filter_.GetOutput(port) for port in range(3)))


def flatten(
    points: ArrayLike,
    triangles: ArrayLike,
    curves: Sequence[Union[Curve, ArrayLike]] = (),
    *,
    scheme: str = "isometric",
    solver: str = "newton",
    interior: str = "arap",
    paper_method: bool = False,
    release_keys: bool = False,
    release_trials: bool = True,
    close_cuts: bool = False,
    skip_closed: bool = False,
    energy: str = "rigid",
    area_bias: float = 0.0,
    angle_weight: float = 5.0,
    coincident_points: str = "automatic",
    split_triangles: bool = True,
    imprint_tolerance: float = 1e-5,
    snap_tolerance: float = 1e-3,
    arrange: bool = True,
    spacing: float = 0.05,
    pins: Tuple[int, int] = (-1, -1),
    max_iterations: int = 300,
    max_length_error: float = 1e-9,
    progress: Optional[Callable[[float], Any]] = None,
) -> Flattening:
    """Flattens a surface; its boundary and feature curves keep the length of each of their edges.

    The arrays given are not changed. A surface is a manifold with a boundary and without handles;
    triangles that run the wrong way are turned over.

    Args:
        points: positions in space in any unit of length, shape (n, 3).
        triangles: ids of their corners, counted from 0, shape (m, 3).
        curves: feature curves, each a :class:`Curve`, or what its `points` may be (then it is an
            accessory curve). Without curves only the boundary keeps its length.
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
            piece lies poorly, which takes up to six flattenings of it; False: report["pieces"] rank
            the curves to release by their sensitivity alone.
        close_cuts: close darts and other cuts as far as their banks would lie over each other, at
            the price of more distortion; False: they overlap, which breaks a promise.
        skip_closed: leave out pieces that cannot be laid flat, since they have no boundary or have
            handles, and flatten the others, with a warning; report["left_out"] names them. False:
            the surface is refused for them.
        energy: "isometric": what deforming the sheet costs: "rigid", as rigid as possible, or
            "dirichlet", symmetric Dirichlet, which forbids flipped triangles.
        area_bias: "isometric" with "rigid": above 0 a change of area costs more than one of angle
            (stiff sheet), below 0 less (stretchy sheet), in [-0.99, 0.99].
        angle_weight: "isometric": weight of the wires' bending against the sheet, in [0, 100].
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
        max_length_error: largest relative error of a wire's edge that is no broken promise.
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
            other than its default where the method has no use for it.

    Warns:
        FlatteningWarning: there is a result, but a promise is broken (not converged, a length
            error, a flipped triangle, an overlap; report["status"] says which), or a part of the
            input was left out (report["warnings"]).
    """
    return _flatten(
        make_surface(points, triangles),
        make_curves(curves, points),
        scheme=scheme,
        solver=solver,
        interior=interior,
        paper_method=paper_method,
        release_keys=release_keys,
        release_trials=release_trials,
        close_cuts=close_cuts,
        skip_closed=skip_closed,
        energy=energy,
        area_bias=area_bias,
        angle_weight=angle_weight,
        coincident_points=coincident_points,
        split_triangles=split_triangles,
        imprint_tolerance=imprint_tolerance,
        snap_tolerance=snap_tolerance,
        arrange=arrange,
        spacing=spacing,
        pins=pins,
        max_iterations=max_iterations,
        max_length_error=max_length_error,
        progress=progress,
    )


def flatten_polydata(
    surface: vtkPolyData, curves: Optional[vtkPolyData] = None, **options: Any
) -> Flattening:
    """:func:`flatten` for a vtkPolyData, or an object of a class that derives from it (PyVista).

    Args:
        surface: polygons and triangle strips; its own line cells are feature curves as well.
        curves: further feature curves, polylines with the cell arrays that
            vtkFeatureCurveAlgorithm documents (CurveType, CurveName, ...).
        options: the options of :func:`flatten`.

    Returns, raises and warns as :func:`flatten` does; the arrays of `surface` are among the point
    and cell arrays of the result.
    """
    return _flatten(surface, curves, **options)
