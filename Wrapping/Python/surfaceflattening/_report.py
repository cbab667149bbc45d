# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run, read from the tables of the filter."""

import math
from typing import Any, Dict, List, Optional, cast

from ._remedies import make_message
from ._types import Report
from ._vtk import Row, as_text, ids_of, remedies_of, rows_of, texts_of, values_of

# Keys of the report and columns of the filter's tables.
_PIECE = {
    "piece": "Piece", "status": "Status", "name": "Name", "message": "StatusDefect",
    "id_kind": "StatusIdKind", "ids": "StatusIds", "size": "SizeInWords", "ease": "EaseInWords",
    "triangles": "Triangles", "vertices": "Vertices", "wire_patches": "WirePatches",
    "wire_nodes": "WireNodes", "free_wire_nodes": "FreeWireNodes", "constraints": "Constraints",
    "iterations": "Iterations", "flipped": "FlippedTriangles", "overlaps": "Overlaps",
    "overlaps_complete": "OverlapsComplete", "objective": "Objective", "closure_residual": "ClosureResidual",
    "E_len": "EdgeLengthError", "E_len_max": "MaxEdgeLengthError",
    "E_len_all": "EdgeLengthErrorAll", "E_ang": "AngleErrorMean",
    "E_h": "GlobalHomogeneity", "E_r": "GlobalAspectRatio", "E_area": "AreaError", "strain_p95": "StrainP95",
    "energy_rigid": "RigidEnergy", "energy_sheet": "DistortionEnergy", "energy_angles": "AngleEnergy",
    "cut_length": "CutLength", "solver_used": "SolverUsed", "energy_used": "EnergyUsed",
    "repaired": "Repaired", "fallbacks": "Fallbacks", "verdict": "Verdict",
    "forecast_area_loss": "ForecastAreaLoss", "forecast_area_loss_after_cut": "ForecastAreaLossAfterCut",
    "forecast_cut_from": "ForecastCutFrom", "forecast_cut_to": "ForecastCutTo"}
_CURVE = {
    "name": "Name", "type": "Type", "length_3d": "RestLength", "length_2d": "FlatLength",
    "error": "LengthError", "tolerance": "Tolerance", "closed_length": "ClosedLength",
    "sensitivity": "Sensitivity", "released": "Released"}
_ANGLE_STEP = {
    "phase": "Phase", "objective": "Objective", "closure": "Closure", "optimality": "Optimality",
    "step": "Step"}
_ISOMETRIC_STEP = {
    "exact": "Exact", "energy": "Energy", "length_error": "LengthError", "optimality": "Optimality",
    "move": "Move"}
# With a material.
_CLOTH = {
    "strain_warp_rms": "StrainWarpRms", "strain_weft_rms": "StrainWeftRms", "shear_rms": "ShearRms",
    "share_out_of_limit": "ShareOutOfLimit", "share_over_5_percent": "ShareOver5Percent",
    "share_locked": "ShareLocked", "shear_limit": "ShearLimit", "grain_angle": "GrainAngle",
    "grain_curve": "GrainCurve", "one_way": "OneWay"}



def _lists_of(table: Any, columns: Dict[str, str], pieces: int) -> List[List[Row]]:
    """The rows of each piece of a table with the column Piece."""
    lists: List[List[Row]] = [[] for _ in range(pieces)]
    for piece, row in zip(values_of(table.GetRowData(), "Piece"), rows_of(table, columns)):
        lists[piece].append(row)
    return lists


def _message(defect: str, remedies: List[Row]) -> str:
    return make_message(defect, [(remedy["name"], remedy["subject"]) for remedy in remedies])


def _releases(filter_: Any, pieces: List[Row]) -> List[Optional[Row]]:
    """What to release of each piece, None where nothing can be."""
    ranking = _lists_of(filter_.GetReleases(), {
        "curve": "Name", "release": "Shape", "tried": "Tried", "objective_without": "Objective",
        "E_area_without": "AreaError", "E_h_without": "Homogeneity"}, len(pieces))
    result: List[Optional[Row]] = []
    for trials, first in zip(ranking, rows_of(filter_.GetPieces(), {
            "first": "ReleaseFirst", "objective_without_first": "ObjectiveWithoutFirst"})):
        for trial in trials:
            trial["release"] = "shape" if trial["release"] else "curve"
            if not trial.pop("tried"):
                trial.update(objective_without=None, E_area_without=None, E_h_without=None)
        if first["objective_without_first"] < 0.0:
            first["objective_without_first"] = None
        result.append({**first, "ranking": trials} if first["first"] else None)
    return result


def _pieces(filter_: Any) -> List[Row]:
    pieces = rows_of(filter_.GetPieces(), _PIECE)
    cloths = rows_of(filter_.GetPieces(), _CLOTH) or [{}] * len(pieces)
    remedies = _lists_of(filter_.GetPieceRemedies(), {"name": "Remedy", "subject": "Subject"}, len(pieces))
    for piece, cloth, release, ways, angles, sheet in zip(
            pieces, cloths, _releases(filter_, pieces), remedies,
            _lists_of(filter_.GetAngleIterations(), _ANGLE_STEP, len(pieces)),
            _lists_of(filter_.GetIsometricIterations(), _ISOMETRIC_STEP, len(pieces))):
        if cloth and not math.isfinite(cloth["shear_limit"]):
            cloth["shear_limit"] = None
        piece.update(
            ids=[int(id_) for id_ in piece["ids"].split()], remedies=ways,
            message=_message(piece["message"], ways), release=release, history=angles,
            isometric_history=sheet, cloth=cloth or None)
    return pieces


def make_report(filter_: Any) -> Report:
    """What became of the last run of a filter that gave flat pieces."""
    remedies = [{"name": name, "subject": subject} for name, subject in remedies_of(filter_)]
    wires, interior, quality, total = filter_.GetSeconds()
    return cast(Report, {
        "status": filter_.GetStatusName(),
        "message": _message(as_text(filter_.GetStatusDefect()), remedies),
        "ids": ids_of(filter_),
        "id_kind": filter_.GetStatusIdKind(),
        "remedies": remedies,
        "warnings": texts_of(filter_.GetStatusWarnings()),
        "pieces": _pieces(filter_),
        "left_out": rows_of(
            filter_.GetLeftOutPieces(), {"reason": "Reason", "cell": "Cell", "triangles": "Triangles"}),
        "curves": rows_of(filter_.GetCurves(), _CURVE),
        "seconds": {
            "wires": wires, "interior": interior, "quality": quality, "core": total, "total": total},
    })
