# SPDX-License-Identifier: BSD-3-Clause
"""The errors and warnings of runs without a sound result; all errors are a FlatteningError."""

from typing import List, Sequence, Tuple


class FlatteningError(ValueError):
    """The input was rejected, or a file; there is no result.

    Attributes:
        code: one of vtkFlatteningAlgorithm's status codes, such as NON_MANIFOLD_EDGE; -1 for files.
        name: its fixed name, such as "NonManifoldEdge".
        ids: the offending elements in the numbering of the input: triangles or points of the
            surface, or curves. Empty where no element is to blame.
        message: the defect, the first offending ids and the remedies.
        kind: what ids are: "points", "cells" (triangles), "edges" (pairs of points), "curves",
            "curve points", or empty.
        remedies: pairs of a fixed name, such as "CutOpen", and what it is to be applied to, which
            may be empty.
    """

    def __init__(self, code: int, name: str, ids: List[int], message: str, kind: str = "",
                 remedies: Sequence[Tuple[str, str]] = ()) -> None:
        # All of them, so that it can be pickled.
        super().__init__(code, name, ids, message, kind, remedies)
        self.code = code
        self.name = name
        self.ids = ids
        self.message = message
        self.kind = kind
        self.remedies = list(remedies)

    def __str__(self) -> str:
        return f"{self.name}: {self.message}" if self.code >= 0 else self.message


class ArgumentError(FlatteningError):
    """An argument of a function has a value that it cannot have; code is -1."""

    def __init__(self, message: str) -> None:
        super().__init__(-1, "InvalidArgument", [], message)
        self.args = (message,)


class ArgumentTypeError(ArgumentError, TypeError):
    """An argument of a function has another type than it needs, or is missing or unknown."""


class FileError(FlatteningError, OSError):
    """A file cannot be written."""


class MissingFileError(FileError, FileNotFoundError):
    """There is no such file."""


class OutOfMemoryError(FlatteningError, MemoryError):
    """There is not enough memory."""


class FlatteningWarning(UserWarning):
    """There is a result, but not a sound one (the report's "status" says why); or a part of the input was
    left out, no plane can hold a piece, or another energy was used (the report's "warnings")."""
