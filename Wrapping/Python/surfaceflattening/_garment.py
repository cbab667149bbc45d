# SPDX-License-Identifier: BSD-3-Clause
"""Sewing patterns of GarmentCode as flat pieces with seams."""

from __future__ import annotations  # help() prints hints as they are written here

import json
import os
from dataclasses import dataclass
from typing import Any, List, Literal, Tuple, Union, get_args

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._equality import ComparedByValue
from ._errors import ArgumentTypeError
from ._options import text_of, word_of
from ._pattern import write_parts
from ._pieces import Pieces
from ._report import raise_failure
from ._result import Wire, wires_of
from ._types import Part

EdgeShape = Literal["straight", "quadratic", "cubic", "circle"]


@dataclass(frozen=True, eq=False)
class PanelEdge(ComparedByValue):
    """An edge of a panel."""

    #: Rows of the panel's vertices at which it begins and ends.
    ends: Tuple[int, int]
    shape: EdgeShape
    #: Of a straight edge none. Of a quadratic or cubic edge x and y of each control point, along the chord
    #: and to its left, in lengths of the chord. Of a circle the radius in cm, 1 for the larger arc (else 0)
    #: and 1 for counter-clockwise (else 0).
    parameters: Tuple[float, ...]
    label: str


@dataclass(frozen=True, eq=False, repr=False)
class Panel(ComparedByValue):
    """A panel of a pattern."""

    name: str
    label: str
    #: In its plane, cm; float64, shape (k, 2).
    vertices: NDArray[np.float64]
    #: One after the other around the panel.
    edges: List[PanelEdge]
    #: Where it is in space: cm, and degrees about the fixed axes x, then y, then z.
    translation: Tuple[float, float, float]
    rotation: Tuple[float, float, float]

    def __repr__(self) -> str:
        return f"<Panel {self.name!r}: {len(self.edges)} edges>"


@dataclass(frozen=True, eq=False)
class Stitch(ComparedByValue):
    """Two edges that are sewn together, each a panel and an edge of it, from 0."""

    first: Tuple[int, int]
    second: Tuple[int, int]
    #: Whether start is sewn to start instead of start to end.
    right_to_wrong: bool


@dataclass(frozen=True, eq=False, repr=False)
class GarmentPattern:
    """Panels and stitches of a file, and the same as flat pieces; lengths in cm."""

    panels: List[Panel]
    stitches: List[Stitch]
    #: Points on the borders in the plane; float64, shape (n, 2).
    positions: NDArray[np.float64]
    #: Between them, counter-clockwise; int64, shape (m, 3).
    triangles: NDArray[np.int64]
    #: The panel of each triangle; int64, shape (m,).
    piece_ids: NDArray[np.int64]
    #: The points where the panels are placed in space; float64, shape (n, 3).
    points: NDArray[np.float64]
    #: The borders: seams, darts, labelled edges and the rest.
    wires: List[Wire]
    #: As :attr:`Flattening.seam_pairs`.
    seam_pairs: NDArray[np.int64]
    _parts: Pieces

    def __repr__(self) -> str:
        count = len(self.panels)
        return f"<GarmentPattern: {count} panel{'' if count == 1 else 's'}, {len(self.stitches)} stitches>"

    def to_polydata(self, part: Part = "flat") -> Any:
        """A vtkPolyData of its own: "flat", the pieces; "wires", their borders; "cut", the pieces placed
        in space; with the arrays of vtkGarmentCodeReader."""
        from ._vtk import mesh_of_data
        return mesh_of_data(getattr(self._parts, word_of(part, get_args(Part), "part")))

    def write_pattern(self, path: Union[str, os.PathLike[str]], **options: Any) -> None:
        """Writes the panels as a pattern to cut, or as GarmentCode's JSON again: panels, edges and
        stitches are then those that were read.

        Args:
            path: as for :meth:`Flattening.write_pattern`.
            options: those of :meth:`Flattening.write_pattern` but unit, which is cm. Unless fair is given,
                borders are drawn by the chords of the panels' edges, at most 0.02 mm beside them.

        Raises:
            TypeError: there is no such option.
            FlatteningError: as :meth:`Flattening.write_pattern`.
        """
        from inspect import signature

        from ._result import Flattening
        known = {name: parameter.default
                 for name, parameter in signature(Flattening.write_pattern).parameters.items()
                 if parameter.kind is parameter.KEYWORD_ONLY and name != "unit"}
        for name in options:
            if name not in known:
                raise ArgumentTypeError(f"write_pattern() has no option {name!r}; there are {', '.join(known)}")
        if "fair" in options:
            # Panels are made smooth curve by curve.
            names = {wire.name for wire in self.wires} | {"boundary"}
            options["curve_fairs"] = {**dict.fromkeys(sorted(names), options["fair"]),
                                      **(options.get("curve_fairs") or {})}
        write_parts(self._parts, os.fspath(path), {**known, **options, "unit": "cm"})


def _triple(values: Any) -> Tuple[float, float, float]:
    return (float(values[0]), float(values[1]), float(values[2]))


def _edge(edge: Any) -> PanelEdge:
    curvature = edge.get("curvature", {"type": "straight", "params": []})
    start, end = edge["endpoints"]
    return PanelEdge((start, end), curvature["type"],
                     tuple(np.ravel(curvature["params"]).astype(float).tolist()), edge.get("label", ""))


def read_garmentcode(path: Union[str, os.PathLike[str]]) -> GarmentPattern:
    """Reads a sewing pattern of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, ACM Transactions on
    Graphics 42(6), 2023).

    Args:
        path: a JSON file with panels, straight, quadratic, cubic and circular edges, and stitches. Its
            lengths are brought to cm. Parameters of a design are ignored.

    Returns:
        A :class:`GarmentPattern`, whose write_pattern() draws it as SVG, PDF, DXF, HPGL or JSON.

    Raises:
        MissingFileError: there is no such file.
        FlatteningError: it cannot be read, or a panel or stitch cannot be; the message names panel and edge.
        OutOfMemoryError: there is not enough memory.
    """
    name = text_of("path", os.fspath(path))
    status, flat, wires, cut = _core.read_garmentcode(name)
    raise_failure(status, "" if os.path.exists(name) else "FileNotFound")
    for data in (flat, wires, cut):
        data["field_arrays"]["LengthUnit"] = ["cm"]
    positions = np.ascontiguousarray(flat["points"][:, :2])
    pattern = json.loads(wires["field_arrays"]["GarmentCode"][0])["pattern"]
    panels = [Panel(panel_name, panel.get("label", ""), np.array(panel["vertices"]),
                    [_edge(edge) for edge in panel["edges"]], _triple(panel["translation"]), _triple(panel["rotation"]))
              for panel_name, panel in pattern["panels"].items()]
    numbers = {panel.name: number for number, panel in enumerate(panels)}
    stitches = []
    for stitch in pattern["stitches"]:
        first, second = ((numbers[side["panel"]], side["edge"]) for side in stitch[:2])
        stitches.append(Stitch(first, second, len(stitch) > 2))
    return GarmentPattern(
        panels, stitches, positions, flat["corners"].reshape(-1, 3), flat["cell_arrays"]["PieceId"], cut["points"],
        wires_of(wires["cell_arrays"], wires["lines"]), flat["field_arrays"].get("SeamPairs", np.empty((0, 5), np.int64)),
        Pieces(flat, wires, cut))
