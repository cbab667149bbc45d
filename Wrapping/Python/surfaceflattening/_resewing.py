# SPDX-License-Identifier: BSD-3-Clause
"""Flat pieces sewn together again: how far the sewn pattern is from the design."""

from __future__ import annotations  # help() prints hints as they are written here

import math
import os
from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._equality import ComparedByValue
from ._errors import ArgumentError, ArgumentTypeError
from ._options import checked, material_text, options_of
from ._report import raise_refusal, warn_of
from ._reshaping import Body, body_data
from ._result import Flattening
from ._types import ResewnShape, SewingTest


@dataclass(frozen=True, eq=False)
class Resewn(ComparedByValue):
    """Flat pieces, sewn together again and at rest; points and triangles are those of the flattening,
    in the same order."""

    #: Where the points lie at rest; float64, shape (n, 3).
    points: NDArray[np.float64]
    #: From there to the closest point of the design, and from the points of the design to the cloth;
    #: float64, shape (n,).
    distance: NDArray[np.float64]
    design_distance: NDArray[np.float64]
    #: Per triangle the angle between its normals at rest and in the design, radians; shape (m,).
    normal_deviation: NDArray[np.float64]
    #: Per triangle the larger and the smaller stretch less 1; shape (m, 2).
    principal_strains: NDArray[np.float64]
    #: Per triangle its row of `shapes`; int64, shape (m,).
    shape_of_triangle: NDArray[np.int64]
    #: How much longer both edges of each of the flattening's seam_pairs are than in their pieces, as a
    #: fraction; shape (k, 2).
    seam_strains: NDArray[np.float64]
    #: A row of measures for each piece ("panel") or all that is sewn together ("product").
    shapes: List[ResewnShape]
    #: Per triangle the strains of warp and weft and the shear in degrees, shape (m, 3); None without
    #: a material.
    thread_strains: Optional[NDArray[np.float64]] = None

    def __repr__(self) -> str:
        count = len(self.shapes)
        words = [f"{count} shape{'' if count == 1 else 's'}", f"{len(self.shape_of_triangle)} triangles"]
        if count:
            words += [f"at most {max(shape.distance_max for shape in self.shapes):.4g} from the design",
                      f"strain p95 {max(shape.strain_p95 for shape in self.shapes):.3g}"]
        if not all(shape.converged for shape in self.shapes):
            words.append("not at rest")
        return f"<Resewn: {', '.join(words)}>"


def resew(
    flattening: Flattening,
    test: SewingTest = "panel",
    *,
    thickness: float = 0.001,
    area_bias: float = 0.0,
    max_iterations: int = 300,
    pressure: float = 0.0,
    gravity: Sequence[float] = (0.0, 0.0, 0.0),
    material: Union[None, str, "os.PathLike[str]"] = None,
    body: Body = None,
    second_start: bool = True,
    progress: Optional[Callable[[float], Any]] = None,
) -> Resewn:
    """Sews flat pieces together again, lets them come to rest and compares that with the design.

    The pieces are cloth that is flat at rest, stretches as the flattening counts it and bends like a
    plate; without friction; under pressure, by its weight and on a body where these are given.

    Args:
        flattening: what :func:`flatten` gave.
        test: what is held: "panel", of each piece its boundary where the design has it; "product",
            nothing, with seams shared and hems free.
        thickness: of a plate that bends as the cloth does, over the size of a piece, in [0, 1].
        area_bias: above 0 a change of area costs the cloth more than one of angle, below 0 less, in
            [-0.99, 0.99].
        max_iterations: most iterations of a piece or product.
        pressure: behind the cloth, times its size over its stiffness, in [-1, 1]; what is sewn
            together must be closed.
        gravity: weight of the cloth per area and where it pulls, times its size over its stiffness;
            at most 1 long. A product needs a body to lie on.
        material: what the cloth is made of, a name that :func:`materials` knows or the path of a
            JSON file, with its warp along y of the flat pieces; None: the isotropic sheet.
        body: a surface that the cloth does not go through, whose normals point outwards: points and triangles, or a
            vtkPolyData.
        second_start: come to rest from a second start as well, to find other shapes; it takes
            twice the time.
        progress: called with the fraction done, 0 to 1. What it raises ends the run and is raised
            again.

    Raises:
        FlatteningError: "product" has a piece that is sewn to nothing; with a free boundary it comes
            to rest flat, which measures nothing.
        ValueError, TypeError: an argument is not one of the words, out of range, or of another type.

    Warns:
        FlatteningWarning: the cloth is not at rest, has several shapes, or lies in the body.
    """
    if not isinstance(flattening, Flattening):
        raise ArgumentTypeError(f"flattening is {type(flattening).__name__}; it must be what flatten() gave")
    try:
        pull = tuple(float(component) for component in gravity)
    except (TypeError, ValueError):
        pull = ()
    if len(pull) != 3:
        raise ArgumentTypeError(f"gravity = {gravity!r} must be three numbers")
    if not math.hypot(*pull) <= 1.0:
        raise ArgumentError(f"gravity = {gravity!r} is out of range; it must be at most 1 long")
    given = {"test": test, "thickness": thickness, "area_bias": area_bias, "max_iterations": max_iterations,
             "pressure": pressure, "gravity": pull, "material": material_text(material), "second_start": second_start}
    values = {option.property: checked(option, given[name]) for name, option in options_of("vtkSewnShape").items()}
    flat, _, cut = flattening._parts
    run = _core.resew(flat, cut, values, body_data(body), progress)
    raise_refusal(run)
    warn_of(run, 2)
    cells, fields = run["cell_arrays"], run["field_arrays"]
    return Resewn(
        points=run["points"],
        distance=run["distances"]["Distance"],
        design_distance=run["distances"]["DesignDistance"],
        normal_deviation=cells["NormalDeviation"],
        principal_strains=cells["PrincipalStrains"],
        shape_of_triangle=cells["ShapeId"],
        seam_strains=fields["SeamStrains"].reshape(-1, 2),
        shapes=[ResewnShape(**row) for row in run["shapes"]],
        thread_strains=np.column_stack([cells[name] for name in (
            "SewnStrainWarp", "SewnStrainWeft", "SewnShearAngle")]) if "strain_warp_rms" in run["shapes"][0] else None)
