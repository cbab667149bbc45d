# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern: pieces nested on each other, and how far each point goes from size to size."""

from __future__ import annotations  # help() prints hints as they are written here

import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._equality import ComparedByValue
from ._errors import ArgumentError, ArgumentTypeError
from ._options import entries_of, text_of
from ._pattern import unit_number, write_sizes
from ._pieces import unit_of
from ._report import error_of
from ._result import Flattening
from ._types import Unit


@dataclass(frozen=True, eq=False)
class GradeRule(ComparedByValue):
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
        rules: one row for each grade point: ends of curves on the border, and corners of the boundary.
    """

    sizes: List[str]
    base: str
    positions: Dict[str, NDArray[np.float64]]
    rules: List[GradeRule]
    _grading: Any
    _flat: Any  # the base
    _unit: Unit

    def __repr__(self) -> str:
        return f"<Grading: {', '.join(self.sizes)}; {len(self.rules)} grade points>"

    def write_rules(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the rules as CSV: piece (from 1), point, name, and dx and dy of each size in mm.

        Raises:
            FileError: the file cannot be written; an earlier one stays.
        """
        self._write(path, "GradeList")

    def write_rule_table(self, path: Union[str, os.PathLike[str]], name: str = "pattern") -> None:
        """Writes the rule table of ASTM D6673 (.rul), for the DXF that :meth:`Flattening.write_pattern` writes
        of the base with ``sizes``: its rules go along the axes of that file.

        Raises:
            FileError: the file cannot be written; an earlier one stays.
        """
        self._write(path, "RuleTable", name)

    def write_nest(self, path: Union[str, os.PathLike[str]], name: str = "nest") -> None:
        """Writes an SVG at true scale with the sew lines of all sizes on each other, one layer for each size.

        Raises:
            FileError: the file cannot be written; an earlier one stays.
        """
        self._write(path, "Nest", name)

    def _write(self, path: Union[str, os.PathLike[str]], format_: str, name: str = "pattern") -> None:
        write_sizes(self._flat, self._grading, os.fspath(path), format_, name, self._unit)


def grade(
    sizes: Mapping[str, Flattening],
    *,
    base: Optional[str] = None,
    unit: Optional[Unit] = None,
    at: Optional[str] = None,
) -> Grading:
    """Grades a pattern by several surfaces: lays the flat pieces of all sizes on each other.

    Args:
        sizes: flattenings by the name of their size, of surfaces of one connectivity with the same curves, such as
            one garment fitted to several bodies; two at least.
        base: the size that rules count from. None: the one in the middle.
        unit: unit of length of the surfaces: "mm", "cm", "m" or "inch". None: that of the field data `LengthUnit`
            of the first surface; where there is none, cm.
        at: name of a curve at whose first point and along whose chord sizes are laid on each other. None: the
            first key curve inside each piece; where there is none, the middle of its wires, turned as they fit
            those of the base best.

    Returns:
        A :class:`Grading`, which writes a nest and a rule table.

    Raises:
        ValueError: fewer than two sizes, or another unit.
        FlatteningError: a base or curve that is not there, or sizes that differ in more than
            where their points are; the message names the size and the curve.
    """
    parts = {}
    for size, result in entries_of("sizes", sizes, "flattenings by the names of their sizes"):
        if not isinstance(result, Flattening):
            raise ArgumentTypeError(f"size {size!r} is {type(result).__name__}; it must be what flatten() gave")
        parts[text_of("a size", size)] = result._parts
    of_surfaces: Any = next(filter(None, (unit_of(part.flat) for part in parts.values())), "cm")
    length_unit: Unit = of_surfaces if unit is None else unit
    number = unit_number(length_unit)
    names = ["" if value is None else text_of(what, value) for value, what in ((base, "base"), (at, "at"))]
    if len(sizes) < 2:
        raise ArgumentError(f"there are {len(sizes)} sizes; grading needs two")
    status, graded = _core.grade([(size, part.flat, part.wires) for size, part in parts.items()], names[0], number, names[1])
    if status[0] != 0:
        raise error_of(status)
    chosen = graded["sizes"][graded["base"]]
    return Grading(
        graded["sizes"], chosen, dict(zip(graded["sizes"], graded["positions"])),
        [GradeRule(*rule) for rule in graded["rules"]], graded["grading"], parts[chosen].flat, length_unit)
