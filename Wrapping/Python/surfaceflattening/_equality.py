# SPDX-License-Identifier: BSD-3-Clause
"""Equality of values that hold arrays."""

from dataclasses import fields
from typing import Any

import numpy as np


def same(one: Any, other: Any) -> bool:
    """Whether two values, or arrays and what holds them, are equal; NaN is equal to NaN."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        one, other = np.asarray(one), np.asarray(other)
        if one.shape != other.shape:
            return False
        different = one != other
        return not np.any(different & ((one == one) | (other == other)))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(value, other[key]) for key, value in one.items())
    if isinstance(one, (list, tuple, range)) and isinstance(other, (list, tuple, range)):
        return len(one) == len(other) and all(map(same, one, other))
    return bool(one == other) or (one != one and other != other)


class ComparedByValue:
    """A data class that is equal to another one where all of its compared fields are."""

    __hash__ = None  # type: ignore[assignment] # arrays may change

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(same(getattr(self, field.name), getattr(other, field.name))
                   for field in fields(self) if field.compare)
