# SPDX-License-Identifier: BSD-3-Clause
"""The options of flatten(): names, properties of the filter, and where they mean something."""

from __future__ import annotations

import difflib
import inspect
import os
import sys
import textwrap
from numbers import Real
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Sequence, Set, TypeVar, get_args, get_type_hints

import numpy as np

from ._errors import ArgumentError, ArgumentTypeError
from ._materials import materials
from ._option_table import TABLE, Option, Options, Scheme
from .vtkFiltersFlattening import vtkLeastSquaresConformalFilter, vtkWireWarpingFilter

Word = TypeVar("Word", bound=str)

# Options of flatten() alone.
_OTHERS: Dict[str, Any] = {"paper_method": False, "progress": None}


def options_of(filter_class: Any) -> Dict[str, Option]:
    """The options of a filter by their names in Python, and those of the conformal map, a scheme here."""
    names = {cls.__name__ for cls in filter_class.__mro__}
    if issubclass(filter_class, vtkWireWarpingFilter):
        names.add(vtkLeastSquaresConformalFilter.__name__)
    return {option.name: option for option in TABLE if option.cls in names}


def _documented(option: Option) -> str:
    extent = f" In {option.range}." if option.range.startswith(("[", "(")) else f" {option.range}." if option.range else ""
    return textwrap.fill(
        f"{option.name}: {option.help[0].lower()}{option.help[1:]}{extent.replace(' f', ' F')}", 110,
        initial_indent=8 * " ", subsequent_indent=12 * " ", break_on_hyphens=False)


def with_options(filter_class: Any) -> Callable[[Any], Any]:
    """Shows the options of a filter in the signature and the help of a function that takes them as keywords."""
    options = options_of(filter_class)

    def decorate(function: Any) -> Any:
        signature = inspect.signature(function)
        own = [parameter.replace(default=parameter.empty) if parameter.name == "triangles" else parameter
               for parameter in signature.parameters.values()
               if parameter.kind is not parameter.VAR_KEYWORD]
        defaults = {**{name: option.default for name, option in options.items()}, **_OTHERS}
        keywords = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default)
                    for name, default in defaults.items() if name not in signature.parameters]
        function.__signature__ = signature.replace(parameters=own + keywords)
        hints = get_type_hints(Options)
        kept = {name: hint for name, hint in function.__annotations__.items() if name != "options"}
        function.__annotations__ = {**kept, **hints}
        derived = filter_class is not vtkWireWarpingFilter
        shown = [option for option in options.values()
                 if option.name not in signature.parameters and (option.cls == filter_class.__name__ or not derived)]
        function.__doc__ = (function.__doc__ or "").replace(
            "        _OPTIONS_", "\n".join(_documented(option) for option in shown))
        return function
    return decorate


def set_property(filter_: Any, option: str, property_: str, value: Any) -> None:
    """Sets a property; the filter clamps what is out of range, here it is refused."""
    try:
        getattr(filter_, "Set" + property_)(value)
    except TypeError as error:
        raise ArgumentTypeError(f"{option} = {value!r}: {error}") from None
    except OverflowError as error:
        raise ArgumentError(f"{option} = {value!r} is out of range: {error}") from None
    kept = getattr(filter_, "Get" + property_)()
    if kept != value:
        raise ArgumentError(f"{option} = {value!r} is out of range; the nearest value is {kept!r}")


def word_of(value: Any, words: Sequence[Word], what: str) -> Word:
    """That of the words which is meant; capitals do not matter, as in the command."""
    for word in words:
        if isinstance(value, str) and value.lower() == word.lower():
            return word
    raise ArgumentError(f"{what} is {value!r}; it must be one of {', '.join(words)}")


def index_of(value: Any, words: Sequence[str], what: str) -> int:
    """The place of a word."""
    return words.index(word_of(value, words, what))


def flag(value: Any, what: str) -> bool:
    """Texts such as "no" would count as True."""
    if not isinstance(value, (bool, np.bool_)):
        raise ArgumentTypeError(f"{what} = {value!r} must be True or False")
    return bool(value)


def _refuse_unknown(names: Iterable[str], known: Mapping[str, Any], function: str) -> None:
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(name.replace("-", "_"), known, 1)
            hint = f"; did you mean {near[0]!r}?" if near else ""
            raise ArgumentTypeError(f"{function}() got an unexpected keyword argument {name!r}{hint}")


def _given(options: Mapping[str, Any], defaults: Mapping[str, Any]) -> Set[str]:
    """What a caller of the command would have to write; flags at their default say nothing there."""
    silent = {name for name, default in defaults.items()
              if default is None or isinstance(default, bool) or name == "pins"}
    return {name for name, value in options.items()
            if name not in silent or value != defaults[name]}


def _set_tolerances(filter_: Any, tolerances: Optional[Mapping[str, float]]) -> None:
    if tolerances is None:
        return
    if not isinstance(tolerances, Mapping):
        raise ArgumentTypeError(f"tolerance = {tolerances!r} must be a dict of curves' names and fractions")
    for name, value in tolerances.items():
        try:
            filter_.AddCurveTolerance(name, value)
        except TypeError as error:
            raise ArgumentTypeError(f"tolerance of {name!r} = {value!r}: {error}") from None


def _set_eases(filter_: Any, eases: Optional[Mapping[Any, float]]) -> None:
    if eases is None:
        return
    if not isinstance(eases, Mapping):
        raise ArgumentTypeError(f"ease = {eases!r} must be a dict of fractions by a curve's name or by (name, piece)")
    for key, value in eases.items():
        name, piece = key if isinstance(key, tuple) and len(key) == 2 else (key, -1)
        if isinstance(piece, bool) or not isinstance(piece, (int, np.integer)) or piece < -1:
            raise ArgumentError(f"ease of {key!r}: {piece!r} is not the number of a piece, from 0")
        try:
            filter_.AddCurveEase(name, int(piece), value)
        except TypeError as error:
            raise ArgumentTypeError(f"ease of {key!r} = {value!r}: {error}") from None


def material_text(material: object) -> str:
    """The name or path that the filter reads a material by; empty: none."""
    if not isinstance(material, (str, os.PathLike)) and material is not None:
        raise ArgumentTypeError(f"material = {material!r} must be a name or the path of a JSON file")
    name = "" if material is None else os.fspath(material)
    known = [preset["name"] for preset in materials()]
    if name and name.lower() not in known and not os.path.exists(name):
        near = difflib.get_close_matches(name.lower(), known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise ArgumentError(f"material is {material!r}; it must be one of {', '.join(known)}, or the path of a JSON file"
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
                raise ArgumentError(f"grain = {grain!r} must be a finite angle in degrees")
            grain = repr(float(grain))
        elif grain is None:
            grain = ""
        elif isinstance(grain, Iterable) and not isinstance(grain, (str, bytes)):
            names = list(grain)
            if not all(isinstance(name, str) for name in names):
                raise ArgumentTypeError(
                    f"grain = {grain!r} must be a list of curves, each \"NAME\" or \"NAME:DEGREES\"")
            grain = ";".join(names)
        elif not isinstance(grain, str):
            raise ArgumentTypeError(f"grain = {grain!r} must be an angle in degrees, the name of a curve or "
                                    "a list of them, or 'free'")
        texts["grain"] = grain
    return texts


def _set_preferences(filter_: Any, preferences: Optional[Mapping[str, float]]) -> None:
    for name, weight in (preferences or {}).items():
        filter_.AddPreference(name, weight)


def _keep_curves(filter_: Any, names: Sequence[str]) -> None:
    if isinstance(names, str):
        raise ArgumentTypeError(f"keep is {names!r}; it must be a sequence of names")
    for name in names:
        filter_.AddKeptCurve(name)


_LISTS: Dict[str, Callable[[Any, Any], None]] = {
    "CurveTolerances": _set_tolerances, "CurveEases": _set_eases, "Preferences": _set_preferences,
    "KeptCurves": _keep_curves}


def set_option(filter_: Any, option: Option, value: Any) -> None:
    """Sets a property or list of a filter, or raises what is wrong with the value."""
    if option.type == "list":
        _LISTS[option.property](filter_, value)
        return
    if option.type == "word":
        value = index_of(value, [word for word, _ in option.words], option.name)
    elif option.type == "flag":
        value = flag(value, option.name)
    elif option.type == "text" and value is None:
        value = ""
    set_property(filter_, option.name, option.property, value)


def make_filter(
    options: Mapping[str, Any], function: str, filter_class: Any = vtkWireWarpingFilter
) -> Any:
    """A filter with these options, or an exception that names the wrong one."""
    table = options_of(filter_class)
    defaults = {**{name: option.default for name, option in table.items()}, **_OTHERS}
    _refuse_unknown(options, defaults, function)
    options = {**options, **_texts(options)}
    if isinstance(options.get("pins"), Iterable):
        options = {**options, "pins": tuple(options["pins"])}
    values, given = {**defaults, **options}, _given(options, defaults)
    if flag(values["paper_method"], "paper_method"):
        for name, chosen in (("scheme", "global"), ("interior", "laplacian")):
            if name in given:
                raise ArgumentError(f"{name} = {values[name]!r} and paper_method=True, which is "
                                    f"{name}={chosen!r}, exclude each other; leave one of them out")
            values[name] = chosen
            given.add(name)
    if word_of(values["scheme"], get_args(Scheme), "scheme") == "lscm":
        if filter_class is not vtkWireWarpingFilter:
            raise ArgumentError(f"scheme is 'lscm', which keeps no length; {function}() needs another")
        filter_class = vtkLeastSquaresConformalFilter
    filter_ = filter_class()
    filter_.CachingOff()  # it runs once
    classes = {cls.__name__ for cls in filter_class.__mro__}
    for name, option in table.items():
        if option.cls in classes:
            set_option(filter_, option, values[name])
    idle = filter_.DescribeIdleOption(
        " ".join(option.property for name, option in table.items() if name in given), filter_.PYTHON)
    if idle:
        raise ArgumentError(idle)
    return filter_
