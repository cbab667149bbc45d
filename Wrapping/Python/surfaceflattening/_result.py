# SPDX-License-Identifier: BSD-3-Clause
"""What a flattening gives, as numpy arrays and plain Python."""

from __future__ import annotations  # help() prints hints as they are written here

import os
from dataclasses import dataclass, field
from typing import (
    TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union, cast, get_args)

import numpy as np
from numpy.typing import NDArray

from ._curves import CURVE_TYPES
from ._equality import ComparedByValue, same
from ._options import word_of
from ._pieces import Data, Pieces
from ._report import Table, make_report, raise_refusal, values_in, warn_of
from ._types import Coloring, Part, Report, WireType
from ._write_pattern import Drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class Wire(ComparedByValue):
    """A wire in the plane: a chain of the boundary, or one side of a feature curve.

    Attributes:
        vertices: points along the wire, rows of Flattening.positions; int64, shape (k,).
        type: "accessory", "key", "dart", "seam", or "boundary", or "connector" (its length is free).
        curve: place of the feature curve in the report's "curves", or -1.
        name: name of the feature curve, or "boundary" or "connector".
        piece: row of the report's "pieces".
        boundary: whether it bounds its piece.
        rest_length, flat_length: lengths on the surface and in the plane, unit of length.
        length_error: largest relative length error of one of its edges.
    """

    vertices: NDArray[np.int64]
    type: WireType
    curve: int
    name: str
    piece: int
    boundary: bool
    rest_length: float
    flat_length: float
    length_error: float

    def __repr__(self) -> str:
        return (f"<Wire {self.name!r}: {self.type}, {len(self.vertices)} points, piece {self.piece}, "
                f"length {self.flat_length:.6g}>")


@dataclass(frozen=True, eq=False)
class Flattening(ComparedByValue, Drawn):
    """Flat pieces; n points and m triangles are those of the surface after cuts and imprints.

    Two of them are equal where all values but the report's "seconds" are. A notebook shows the picture
    and the measures. to_polydata() copies the arrays and write_pattern() draws them,
    both as they are at the call.

    Attributes:
        positions: in the plane, unit of length of the surface; float64, shape (n, 2).
        triangles: corners, counter-clockwise; int64, shape (m, 3).
        points: the same points on the cut surface in space; float64, shape (n, 3).
        point_arrays: by name, a value a point, such as "Developability" and "vtkOriginalPointIds"; see
            vtkWireWarpingFilter for all names. Arrays of texts, and those without a name, are left out.
        cell_arrays: by name, a value a triangle, such as "HomogeneityOfDistortion", "AspectRatio",
            "AreaRatio", "PieceId".
        wires: boundary and feature curves in the plane, each a :class:`Wire`.
        seam_pairs: cut edges that are sewn together: points a, b, c, d and the curve, edge ab to edge
            cd, a to c and b to d; int64, shape (k, 5).
        seam_closed: whether such a pair lies on each other because close_cuts closed the cut; bool,
            shape (k,).
        overlap_edges: boundary edges that cross in the plane: points a, b and c, d and the piece;
            int64, shape (k, 5). 1000 pairs a piece at most; the report's "overlaps" counts all.
        report: measures, plain Python that json can write, with the keys of wirewarp's report.json:
            "status", "message", "ids", "id_kind", "remedies", "warnings", "left_out", "pieces" (E_len,
            E_ang, E_h, ...), "curves" (length_3d, length_2d, error, ...) and "seconds". help(Report),
            help(PieceReport) and help(CurveReport) say what each is.
    """

    positions: NDArray[np.float64]
    triangles: NDArray[np.int64]
    points: NDArray[np.float64]
    point_arrays: Dict[str, NDArray[Any]]
    cell_arrays: Dict[str, NDArray[Any]]
    wires: List[Wire]
    seam_pairs: NDArray[np.int64]
    seam_closed: NDArray[np.bool_]
    overlap_edges: NDArray[np.int64]
    report: Report
    # What to_polydata() has; the arrays above are of them.
    _parts: Pieces = field(repr=False)
    # Of the surface that was given, for to_polydata().
    _mesh_class: Optional[type] = field(repr=False, compare=False)

    def __reduce__(self) -> Any:
        return flattening_of, (self._parts, self.report, self._mesh_class)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Flattening):
            return NotImplemented
        mine, theirs = (
            {**vars(result), "report": {**cast(Dict[str, Any], result.report), "seconds": None},
             "_parts": None, "_mesh_class": None} for result in (self, other))
        return same(mine, theirs)

    def __repr__(self) -> str:
        report = self.report
        pieces, count = report["pieces"], len(report["pieces"])
        words = [f"{count} piece{'' if count == 1 else 's'}", f"{len(self.triangles)} triangles",
                 report["status"]]
        if pieces:
            words.append(f"E_len_max {max(piece['E_len_max'] for piece in pieces):.1e}")
            words.append(f"E_area {max(piece['E_area'] for piece in pieces):.3g}")
        return f"<Flattening: {', '.join(words)}>"

    def _repr_html_(self) -> str:
        from ._html import to_html
        return to_html(self)

    def to_polydata(self, part: Part = "flat") -> Any:
        """The result as a mesh, for VTK's pipelines and writers, and for PyVista.

        Args:
            part: "flat", the pieces in the plane (z is 0); "wires", their boundary and feature curves
                as lines; "cut", the cut surface in space, point for point like "flat", with the flat
                positions as texture coordinates.

        Returns:
            A vtkPolyData of its own, or an object of the class of the surface that was given to
            flatten_polydata(), such as pyvista.PolyData. It has all arrays of vtkWireWarpingFilter's
            output, with those that came with the surface.
        """
        from ._vtk import mesh_of_data
        return mesh_of_data(getattr(self._parts, word_of(part, get_args(Part), "part")), mesh_class=self._mesh_class)

    def plot(self, color_by: Optional[Coloring] = "homogeneity", *, ax: Optional[Axes] = None,
             measures: bool = True) -> Axes:
        """Draws pieces, wires and measures with matplotlib (Debian package python3-matplotlib).

        Args:
            color_by: what the colors show, the words of the command: of triangles "homogeneity" and
                "area", what flattening does to the area, or "aspect-ratio", to the shape; of points
                "developability", the surface's angle defect; with a material what its threads do,
                "stretch", "warp", "weft" or "shear". None: one color.
            ax: the axes to draw into. None: those of a new figure.
            measures: number the pieces, from 1 as patterns do, and write a line of measures for each piece below them.

        Returns:
            The axes; ``ax.figure.savefig("pieces.png")`` writes the picture.
        """
        from ._plot import plot
        return plot(self, color_by, ax, measures)


def wires_of(cells: Table, chains: Sequence[NDArray[np.int64]]) -> List[Wire]:
    """Wires by the arrays of their cells and their points."""
    columns = [values_in(cells, name) for name in (
        "CurveType", "CurveId", "CurveName", "PieceId", "Boundary", "Connector", "RestLength", "FlatLength", "LengthError")]
    result = []
    for vertices, (kind, curve, name, piece, boundary, connector, *lengths) in zip(chains, zip(*columns)):
        other: WireType = "connector" if connector else "boundary"
        result.append(Wire(
            vertices, other if kind < 0 else CURVE_TYPES[kind], curve, name, piece, bool(boundary), *lengths))
    return result


def flattening_of(parts: Pieces, report: Report, mesh_class: Optional[type]) -> Flattening:
    """Of the parts, which share the arrays of the result from now on."""
    flat, wires, cut = parts
    numbers = {kind: {name: values for name, values in flat[kind].items() if not isinstance(values, list)}
               for kind in ("point_arrays", "cell_arrays")}
    wires.update(points=flat["points"], point_arrays=flat["point_arrays"])
    positions, fields = flat["points"][:, :2], flat["field_arrays"]
    for kind in numbers:
        cut[kind].update(flat[kind])
    cut["point_arrays"]["FlatPositions"] = positions
    cut.update(corners=flat["corners"], offsets=flat["offsets"])
    return Flattening(
        positions=positions,
        triangles=flat["corners"].reshape(-1, 3),
        points=cut["points"],
        **numbers,
        wires=wires_of(wires["cell_arrays"], wires["lines"]),
        seam_pairs=fields["SeamPairs"] if "SeamPairs" in fields else np.empty((0, 5), np.int64),
        seam_closed=np.array(values_in(fields, "SeamClosed"), np.bool_),
        overlap_edges=fields["OverlapEdges"] if "OverlapEdges" in fields else np.empty((0, 5), np.int64),
        report=report,
        _parts=parts,
        _mesh_class=mesh_class)


def _keep_types(arrays: Data, given: Data, ids: NDArray[np.int64]) -> None:
    """Arrays that come from the input get its type of numbers, since the algorithms have four alone."""
    for name, values in given.items():
        array = arrays.get(name)
        if not isinstance(values, list) and isinstance(array, np.ndarray) and array.dtype != values.dtype:
            known = ids >= 0
            if np.array_equal(array[known], values[ids[known]], equal_nan=True):
                arrays[name] = array.astype(values.dtype)


def finished(run: Mapping[str, Any], data: Data, mesh_class: Optional[type] = None, stacklevel: int = 3) -> Flattening:
    """What a run of the algorithms gave for this input, or the error that says why there is nothing."""
    raise_refusal(run)
    warn_of(run, stacklevel)
    given = run["flattening"]
    parts = Pieces(given["flat"], given["wires"], given["cut"])
    for kind, ids in (("point_arrays", "vtkOriginalPointIds"), ("cell_arrays", "vtkOriginalCellIds")):
        for part in (parts.flat, parts.cut):
            _keep_types(part[kind], data.get(kind, {}), part[kind][ids])
    return flattening_of(parts, make_report(run, given), mesh_class)
