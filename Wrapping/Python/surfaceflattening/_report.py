# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run, and the errors and warnings of one without a sound result."""

import math
import warnings
from typing import Any, Dict, List, Mapping, Optional, Tuple, Type, cast

from ._errors import FileError, FlatteningError, FlatteningWarning, MissingFileError, OutOfMemoryError
from ._remedies import make_message
from ._types import Report

Row = Dict[str, Any]
# A table as its columns, each an array or a list of texts.
Table = Mapping[str, Any]
# Code, name, defect, ids, what they are of, and remedies with what each is to be applied to.
Status = Tuple[int, str, str, List[int], str, List[Tuple[str, str]]]

_TRUTH_VALUES = (
    "overlaps_complete", "repaired", "released", "exact", "one_way", "sound", "converged", "several_shapes")
_KINDS: Dict[str, Type[FlatteningError]] = {
    "FileNotWritten": FileError, "FileNotFound": MissingFileError, "OutOfMemory": OutOfMemoryError}

# Keys of the report and columns of the filter's tables.
MEASURES = {
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


def error_of(status: Status) -> FlatteningError:
    """The error of a run, or the warning that it is worth."""
    code, name, defect, ids, kind, remedies = status
    return _KINDS.get(name, FlatteningError)(code, name, ids, make_message(defect, remedies), kind, remedies)


def raise_failure(status: Status, name: str = "") -> None:
    """The error of an operation that gives a status alone, whose number is 0 where it went well; under another name."""
    if status[0] != 0:
        raise error_of((-1, name or status[1], status[2], status[3], status[4], status[5]))


def raise_refusal(run: Mapping[str, Any]) -> None:
    """FlatteningError where a run of the algorithms has no result."""
    if run["refused"]:
        raise error_of(run["status"])


def warn_of(run: Mapping[str, Any], stacklevel: int) -> None:
    """FlatteningWarning for all that a result is not."""
    for warning in run["warnings"]:
        warnings.warn(warning, FlatteningWarning, stacklevel=stacklevel + 1)
    if run["status"][0] != 0:
        warnings.warn(str(error_of(run["status"])), FlatteningWarning, stacklevel=stacklevel + 1)


def values_in(table: Table, name: str) -> List[Any]:
    """A column as Python values; empty where there is none."""
    column = table.get(name, [])
    return column if isinstance(column, list) else cast(List[Any], column.tolist())


def rows_of(table: Table, columns: Dict[str, str]) -> List[Row]:
    """The rows of a table, with some of its columns by other names; none where one is not there."""
    values = [values_in(table, name) for name in columns.values()]
    rows = [dict(zip(columns, row)) for row in zip(*values)]
    for row in rows:
        row.update((key, bool(row[key])) for key in _TRUTH_VALUES if key in row)
    return rows


def _lists_of(table: Table, columns: Dict[str, str], pieces: int) -> List[List[Row]]:
    """The rows of each piece of a table with the column Piece."""
    lists: List[List[Row]] = [[] for _ in range(pieces)]
    for piece, row in zip(values_in(table, "Piece"), rows_of(table, columns)):
        lists[piece].append(row)
    return lists


def _message(defect: str, remedies: List[Row]) -> str:
    return make_message(defect, [(remedy["name"], remedy["subject"]) for remedy in remedies])


def _releases(tables: Mapping[str, Table], pieces: List[Row]) -> List[Optional[Row]]:
    """What to release of each piece, None where nothing can be."""
    ranking = _lists_of(tables["releases"], {
        "curve": "Name", "release": "Shape", "tried": "Tried", "objective_without": "Objective",
        "E_area_without": "AreaError", "E_h_without": "Homogeneity"}, len(pieces))
    result: List[Optional[Row]] = []
    for trials, first in zip(ranking, rows_of(tables["pieces"], {
            "first": "ReleaseFirst", "objective_without_first": "ObjectiveWithoutFirst"})):
        for trial in trials:
            trial["release"] = "shape" if trial["release"] else "curve"
            if not trial.pop("tried"):
                trial.update(objective_without=None, E_area_without=None, E_h_without=None)
        if first["objective_without_first"] < 0.0:
            first["objective_without_first"] = None
        result.append({**first, "ranking": trials} if first["first"] else None)
    return result


def _pieces(tables: Mapping[str, Table]) -> List[Row]:
    pieces = rows_of(tables["pieces"], MEASURES)
    cloths = rows_of(tables["pieces"], _CLOTH) or [{}] * len(pieces)
    remedies = _lists_of(tables["piece_remedies"], {"name": "Remedy", "subject": "Subject"}, len(pieces))
    for piece, cloth, release, ways, angles, sheet in zip(
            pieces, cloths, _releases(tables, pieces), remedies,
            _lists_of(tables["angle_iterations"], _ANGLE_STEP, len(pieces)),
            _lists_of(tables["isometric_iterations"], _ISOMETRIC_STEP, len(pieces))):
        if cloth and not math.isfinite(cloth["shear_limit"]):
            cloth["shear_limit"] = None
        piece.update(
            ids=[int(id_) for id_ in piece["ids"].split()], remedies=ways,
            message=_message(piece["message"], ways), release=release, history=angles,
            isometric_history=sheet, cloth=cloth or None)
    return pieces


def make_report(run: Mapping[str, Any], flattening: Mapping[str, Any]) -> Report:
    """What became of a run that gave flat pieces."""
    _, name, defect, ids, kind, remedies = run["status"]
    tables = flattening["tables"]
    wires, interior, quality, total = flattening["seconds"]
    return cast(Report, {
        "status": name,
        "message": make_message(defect, remedies),
        "ids": ids,
        "id_kind": kind,
        "remedies": [{"name": remedy, "subject": subject} for remedy, subject in remedies],
        "warnings": run["warnings"],
        "pieces": _pieces(tables),
        "left_out": rows_of(tables["left_out"], {"reason": "Reason", "cell": "Cell", "triangles": "Triangles"}),
        "curves": rows_of(tables["curves"], _CURVE),
        "seconds": {
            "wires": wires, "interior": interior, "quality": quality, "core": total, "total": total},
    })
