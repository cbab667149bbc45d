# SPDX-License-Identifier: BSD-3-Clause
"""Flattens triangulated surfaces with wires of exact length, on top of VTK's Python wrapping."""

from .vtkFiltersFlattening import *  # noqa: F401,F403
