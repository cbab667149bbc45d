# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and feature curves from files."""

from __future__ import annotations  # help() prints hints as they are written here

import os
import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Tuple, Union, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._curves import Curve, curves_of, surface_data
from ._errors import FlatteningWarning, MissingFileError
from ._options import index_of, text_of
from ._pieces import Data
from ._report import error_of
from ._types import SeamSource

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

Path = Union[str, "os.PathLike[str]"]


class LoadedSurface(NamedTuple):
    """A surface of a file, for :func:`flatten`: ``flatten(*load_surface(path)[:3])``."""

    #: Positions; float64, shape (n, 3).
    points: NDArray[np.float64]
    #: Ids of corners; int64, shape (m, 3), or a flat list where there are other polygons.
    triangles: NDArray[np.int64]
    #: Line elements and seams.
    curves: List[Curve]
    #: That the file states; empty: none.
    unit: str


def _raise_failure(path: Path, failure: str) -> None:
    if failure:
        missing = not os.path.exists(path)
        raise MissingFileError(-1, "FileNotFound", [], failure) if missing else error_of(
            (-1, "InvalidFile", failure, [], "", []))


def _faces(data: Data) -> NDArray[np.int64]:
    counts = np.diff(data["offsets"])
    if (counts == 3).all():
        return np.asarray(data["corners"], np.int64).reshape(-1, 3)
    return np.insert(data["corners"], data["offsets"][:-1], counts)


def _curves(data: Data) -> List[Curve]:
    """At their places."""
    return [replace(curve, points=data["points"][curve.points]) for curve in curves_of(data)]


def _warn_of(path: Path, note: str) -> None:
    if note:
        warnings.warn(f"{os.fspath(path)}: {note}", FlatteningWarning, stacklevel=4)


def _read(path: Path, seams: SeamSource) -> Tuple[Data, Data, str]:
    failure, surface, curves, unit, note = _core.read_surface(
        text_of("path", os.fspath(path)), index_of(seams, get_args(SeamSource), "seams"))
    _raise_failure(path, failure)
    _warn_of(path, note)
    return surface, curves, unit


def load_surface(path: Path, seams: SeamSource = "none") -> LoadedSurface:
    """Reads a surface as arrays, in the precision of the file; points are not split along texture seams.

    Args:
        path: an .obj, .ply, .stl or .off file.
        seams: as for :func:`read_surface`.

    Raises:
        MissingFileError: there is no such file.
        FlatteningError: it cannot be read, or has nothing that gives such seams; the message names the line.

    Warns:
        FlatteningWarning: edges without a face, in an object of an .obj file that has faces, were left out.
    """
    surface, curves, unit = _read(path, seams)
    return LoadedSurface(surface["points"], _faces(surface), _curves(curves), unit)


def load_curves(path: Path, points: ArrayLike = (), triangles: Optional[ArrayLike] = None) -> List[Curve]:
    """Reads feature curves for :func:`flatten`.

    Args:
        path: as for :func:`read_curves`.
        points, triangles: of the surface, that ids of points in texts, and edges along the boundary, refer to.

    Raises and warns as :func:`read_curves` does.
    """
    return _curves(_read_curves(path, None if triangles is None else surface_data(points, triangles)))


def _read_curves(path: Path, owner: Optional[Data]) -> Data:
    failure, curves, note = _core.read_curves(text_of("path", os.fspath(path)), owner or {"points": np.empty((0, 3))})
    _raise_failure(path, failure)
    _warn_of(path, note)
    data: Data = curves
    return data


def read_surface(path: Path, seams: SeamSource = "none") -> Tuple[vtkPolyData, vtkPolyData]:
    """:func:`load_surface` for VTK's pipelines, PyVista and :func:`flatten_polydata`; it needs VTK, of any version.

    Args:
        path: an .obj, .ply, .stl or .off file; VTK and PyVista read other formats.
        seams: edges of the faces of an .obj file that become seams: "none" (default), "textures", where
            texture coordinates break, "materials", between two of them, or "groups", between two objects
            or groups.

    Returns:
        The surface, and the curves of the file over the same points (its line elements and the seams; no
        cell where it has none), both for :func:`flatten_polydata`.

    Raises:
        MissingFileError: there is no such file.
        FlatteningError: it cannot be read, or has nothing that gives such seams; the message names the line.

    Warns:
        FlatteningWarning: edges without a face, in an object of an .obj file that has faces, were left out.
    """
    from ._vtk import mesh_of_data

    surface, curves, unit = _read(path, seams)
    for data in (surface, curves):
        data["field_arrays"] = {"LengthUnit": [unit]} if unit else {}
    mesh = mesh_of_data(surface)
    return mesh, mesh_of_data(curves if curves["lines"] else {"points": np.empty((0, 3)), "field_arrays": curves["field_arrays"]},
                              mesh if curves["lines"] else None)


def read_curves(path: Path, surface: Optional[vtkPolyData] = None) -> vtkPolyData:
    """Reads feature curves; the page of vtkFeatureCurveReader describes the formats. It needs VTK, of any version.

    Args:
        path: a .csv table, a .dxf drawing, an .obj file with line elements, or a text with one curve on each line:
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
    from ._vtk import data_of, mesh_of_data
    return mesh_of_data(_read_curves(path, None if surface is None else data_of(surface, "surface")))
