# SPDX-License-Identifier: BSD-3-Clause
"""Remedies of defects, with the arguments of this package's functions."""

import re
from typing import Iterable, Match, Tuple

from . import _core
from ._option_table import TABLE

_ARGUMENTS = {option.property: option.name for option in TABLE}
_ARGUMENTS.update(CurveType="type", vtkFeatureCurveSuggestion="suggest()")
_VALUES = {"on": "True", "AS_RIGID_AS_POSSIBLE": '"arap"', "0": '"accessory"'}


def _spelled(option: Match[str]) -> str:
    """{Sewing.MaximumIterations} is max_iterations, {Solver=NEWTON} solver="newton"."""
    property_, _, value = option.group(1).rpartition(".")[2].partition("=")
    words = re.findall("[A-Z][a-z]*", property_)
    plain = "_".join(words).lower().replace("maximum", "max").replace("minimum", "min")
    name = _ARGUMENTS.get(property_, plain)
    return f"{name}={_VALUES.get(value, repr(value.lower()))}".replace("'", '"') if value else name


def remedy_words(name: str) -> str:
    """What the remedy of a name says, % for its subject; empty where there is none."""
    sentence = _core.remedy_sentence(name)
    return re.sub("{(.*?)}", _spelled, re.sub(r"[][]", "", sentence))


def make_message(defect: str, remedies: Iterable[Tuple[str, str]]) -> str:
    """A defect and its remedies, each a name and what it is to be applied to."""
    ways = [remedy_words(name).replace("%", subject, 1) for name, subject in remedies]
    return "; ".join([defect, ", or ".join(ways)] if ways else [defect])
