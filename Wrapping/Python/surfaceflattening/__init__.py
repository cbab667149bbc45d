# SPDX-License-Identifier: BSD-3-Clause
"""Flattens triangulated surfaces so that their boundary and feature curves keep their exact length.

Two ways to use it:

- the VTK filters (vtkWireWarpingFilter and its family) in pipelines of vtkPolyData. Objects of
  Python classes that derive from vtkPolyData, such as PyVista's, are handed over as they are;
- :func:`flatten` for numpy arrays, :func:`flatten_polydata` for a vtkPolyData or a PyVista mesh: one
  call that returns a :class:`Flattening`, or raises an exception where the input is rejected. Notebooks
  show the result as a picture; plot() draws it, to_polydata() returns meshes, write_pattern() writes a pattern.
  :func:`suggest` and :func:`suggest_polydata` propose the cuts as well, and :func:`price_keys` measures what
  each key curve costs; :func:`resew` sews the pieces together again and measures how far that is from
  the design; :func:`make_flattenable` and :func:`make_flattenable_polydata` move the surface until it
  lies flat with little strain. :func:`read_surface` and :func:`read_curves` read files.
  :func:`read_garmentcode` reads sewing patterns of GarmentCode, to be drawn
  at true scale; :func:`grade` lays the sizes of one pattern on each other, with their rule table.

Neither needs a screen. Only builds with VTK have the filters. Everything else needs VTK only where it takes or
returns meshes, and then uses that of the caller; :func:`load_surface` and :func:`load_curves` read files as arrays.
Start with help(surfaceflattening.flatten); help(surfaceflattening.Flattening), help(surfaceflattening.Report) and
help(surfaceflattening.PieceReport) describe the result, and each filter has a help() of its own, such as
help(surfaceflattening.vtkWireWarpingFilter).

Threads: any number of them may flatten at the same time, each with surfaces of its own, and get the same
results as one alone. flatten(), suggest(), make_flattenable(), price_keys() and resew() release the interpreter's lock
while they run; VTK's filters hold it except in calls of progress. One run uses several
cores by itself. For many surfaces use processes (concurrent.futures.ProcessPoolExecutor; results, curves and
errors can be sent between them) or the command wirewarp batch.

The method is that of C. C. L. Wang, "WireWarping: A fast surface flattening
approach with length-preserved feature curves", Computer-Aided Design 40(3), 2008.
"""

from ._version import BUILT_WITH_VTK as _VTK
from ._version import __version__

if _VTK:
    from .vtk import *  # noqa: F401,F403
from ._calls import (
    flatten, flatten_polydata, make_flattenable, make_flattenable_polydata, price_keys, suggest, suggest_polydata)
from ._curves import Curve, make_curves, make_surface
from ._errors import (
    ArgumentError, ArgumentTypeError, FileError, FlatteningError, FlatteningWarning, MissingFileError, OutOfMemoryError)
from ._garment import GarmentPattern, Panel, PanelEdge, Stitch, read_garmentcode
from ._grading import GradeRule, Grading, grade
from ._keys import KeyPrice, KeyPrices, KeyTrial
from ._materials import materials
from ._readers import LoadedSurface, load_curves, load_surface, read_curves, read_surface
from ._resewing import Resewn, resew
from ._reshaping import Flattenable
from ._result import Flattening, Wire
from ._surfaces import Quality, developability, draw_curve, measure
from ._suggestion import MirrorAxis, MirrorPlane, SuggestedCut, Suggestion
from ._types import (
    BoundaryMode, ClothReport, CoincidentPoints, Coloring, CurveReport, CurveType, CutChoice, DartLegs, Energy,
    Interior, KeyShape, LeftOutLine, Options, Paper, Part, PieceReport, Report, ResewnShape, Scheme, SeamSource, SewingTest, Solver, Unit, UpAxis,
    WireType)

# Without the filters, of whose methods help() would print 31,000 lines.
__all__ = [
    "ArgumentError", "ArgumentTypeError", "BoundaryMode", "ClothReport", "CoincidentPoints", "Coloring", "Curve", "CurveReport",
    "CurveType", "CutChoice", "DartLegs", "Energy", "FileError", "Flattenable", "Flattening", "FlatteningError", "FlatteningWarning",
    "GarmentPattern", "GradeRule", "Grading", "Interior", "KeyPrice", "KeyPrices", "KeyShape", "KeyTrial",
    "LeftOutLine", "LoadedSurface", "MirrorAxis", "MirrorPlane", "MissingFileError", "Options", "OutOfMemoryError", "Panel",
    "PanelEdge", "Paper", "Part", "PieceReport", "Quality", "Report", "Resewn", "ResewnShape", "Scheme", "SeamSource",
    "SewingTest", "Solver", "Stitch", "SuggestedCut", "Suggestion", "Unit", "UpAxis", "Wire", "WireType", "__version__",
    "developability", "draw_curve", "flatten", "flatten_polydata", "grade", "load_curves", "load_surface", "make_curves", "make_flattenable", "make_flattenable_polydata",
    "make_surface", "materials", "measure", "price_keys", "read_curves", "read_garmentcode", "read_surface", "resew",
    "suggest", "suggest_polydata"]

if not _VTK:
    def __getattr__(name: str) -> object:
        if name.startswith("vtk"):
            raise AttributeError(
                f"{name} needs a build of surfaceflattening with VTK, and this one has none; install the Debian package, or "
                "build with CMake and SURFACEFLATTENING_WITH_VTK=ON")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
