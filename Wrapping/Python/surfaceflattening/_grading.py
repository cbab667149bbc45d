# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern: pieces nested on each other, and how far each point goes from size to size."""

from __future__ import annotations  # help() prints hints as they are written here

import csv
import io
import os
import tempfile
from dataclasses import dataclass
from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple, Union, get_args
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from numpy.typing import NDArray

from ._options import index_of
from ._result import Flattening, Wire
from ._types import Unit

_MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
_CORNER = np.radians(30.0)  # turns of the boundary above this are grade points
_COLOURS = ("#000000", "#c00000", "#0060c0", "#008040", "#a000a0", "#c07000", "#606060", "#00a0a0")


class GradeRule(NamedTuple):
    """How one point of a piece goes from the base size to the others."""

    #: Row of the report's "pieces".
    piece: int
    #: Row of Flattening.positions, the same in all sizes.
    point: int
    #: The curves that meet there, such as "side, hem"; "boundary" for its own corners.
    name: str
    #: From the base size to each size, in mm, across the grain to the right and along it; (0, 0) for the base.
    deltas: Tuple[Tuple[float, float], ...]


@dataclass(frozen=True, eq=False, repr=False)
class Grading:
    """Sizes of one pattern, laid on each other piece by piece at a point and a direction of the grain.

    Attributes:
        sizes: their names, in the order given.
        base: the one that rules count from.
        positions: by size, points in mm from the point of their piece at which sizes are laid on each other, y
            along the grain; float64, shape (n, 2).
        rules: a row a grade point: ends of curves on the border, and corners of the boundary.
    """

    sizes: List[str]
    base: str
    positions: Dict[str, NDArray[np.float64]]
    rules: List[GradeRule]
    _wires: List[Wire]

    def __repr__(self) -> str:
        return f"<Grading: {', '.join(self.sizes)}; {len(self.rules)} grade points>"

    def write_rules(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the rule table as CSV: piece (from 1), point, name, and dx and dy of each size in mm.

        Raises:
            OSError: the file cannot be written; an earlier one stays.
        """
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["piece", "point", "name"] + [f"{axis} {size} mm" for size in self.sizes for axis in ("dx", "dy")])
        for rule in self.rules:
            table.writerow([rule.piece + 1, rule.point, rule.name]
                           + [f"{value:.4f}" for delta in rule.deltas for value in delta])
        _write(path, text.getvalue())

    def write_nest(self, path: Union[str, os.PathLike[str]], name: str = "nest") -> None:
        """Writes an SVG at true scale with the sew lines of all sizes on each other, a layer a size.

        Raises:
            OSError: the file cannot be written; an earlier one stays.
        """
        _write(path, self._svg(name))

    def _svg(self, name: str) -> str:
        margin, gap, top = 10.0, 20.0, 20.0
        pieces = sorted({wire.piece for wire in self._wires})
        shift: Dict[int, NDArray[np.float64]] = {}
        x, height = margin, 0.0
        for piece in pieces:
            ids = np.concatenate([wire.vertices for wire in self._wires if wire.piece == piece])
            points = np.concatenate([self.positions[size][ids] for size in self.sizes])
            low, high = points.min(axis=0), points.max(axis=0)
            shift[piece] = np.array([x - low[0], margin + top + high[1]])
            x += high[0] - low[0] + gap
            height = max(height, high[1] - low[1])
        width, height = x - gap + margin, height + top + 2 * margin
        lines = [
            '<?xml version="1.0" encoding="UTF-8"?>',
            '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
            f'version="1.1" width="{width:.6f}mm" height="{height:.6f}mm" viewBox="0 0 {width:.6f} {height:.6f}" '
            'font-family="sans-serif" fill="none" stroke-width="0.25">',
            f"<title>{escape(name)}</title>"]
        for number, size in enumerate(self.sizes):
            colour = _COLOURS[number % len(_COLOURS)]
            lines.append(f'<g inkscape:groupmode="layer" inkscape:label={quoteattr(size)} data-size={quoteattr(size)} '
                         f'stroke="{colour}">')
            lines.append(f'<text x="{margin + 25 * number}" y="{margin + 5}" font-size="5" stroke="none" '
                         f'fill="{colour}">{escape(size)}</text>')
            for wire in self._wires:
                drawn = self.positions[size][wire.vertices] * (1, -1) + shift[wire.piece]
                path = " L".join(f"{px:.9f},{py:.9f}" for px, py in drawn)
                lines.append(f'<path data-piece="{wire.piece + 1}" data-curve={quoteattr(wire.name)} d="M{path}"/>')
            lines.append("</g>")
        return "\n".join([*lines, "</svg>", ""])


def _write(path: Union[str, os.PathLike[str]], text: str) -> None:
    """Beside the file first, so that an earlier one is never half replaced."""
    target = os.fspath(path)
    folder = os.path.dirname(target) or "."
    handle, aside = tempfile.mkstemp(suffix=".part", dir=folder)
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(aside, 0o666 & ~umask)
        os.replace(aside, target)
    except OSError:
        os.unlink(aside)
        raise


def _check(sizes: Mapping[str, Flattening], base: str) -> None:
    model = sizes[base]
    for size, result in sizes.items():
        same = np.array_equal(result.triangles, model.triangles) and len(result.positions) == len(model.positions)
        if not same:
            raise ValueError(f"size {size!r} has another mesh than {base!r}: sizes must be surfaces of one "
                             "connectivity, with the same curves")
        for mine, theirs in zip(result.wires, model.wires):
            if (mine.name, mine.type, mine.piece) != (theirs.name, theirs.type, theirs.piece) \
                    or not np.array_equal(mine.vertices, theirs.vertices):
                raise ValueError(f"curve {mine.name!r} of size {size!r} runs elsewhere than in {base!r}, on piece "
                                 f"{mine.piece + 1}")
        if len(result.wires) != len(model.wires):
            raise ValueError(f"size {size!r} has other curves than {base!r}")


def _frames(result: Flattening, at: Optional[str], wires: List[Wire]) -> Dict[int, Tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """By piece the point at which sizes are laid on each other, and the direction of its grain."""
    frames = {}
    for piece in {wire.piece for wire in wires}:
        named = [wire for wire in wires if wire.piece == piece and wire.name == at]
        keys = [wire for wire in wires if wire.piece == piece and wire.type == "key" and not wire.boundary]
        chosen = named or ([] if at else keys)
        if chosen:
            chain = result.positions[chosen[0].vertices]
            way = chain[-1] - chain[0]
            length = np.linalg.norm(way)
            if length > 0.0:
                frames[piece] = (chain[0], way / length * (1.0 if way[1] >= 0.0 else -1.0))
                continue
        ids = np.unique(np.concatenate([wire.vertices for wire in wires if wire.piece == piece]))
        frames[piece] = (result.positions[ids].mean(axis=0), np.array([0.0, 1.0]))
    return frames


def _laid(result: Flattening, at: Optional[str], wires: List[Wire], scale: float) -> NDArray[np.float64]:
    positions = np.array(result.positions)
    piece_of = np.zeros(len(positions), np.int64)
    piece_of[result.triangles] = result.cell_arrays["PieceId"][:, None]
    for piece, (origin, along) in _frames(result, at, wires).items():
        mine = piece_of == piece
        turn = np.array([[along[1], -along[0]], [along[0], along[1]]])
        positions[mine] = scale * (positions[mine] - origin) @ turn.T
    return positions


def _grade_points(result: Flattening, wires: List[Wire]) -> List[Tuple[int, int, str]]:
    points: Dict[Tuple[int, int], List[str]] = {}
    border = {(wire.piece, int(vertex)) for wire in wires if wire.boundary for vertex in wire.vertices}
    for wire in wires:
        for end in (wire.vertices[0], wire.vertices[-1]):
            key = (wire.piece, int(end))
            if key in border and wire.vertices[0] != wire.vertices[-1]:
                names = points.setdefault(key, [])
                if wire.name not in names:
                    names.append(wire.name)
        if wire.type == "boundary":
            closed = wire.vertices[0] == wire.vertices[-1]
            ids = np.append(wire.vertices, wire.vertices[1:2]) if closed else wire.vertices
            chain = result.positions[ids]
            steps = np.diff(chain, axis=0)
            turns = np.arctan2(
                steps[:-1, 0] * steps[1:, 1] - steps[:-1, 1] * steps[1:, 0], np.sum(steps[:-1] * steps[1:], axis=1))
            for place in np.flatnonzero(np.abs(turns) > _CORNER):
                points.setdefault((wire.piece, int(ids[place + 1])), [wire.name])
    return [(piece, point, ", ".join(names)) for (piece, point), names in sorted(points.items())]


def grade(
    sizes: Mapping[str, Flattening],
    *,
    base: Optional[str] = None,
    unit: Unit = "cm",
    at: Optional[str] = None,
) -> Grading:
    """Grades a pattern by several surfaces: lays the flat pieces of all sizes on each other.

    Args:
        sizes: flattenings by the name of their size, of surfaces of one connectivity with the same curves, such as
            one garment fitted to several bodies; two at least.
        base: the size that rules count from. None: the one in the middle.
        unit: unit of length of the surfaces: "mm", "cm", "m" or "inch".
        at: name of a curve at whose first point and along whose chord sizes are laid on each other. None: the
            first key curve inside each piece; where there is none, the middle of its border, as it lies.

    Returns:
        A :class:`Grading`, which writes a nest and a rule table.

    Raises:
        ValueError: fewer than two sizes, a base, unit or curve that is not there, or sizes that differ in more than
            where their points are; the message names the size and the curve.
    """
    names = list(sizes)
    if len(names) < 2:
        raise ValueError(f"there are {len(names)} sizes; grading needs two at least")
    chosen = names[(len(names) - 1) // 2] if base is None else base
    if chosen not in sizes:
        raise ValueError(f"there is no size {chosen!r}; there are {', '.join(names)}")
    index_of(unit, get_args(Unit), "unit")
    _check(sizes, chosen)
    model = sizes[chosen]
    wires = [wire for wire in model.wires if wire.type != "connector"]
    if at is not None and all(wire.name != at for wire in wires):
        raise ValueError(f"no curve is named {at!r}; the curves are "
                         f"{', '.join(sorted({wire.name for wire in wires}))}")
    laid = {size: _laid(result, at, wires, _MILLIMETRES[unit]) for size, result in sizes.items()}
    rules = []
    for piece, point, name in _grade_points(model, wires):
        deltas = []
        for size in names:
            dx, dy = laid[size][point] - laid[chosen][point]
            deltas.append((float(dx), float(dy)))
        rules.append(GradeRule(piece, point, name, tuple(deltas)))
    return Grading(names, chosen, laid, rules, wires)
