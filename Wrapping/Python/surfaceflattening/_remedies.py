# SPDX-License-Identifier: BSD-3-Clause
"""Ways out of defects, said with the arguments of :func:`flatten`."""

from typing import Iterable, Tuple
from .vtkFiltersFlattening import vtkFlatteningAlgorithm

# By the filters' name of a remedy; % stands for what it is to be applied to. Only those that name
# an option: the filters' words serve for the others.
WORDS = {
    "WriteAgain": "give the ids of points that are there",
    "CutOpen": "cut it open by a seam, such as suggest() proposes",
    "SkipClosed": "leave out what cannot be laid flat (skip_closed=True)",
    "DivideInput": "divide it",
    "RaiseImprintTolerance": "raise imprint_tolerance to %",
    "SplitTriangles": "leave split_triangles True",
    "RaiseSnapTolerance": "raise snap_tolerance",
    "NameCurve": "name a curve that is there in tolerance",
    "NamePins": "name two points of the surface in pins, or (-1, -1)",
    "OrderRelaxation": "give 0 <= relaxation_min_iterations <= relaxation_max_iterations, of them "
                       "one at least, and a relaxation_movement that is not negative",
    "AllowAngleIterations": "raise max_iterations",
    "AllowIsometricIterations": "raise isometric_iterations",
    "AllowRigidIterations": "raise rigid_iterations",
    "AllowRelaxationIterations": 'raise relaxation_max_iterations or relaxation_movement, or take '
                                 'interior="laplacian", which solves the same equation at once',
    "AllowSewingIterations": "raise max_iterations",
    "TestPanels": 'take test="panel"',
    "UseNewton": 'take solver="newton"',
    "UseIsometricScheme": 'take scheme="isometric"',
    "UseRigidInterior": 'take interior="arap"',
    "ReleaseCurves": "remove % or give a length_tolerance",
    "MakeAccessory": 'turn % into accessory curves (type="accessory", or release_keys=True for all '
                     "keys)",
    "AllowLengthError": "raise max_length_error",
    "CloseCuts": "close the cuts as far as they cross (close_cuts=True)",
    "NameGrain": "name a curve of the piece as grain: %",
    "GiveGrainAngle": 'give degrees or "free" (grain)',
    "TakeSofterCloth": "take a material that gives more (material)",
    "CheckUnit": "check the unit (unit)",
    "WidenNotches": "raise notch_spacing",
    "PrintOnPages": 'print on several pages (paper="A4", "letter", "A3" or "A0")',
    "TakeLargerPaper": "take larger paper (paper)",
    "WriteOtherFormat": "write .svg or .dxf",
    "NameAnotherFile": "name another path",
}


def remedy_words(name: str) -> str:
    """How this package says the remedy of a name; empty where there is none."""
    return WORDS.get(name) or vtkFlatteningAlgorithm.GetRemedyWords(name) or ""


def make_message(defect: str, remedies: Iterable[Tuple[str, str]]) -> str:
    """A defect and its ways out, each a name and what it is to be applied to."""
    ways = [remedy_words(name).replace("%", subject, 1) for name, subject in remedies]
    return "; ".join([defect, ", or ".join(ways)] if ways else [defect])
