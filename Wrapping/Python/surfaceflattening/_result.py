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
from ._errors import missing_vtk
from ._options import word_of
from ._report import Table, make_report, values_in
from ._types import Coloring, Paper, Part, Report, Unit, UpAxis, WireType
from ._version import BUILT_WITH_VTK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._grading import Grading
    from ._vtk import Parts


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
class Flattening(ComparedByValue):
    """Flat pieces; n points and m triangles are those of the surface after cuts and imprints.

    Two of them are equal where all values but the report's "seconds" are. A notebook shows the picture
    and the measures. to_polydata() copies the arrays and write_pattern() draws them: what is changed in them
    is changed there.

    Attributes:
        positions: in the plane, unit of length of the surface; float64, shape (n, 2).
        triangles: corners, counter-clockwise; int64, shape (m, 3).
        points: the same points on the cut surface in space; float64, shape (n, 3).
        point_arrays: by name, a value a point, such as "Developability" and "vtkOriginalPointIds"; see
            vtkWireWarpingFilter for all names. Arrays of texts and without a name are not there.
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
    # What to_polydata() has beside the above; of a mesh that was given all parts, whose arrays those above are.
    _field_arrays: Dict[str, Any] = field(default_factory=dict, repr=False)
    _wire_arrays: Dict[str, Any] = field(default_factory=dict, repr=False)
    _parts: Optional[Parts] = field(default=None, repr=False)
    # Of the surface that was given, for to_polydata().
    _mesh_class: Optional[type] = field(default=None, repr=False, compare=False)

    def __reduce__(self) -> Any:
        if self._parts is None:
            return object.__reduce_ex__(self, 2)
        from ._vtk import bytes_of, unpickled
        return unpickled, (*map(bytes_of, self._parts), self.report, self._mesh_class)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Flattening):
            return NotImplemented
        mine, theirs = (
            {**vars(result), "report": {**cast(Dict[str, Any], result.report), "seconds": None},
             "_field_arrays": None, "_wire_arrays": None, "_parts": None, "_mesh_class": None} for result in (self, other))
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
        from ._vtk import copy_of, parts_of
        return copy_of(getattr(parts_of(self), word_of(part, get_args(Part), "part")), self._mesh_class)

    def write_pattern(
        self,
        path: Union[str, os.PathLike[str]],
        *,
        unit: Optional[Unit] = None,
        name: str = "pattern",
        size: str = "",
        quantity: int = 1,
        piece_quantities: Sequence[int] = (),
        piece_names: Sequence[str] = (),
        allowance: Optional[float] = None,
        curve_allowances: Optional[Mapping[str, float]] = None,
        mitre_limit: float = 2.0,
        notch_spacing: Optional[float] = None,
        curve_notches: Optional[Mapping[str, Sequence[float]]] = None,
        double_notches: Sequence[str] = (),
        notch_corners: bool = False,
        notch_curve_ends: bool = False,
        notch_length: float = 5.0,
        join_marks: bool = True,
        up: UpAxis = "auto",
        cut_darts_out: bool = False,
        cut_on_fold: bool = False,
        folds: Sequence[str] = (),
        dart_tip: float = 0.0,
        curve_dart_tips: Optional[Mapping[str, float]] = None,
        cut_pairs: bool = False,
        fair: float = 0.2,
        curve_fairs: Optional[Mapping[str, float]] = None,
        symmetrize: bool = False,
        laser_colors: bool = False,
        cutter_style: bool = False,
        fabric_width: float = 0.0,
        nap: bool = False,
        fabric_gap: float = 5.0,
        paper: Paper = "A4",
        page_overlap: float = 10.0,
        max_pages: int = 200,
        walk_table: bool = False,
        sizes: Optional[Grading] = None,
    ) -> None:
        """Writes a pattern to cut, true to scale: SVG, PDF, DXF (R12 after ASTM D6673 / AAMA) or HPGL;
        panels and stitches of GarmentCode (.json); or the
        walk of its seams, both sides from notch to notch, as a table (.csv, see vtkPatternWriter).

        The options are those of the command wirewarp and mean the same. Lengths among them are in mm.

        Args:
            path: the file, which ends in .svg, .pdf, .dxf, .plt, .json or .csv. An earlier one stays where this fails.
            unit: unit of length of the surface: "mm", "cm", "m" or "inch". None: that of the field data `LengthUnit` of the surface;
                where there is none, cm, with a warning.
            name, size: of the pattern, to be written on it.
            quantity: how many of each piece are cut, 1 to 1,000,000.
            piece_quantities: how many of each piece in place of quantity, in the order of the report's,
                each 1 to 1,000,000; no more than there are pieces.
            piece_names: of the pieces, in the order of the report's.
            allowance: seam allowance, in [0, 1e6]; None: 10, and 0 of a material whose edges do not fray.
            curve_allowances: by the name of a curve, or "boundary", where it is another.
            mitre_limit: longest mitre of a corner, in allowances, in [1, 100].
            notch_spacing: distance of notches along seams and darts, in [0, 1e6]; 0: none but at the
                mouths of darts; None: about a sixth of the largest piece.
            curve_notches: by the name of a curve, a seam, a dart or one along the boundary, distances from
                its start in place of notch_spacing, each in [0, 1e6].
            double_notches: names of curves whose notches are double, as at the back: two marks 6.35 mm apart.
            notch_corners: notch the cut line at corners, where the sew lines, drawn on, meet it.
            notch_curve_ends: notch the border where feature curves and edges end on it, and opposite on
                what is sewn to it.
            notch_length: in [0, 1e6].
            join_marks: mark both sides of each stretch that is sewn to another with the same letters, and list
                them in a PDF.
            up: the axis of the surface that points up in each piece, with its grain along it, where the piece has no
                grain of its own: "x", "y", "z", "auto" (of y and z that along which the surface is larger), or "none".
            cut_darts_out: cut darts out along their allowance instead of folding them.
            cut_on_fold: draw a half of each symmetric piece, to be cut on the fold of the cloth.
            folds: names of curves along which pieces are cut on the fold: inside, where a half is drawn of a
                piece that must be symmetric about it, or on the border of a piece that is a half.
            dart_tip: how far tips of folded darts are drawn back, their legs with them, which are shorter then,
                in [0, 1e6] and at most half of a dart's depth.
            curve_dart_tips: by the name of a dart, another such distance.
            cut_pairs: of two pieces that are mirror images draw the first alone, to be cut in pairs of
                which one is turned over.
            fair: draw borders and curves as smooth splines of the same lengths, straight where nearly so, at
                most this far from the points of the mesh, in [0, 100]; 0: raw, as the mesh has them.
            curve_fairs: by the name of a curve, or "boundary", another such distance, each in [0, 100].
            symmetrize: draw the outline of each piece that is symmetric to 0.5 mm as exactly its own mirror
                image; sides whose lengths differ by up to 0.1 mm get their mean.
            laser_colors: draw an SVG in thin lines with a colour of its own for each role.
            cutter_style: draw a DXF for cutting machines: layers CUT, MARK and TEXT, each line once, with arcs.
            fabric_width: of SVG, PDF and HPGL: lay all copies of all pieces on cloth of this width, their
                grain along it, as short as a search finds it, in [0, 1e5]; 0: pieces in rows.
            nap: that cloth has an up and a down, so that no piece is turned by half a turn.
            fabric_gap: least distance of pieces on that cloth, in [0, 1000].
            paper: of a PDF: "A4", "letter", "A3", "A0", or "sheet", one page for all.
            page_overlap: how far its pages overlap, in [0, 50].
            max_pages: a PDF of more pages is refused, since the unit is likely wrong; 1 to 100,000.
            walk_table: add the walk of the seams to a PDF, on pages of its own.
            sizes: the sizes of which this is the base; a DXF has the numbers of their rules at its points then, as
                :meth:`Grading.write_rule_table` counts them. None: no numbers.

        Raises:
            ValueError: a word or a number out of range.
            FlatteningError: another file's extension, a curve that is not there, or what cannot be drawn.
            FileError: the file cannot be written.
            OutOfMemoryError: there is not enough memory to draw it.
        """
        options = {key: value for key, value in locals().items() if key not in ("self", "path")}
        if not BUILT_WITH_VTK:
            raise ImportError(missing_vtk("write_pattern()"))
        from ._pattern import write_parts
        from ._vtk import parts_of
        write_parts(parts_of(self), os.fspath(path), options)

    def plot(self, color_by: Optional[Coloring] = "homogeneity", *, ax: Optional[Axes] = None,
             measures: bool = True) -> Axes:
        """Draws pieces, wires and measures with matplotlib (Debian package python3-matplotlib).

        Args:
            color_by: what the colors show, the words of the command: of triangles "homogeneity" and
                "area", what flattening does to the area, or "aspect-ratio", to the shape; of points
                "developability", the surface's angle defect; with a material what its threads do,
                "stretch", "warp", "weft" or "shear". None: one colour.
            ax: the axes to draw into. None: those of a new figure.
            measures: number the pieces, from 1 as patterns do, and write a line of measures a piece below them.

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


def flattening_of(run: Mapping[str, Any], given: Mapping[str, Any], parts: Optional[Parts] = None,
                  mesh_class: Optional[type] = None, report: Optional[Report] = None) -> Flattening:
    """What a run of the algorithms gave."""
    fields = given["field_arrays"]
    return Flattening(
        positions=given["positions"],
        triangles=given["triangles"],
        points=given["points"],
        point_arrays=given["point_arrays"],
        cell_arrays=given["cell_arrays"],
        wires=wires_of(given["wire_arrays"], given["wires"]),
        seam_pairs=fields["SeamPairs"] if "SeamPairs" in fields else np.empty((0, 5), np.int64),
        seam_closed=np.array(values_in(fields, "SeamClosed"), np.bool_),
        overlap_edges=fields["OverlapEdges"] if "OverlapEdges" in fields else np.empty((0, 5), np.int64),
        report=make_report(run, given) if report is None else report,
        _field_arrays=fields,
        _wire_arrays=given["wire_arrays"],
        _parts=parts,
        _mesh_class=mesh_class)
