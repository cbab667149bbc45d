# SPDX-License-Identifier: BSD-3-Clause
"""What a flattening gives, as numpy arrays and plain Python."""

from typing import Any, Dict, List, NamedTuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._curves import CURVE_TYPES
from ._remedies import make_message

Report = Dict[str, Any]

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
}
_PIECE_TEXTS = {
    "status": "Status",
    "message": "StatusDefect",
    "id_kind": "StatusIdKind",
    "solver_used": "SolverUsed",
    "energy_used": "EnergyUsed",
    "fallbacks": "Fallbacks",
}
_SECONDS = {
    "wires": "SecondsWires",
    "interior": "SecondsInterior",
    "quality": "SecondsQuality",
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
# Of a curve that may be released: what the piece would be without it.
_RELEASE_NUMBERS = {
    "objective_without": "ReleaseObjective",
    "E_area_without": "ReleaseAreaError",
    "E_h_without": "ReleaseHomogeneity",
}


class Wire(NamedTuple):
    """A wire in the plane: a chain of the boundary, or one side of a feature curve."""

    #: Points along the wire, rows of Flattening.positions; int64, shape (k,).
    vertices: NDArray[np.int64]
    #: "accessory", "key", "dart", "seam", or "boundary", or "connector" (its length is free).
    type: str
    #: Place of the feature curve in the report's "curves", or -1.
    curve: int
    #: Name of the feature curve, or "boundary" or "connector".
    name: str
    #: Row of the report's "pieces".
    piece: int
    #: Whether it bounds its piece.
    boundary: bool
    #: Lengths on the surface and in the plane, unit of length.
    rest_length: float
    flat_length: float
    #: Largest relative length error of one of its edges.
    length_error: float


class Flattening(NamedTuple):
    """Flat pieces. n points and m triangles are those of the surface after cuts and imprints."""

    #: Positions in the plane, unit of length of the surface; float64, shape (n, 2).
    positions: NDArray[np.float64]
    #: Corners of the triangles, counter-clockwise; int64, shape (m, 3).
    triangles: NDArray[np.int64]
    #: The same points on the cut surface in space; float64, shape (n, 3).
    points: NDArray[np.float64]
    #: By name, a value a point, such as "Developability" and "vtkOriginalPointIds"; see
    #: vtkWireWarpingFilter for all names. Arrays of texts and without a name are not there.
    point_arrays: Dict[str, NDArray[Any]]
    #: By name, a value a triangle, such as "HomogeneityOfDistortion", "AspectRatio", "AreaRatio",
    #: "PieceId".
    cell_arrays: Dict[str, NDArray[Any]]
    #: Boundary and feature curves in the plane.
    wires: List[Wire]
    #: Cut edges that are sewn together: points a, b, c, d and the curve, edge ab to edge cd, a to c
    #: and b to d; int64, shape (k, 5).
    seam_pairs: NDArray[np.int64]
    #: Whether such a pair lies on each other because close_cuts closed the cut; bool, shape (k,).
    seam_closed: NDArray[np.bool_]
    #: Boundary edges that cross in the plane: points a, b and c, d and the piece; int64, (k, 5).
    #: 1000 pairs a piece at most; the report's "overlaps" counts all.
    overlap_edges: NDArray[np.int64]
    #: Measures, plain Python that json can write, with the keys of wirewarp's report.json: "status",
    #: "message", "ids", "id_kind", "remedies", "warnings", "left_out", "pieces" (E_len, E_ang, E_h, ...),
    #: "curves" (length_3d, length_2d, error, ...)
    #: and "seconds".
    report: Report


def as_text(value: Any) -> str:
    """A text of VTK, which gives bytes where they are no UTF-8."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _as_numpy(array: Any) -> NDArray[Any]:
    """A copy."""
    if isinstance(array, vtkBitArray):
        bytes_ = vtkUnsignedCharArray()
        bytes_.DeepCopy(array)
        return np.array(vtk_to_numpy(bytes_), np.bool_)
    return np.array(vtk_to_numpy(array))


def _values(field: Any, name: str) -> List[Any]:
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
    values: List[str] = _values(field, name)
    return values


def _arrays(attributes: Any) -> Dict[str, NDArray[Any]]:
    result = {}
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(index)  # None for strings
        if array is not None and array.GetName():
            result[array.GetName()] = _as_numpy(array)
    return result


def _rows(field: Any, name: str, components: int) -> NDArray[np.int64]:
    array = field.GetAbstractArray(name)
    if array is None:
        return np.empty((0, components), np.int64)
    return np.array(vtk_to_numpy(array), np.int64).reshape(-1, components)


def _wires(output: vtkPolyData) -> List[Wire]:
    cells = output.GetCellData()
    columns = {
        name: _values(cells, name)
        for name in ("CurveType", "CurveId", "CurveName", "PieceId", "Boundary", "Connector",
                     "RestLength", "FlatLength", "LengthError")
    }
    offsets = vtk_to_numpy(output.GetLines().GetOffsetsArray())
    connectivity = vtk_to_numpy(output.GetLines().GetConnectivityArray())
    result = []
    for row, kind in enumerate(columns["CurveType"]):
        other = "connector" if columns["Connector"][row] else "boundary"
        result.append(Wire(
            vertices=np.array(connectivity[offsets[row]:offsets[row + 1]], np.int64),
            type=other if kind < 0 else CURVE_TYPES[kind],
            curve=columns["CurveId"][row],
            name=columns["CurveName"][row],
            piece=columns["PieceId"][row],
            boundary=bool(columns["Boundary"][row]),
            rest_length=columns["RestLength"][row],
            flat_length=columns["FlatLength"][row],
            length_error=columns["LengthError"][row],
        ))
    return result


def _add_history(
        field: Any, key: str, owner: str, names: Dict[str, str], pieces: List[Report]) -> None:
    """Adds a list of iterations to each piece, from arrays with a row an iteration."""
    columns = {column: _values(field, name) for column, name in names.items()}
    for entry in pieces:
        entry[key] = []
    for row, piece in enumerate(_values(field, owner)):
        pieces[piece][key].append({column: values[row] for column, values in columns.items()})


def _message(defect: str, remedies: List[Dict[str, str]]) -> str:
    return make_message(defect, [(remedy["name"], remedy["subject"]) for remedy in remedies])


def _report(flat: vtkPolyData, wires: vtkPolyData) -> Report:
    field, curve_field = flat.GetFieldData(), wires.GetFieldData()
    columns = {key: _values(field, name)
               for key, name in {**_PIECE_INTEGERS, **_PIECE_NUMBERS, **_PIECE_TEXTS}.items()}
    columns["overlaps_complete"] = [bool(all_) for all_ in _values(field, "OverlapsComplete")]
    pieces: List[Report] = [
        {"piece": piece, **{key: column[piece] for key, column in columns.items()}, "ids": [],
         "remedies": []}
        for piece in range(len(columns["triangles"]))
    ]
    for row, value in zip(_values(field, "StatusIdPiece"), _values(field, "StatusId")):
        pieces[row]["ids"].append(value)
    for row, name, subject in zip(
            *(_values(field, name) for name in ("RemedyPiece", "RemedyName", "RemedySubject"))):
        pieces[row]["remedies"].append({"name": name, "subject": subject})
    for piece in pieces:
        piece["message"] = _message(piece["message"], piece["remedies"])
    names = _values(curve_field, "CurveNames")
    for entry, first, objective in zip(
            pieces, _values(field, "ReleaseFirst"), _values(field, "ObjectiveWithoutFirst")):
        entry["release"] = None if first < 0 else {
            "first": names[first],
            "objective_without_first": objective if objective >= 0.0 else None,
            "ranking": []}
    without = {key: _values(field, name) for key, name in _RELEASE_NUMBERS.items()}
    for row, (piece, curve, shape, tried) in enumerate(zip(*(_values(field, name) for name in (
            "ReleasePiece", "ReleaseCurve", "ReleaseShape", "ReleaseTried")))):
        pieces[piece]["release"]["ranking"].append(
            {"curve": names[curve], "release": "shape" if shape else "curve",
             **{key: column[row] if tried else None for key, column in without.items()}})
    for repaired, entry in zip(_values(field, "Repaired"), pieces):
        entry["repaired"] = bool(repaired)
    _add_history(field, "history", "HistoryPiece", _HISTORY, pieces)
    _add_history(
        field, "isometric_history", "IsometricHistoryPiece", _ISOMETRIC_HISTORY, pieces)
    for entry in pieces:
        for record in entry["isometric_history"]:
            record["exact"] = bool(record["exact"])
    curves = zip(*(_values(curve_field, name) for name in (
        "CurveNames", "CurveTypes", "CurveRestLengths", "CurveFlatLengths", "CurveLengthErrors",
        "CurveTolerances", "CurveClosedLengths", "CurveSensitivities", "CurveReleased")))
    remedies = [{"name": name, "subject": subject} for name, subject in zip(
        _values(field, "RunRemedyName"), _values(field, "RunRemedySubject"))]
    return {
        "status": _values(field, "RunStatus")[0],
        "message": _message(_values(field, "RunStatusDefect")[0], remedies),
        "ids": _values(field, "RunStatusIds"),
        "id_kind": _values(field, "RunStatusIdKind")[0],
        "remedies": remedies,
        "warnings": texts_of(field, "RunWarnings"),
        "pieces": pieces,
        "left_out": [
            {"reason": reason, "cell": cell, "triangles": triangles}
            for reason, cell, triangles in zip(*(_values(field, name) for name in (
                "LeftOutReasons", "LeftOutCells", "LeftOutTriangles")))
        ],
        "curves": [
            {"name": name, "type": CURVE_TYPES[kind], "length_3d": rest, "length_2d": length,
             "error": error, "tolerance": tolerance, "closed_length": closed,
             "sensitivity": sensitivity, "released": bool(released)}
            for name, kind, rest, length, error, tolerance, closed, sensitivity, released in curves
        ],
        "seconds": {key: _values(field, name)[0] for key, name in _SECONDS.items()},
    }


def make_result(flat: vtkPolyData, wires: vtkPolyData, cut: vtkPolyData) -> Flattening:
    """The three outputs of vtkWireWarpingFilter as arrays of their own."""
    corners = vtk_to_numpy(flat.GetPolys().GetConnectivityArray())
    return Flattening(
        positions=np.array(vtk_to_numpy(flat.GetPoints().GetData())[:, :2], np.float64),
        triangles=np.array(corners, np.int64).reshape(-1, 3),
        points=np.array(vtk_to_numpy(cut.GetPoints().GetData()), np.float64),
        point_arrays=_arrays(flat.GetPointData()),
        cell_arrays=_arrays(flat.GetCellData()),
        wires=_wires(wires),
        seam_pairs=_rows(flat.GetFieldData(), "SeamPairs", 5),
        seam_closed=np.array(_values(flat.GetFieldData(), "SeamClosed"), np.bool_),
        overlap_edges=_rows(flat.GetFieldData(), "OverlapEdges", 5),
        report=_report(flat, wires),
    )
