# SPDX-License-Identifier: BSD-3-Clause
"""Flat pieces as the algorithms take them again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, NamedTuple, get_args

from ._types import Unit

if TYPE_CHECKING:
    from ._result import Flattening

Data = Dict[str, Any]


class Pieces(NamedTuple):
    """Points, triangles or lines, and arrays."""

    flat: Data
    wires: Data
    cut: Data


def pieces_of(result: Flattening) -> Pieces:
    """The arrays of a result, with the texts of the mesh that it is of."""
    cells, fields = dict(result.cell_arrays), dict(result._field_arrays)
    if result._parts is not None:
        from ._vtk import table_of_arrays
        flat = result._parts.flat
        for arrays, data, name in ((cells, flat.GetCellData(), "PieceName"), (fields, flat.GetFieldData(), "LengthUnit")):
            texts = table_of_arrays(data).get(name)
            if texts:
                arrays[name] = texts
    return Pieces(
        {"points": result.positions, "triangles": result.triangles, "cell_arrays": cells, "field_arrays": fields},
        {"points": result.positions, "lines": [wire.vertices for wire in result.wires], "cell_arrays": result._wire_arrays},
        {"points": result.points, "triangles": result.triangles})


def unit_of(flat: Data) -> str:
    """The unit that the field data LengthUnit states; empty: none that is known."""
    stated = str((flat["field_arrays"].get("LengthUnit") or [""])[0]).lower()
    return stated if stated in get_args(Unit) else ""
