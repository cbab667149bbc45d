# SPDX-License-Identifier: BSD-3-Clause
"""Documentation of the filters and the signature of flatten() name one set of defaults: the filters'.
TestPluginDescription.py compares the plugin's with them."""

import ast
import glob
import inspect
import os
import re
import typing
import unittest

import surfaceflattening as sf
from surfaces import SOURCE

SCHEMES = ("progressive", "global", "isometric", "lscm")
SOLVERS = ("newton", "sequential")
INTERIORS = ("laplacian", "relaxation", "arap")
ENERGIES = ("rigid", "dirichlet")
DART_LEGS = ("free", "straight", "mirrored")
COINCIDENT = ("automatic", "join", "keep")

PARAMETERS = {
    "scheme": ("Scheme", SCHEMES),
    "solver": ("Solver", SOLVERS),
    "interior": ("Interior", INTERIORS),
    "release_keys": ("ReleaseKeys", None),
    "release_trials": ("ReleaseTrials", None),
    "close_cuts": ("CloseCuts", None),
    "dart_legs": ("DartLegs", DART_LEGS),
    "skip_closed": ("SkipClosed", None),
    "energy": ("DistortionEnergy", ENERGIES),
    "area_bias": ("AreaBias", None),
    "angle_weight": ("AngleWeight", None),
    "material": ("Material", None),
    "grain": ("Grain", None),
    "coincident_points": ("CoincidentPoints", COINCIDENT),
    "split_triangles": ("SplitTriangles", None),
    "imprint_tolerance": ("ImprintTolerance", None),
    "snap_tolerance": ("SnapTolerance", None),
    "arrange": ("Arrange", None),
    "spacing": ("Spacing", None),
    "pins": ("ConformalPins", None),
    "max_iterations": ("MaximumIterations", None),
    "max_length_error": ("MaximumLengthError", None),
    "closure_tolerance": ("ClosureTolerance", None),
    "optimality_tolerance": ("OptimalityTolerance", None),
    "relaxation_factor": ("RelaxationFactor", None),
    "relaxation_movement": ("RelaxationMovement", None),
    "relaxation_min_iterations": ("RelaxationMinimumIterations", None),
    "relaxation_max_iterations": ("RelaxationMaximumIterations", None),
    "rigid_tolerance": ("RigidEnergyTolerance", None),
    "rigid_iterations": ("RigidMaximumIterations", None),
    "isometric_tolerance": ("IsometricTolerance", None),
    "isometric_iterations": ("IsometricMaximumIterations", None),
}
OTHER_PARAMETERS = {"points", "triangles", "curves", "paper_method", "progress", "tolerance", "ease"}


def default_of(name, words=None, filter_=None):
    value = getattr(filter_ or sf.vtkWireWarpingFilter(), "Get" + name)()
    return words[value] if words else value


def documented(path):
    """(property, text after "Default:") of the set macros of a header."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for part in text.split("///@{")[1:]:
        comment, _, macros = part.partition("*/")
        names = re.findall(r"vtkSet(?:Clamp|Vector2)?Macro\((\w+)", macros.partition("///@}")[0])
        words = " ".join(line.strip(" *") for line in comment.splitlines())
        found = re.search(r"Default: (.*?)\.(?: |$)", words)
        if names:
            yield names, found.group(1) if found else None


def same(text, value, filter_):
    if isinstance(value, tuple):
        return text == ", ".join(map(str, value))
    if isinstance(value, bool):
        return text == ("on" if value else "off")
    if isinstance(value, str):
        return text == (value or "empty")
    if re.fullmatch(r"[A-Z_]+", text):
        return getattr(filter_, text) == value
    return float(text) == value


class Defaults(unittest.TestCase):
    def test_suggest_has_those_of_the_filter(self):
        parameters = inspect.signature(sf.suggest).parameters
        suggestion = sf.vtkFeatureCurveSuggestion()
        for parameter, (name, words) in {
                "cuts": ("SuggestedCuts", ("darts", "seams", "all")), "bound": ("Bound", None),
                "max_cuts": ("MaximumCuts", None), "max_cut_length": ("MaximumCutLength", None),
                "max_work": ("MaximumWork", None),
                "symmetric": ("Symmetric", None)}.items():
            self.assertEqual(
                parameters[parameter].default, default_of(name, words, suggestion), parameter)

    def test_flatten_has_those_of_the_filter(self):
        parameters = inspect.signature(sf.flatten).parameters
        self.assertEqual(set(parameters), set(PARAMETERS) | OTHER_PARAMETERS)
        for parameter, (name, words) in PARAMETERS.items():
            self.assertEqual(parameters[parameter].default, default_of(name, words), parameter)

    def test_type_checkers_are_told_the_same_options_and_defaults(self):
        stub = os.path.join(os.path.dirname(sf.__file__), "_calls.pyi")
        with open(stub, encoding="utf-8") as file:
            functions = [node for node in ast.parse(file.read()).body if isinstance(node, ast.FunctionDef)]
        self.assertEqual([node.name for node in functions], [
            "flatten", "flatten_polydata", "suggest", "suggest_polydata", "make_flattenable",
            "make_flattenable_polydata", "price_keys"])
        words = {name: words for name, (_, words) in PARAMETERS.items() if words}
        for node in functions:
            told = {argument.arg: ast.literal_eval(default)
                    for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults)}
            parameters = inspect.signature(getattr(sf, node.name)).parameters.values()
            self.assertEqual(told, {parameter.name: parameter.default for parameter in parameters
                                    if parameter.kind is parameter.KEYWORD_ONLY})
            self.assertLessEqual(set(sf.Options.__annotations__), set(told))
            hints = typing.get_type_hints(sf.Options)
            for name, allowed in words.items():
                self.assertEqual(set(typing.get_args(hints[name])), set(allowed))

    def test_the_headers_document_them(self):
        count = 0
        for path in sorted(glob.glob(os.path.join(SOURCE, "Filters", "vtk*.h"))):
            class_ = getattr(sf, os.path.splitext(os.path.basename(path))[0], None)
            if class_ in (sf.vtkFeatureCurveAlgorithm, sf.vtkFlatPieceAlgorithm):
                class_ = sf.vtkWireWarpingFilter
            if class_ in (None, sf.vtkFlatteningAlgorithm, sf.vtkPatternWriter):
                continue
            filter_ = class_()
            for names, text in documented(path):
                with self.subTest(header=os.path.basename(path), names=names):
                    self.assertIsNotNone(text, "no default is documented")
                    values = [default_of(name, None, filter_) for name in names]
                    texts = text.split(" and ") if len(values) > 1 else [text]
                    if text.startswith("all "):
                        texts = [text[4:]] * len(values)
                    self.assertEqual(len(texts), len(values))
                    for one, value, name in zip(texts, values, names):
                        self.assertTrue(same(one, value, filter_), f"{name}: {one}, {value}")
                        count += 1
        self.assertGreater(count, 25)


if __name__ == "__main__":
    unittest.main()
