# SPDX-License-Identifier: BSD-3-Clause
"""Data sets as the algorithms take and give them."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, get_args

from ._types import Unit

# points, corners and offsets of polygons (without offsets: of triangles), lines and strips as lists of ids, point_arrays,
# cell_arrays and field_arrays by name, and roles of VTK by kind and name.
Data = Dict[str, Any]


class Pieces(NamedTuple):
    """Flat pieces, their wires, and the cut surface."""

    flat: Data
    wires: Data
    cut: Data


def unit_of(flat: Data) -> str:
    """The unit that the field data LengthUnit states; empty: none that is known."""
    stated = str((flat["field_arrays"].get("LengthUnit") or [""])[0]).lower()
    return stated if stated in get_args(Unit) else ""
