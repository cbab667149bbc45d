# SPDX-License-Identifier: BSD-3-Clause
"""Flattens triangulated surfaces so that their boundary and feature curves keep their exact length.

Two ways to use it:

- the VTK filters (vtkWireWarpingFilter and its family) in pipelines of vtkPolyData. Objects of
  Python classes that derive from vtkPolyData, such as PyVista's, are handed over as they are;
- :func:`flatten` for numpy arrays, :func:`flatten_polydata` for a vtkPolyData or a PyVista mesh: one
  call, and a :class:`Flattening` back, which draws itself in notebooks, plot()s, goes on as a mesh with
  to_polydata() and is cut from paper after write_pattern(); an exception where the input is refused.
  :func:`suggest` and :func:`suggest_polydata` propose the cuts as well, and :func:`price_keys` says what
  each key curve costs; :func:`resew` sews the pieces together again to say how far that is from
  the design; :func:`make_flattenable` and :func:`make_flattenable_polydata` move the surface until it
  lies flat with little strain. :func:`read_surface` and :func:`read_curves` read files.
  :func:`read_garmentcode` reads sewing patterns of GarmentCode, to be drawn
  at true scale; :func:`grade` lays the sizes of one pattern on each other, with their rule table.

Neither needs a screen. Start with help(surfaceflattening.flatten); help(surfaceflattening.Flattening),
help(surfaceflattening.Report) and help(surfaceflattening.PieceReport) say what it gives, and each filter has a
help() of its own, such as help(surfaceflattening.vtkWireWarpingFilter).

Threads: any number of them may flatten at the same time, each with surfaces of its own, and get the
results of a single one. flatten() and price_keys() leave the interpreter's lock to other threads while they
run; VTK's filters, and what takes or gives its meshes, hold it but for calls of progress. One run uses several
cores by itself. For many surfaces take processes (concurrent.futures.ProcessPoolExecutor; results, curves and
errors can be sent between them) or the command wirewarp batch.

The method is that of C. C. L. Wang, "WireWarping: A fast surface flattening
approach with length-preserved feature curves", Computer-Aided Design 40(3), 2008.
"""

import importlib.util as _import

from ._version import BUILT_FOR, BUILT_WITH_VTK, __version__

try:
    from vtkmodules.vtkCommonCore import vtkVersion as _vtk
    # With the libraries of another VTK in one process Python would end without a word.
    if _vtk.GetVTKVersion().split(".")[:2] != BUILT_WITH_VTK.split(".")[:2]:
        raise ImportError(f"this is VTK {_vtk.GetVTKVersion()}")
    from . import _core as _core
    from .vtkFiltersFlattening import *  # noqa: F401,F403
    from .vtkIOFlattening import *  # noqa: F401,F403
    if _import.find_spec(".vtkIOPattern", __name__):  # built without patterns there is none
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
from ._calls import (
    flatten, flatten_polydata, make_flattenable, make_flattenable_polydata, price_keys, suggest, suggest_polydata)
from ._curves import Curve
from ._errors import (
    ArgumentError, ArgumentTypeError, FileError, FlatteningError, FlatteningWarning, MissingFileError, OutOfMemoryError)
from ._garment import GarmentPattern, Panel, PanelEdge, Stitch, read_garmentcode
from ._grading import GradeRule, Grading, grade
from ._keys import KeyPrice, KeyPrices, KeyTrial
from ._materials import materials
from ._readers import read_curves, read_surface
from ._reshaping import Flattenable
from ._resewing import Resewn, ResewnShape, resew
from ._result import Flattening, Wire
from ._suggestion import LeftOutLine, MirrorAxis, MirrorPlane, SuggestedCut, Suggestion
from ._types import (
    BoundaryMode, ClothReport, CoincidentPoints, Coloring, CurveReport, CurveType, CutChoice, DartLegs, Energy,
    Interior, KeyShape, Options, Paper, Part, PieceReport, Report, Scheme, SeamSource, SewingTest, Solver, Unit, WireType)
from ._vtk import make_curves, make_surface

# Without the filters, of whose methods help() would print 31,000 lines.
__all__ = [
    "ArgumentError", "ArgumentTypeError", "BoundaryMode", "ClothReport", "CoincidentPoints", "Coloring", "Curve", "CurveReport",
    "CurveType", "CutChoice", "DartLegs", "Energy", "FileError", "Flattenable", "Flattening", "FlatteningError", "FlatteningWarning",
    "GarmentPattern", "GradeRule", "Grading", "Interior", "KeyPrice", "KeyPrices", "KeyShape", "KeyTrial",
    "LeftOutLine", "MirrorAxis", "MirrorPlane", "MissingFileError", "Options", "OutOfMemoryError", "Panel",
    "PanelEdge", "Paper", "Part", "PieceReport", "Report", "Resewn", "ResewnShape", "Scheme", "SeamSource",
    "SewingTest", "Solver", "Stitch", "SuggestedCut", "Suggestion", "Unit", "Wire", "WireType", "__version__",
    "flatten", "flatten_polydata", "grade", "make_curves", "make_flattenable", "make_flattenable_polydata",
    "make_surface", "materials", "price_keys", "read_curves", "read_garmentcode", "read_surface", "resew",
    "suggest", "suggest_polydata"]
