# SPDX-License-Identifier: BSD-3-Clause
"""The materials that flatten() knows by name."""

from typing import Any, Dict, List

from . import _core

_COLUMNS = {
    "name": "Name", "description": "Description", "warp": "Warp", "weft": "Weft", "shear": "Shear",
    "compression": "Compression", "warp_least": "WarpLeast", "warp_greatest": "WarpGreatest",
    "weft_least": "WeftLeast", "weft_greatest": "WeftGreatest", "shear_limit": "ShearLimit",
    "one_way": "OneWay", "source": "Source"}


def materials() -> List[Dict[str, Any]]:
    """The materials that `material` takes by name, as wirewarp materials prints them.

    Returns:
        A dict for each material: name, description; warp, weft, shear, stiffness in N/m (0: a sheet alike in
        all directions); compression, stiffness of a compressed thread over that of a drawn one;
        warp_least, warp_greatest, weft_least, weft_greatest, limits of strains in percent, and
        shear_limit, in degrees (infinite: none); one_way; source of the numbers.
    """
    table = _core.materials()
    rows = zip(*(list(table[column]) for column in _COLUMNS.values()))
    return [{key: bool(value) if key == "one_way" else value if isinstance(value, str) else float(value)
             for key, value in zip(_COLUMNS, row)} for row in rows]
