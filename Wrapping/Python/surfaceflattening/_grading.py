# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of one pattern: pieces nested on each other, and how far each point goes from size to size."""

from __future__ import annotations  # help() prints hints as they are written here

import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union, get_args

import numpy as np
from numpy.typing import NDArray

from ._equality import ComparedByValue
from ._errors import ArgumentError
from ._options import index_of, text_of
from ._pattern import write_sizes
from ._result import Flattening
from ._types import Unit
from ._vtk import coordinates_of, copy_of, numbers_of, parts_of, update, values_of
from .vtkFiltersFlattening import vtkFlatteningAlgorithm


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
        nest: the same as a vtkPolyData, the output of vtkPatternGrading.
    """

    sizes: List[str]
    base: str
    positions: Dict[str, NDArray[np.float64]]
    rules: List[GradeRule]
    nest: Any
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
        """Writes an SVG at true scale with the sew lines of all sizes on each other, a layer a size.

        Raises:
            FileError: the file cannot be written; an earlier one stays.
        """
        self._write(path, "Nest", name)

    def _write(self, path: Union[str, os.PathLike[str]], format_: str, name: str = "pattern") -> None:
        write_sizes(self._flat, self.nest, os.fspath(path), format_, name, self._unit)


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
    from .vtkIOPattern import vtkPatternGrading  # a build without patterns has none

    filter_ = vtkPatternGrading()
    parts = {size: parts_of(result) for size, result in sizes.items()}
    stated = (vtkFlatteningAlgorithm.GetLengthUnitOf(part.flat) for part in parts.values())
    of_surfaces: Any = next((word for word in stated if word), "cm")
    length_unit: Unit = of_surfaces if unit is None else unit
    filter_.SetUnit(1 + index_of(length_unit, get_args(Unit), "unit"))
    for value, what, set_text in ((base, "base", filter_.SetBaseSize), (at, "at", filter_.SetAlignmentCurve)):
        if value is not None:
            set_text(text_of(what, value))
    if len(sizes) < 2:
        raise ArgumentError(f"there are {len(sizes)} sizes; grading needs two")
    for size, part in parts.items():
        filter_.AddSize(text_of("a size", size), part.flat, part.wires)
    update(filter_)
    nest = filter_.GetOutput()
    field = nest.GetFieldData()
    names = [str(name) for name in values_of(field, "SizeName")]
    chosen = names[values_of(field, "BaseSize")[0]]
    positions = coordinates_of(nest)[:, :2].reshape(len(names), -1, 2)
    rule_names = values_of(field, "RuleName")
    deltas = numbers_of(field, "RuleDelta") if rule_names else np.empty((0, 2 * len(names)))
    rules = [
        GradeRule(piece, point, name, tuple((float(dx), float(dy)) for dx, dy in row.reshape(-1, 2)))
        for piece, point, name, row in zip(
            values_of(field, "RulePiece"), values_of(field, "RulePoint"), rule_names, deltas)]
    return Grading(names, chosen, dict(zip(names, positions)), rules, nest, copy_of(parts[chosen].flat), length_unit)
