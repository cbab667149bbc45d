# SPDX-License-Identifier: BSD-3-Clause
"""The accessor ``flattening`` of PyVista's meshes. PyVista imports this module where ``mesh.flattening`` is
first asked for (0.48 and later, by its entry points)."""

from typing import Any, Sequence, Union

import pyvista
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._calls import flatten_polydata, suggest_polydata
from ._curves import Curve
from ._result import Flattening
from ._suggestion import Suggestion

Curves = Union[None, vtkPolyData, Sequence[Union[Curve, ArrayLike]]]


class FlatteningAccessor:
    """Flattens a mesh so that its boundary and feature curves keep their exact length.

    ``mesh.flattening.flat().plot(scalars="AreaRatio")`` shows the flat pieces. The options are those of
    :func:`surfaceflattening.flatten`.
    """

    def __init__(self, mesh: vtkPolyData) -> None:
        self._mesh = mesh

    def flatten(self, curves: Curves = None, **options: Any) -> Flattening:
        """The whole result, as :func:`surfaceflattening.flatten_polydata` gives it."""
        return flatten_polydata(self._mesh, curves, **options)

    def flat(self, curves: Curves = None, **options: Any) -> Any:
        """The flat pieces as a mesh with the measures of each triangle."""
        return self.flatten(curves, **options).to_polydata()

    def suggest(self, curves: Curves = None, **options: Any) -> Suggestion:
        """Cuts with which the mesh lies flat, as :func:`surfaceflattening.suggest_polydata` proposes them."""
        return suggest_polydata(self._mesh, curves, **options)


if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("flattening", pyvista.PolyData)(FlatteningAccessor)
