# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and feature curves from files."""

from __future__ import annotations  # help() prints hints as they are written here

import os
import warnings
from typing import Optional, Tuple, Union, get_args

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._errors import FlatteningWarning
from ._options import index_of
from ._types import SeamSource
from ._vtk import demand_polydata, read_file
from .vtkIOFlattening import vtkFeatureCurveReader, vtkSurfaceMeshReader


def read_surface(path: Union[str, os.PathLike[str]], seams: SeamSource = "none") -> Tuple[vtkPolyData, vtkPolyData]:
    """Reads a surface in double precision, whose points are not split along texture seams.

    Args:
        path: an .obj, .ply or .off file; VTK and PyVista read other formats.
        seams: edges of the faces of an .obj file that become seams: "none" (default), "textures", where
            texture coordinates break, "materials", between two of them, or "groups", between two objects
            or groups.

    Returns:
        The surface, and the curves of the file over the same points (its line elements and the seams; no
        cell where it has none), both for :func:`flatten_polydata`.

    Raises:
        MissingFileError: there is no such file.
        FlatteningError: it cannot be read, or says nothing of such seams; the message names the line.
    """
    reader = vtkSurfaceMeshReader()
    reader.SetSeamSource(index_of(seams, get_args(SeamSource), "seams"))
    read_file(reader, path)
    return reader.GetOutput(0), reader.GetOutput(1)


def read_curves(path: Union[str, os.PathLike[str]], surface: Optional[vtkPolyData] = None) -> vtkPolyData:
    """Reads feature curves; the page of vtkFeatureCurveReader describes the formats.

    Args:
        path: a .csv table, a .dxf drawing, an .obj file with line elements, or a text with a curve a line:
            TYPE NAME v0 v1 ...
        surface: what ids of points in texts, and edges along the boundary, refer to.

    Returns:
        Polylines with the cell arrays that the filters read, for :func:`flatten_polydata`.

    Raises:
        MissingFileError: there is no such file.
        FlatteningError: it cannot be read, or does not fit the surface; the message names the line.

    Warns:
        FlatteningWarning: entities of a drawing were left out.
    """
    reader = vtkFeatureCurveReader()
    if surface is not None:
        demand_polydata(surface, "surface")
        reader.SetInputData(surface)
    read_file(reader, path)
    if reader.GetNote():
        warnings.warn(f"{os.fspath(path)}: {reader.GetNote()}", FlatteningWarning, stacklevel=2)
    curves: vtkPolyData = reader.GetOutput()
    return curves
