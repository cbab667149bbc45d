# SPDX-License-Identifier: BSD-3-Clause
"""The VTK filters, readers and writers for pipelines of vtkPolyData; a package that was built without VTK has none."""

import importlib.util as _import

from ._version import BUILT_FOR, BUILT_WITH_VTK

try:
    from vtkmodules.vtkCommonCore import vtkVersion as _vtk
    # With the libraries of another VTK in one process Python would end without a word.
    if _vtk.GetVTKVersion().split(".")[:2] != BUILT_WITH_VTK.split(".")[:2]:
        raise ImportError(f"this is VTK {_vtk.GetVTKVersion()}")
    from . import _core as _core
    from .vtkFiltersFlattening import *  # noqa: F401,F403
    from .vtkIOFlattening import *  # noqa: F401,F403
    if _import.find_spec(".vtkIOPattern", __package__):  # built without patterns there is none
        from .vtkIOPattern import *  # noqa: F401,F403
except ImportError as _error:
    import sys as _sys
    _paraview = (
        ". ParaView's Python has a VTK of its own: there its plugin's filters are those of paraview.simple, such as "
        "FlattenSurfaceWireWarping, where it was started by build-paraview/bin/pvpython or `surfaceflattening-paraview pvpython`"
        if _import.find_spec("paraview") else "")
    raise ImportError(
        f"surfaceflattening cannot load its filters ({_error}). They are built for {BUILT_FOR} and need both: "
        f"start that Python, on Debian /usr/bin/python3 with the package python3-vtk9; this is "
        f"{_sys.executable} {_sys.version.split()[0]}. In a build folder the target surfaceflattening-python "
        f"makes them{_paraview}") from _error
