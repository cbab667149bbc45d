# SPDX-License-Identifier: BSD-3-Clause
"""The materials that flatten() knows by name."""

from typing import Any, Dict, List

from vtkmodules.vtkCommonDataModel import vtkTable

from .vtkFiltersFlattening import vtkWireWarpingFilter

_COLUMNS = {
    "name": "Name", "description": "Description", "warp": "Warp", "weft": "Weft", "shear": "Shear",
    "compression": "Compression", "warp_least": "WarpLeast", "warp_greatest": "WarpGreatest",
    "weft_least": "WeftLeast", "weft_greatest": "WeftGreatest", "shear_limit": "ShearLimit",
    "one_way": "OneWay", "source": "Source"}


def materials() -> List[Dict[str, Any]]:
    """The materials that `material` takes by name, as wirewarp materials prints them.

    Returns:
        A dict a material: name, description; warp, weft, shear, stiffness in N/m (0: a sheet alike in
        all directions); compression, stiffness of a compressed thread over that of a drawn one;
        warp_least, warp_greatest, weft_least, weft_greatest, limits of strains in percent, and
        shear_limit, in degrees (infinite: none); one_way; source of the numbers.
    """
    table = vtkTable()
    vtkWireWarpingFilter.ListMaterials(table)
    result = []
    for row in range(table.GetNumberOfRows()):
        entry: Dict[str, Any] = {}
        for key, column in _COLUMNS.items():
            value = table.GetValueByName(row, column)
            entry[key] = value.ToString() if value.IsString() else value.ToDouble()
        entry["one_way"] = bool(entry["one_way"])
        result.append(entry)
    return result
