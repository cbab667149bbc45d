# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run, and the errors and warnings of one without a sound result."""

import warnings
from typing import Any, Dict, List, Mapping, Tuple, Type, cast

from . import _core
from ._errors import FileError, FlatteningError, FlatteningWarning, MissingFileError, OutOfMemoryError
from ._types import Report

# A table as its columns, each an array or a list of texts.
Table = Mapping[str, Any]
# Code, name, defect, ids, what they are of, and remedies with what each is to be applied to.
Status = Tuple[int, str, str, List[int], str, List[Tuple[str, str]]]

_KINDS: Dict[str, Type[FlatteningError]] = {
    "FileNotWritten": FileError, "FileNotFound": MissingFileError, "OutOfMemory": OutOfMemoryError}


def error_of(status: Status) -> FlatteningError:
    """The error of a run, or the warning that it is worth."""
    code, name, defect, ids, kind, remedies = status
    return _KINDS.get(name, FlatteningError)(code, name, ids, _core.make_message(defect, remedies), kind, remedies)


def raise_failure(status: Status, name: str = "") -> None:
    """The error of an operation that gives a status alone, whose number is 0 where it went well; under another name."""
    if status[0] != 0:
        raise error_of((-1, name or status[1], status[2], status[3], status[4], status[5]))


def raise_refusal(run: Mapping[str, Any]) -> None:
    """FlatteningError where a run of the algorithms has no result."""
    if run["refused"]:
        raise error_of(run["status"])


def warn_of(run: Mapping[str, Any], stacklevel: int) -> None:
    """FlatteningWarning for all that a result is not."""
    for warning in run["warnings"]:
        warnings.warn(warning, FlatteningWarning, stacklevel=stacklevel + 1)
    if run["status"][0] != 0:
        warnings.warn(str(error_of(run["status"])), FlatteningWarning, stacklevel=stacklevel + 1)


def values_in(table: Table, name: str) -> List[Any]:
    """A column as Python values; empty where there is none."""
    column = table.get(name, [])
    return column if isinstance(column, list) else cast(List[Any], column.tolist())


def make_report(run: Mapping[str, Any], flattening: Mapping[str, Any]) -> Report:
    """What became of a run that gave flat pieces."""
    _, name, defect, ids, kind, remedies = run["status"]
    tables = flattening["tables"]
    for piece in tables["pieces"]:
        piece["message"] = _core.make_message(piece["message"], [(way["name"], way["subject"]) for way in piece["remedies"]])
    return cast(Report, {
        "status": name,
        "message": _core.make_message(defect, remedies),
        "ids": ids,
        "id_kind": kind,
        "remedies": [{"name": remedy, "subject": subject} for remedy, subject in remedies],
        "warnings": run["warnings"],
        **tables,
    })
