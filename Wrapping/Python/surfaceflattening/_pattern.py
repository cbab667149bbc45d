# SPDX-License-Identifier: BSD-3-Clause
"""Results as patterns to cut."""

from __future__ import annotations  # hints name a class of a module that may be missing

import warnings
from typing import TYPE_CHECKING, Any, Mapping, Sequence, get_args

from ._errors import ArgumentError, ArgumentTypeError, FlatteningWarning
from ._options import flag, index_of, text_of
from ._report import error_of
from ._types import Paper, Unit, UpAxis
from ._vtk import silence, status_of
from .vtkFiltersFlattening import vtkFlatteningAlgorithm

if TYPE_CHECKING:
    from .vtkIOPattern import vtkPatternWriter

# Option: property of the writer, least and most, those of the command.
_NUMBERS = {
    "quantity": ("Quantity", 1, 1_000_000),
    "allowance": ("Allowance", 0.0, 1e6),
    "mitre_limit": ("MitreLimit", 1.0, 100.0),
    "notch_spacing": ("NotchSpacing", 0.0, 1e6),
    "notch_length": ("NotchLength", 0.0, 1e6),
    "dart_tip": ("DartTip", 0.0, 1e6),
    "fair": ("FairTolerance", 0.0, 100.0),
    "fabric_width": ("FabricWidth", 0.0, 1e5),
    "fabric_gap": ("FabricGap", 0.0, 1000.0),
    "page_overlap": ("PageOverlap", 0.0, 50.0),
    "max_pages": ("MaximumPages", 1, 100_000),
}
_FLAGS = {
    "cut_darts_out": "CutDartsOut", "symmetrize": "Symmetrize", "cut_on_fold": "CutOnFold",
    "notch_corners": "NotchCorners", "notch_curve_ends": "NotchCurveEnds", "walk_table": "WalkTable",
    "cut_pairs": "CutPairs", "laser_colors": "LaserColors", "cutter_style": "CutterStyle",
    "join_marks": "JoinMarks", "nap": "FabricNap"}


def _in_range(what: str, value: Any, least: float, most: float) -> Any:
    try:
        inside = least <= value <= most
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a number") from None
    if not inside:
        raise ArgumentError(f"{what} = {value!r} is out of range; it must be from {least:g} to {most:g}")
    return value


def _set_options(writer: vtkPatternWriter, options: Mapping[str, Any]) -> None:
    for option, (property_, least, most) in _NUMBERS.items():
        if options[option] is None and option in ("allowance", "notch_spacing"):
            continue  # chosen by the pieces
        value = _in_range(option, options[option], least, most)
        try:
            getattr(writer, "Set" + property_)(value)
        except TypeError as error:
            raise ArgumentTypeError(f"{option} = {value!r}: {error}") from None
    if options["unit"] is not None:
        writer.SetUnit(1 + index_of(options["unit"], get_args(Unit), "unit"))
    writer.SetPaper(index_of(options["paper"], get_args(Paper), "paper"))
    writer.SetUpAxis(index_of(options["up"], get_args(UpAxis), "up"))
    for option, property_ in _FLAGS.items():
        getattr(writer, "Set" + property_)(flag(options[option], option))
    for option, set_text in (("name", writer.SetPatternName), ("size", writer.SetPatternSize)):
        set_text(text_of(option, options[option]))
    for option in ("piece_names", "double_notches", "folds"):
        if isinstance(options[option], str):
            raise ArgumentTypeError(f"{option} = {options[option]!r} must be a list of names")
    for piece, quantity in enumerate(options["piece_quantities"]):
        what = f"piece_quantities[{piece}]"
        try:
            writer.SetPieceQuantity(piece, _in_range(what, quantity, 1, 1_000_000))
        except TypeError as error:
            raise ArgumentTypeError(f"{what} = {quantity!r}: {error}") from None
    for piece, name in enumerate(options["piece_names"]):
        writer.SetPieceName(piece, text_of(f"piece_names[{piece}]", name))
    for curve, allowance in (options["curve_allowances"] or {}).items():
        writer.SetCurveAllowance(curve, _in_range(f"allowance of {curve!r}", allowance, 0.0, 1e6))
    for curve, distances in (options["curve_notches"] or {}).items():
        for distance in distances:
            writer.AddCurveNotch(curve, _in_range(f"notch of {curve!r}", distance, 0.0, 1e6))
    for option, add in (("double_notches", writer.AddDoubleNotches), ("folds", writer.AddFold)):
        for curve in options[option]:
            add(text_of(option, curve))
    for curve, distance in (options["curve_dart_tips"] or {}).items():
        writer.SetCurveDartTip(curve, _in_range(f"dart tip of {curve!r}", distance, 0.0, 1e6))
    for curve, tolerance in (options["curve_fairs"] or {}).items():
        writer.SetCurveFairTolerance(curve, _in_range(f"fair of {curve!r}", tolerance, 0.0, 100.0))


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
