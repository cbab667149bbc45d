# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run, read from the arrays of the filter's outputs."""

import math
from typing import Any, Dict, List, Tuple, cast

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import CURVE_TYPES
from ._remedies import make_message
from ._types import Report

_Row = Dict[str, Any]

# Name in the report and field data array, one row a piece.
_PIECE_INTEGERS = {
    "triangles": "Triangles",
    "vertices": "Vertices",
    "wire_patches": "WirePatches",
    "wire_nodes": "WireNodes",
    "free_wire_nodes": "FreeWireNodes",
    "constraints": "Constraints",
    "iterations": "Iterations",
    "flipped": "FlippedTriangles",
    "overlaps": "Overlaps",
    "forecast_cut_from": "ForecastCutFrom",
    "forecast_cut_to": "ForecastCutTo",
}
_PIECE_NUMBERS = {
    "objective": "Objective",
    "closure_residual": "ClosureResidual",
    "E_len": "EdgeLengthError",
    "E_len_max": "MaxEdgeLengthError",
    "E_ang": "AngleErrorMean",
    "E_h": "GlobalHomogeneity",
    "E_r": "GlobalAspectRatio",
    "E_area": "AreaError",
    "strain_p95": "StrainP95",
    "energy_rigid": "RigidEnergy",
    "cut_length": "CutLength",
    "forecast_area_loss": "ForecastAreaLoss",
    "forecast_area_loss_after_cut": "ForecastAreaLossAfterCut",
}
_PIECE_TEXTS = {
    "status": "Status",
    "message": "StatusDefect",
    "id_kind": "StatusIdKind",
    "solver_used": "SolverUsed",
    "energy_used": "EnergyUsed",
    "fallbacks": "Fallbacks",
    "verdict": "Verdict",
    "name": "PieceNames",
    "size": "SizeInWords",
    "ease": "EaseInWords",
}
_SECONDS = {
    "wires": "SecondsWires",
    "interior": "SecondsInterior",
    "quality": "SecondsQuality",
    "core": "SecondsTotal",
    "total": "SecondsTotal",
}
_HISTORY = {
    "phase": "HistoryPhase",
    "objective": "HistoryObjective",
    "closure": "HistoryClosure",
    "optimality": "HistoryOptimality",
    "step": "HistoryStep",
}
_ISOMETRIC_HISTORY = {
    "exact": "IsometricHistoryExact",
    "energy": "IsometricHistoryEnergy",
    "length_error": "IsometricHistoryLengthError",
    "optimality": "IsometricHistoryOptimality",
    "move": "IsometricHistoryMove",
}
# With a material.
_CLOTH = {
    "strain_warp_rms": "StrainWarpRms",
    "strain_weft_rms": "StrainWeftRms",
    "shear_rms": "ShearRms",
    "share_out_of_limit": "ShareOutOfLimit",
    "share_over_5_percent": "ShareOver5Percent",
    "share_locked": "ShareLocked",
    "shear_limit": "ShearLimit",
    "grain_angle": "GrainAngle",
    "grain_curve": "GrainCurve",
    "one_way": "OneWay",
}
# Of a curve that may be released: what the piece would be without it.
_RELEASE_NUMBERS = {
    "objective_without": "ReleaseObjective",
    "E_area_without": "ReleaseAreaError",
    "E_h_without": "ReleaseHomogeneity",
}


def as_text(value: Any) -> str:
    """A text of VTK, which gives bytes where they are no UTF-8."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def remedies_of(source: Any) -> List[Tuple[str, str]]:
    """The ways out that a filter or writer found for its last run."""
    names, subjects = source.GetStatusRemedies(), source.GetStatusRemedySubjects()
    return [(names.GetValue(k), as_text(subjects.GetValue(k)))
            for k in range(names.GetNumberOfValues())]


def values_of(field: Any, name: str) -> List[Any]:
    """An array of one component as Python values; empty where there is none."""
    array = field.GetAbstractArray(name)
    if array is None:
        return []
    if isinstance(array, vtkStringArray):
        return [as_text(array.GetValue(row)) for row in range(array.GetNumberOfValues())]
    values: List[Any] = vtk_to_numpy(array).tolist()
    return values


def texts_of(field: Any, name: str) -> List[str]:
    """The rows of a string array; none where there is no such array."""
    values: List[str] = values_of(field, name)
    return values


def _add_history(
        field: Any, key: str, owner: str, names: Dict[str, str], pieces: List[_Row]) -> None:
    """Adds a list of iterations to each piece, from arrays with a row an iteration."""
    columns = {column: values_of(field, name) for column, name in names.items()}
    for entry in pieces:
        entry[key] = []
    for row, piece in enumerate(values_of(field, owner)):
        pieces[piece][key].append({column: values[row] for column, values in columns.items()})


def _add_cloth(field: Any, pieces: List[_Row]) -> None:
    columns = {key: values_of(field, name) for key, name in _CLOTH.items()}
    for row, entry in enumerate(pieces):
        entry["cloth"] = {key: column[row] for key, column in columns.items()} if all(
            columns.values()) else None
        if entry["cloth"]:
            entry["cloth"]["one_way"] = bool(entry["cloth"]["one_way"])
            if not math.isfinite(entry["cloth"]["shear_limit"]):
                entry["cloth"]["shear_limit"] = None


def _message(defect: str, remedies: List[Dict[str, str]]) -> str:
    return make_message(defect, [(remedy["name"], remedy["subject"]) for remedy in remedies])


def make_report(flat: vtkPolyData, wires: vtkPolyData) -> Report:
    field, curve_field = flat.GetFieldData(), wires.GetFieldData()
    columns = {key: values_of(field, name)
               for key, name in {**_PIECE_INTEGERS, **_PIECE_NUMBERS, **_PIECE_TEXTS}.items()}
    columns["overlaps_complete"] = [bool(all_) for all_ in values_of(field, "OverlapsComplete")]
    pieces: List[_Row] = [
        {"piece": piece, **{key: column[piece] for key, column in columns.items()}, "ids": [],
         "remedies": []}
        for piece in range(len(columns["triangles"]))
    ]
    for row, value in zip(values_of(field, "StatusIdPiece"), values_of(field, "StatusId")):
        pieces[row]["ids"].append(value)
    for row, name, subject in zip(
            *(values_of(field, name) for name in ("RemedyPiece", "RemedyName", "RemedySubject"))):
        pieces[row]["remedies"].append({"name": name, "subject": subject})
    for piece in pieces:
        piece["message"] = _message(piece["message"], piece["remedies"])
    names = values_of(curve_field, "CurveNames")
    for entry, first, objective in zip(
            pieces, values_of(field, "ReleaseFirst"), values_of(field, "ObjectiveWithoutFirst")):
        entry["release"] = None if first < 0 else {
            "first": names[first],
            "objective_without_first": objective if objective >= 0.0 else None,
            "ranking": []}
    without = {key: values_of(field, name) for key, name in _RELEASE_NUMBERS.items()}
    for row, (owner, curve, shape, tried) in enumerate(zip(*(values_of(field, name) for name in (
            "ReleasePiece", "ReleaseCurve", "ReleaseShape", "ReleaseTried")))):
        pieces[owner]["release"]["ranking"].append(
            {"curve": names[curve], "release": "shape" if shape else "curve",
             **{key: column[row] if tried else None for key, column in without.items()}})
    for repaired, entry in zip(values_of(field, "Repaired"), pieces):
        entry["repaired"] = bool(repaired)
    _add_history(field, "history", "HistoryPiece", _HISTORY, pieces)
    _add_history(
        field, "isometric_history", "IsometricHistoryPiece", _ISOMETRIC_HISTORY, pieces)
    for entry in pieces:
        for record in entry["isometric_history"]:
            record["exact"] = bool(record["exact"])
    _add_cloth(field, pieces)
    curves = zip(*(values_of(curve_field, name) for name in (
        "CurveNames", "CurveTypes", "CurveRestLengths", "CurveFlatLengths", "CurveLengthErrors",
        "CurveTolerances", "CurveClosedLengths", "CurveSensitivities", "CurveReleased")))
    remedies = [{"name": name, "subject": subject} for name, subject in zip(
        values_of(field, "RunRemedyName"), values_of(field, "RunRemedySubject"))]
    return cast(Report, {
        "status": values_of(field, "RunStatus")[0],
        "message": _message(values_of(field, "RunStatusDefect")[0], remedies),
        "ids": values_of(field, "RunStatusIds"),
        "id_kind": values_of(field, "RunStatusIdKind")[0],
        "remedies": remedies,
        "warnings": texts_of(field, "RunWarnings"),
        "pieces": pieces,
        "left_out": [
            {"reason": reason, "cell": cell, "triangles": triangles}
            for reason, cell, triangles in zip(*(values_of(field, name) for name in (
                "LeftOutReasons", "LeftOutCells", "LeftOutTriangles")))
        ],
        "curves": [
            {"name": name, "type": CURVE_TYPES[kind], "length_3d": rest, "length_2d": length,
             "error": error, "tolerance": tolerance, "closed_length": closed,
             "sensitivity": sensitivity, "released": bool(released)}
            for name, kind, rest, length, error, tolerance, closed, sensitivity, released in curves
        ],
        "seconds": {key: values_of(field, name)[0] for key, name in _SECONDS.items()},
    })
