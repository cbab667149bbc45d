# SPDX-License-Identifier: BSD-3-Clause
"""The options of flatten(): names, properties of the filter, and where they mean something."""

from __future__ import annotations

import difflib
import inspect
import os
import sys
from numbers import Real
from typing import (
    Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, TypeVar,
    get_args, get_type_hints)

import numpy as np

from ._materials import materials
from ._types import CoincidentPoints, DartLegs, Energy, Interior, Options, Scheme, Solver
from .vtkFiltersFlattening import vtkWireWarpingFilter


Word = TypeVar("Word", bound=str)


class _Option(NamedTuple):
    property: str
    words: Tuple[str, ...] = ()


# Those that are a property of the filter, under the names of the command.
PROPERTIES = {
    "scheme": _Option("Scheme", get_args(Scheme)),
    "solver": _Option("Solver", get_args(Solver)),
    "interior": _Option("Interior", get_args(Interior)),
    "release_keys": _Option("ReleaseKeys"),
    "release_trials": _Option("ReleaseTrials"),
    "close_cuts": _Option("CloseCuts"),
    "dart_legs": _Option("DartLegs", get_args(DartLegs)),
    "skip_closed": _Option("SkipClosed"),
    "energy": _Option("DistortionEnergy", get_args(Energy)),
    "area_bias": _Option("AreaBias"),
    "angle_weight": _Option("AngleWeight"),
    "material": _Option("Material"),
    "grain": _Option("Grain"),
    "coincident_points": _Option("CoincidentPoints", get_args(CoincidentPoints)),
    "split_triangles": _Option("SplitTriangles"),
    "imprint_tolerance": _Option("ImprintTolerance"),
    "snap_tolerance": _Option("SnapTolerance"),
    "arrange": _Option("Arrange"),
    "spacing": _Option("Spacing"),
    "pins": _Option("ConformalPins"),
    "max_iterations": _Option("MaximumIterations"),
    "closure_tolerance": _Option("ClosureTolerance"),
    "optimality_tolerance": _Option("OptimalityTolerance"),
    "max_length_error": _Option("MaximumLengthError"),
    "relaxation_factor": _Option("RelaxationFactor"),
    "relaxation_movement": _Option("RelaxationMovement"),
    "relaxation_min_iterations": _Option("RelaxationMinimumIterations"),
    "relaxation_max_iterations": _Option("RelaxationMaximumIterations"),
    "rigid_tolerance": _Option("RigidEnergyTolerance"),
    "rigid_iterations": _Option("RigidMaximumIterations"),
    "isometric_tolerance": _Option("IsometricTolerance"),
    "isometric_iterations": _Option("IsometricMaximumIterations"),
}
_OTHERS: Dict[str, Any] = {"paper_method": False, "tolerance": None, "ease": None, "progress": None}


def _defaults() -> Dict[str, Any]:
    """In the order of Options; those of the filter are its own."""
    filter_ = vtkWireWarpingFilter()
    result = {}
    for name in Options.__annotations__:
        if name in PROPERTIES:
            value = getattr(filter_, "Get" + PROPERTIES[name].property)()
            words = PROPERTIES[name].words
            result[name] = words[value] if words else value
        else:
            result[name] = _OTHERS[name]
    return result


DEFAULTS = _defaults()


def with_options(function: Any) -> Any:
    """Shows the options in the signature and the hints of a function that takes them as keywords."""
    hints = get_type_hints(Options)
    signature = inspect.signature(function)
    own = [parameter.replace(default=parameter.empty) if parameter.name == "triangles" else parameter
           for parameter in signature.parameters.values()
           if parameter.kind is not parameter.VAR_KEYWORD]
    options = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default)
               for name, default in DEFAULTS.items()]  # defaults say what a hint would
    function.__signature__ = signature.replace(parameters=own + options)
    kept = {name: hint for name, hint in function.__annotations__.items() if name != "options"}
    function.__annotations__ = {**kept, **hints}
    return function


def set_property(filter_: Any, option: str, property_: str, value: Any) -> None:
    """Sets a property; the filter clamps what is out of range, here it is refused."""
    try:
        getattr(filter_, "Set" + property_)(value)
    except TypeError as error:
        raise TypeError(f"{option} = {value!r}: {error}") from None
    except OverflowError as error:
        raise ValueError(f"{option} = {value!r} is out of range: {error}") from None
    kept = getattr(filter_, "Get" + property_)()
    if kept != value:
        raise ValueError(f"{option} = {value!r} is out of range; the nearest value is {kept!r}")


def word_of(value: Any, words: Sequence[Word], what: str) -> Word:
    """That of the words which is meant; capitals do not matter, as in the command."""
    for word in words:
        if isinstance(value, str) and value.lower() == word.lower():
            return word
    raise ValueError(f"{what} is {value!r}; it must be one of {', '.join(words)}")


def index_of(value: Any, words: Sequence[str], what: str) -> int:
    """The place of a word."""
    return words.index(word_of(value, words, what))


def flag(value: Any, what: str) -> bool:
    """Texts such as "no" would count as True."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{what} = {value!r} must be True or False")
    return bool(value)


def _refuse_unknown(names: Iterable[str], function: str) -> None:
    for name in names:
        if name not in DEFAULTS:
            near = difflib.get_close_matches(name.replace("-", "_"), DEFAULTS, 1)
            hint = f"; did you mean {near[0]!r}?" if near else ""
            raise TypeError(f"{function}() got an unexpected keyword argument {name!r}{hint}")


def _given(options: Mapping[str, Any]) -> Set[str]:
    """What a caller of the command would have to write; flags at their default say nothing there."""
    silent = {name for name, default in DEFAULTS.items()
              if default is None or isinstance(default, bool) or name == "pins"}
    return {name for name, value in options.items()
            if name not in silent or value != DEFAULTS[name]}


def _refuse_idle(
    options: Mapping[str, Any], given: Set[str], written: Mapping[str, Any]
) -> None:
    """An option that the method has no use for means something else than it does; as the command.

    `written` are options as the caller wrote them, which messages repeat.
    """
    scheme, interior, energy = options["scheme"], options["interior"], options["energy"]
    isometric, conformal = scheme == "isometric", scheme == "lscm"
    wires = "schemes that keep lengths, not for 'lscm'"
    method = ("scheme", "paper_method")
    filling = (*method, "interior")
    # Options, on which others it depends that they mean something, whether they do, and for what they are.
    scopes: List[Tuple[Sequence[str], Sequence[str], bool, str]] = [
        (("solver", "interior", "tolerance", "ease", "dart_legs", "max_iterations", "closure_tolerance",
          "optimality_tolerance", "max_length_error"), method, not conformal, wires),
        (("release_trials",), method, isometric or scheme == "global",
         f"schemes 'isometric' and 'global', not for {scheme!r}"),
        (("energy", "area_bias", "angle_weight", "isometric_tolerance", "isometric_iterations"),
         method, isometric, f"scheme='isometric', not for {scheme!r}"),
        (("energy", "area_bias"), ("material",), options["material"] in ("", None, "isotropic"),
         "a sheet without a material, or material='isotropic'"),
        (("area_bias",), ("energy",), energy == "rigid", f"energy='rigid', not for {energy!r}"),
        (("pins",), method, conformal, f"scheme='lscm', not for {scheme!r}"),
        (("relaxation_factor", "relaxation_movement", "relaxation_min_iterations",
          "relaxation_max_iterations"), filling, not conformal and interior == "relaxation",
         wires if conformal else f"interior='relaxation', not for {interior!r}"),
        (("rigid_tolerance", "rigid_iterations"), filling, not conformal and interior == "arap",
         wires if conformal else f"interior='arap', not for {interior!r}"),
        (("spacing",), ("arrange",), bool(options["arrange"]), "arrange=True"),
        (("grain",), (), bool(options["material"]), "a material (material=...; materials() names them)"),
    ]
    for names, others, holds, condition in scopes:
        for name in names:
            if not holds and name in given:
                way = ("leave one of them out" if given.intersection(others)
                       else f"give that as well, or leave {name} out")
                raise ValueError(
                    f"{name} = {written.get(name, options[name])!r} is for {condition}; {way}")


def _set_tolerances(filter_: Any, tolerances: Optional[Mapping[str, float]]) -> None:
    if tolerances is None:
        return
    if not isinstance(tolerances, Mapping):
        raise TypeError(f"tolerance = {tolerances!r} must be a dict of curves' names and fractions")
    for name, value in tolerances.items():
        try:
            filter_.AddCurveTolerance(name, value)
        except TypeError as error:
            raise TypeError(f"tolerance of {name!r} = {value!r}: {error}") from None


def _set_eases(filter_: Any, eases: Optional[Mapping[Any, float]]) -> None:
    if eases is None:
        return
    if not isinstance(eases, Mapping):
        raise TypeError(f"ease = {eases!r} must be a dict of fractions by a curve's name or by (name, piece)")
    for key, value in eases.items():
        name, piece = key if isinstance(key, tuple) and len(key) == 2 else (key, -1)
        if isinstance(piece, bool) or not isinstance(piece, (int, np.integer)) or piece < -1:
            raise ValueError(f"ease of {key!r}: {piece!r} is no number of a piece, from 0")
        try:
            filter_.AddCurveEase(name, int(piece), value)
        except TypeError as error:
            raise TypeError(f"ease of {key!r} = {value!r}: {error}") from None


def material_text(material: object) -> str:
    """The name or path that the filter reads a material by; empty: none."""
    if not isinstance(material, (str, os.PathLike)) and material is not None:
        raise TypeError(f"material = {material!r} must be a name or the path of a JSON file")
    name = "" if material is None else os.fspath(material)
    known = [preset["name"] for preset in materials()]
    if name and name.lower() not in known and not os.path.exists(name):
        near = difflib.get_close_matches(name.lower(), known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise ValueError(f"material is {material!r}; it must be one of {', '.join(known)}, or the path of a JSON file"
                         f"{hint}")
    return name


def _texts(options: Mapping[str, Any]) -> Dict[str, str]:
    """Material and grain as the filter has them."""
    texts = {}
    grain = options.get("grain", "")
    if "material" in options:
        texts["material"] = material_text(options["material"])
    if "grain" in options:
        if isinstance(grain, Real) and not isinstance(grain, bool):
            if not abs(grain) <= sys.float_info.max:  # an int may be beyond any float
                raise ValueError(f"grain = {grain!r} must be a finite angle in degrees")
            grain = repr(float(grain))
        elif grain is None:
            grain = ""
        elif isinstance(grain, Iterable) and not isinstance(grain, (str, bytes)):
            names = list(grain)
            if not all(isinstance(name, str) for name in names):
                raise TypeError(
                    f"grain = {grain!r} must be a list of curves, each \"NAME\" or \"NAME:DEGREES\"")
            grain = ";".join(names)
        elif not isinstance(grain, str):
            raise TypeError(f"grain = {grain!r} must be an angle in degrees, the name of a curve or "
                            "a list of them, or 'free'")
        texts["grain"] = grain
    return texts


def make_filter(
    options: Mapping[str, Any], function: str, filter_class: Any = vtkWireWarpingFilter
) -> Any:
    """A filter with these options, or an exception that names the wrong one."""
    _refuse_unknown(options, function)
    written = options
    options = {**options, **_texts(options)}
    if isinstance(options.get("pins"), Iterable):
        options = {**options, "pins": tuple(options["pins"])}
    values, given = {**DEFAULTS, **options}, _given(options)
    for name, value in values.items():
        if isinstance(DEFAULTS[name], bool):
            values[name] = flag(value, name)
    if values["paper_method"]:
        for name, chosen in (("scheme", "global"), ("interior", "laplacian")):
            if name in given:
                raise ValueError(f"{name} = {values[name]!r} and paper_method=True, which is "
                                 f"{name}={chosen!r}, exclude each other; leave one of them out")
            values[name] = chosen
    for name, option in PROPERTIES.items():
        if option.words:
            values[name] = word_of(values[name], option.words, name)
    _refuse_idle(values, given, written)
    filter_ = filter_class()
    filter_.CachingOff()  # it runs once
    for name, option in PROPERTIES.items():
        value = option.words.index(values[name]) if option.words else values[name]
        set_property(filter_, name, option.property, value)
    _set_tolerances(filter_, values["tolerance"])
    _set_eases(filter_, values["ease"])
    return filter_
