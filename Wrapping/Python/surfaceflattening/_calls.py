# SPDX-License-Identifier: BSD-3-Clause
"""The calls that take the options of flatten(); type checkers see them, each option with its type, in the stub."""

from ._flatten import flatten, flatten_polydata
from ._keys import price_keys
from ._reshaping import make_flattenable, make_flattenable_polydata
from ._suggestion import suggest, suggest_polydata

__all__ = [
    "flatten", "flatten_polydata", "make_flattenable", "make_flattenable_polydata", "price_keys", "suggest", "suggest_polydata"]
