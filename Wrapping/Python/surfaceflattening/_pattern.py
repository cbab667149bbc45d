# SPDX-License-Identifier: BSD-3-Clause
"""Results as patterns to cut."""

from __future__ import annotations

import operator
import warnings
from typing import Any, Dict, Mapping, get_args

from . import _core
from ._errors import ArgumentError, ArgumentTypeError, FlatteningWarning
from ._option_table import TABLE
from ._options import checked, entries_of, index_of, list_of, text_of
from ._pieces import Pieces, unit_of
from ._report import raise_failure
from ._types import Unit

_TABLE = {option.name: option for option in TABLE if option.cls == "vtkPatternWriter"}
_OF_CURVES = {"curve_allowances": "allowance", "curve_notches": "notch", "curve_dart_tips": "dart tip", "curve_fairs": "fair"}
FORMATS = ("Automatic", "Svg", "Pdf", "Dxf", "Walk", "Hpgl", "GarmentCode", "Nest", "GradeList", "RuleTable")


def _in_range(name: str, what: str, value: Any, whole: bool = False) -> Any:
    option = _TABLE[name]
    try:
        inside = option.minimum <= value <= option.maximum
        number = operator.index(value) if whole else float(value)
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a {'whole ' if whole else ''}number") from None
    if not inside:
        raise ArgumentError(f"{what} = {value!r} is out of range; it must be in {option.range}")
    return number


def unit_number(unit: Any) -> int:
    """Of flattening::Unit."""
    return 1 + index_of(unit, get_args(Unit), "unit")


def _checked(options: Mapping[str, Any]) -> Dict[str, Any]:
    """Values that are known to be right, or an exception that names the wrong one."""
    # None: chosen by the pieces.
    values = {option.property: checked(option, options[name]) for name, option in _TABLE.items()
              if option.type != "list" and not (options[name] is None and option.default is None)}
    if options["unit"] is not None:
        values["unit"] = unit_number(options["unit"])
    values["piece_quantities"] = [
        _in_range("piece_quantities", f"piece_quantities[{piece}]", quantity, True)
        for piece, quantity in enumerate(list_of("piece_quantities", options["piece_quantities"], "whole numbers"))]
    values["piece_names"] = [text_of(f"piece_names[{piece}]", text)
                             for piece, text in enumerate(list_of("piece_names", options["piece_names"], "names"))]
    for name in ("double_notches", "folds"):
        values[name] = {text_of(name, curve) for curve in list_of(name, options[name], "names")}
    for name, what in _OF_CURVES.items():
        several = name == "curve_notches"
        contents = "curves' names and lists of millimeters" if several else "curves' names and millimeters"
        values[name] = {
            text_of(f"a curve of {name}", curve): [
                _in_range(name, f"{what} of {curve!r}", one)
                for one in list_of(f"{name} of {curve!r}", value, "millimeters")
            ] if several else _in_range(name, f"{what} of {curve!r}", value)
            for curve, value in entries_of(name, options[name], contents)}
    return values


def write_parts(parts: Pieces, path: str, options: Mapping[str, Any]) -> None:
    """Writes the file of flat pieces, wires and cut surface, or raises what is wrong."""
    values = _checked(options)
    stated = unit_of(parts.flat)
    if "unit" not in values and stated:
        values["unit"] = unit_number(stated)
    sizes = options["sizes"]
    status, notes = _core.write_pattern(
        *parts, text_of("path", path), values, None if sizes is None else sizes._grading)
    raise_failure(status)
    for warning in notes:
        warnings.warn(warning + "; give it key_shape=\"straight\"", FlatteningWarning, stacklevel=3)
    if "unit" not in values:
        warnings.warn("the unit of the surface is taken as cm; state it with unit=\"mm\", \"cm\", \"m\" "
                      "or \"inch\"", FlatteningWarning, stacklevel=3)


def write_sizes(flat: Any, grading: Any, path: str, format_: str, name: str, unit: Unit) -> None:
    """Writes a file of graded sizes, whose base has these flat pieces."""
    status, _ = _core.write_pattern(flat, None, None, text_of("path", path), {
        "format": FORMATS.index(format_), "PatternName": text_of("name", name), "unit": unit_number(unit)}, grading)
    raise_failure(status)
