# SPDX-License-Identifier: BSD-3-Clause
"""Flattens triangulated surfaces so that their boundary and feature curves keep their exact length.

Two ways to use it:

- the VTK filters (vtkWireWarpingFilter and its family) in pipelines of vtkPolyData. Objects of
  Python classes that derive from vtkPolyData, such as PyVista's, are handed over as they are;
- :func:`flatten` for numpy arrays, :func:`flatten_polydata` for a vtkPolyData: one call, arrays and
  a plain dict back, an exception where the input is refused.

Neither needs a screen. The method is that of C. C. L. Wang, "WireWarping: A fast surface flattening
approach with length-preserved feature curves", Computer-Aided Design 40(3), 2008.
"""

from .vtkFiltersFlattening import *  # noqa: F401,F403
from ._curves import Curve, make_curves, make_surface
from ._errors import FlatteningError, FlatteningWarning
from ._flatten import flatten, flatten_polydata
from ._result import Flattening, Wire

__all__ = [name for name in dir() if name.startswith("vtk") and name != "vtkFiltersFlattening"]
__all__ += [
    "Curve",
    "Flattening",
    "FlatteningError",
    "FlatteningWarning",
    "Wire",
    "flatten",
    "flatten_polydata",
    "make_curves",
    "make_surface",
]
