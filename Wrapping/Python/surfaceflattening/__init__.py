# SPDX-License-Identifier: BSD-3-Clause
"""Flattens triangulated surfaces so that their boundary and feature curves keep their exact length.

Two ways to use it:

- the VTK filters (vtkWireWarpingFilter and its family) in pipelines of vtkPolyData. Objects of
  Python classes that derive from vtkPolyData, such as PyVista's, are handed over as they are;
- :func:`flatten` for numpy arrays, :func:`flatten_polydata` for a vtkPolyData or a PyVista mesh: one
  call, and a :class:`Flattening` back, which draws itself in notebooks, plot()s, goes on as a mesh with
  to_polydata() and is cut from paper after write_pattern(); an exception where the input is refused.
  :func:`suggest` and :func:`suggest_polydata` propose the cuts as well.

Neither needs a screen. help(Report) and help(PieceReport) say what the measures are.

Threads: any number of them may flatten at the same time, each with surfaces of its own, and get the
results of a single one. It saves no time: VTK's Python holds the interpreter's lock while a filter
runs, so that they take turns, and other threads of the program get a turn only each time the run
reports progress. One run uses several cores by itself. For many surfaces take processes
(concurrent.futures.ProcessPoolExecutor; results, curves and errors can be sent between them) or the
command wirewarp --batch.

The method is that of C. C. L. Wang, "WireWarping: A fast surface flattening
approach with length-preserved feature curves", Computer-Aided Design 40(3), 2008.
"""

from ._version import BUILT_FOR, __version__

try:
    from .vtkFiltersFlattening import *  # noqa: F401,F403
except ImportError as _error:
    import sys as _sys
    raise ImportError(
        f"surfaceflattening cannot load its filters ({_error}). They are built for {BUILT_FOR} and need both: "
        f"start that Python, on Debian /usr/bin/python3 with the package python3-vtk9; this is "
        f"{_sys.executable} {_sys.version.split()[0]}. In a build folder the target surfaceflattening-python "
        "makes them") from _error
from ._curves import Curve, make_curves, make_surface
from ._errors import FlatteningError, FlatteningWarning
from ._flatten import flatten, flatten_polydata
from ._result import Flattening, Wire
from ._suggestion import SuggestedCut, Suggestion, suggest, suggest_polydata
from ._types import (
    CoincidentPoints, Coloring, CurveReport, CurveType, Energy, Interior, KeyShape, Options, Paper, Part,
    PieceReport, Report, Scheme, Solver, Unit, WireType)

__all__ = [name for name in dir() if name.startswith("vtk") and name != "vtkFiltersFlattening"]
__all__ += [
    "CoincidentPoints",
    "Coloring",
    "Curve",
    "CurveReport",
    "CurveType",
    "Energy",
    "Flattening",
    "FlatteningError",
    "FlatteningWarning",
    "Interior",
    "KeyShape",
    "Options",
    "Paper",
    "Part",
    "PieceReport",
    "Report",
    "Scheme",
    "Solver",
    "SuggestedCut",
    "Suggestion",
    "Unit",
    "Wire",
    "WireType",
    "__version__",
    "flatten",
    "flatten_polydata",
    "make_curves",
    "make_surface",
    "suggest",
    "suggest_polydata",
]
