# SPDX-License-Identifier: BSD-3-Clause
"""The options of flatten(): names, values, and where they mean something."""

from __future__ import annotations

import difflib
import functools
import inspect
import operator
import os
import sys
import textwrap
from numbers import Real
from typing import (
    Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Set, Tuple, TypeVar, Union, get_args,
    get_type_hints
)

import numpy as np

from . import _core
from ._errors import ArgumentError, ArgumentTypeError
from ._materials import materials
from ._option_table import TABLE, Option
from ._types import Options, Scheme

Word = TypeVar("Word", bound=str)

# Options of flatten() alone.
_OTHERS: Dict[str, Any] = {"paper_method": False, "progress": None}


WARPING, CONFORMAL = "vtkWireWarpingFilter", "vtkLeastSquaresConformalFilter"


@functools.lru_cache(maxsize=None)
def options_of(owner: str) -> Mapping[str, Option]:
    """The options of a filter by their names in Python, and those of the conformal map, a scheme here."""
    owned = _core.options_of(owner)
    return {option.name: option for option in TABLE if (option.cls, option.property) in owned}


def _of_command(owner: str) -> Dict[str, str]:
    """What the command calls options, with underscores, and how they are written here: arrange=False for no_arrange."""
    return {command[2:].replace("-", "_"): option.name + ("=False" if option.default is True else "")
            for option in options_of(owner).values()
            for command in [_core.options_of(owner)[option.cls, option.property]]}


def _documented(option: Option) -> str:
    extent = f" In {option.range}." if option.range.startswith(("[", "(")) else f" {option.range}." if option.range else ""
    return textwrap.fill(
        f"{option.name}: {option.help[0].lower()}{option.help[1:]}{extent.replace(' f', ' F')}", 110,
        initial_indent=8 * " ", subsequent_indent=12 * " ", break_on_hyphens=False)


def with_options(owner: str) -> Callable[[Any], Any]:
    """Shows the options of a filter in the signature and the help of a function that takes them as keywords."""
    options = options_of(owner)

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
        derived = owner != WARPING
        shown = [option for option in options.values()
                 if option.name not in signature.parameters and (option.cls == owner or not derived)]
        function.__doc__ = (function.__doc__ or "").replace(
            "        _OPTIONS_", "\n".join(_documented(option) for option in shown))
        return function
    return decorate


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


def _refuse_unknown(names: Iterable[str], known: Mapping[str, Any], function: str, owner: str) -> None:
    for name in names:
        if name not in known:
            meant = {**_of_command(owner), **{word: word for word in known}}
            near = difflib.get_close_matches(name.lstrip("-").replace("-", "_"), meant, 1)
            hint = f"; did you mean {meant[near[0]]!r}?" if near else ""
            raise ArgumentTypeError(f"{function}() got an unexpected keyword argument {name!r}{hint}")


def _given(options: Mapping[str, Any], defaults: Mapping[str, Any]) -> Set[str]:
    """What a caller of the command would have to write; flags at their default say nothing there."""
    silent = {name for name, default in defaults.items()
              if default is None or isinstance(default, bool) or name == "pins"}
    return {name for name, value in options.items()
            if name not in silent or value != defaults[name]}


def text_of(what: str, value: Any) -> str:
    """A string that C++ can hold, or an error that names what it is."""
    if not isinstance(value, str):
        raise ArgumentTypeError(f"{what} = {value!r} must be a string")
    try:
        value.encode()
    except UnicodeEncodeError as error:
        raise ArgumentError(f"{what} = {value!r} is not text that UTF-8 can hold: {error.reason}") from None
    return value


def number_of(what: str, value: Any) -> float:
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError("must be a number")
        return float(value)
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a number") from None
    except OverflowError as error:
        raise ArgumentError(f"{what} = {value!r} is out of range: {error}") from None


def _whole(what: str, value: Any, bits: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a whole number") from None
    if not -2**(bits - 1) <= number < 2**(bits - 1):
        raise ArgumentError(f"{what} = {value!r} is out of range: it must have at most {bits} bits")
    return number


def _ids(what: str, value: Any) -> Tuple[int, int]:
    if isinstance(value, (str, bytes)) or not isinstance(value, Iterable) or len(ids := tuple(value)) != 2:
        raise ArgumentTypeError(f"{what} = {value!r} must be two ids of points")
    return (_whole(what, ids[0], 64), _whole(what, ids[1], 64))


def entries_of(what: str, given: Any, contents: str) -> Iterable[Tuple[Any, Any]]:
    """Keys and values of a dict, which None stands for an empty one of."""
    if given is not None and not isinstance(given, Mapping):
        raise ArgumentTypeError(f"{what} = {given!r} must be a dict of {contents}")
    return (given or {}).items()


def list_of(what: str, given: Any, contents: str) -> List[Any]:
    """A list, for which a text would be taken letter by letter."""
    if isinstance(given, (str, bytes)) or not isinstance(given, Iterable):
        raise ArgumentTypeError(f"{what} = {given!r} must be a list of {contents}")
    return list(given)


def _tolerances(given: Optional[Mapping[str, float]]) -> List[Tuple[Any, ...]]:
    return [(text_of("a curve of tolerance", name), number_of(f"tolerance of {name!r}", value))
            for name, value in entries_of("tolerance", given, "curves' names and fractions")]


def _eases(given: Optional[Mapping[Any, float]]) -> List[Tuple[Any, ...]]:
    rows: List[Tuple[Any, ...]] = []
    for key, value in entries_of("ease", given, "fractions by a curve's name or by (name, piece)"):
        name, piece = key if isinstance(key, tuple) and len(key) == 2 else (key, -1)
        if isinstance(piece, bool) or not isinstance(piece, (int, np.integer)) or not -1 <= piece < 2**31:
            raise ArgumentError(f"ease of {key!r}: {piece!r} is not the number of a piece, from 0")
        rows.append((text_of("a curve of ease", name), int(piece), number_of(f"ease of {key!r}", value)))
    return rows


def _preferences(given: Optional[Mapping[str, float]]) -> List[Tuple[Any, ...]]:
    return [(text_of("a curve of prefer", name), number_of(f"preference of {name!r}", weight))
            for name, weight in entries_of("prefer", given, "curves' names and weights")]


def _kept(names: Sequence[str]) -> List[Tuple[Any, ...]]:
    return [(text_of("a curve of keep", name),) for name in list_of("keep", names, "names")]


def _grain(grain: Union[None, float, str, Sequence[str]]) -> List[Tuple[Any, ...]]:
    if isinstance(grain, Real) and not isinstance(grain, bool):
        if not abs(grain) <= sys.float_info.max:  # an int may be beyond any float
            raise ArgumentError(f"grain = {grain!r} must be a finite angle in degrees")
        return [(repr(float(grain)),)]
    if grain is None or isinstance(grain, str):
        return [(text_of("grain", grain),)] if grain else []
    if isinstance(grain, bytes) or not isinstance(grain, Iterable):
        raise ArgumentTypeError(f"grain = {grain!r} must be an angle in degrees, the name of a curve or "
                                "a list of them, or 'free'")
    names = list(grain)
    if not all(isinstance(name, str) for name in names):
        raise ArgumentTypeError(f"grain = {grain!r} must be a list of curves, each \"NAME\" or \"NAME:DEGREES\"")
    return [(text_of("a curve of grain", name),) for name in names]


# Rows of arguments for the filters' Add methods.
_LISTS: Dict[str, Callable[[Any], List[Tuple[Any, ...]]]] = {
    "CurveTolerances": _tolerances, "CurveEases": _eases, "Preferences": _preferences, "KeptCurves": _kept,
    "Grain": _grain}


def checked(option: Option, value: Any) -> Any:
    """The value of a property or list, or an exception that says what is wrong with it."""
    name = option.name
    if option.type == "list":
        return _LISTS[option.property](value)
    if option.type == "word":
        return index_of(value, [word for word, _ in option.words], name)
    if option.type == "flag":
        return flag(value, name)
    if option.type == "text":
        return "" if value is None else text_of(name, value)
    if option.type == "ids":
        return _ids(name, value)
    if option.type == "numbers":
        return tuple(number_of(name, component) for component in value)
    number = _whole(name, value, 32) if option.type == "integer" else number_of(name, value)
    # Of an open range the algorithm says itself what is beyond.
    ranged = option.minimum != option.maximum and not option.open
    if number != number or ranged and not option.minimum <= number <= option.maximum:
        raise ArgumentError(f"{name} = {value!r} is out of range; it must be in {option.range}")
    return number


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


def read_options(
    options: Mapping[str, Any], function: str, owner: str = WARPING, *, keeps_lengths: bool = False
) -> Tuple[str, Dict[str, Any]]:
    """The class of the method, and the values of its properties; or an exception that names the wrong one."""
    table = options_of(owner)
    defaults = {**{name: option.default for name, option in table.items()}, **_OTHERS}
    _refuse_unknown(options, defaults, function, owner)
    if "material" in options:
        options = {**options, "material": material_text(options["material"])}
    values, given = {**defaults, **options}, _given(options, defaults)
    if flag(values["paper_method"], "paper_method"):
        for name, chosen in (("scheme", "global"), ("interior", "laplacian")):
            if name in given:
                raise ArgumentError(f"{name} = {values[name]!r} and paper_method=True, which is "
                                    f"{name}={chosen!r}, exclude each other; leave one of them out")
            values[name] = chosen
            given.add(name)
    conformal = word_of(values["scheme"], get_args(Scheme), "scheme") == "lscm"
    if conformal and (keeps_lengths or owner != WARPING):
        raise ArgumentError(f"scheme is 'lscm', which keeps no length; {function}() needs another")
    properties = {option.property: checked(option, values[name]) for name, option in table.items()}
    idle = _core.describe_idle(owner, properties, [option.property for name, option in table.items() if name in given])
    if idle:
        raise ArgumentError(idle)
    if not conformal:
        return owner, properties
    return CONFORMAL, {option.property: properties[option.property] for option in options_of(CONFORMAL).values()}
