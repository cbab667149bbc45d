# SPDX-License-Identifier: BSD-3-Clause
"""What a run that does not give a sound result is told with."""

from typing import List


class FlatteningError(ValueError):
    """The input was refused; there is no result.

    Attributes:
        code: one of vtkFlatteningAlgorithm's status codes, such as NON_MANIFOLD_EDGE.
        name: the code's fixed name, such as "NonManifoldEdge".
        ids: the offending elements in the numbering of the input: triangles or points of the
            surface, or curves; the message says which. Empty where no element is to blame.
        message: the defect, the first offending ids and the way out.
    """

    def __init__(self, code: int, name: str, ids: List[int], message: str) -> None:
        super().__init__(code, name, ids, message)  # all of them, so that it can be pickled
        self.code = code
        self.name = name
        self.ids = ids
        self.message = message

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


class FlatteningWarning(UserWarning):
    """There is a result, but a promise is broken: not converged, keys that contradict each other, a
    length error, a flipped triangle or an overlap (the report's "status" says which), or a part of
    the input was left out (the report's "warnings")."""
