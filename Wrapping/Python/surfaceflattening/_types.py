# SPDX-License-Identifier: BSD-3-Clause
"""Words, options and reports as type checkers see them; help() prints the docstrings."""

from typing import List, Literal, Optional, TypedDict

from ._option_table import BoundaryMode as BoundaryMode
from ._option_table import CoincidentPoints as CoincidentPoints
from ._option_table import DartLegs as DartLegs
from ._option_table import DistortionEnergy as Energy
from ._option_table import Interior as Interior
from ._option_table import Options as Options
from ._option_table import Paper as Paper
from ._option_table import Scheme as Scheme
from ._option_table import Solver as Solver
from ._option_table import SuggestedCuts as CutChoice
from ._option_table import Test as SewingTest
from ._option_table import UpAxis as UpAxis

__all__ = [
    "BoundaryMode", "CoincidentPoints", "CutChoice", "DartLegs", "Energy", "Interior", "Options", "Paper", "Scheme", "SewingTest", "Solver",
    "UpAxis"]

CurveType = Literal["accessory", "key", "dart", "seam"]
KeyShape = Literal["surface", "straight"]
WireType = Literal["accessory", "key", "dart", "seam", "boundary", "connector"]
SeamSource = Literal["none", "textures", "materials", "groups"]
Part = Literal["flat", "wires", "cut"]
Coloring = Literal["homogeneity", "area", "aspect-ratio", "developability", "stretch", "warp", "weft", "shear"]
Unit = Literal["mm", "cm", "m", "inch"]


class Remedy(TypedDict):
    """A way out of a defect.

    Keys:
        name: a fixed name, such as "CutOpen".
        subject: what it is to be applied to, such as the name of a curve; may be empty.
    """

    name: str
    subject: str


class AngleStep(TypedDict):
    """An iteration of the wires' angles.

    Keys:
        phase: which problem it belongs to.
        objective: of Eq. 13, rad^2.
        closure: largest gap of a loop of wires, as a fraction of the perimeter.
        optimality: largest entry of the gradient of the Lagrangian.
        step: root mean square of the change of the angles, radians.
    """

    phase: str
    objective: float
    closure: float
    optimality: float
    step: float


class IsometricStep(TypedDict):
    """An iteration of the whole piece, scheme "isometric". Lengths count in roots of the mean
    triangle area, energies in mean triangle areas.

    Keys:
        exact: whether the Hessian was exact, otherwise its convex part.
        energy: what is minimized.
        length_error: largest error of a wire's edge.
        optimality: largest entry of the gradient of the Lagrangian.
        move: of the vertex that moved farthest.
    """

    exact: bool
    energy: float
    length_error: float
    optimality: float
    move: float


class ReleasedCurve(TypedDict):
    """What a piece would be without a curve, or without its shape.

    Keys:
        curve: its name.
        release: "shape", of a key curve its shape alone, or "curve".
        objective_without, E_area_without, E_h_without: objective, E_area and E_h of the piece flattened
            so; None where that was not tried or has no solution.
    """

    curve: str
    release: Literal["shape", "curve"]
    objective_without: Optional[float]
    E_area_without: Optional[float]
    E_h_without: Optional[float]


class Release(TypedDict):
    """Where to start if a piece is poor.

    Keys:
        first: name of the curve to release first.
        objective_without_first: the piece's objective without it, None where that was not tried.
        ranking: all curves that may be released, the best first.
    """

    first: str
    objective_without_first: Optional[float]
    ranking: List[ReleasedCurve]


class ClothReport(TypedDict):
    """What the threads of a flat piece have to do on the surface; strains are fractions, angles degrees.

    Keys:
        strain_warp_rms, strain_weft_rms, shear_rms: root mean squares by area on the surface.
        share_out_of_limit: share of the area beyond the limits of the material.
        share_over_5_percent: share where warp or weft is drawn or compressed by more than 5 %.
        share_locked: share where the threads are sheared to the material's limit or beyond.
        shear_limit: that limit, by which the angle between the threads may change; None where there
            is none.
        grain_angle: from the curve, or else from the upright of the piece, to the warp,
            counter-clockwise.
        grain_curve: name of that curve; empty where it is the upright.
        one_way: whether the material must not be turned by half a turn.
    """

    strain_warp_rms: float
    strain_weft_rms: float
    shear_rms: float
    share_out_of_limit: float
    share_over_5_percent: float
    share_locked: float
    shear_limit: Optional[float]
    grain_angle: float
    grain_curve: str
    one_way: bool


class PieceReport(TypedDict):
    """Measures of a flat piece. Ratios and angles have no unit; lengths are in that of the surface.

    Keys:
        piece: its number from 0, the value of the cell array "PieceId".
        status: "Ok", or the name of the worst promise that is broken, such as "LengthError".
        message: what is wrong and the ways out; empty where it is "Ok".
        ids, id_kind: the offending elements, and what they are: "points", "cells", "curves", ...
        remedies: the ways out.
        triangles, vertices, wire_patches, wire_nodes, free_wire_nodes, constraints: counts.
        iterations: of the wires' angles.
        E_len: mean relative error of the wires' edges (Eq. 26), without connectors, elastic curves and a free boundary.
        E_len_max: the largest such error.
        E_len_all: mean relative error of all edges of the mesh.
        E_ang: mean relative error of the triangles' angles (Eq. 27); 0 is ideal.
        E_h: homogeneity, min a / max a, a = flat area / area on the surface of a triangle; 1 is ideal.
        E_r: aspect ratio, min s / max S, the singular values of the triangles' maps; 1 is ideal.
        E_area: sum of abs(flat area - area) / sum of area; 0 is ideal.
        strain_p95: the strain, max abs(ln sigma), that is not exceeded on 95 % of the area.
        energy_rigid: mean squared distance of the triangles' maps from a rotation.
        energy_sheet, energy_angles: the two terms of the energy of scheme "isometric", in mean triangle areas.
        cut_length: length of the darts and seams that bound or slit it.
        flipped: triangles that are turned over.
        overlaps: pairs of boundary edges that cross; overlaps_complete: whether all were looked at.
        objective: half the sum of the squared changes of the wires' angles (Eq. 13), rad^2.
        closure_residual: largest gap of a loop of wires, unit of length.
        solver_used, energy_used: of the method; empty where it has none.
        repaired: whether progressive angles did not close and the nearest that do were taken.
        fallbacks: what was done in place of what was asked for, and why; else empty. Another energy is
            among the warnings.
        name: that all of its cells have in the array "PieceName", numbered where several pieces have it.
        size, ease: how large the flat piece is, in cm, and what its cloth has to do and where, in words.
        verdict: that the plane has no room for the piece, where to cut it, and which other energy was
            used; else empty. It is a warning as well.
        forecast_area_loss, forecast_area_loss_after_cut: part of the area that is lost where the
            boundary keeps its lengths, as known before flattening, and with that cut; 0 below 0.3.
        forecast_cut_from, forecast_cut_to: points that it joins along edges; -1: none.
        release: what to release if the piece is poor, None where nothing can be.
        history, isometric_history: the iterations of the angles and of the whole piece.
        cloth: what its threads have to do; None without a material.
    """

    piece: int
    status: str
    message: str
    ids: List[int]
    id_kind: str
    remedies: List[Remedy]
    triangles: int
    vertices: int
    wire_patches: int
    wire_nodes: int
    free_wire_nodes: int
    constraints: int
    iterations: int
    E_len: float
    E_len_max: float
    E_len_all: float
    E_ang: float
    E_h: float
    E_r: float
    E_area: float
    strain_p95: float
    energy_rigid: float
    energy_sheet: float
    energy_angles: float
    cut_length: float
    flipped: int
    overlaps: int
    overlaps_complete: bool
    objective: float
    closure_residual: float
    solver_used: str
    energy_used: str
    repaired: bool
    fallbacks: str
    name: str
    size: str
    ease: str
    verdict: str
    forecast_area_loss: float
    forecast_area_loss_after_cut: float
    forecast_cut_from: int
    forecast_cut_to: int
    release: Optional[Release]
    history: List[AngleStep]
    isometric_history: List[IsometricStep]
    cloth: Optional[ClothReport]


class CurveReport(TypedDict):
    """What became of a feature curve; both sides of a cut count once. Lengths are in the unit of the
    surface.

    Keys:
        name, type: of the curve.
        length_3d, length_2d: on the surface and in the plane.
        error: largest relative error of one of its edges.
        tolerance: how far its length may go, as a fraction; 0 is rigid.
        closed_length: how much of a cut close_cuts has closed.
        sensitivity: derivative of the objective by the logarithm of its length.
        released: whether a key's shape was given up, by release_keys or since it clashes with others.
    """

    name: str
    type: CurveType
    length_3d: float
    length_2d: float
    error: float
    tolerance: float
    closed_length: float
    sensitivity: float
    released: bool


class LeftOut(TypedDict):
    """A piece that skip_closed left out.

    Keys:
        reason: "ClosedSurface" or "Handle".
        cell: the first of its triangles.
        triangles: how many it has.
    """

    reason: str
    cell: int
    triangles: int


class Seconds(TypedDict):
    """Wall-clock time.

    Keys:
        wires, interior, quality: what placing wires, placing the interior and measuring took, summed
            over the pieces.
        core: all that the algorithms took.
        total: the same, since nothing is read or written.
    """

    core: float
    wires: float
    interior: float
    quality: float
    total: float


class Report(TypedDict):
    """What became of a surface: plain Python that json can write, with the keys of wirewarp's report.json.

    Keys:
        status: "Ok", or the worst status of a piece.
        message: what is wrong and the ways out; empty where it is "Ok".
        ids, id_kind: the offending elements, and what they are.
        remedies: the ways out, each a :class:`Remedy`.
        warnings: what of the input was left out, and verdicts on pieces, a sentence each.
        left_out: pieces that skip_closed left out, each a :class:`LeftOut`.
        pieces: measures of each piece, :class:`PieceReport`: E_len, E_ang, E_h, E_area, ...
        curves: lengths of each feature curve, :class:`CurveReport`.
        seconds: what it took, :class:`Seconds`.
    """

    status: str
    message: str
    ids: List[int]
    id_kind: str
    remedies: List[Remedy]
    warnings: List[str]
    left_out: List[LeftOut]
    pieces: List[PieceReport]
    curves: List[CurveReport]
    seconds: Seconds
