# SPDX-License-Identifier: BSD-3-Clause
"""Results as patterns to cut."""

from __future__ import annotations  # hints name a class of a module that may be missing

import warnings
from typing import TYPE_CHECKING, Any, Mapping, Sequence, get_args

from ._errors import ArgumentError, ArgumentTypeError, FlatteningWarning
from ._option_table import TABLE
from ._options import checked, index_of, text_of
from ._report import error_of
from ._types import Unit
from ._vtk import silence, status_of
from .vtkFiltersFlattening import vtkFlatteningAlgorithm

if TYPE_CHECKING:
    from .vtkIOPattern import vtkPatternWriter

_TABLE = [option for option in TABLE if option.cls == "vtkPatternWriter"]


def _in_range(name: str, what: str, value: Any) -> Any:
    (option,) = [option for option in _TABLE if option.name == name]
    try:
        inside = option.minimum <= value <= option.maximum
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a number") from None
    if not inside:
        raise ArgumentError(f"{what} = {value!r} is out of range; it must be in {option.range}")
    return value


def _set_options(writer: vtkPatternWriter, options: Mapping[str, Any]) -> None:
    for option in _TABLE:
        value = options[option.name]
        # None: chosen by the pieces.
        if option.type != "list" and not (value is None and option.default is None):
            getattr(writer, "Set" + option.property)(checked(option, value))
    if options["unit"] is not None:
        writer.SetUnit(1 + index_of(options["unit"], get_args(Unit), "unit"))
    for name in ("piece_names", "double_notches", "folds"):
        if isinstance(options[name], str):
            raise ArgumentTypeError(f"{name} = {options[name]!r} must be a list of names")
    for piece, quantity in enumerate(options["piece_quantities"]):
        what = f"piece_quantities[{piece}]"
        try:
            writer.SetPieceQuantity(piece, _in_range("piece_quantities", what, quantity))
        except TypeError as error:
            raise ArgumentTypeError(f"{what} = {quantity!r}: {error}") from None
    for piece, text in enumerate(options["piece_names"]):
        writer.SetPieceName(piece, text_of(f"piece_names[{piece}]", text))
    for curve, allowance in (options["curve_allowances"] or {}).items():
        writer.SetCurveAllowance(curve, _in_range("curve_allowances", f"allowance of {curve!r}", allowance))
    for curve, distances in (options["curve_notches"] or {}).items():
        for distance in distances:
            writer.AddCurveNotch(curve, _in_range("curve_notches", f"notch of {curve!r}", distance))
    for name, add in (("double_notches", writer.AddDoubleNotches), ("folds", writer.AddFold)):
        for curve in options[name]:
            add(text_of(name, curve))
    for curve, distance in (options["curve_dart_tips"] or {}).items():
        writer.SetCurveDartTip(curve, _in_range("curve_dart_tips", f"dart tip of {curve!r}", distance))
    for curve, tolerance in (options["curve_fairs"] or {}).items():
        writer.SetCurveFairTolerance(curve, _in_range("curve_fairs", f"fair of {curve!r}", tolerance))


def write_parts(parts: Sequence[Any], path: str, options: Mapping[str, Any]) -> None:
    """Writes the file of flat pieces, wires and cut surface, or raises what the writer says."""
    from .vtkIOPattern import vtkPatternWriter  # a build without patterns has none

    writer = vtkPatternWriter()
    _set_options(writer, options)
    writer.SetFileName(text_of("path", path))
    for port, part in enumerate(parts):
        writer.SetInputData(port, part)
    if options["sizes"] is not None:
        writer.SetInputData(3, options["sizes"].nest)
    silence(writer)
    if not writer.Write():
        raise error_of(status_of(writer))
    for warning in range(writer.GetNumberOfWarnings()):
        warnings.warn(writer.GetWarning(warning) + "; give it key_shape=\"straight\"",
                      FlatteningWarning, stacklevel=3)
    if options["unit"] is None and not vtkFlatteningAlgorithm.GetLengthUnitOf(parts[0]):
        warnings.warn("the unit of the surface is taken as cm; state it with unit=\"mm\", \"cm\", \"m\" "
                      "or \"inch\"", FlatteningWarning, stacklevel=3)


def write_sizes(flat: Any, nest: Any, path: str, format_: str, name: str, unit: Unit) -> None:
    """Writes a file of the output of vtkPatternGrading, whose base has these flat pieces."""
    from .vtkIOPattern import vtkPatternWriter  # a build without patterns has none

    writer = vtkPatternWriter()
    writer.SetFileName(text_of("path", path))
    getattr(writer, "SetFileFormatTo" + format_)()
    writer.SetPatternName(text_of("name", name))
    writer.SetUnit(1 + index_of(unit, get_args(Unit), "unit"))
    writer.SetInputData(0, flat)
    writer.SetInputData(3, nest)
    silence(writer)
    if not writer.Write():
        raise error_of(status_of(writer))
