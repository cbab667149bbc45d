# SPDX-License-Identifier: BSD-3-Clause
"""The properties of the filters, their documentation, and the functions of Python have the names, defaults,
ranges and words of the table of options."""

import ast
import glob
import inspect
import os
import re
import unittest

import surfaceflattening as sf
from surfaceflattening._option_table import TABLE
from surfaces import SOURCE

# Set methods that are no option: inputs, and how a filter runs.
OTHERS = {"Caching", "OutputPointsPrecision", "BesideSurface", "Distributed", "Options", "LengthUnitOf",
          "MaterialFile", "FileName", "FollowPipeline", "FileFormat", "Unit", "UnitByName", "PieceName", "PieceQuantity",
          "CurveAllowance", "CurveDartTip", "CurveFairTolerance"}
ADDERS = {"CurveAllowances": "SetCurveAllowance", "CurveDartTips": "SetCurveDartTip",
          "CurveFairTolerances": "SetCurveFairTolerance", "CurveNotches": "AddCurveNotch",
          "DoubleNotches": "AddDoubleNotches", "Folds": "AddFold", "PieceNames": "SetPieceName",
          "PieceQuantities": "SetPieceQuantity",
          "CurveTolerances": "AddCurveTolerance", "CurveEases": "AddCurveEase", "Preferences": "AddPreference",
          "KeptCurves": "AddKeptCurve", "Grain": "AddGrain"}
# A class that can be made, with all that is derived from.
MADE = {"vtkFeatureCurveAlgorithm": "vtkWireWarpingFilter", "vtkFlatPieceAlgorithm": "vtkWireWarpingFilter"}


def filter_of(option):
    return getattr(sf, MADE.get(option.cls, option.cls))()


def get(filter_, option):
    return getattr(filter_, "Get" + option.property)()


def default_of(option):
    """As the property has it: -1 is a number that follows from the input."""
    automatic = -1.0 if option.type == "number" else ""
    return automatic if option.default is None else number(option, option.default)


def number(option, value):
    return [word for word, _ in option.words].index(value) if option.words else value


def documented(path):
    """(properties, text after "Default:") of the set macros of a header."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for part in text.split("///@{")[1:]:
        comment, _, macros = part.partition("*/")
        names = re.findall(r"vtk(?:Set(?:Clamp|Vector2)?|Flattening(?:Number|Word|Flag))Macro\((\w+)", macros.partition("///@}")[0])
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
        return text.strip('"') == (value or "empty")
    if re.fullmatch(r"[A-Z][A-Z_0-9]*", text):
        return getattr(filter_, text) == value
    return float(text) == value


class Options(unittest.TestCase):
    def test_the_filters_have_the_defaults_of_the_table(self):
        for option in TABLE:
            with self.subTest(option.cls, property=option.property):
                filter_ = filter_of(option)
                if option.type == "list":
                    self.assertTrue(callable(getattr(filter_, ADDERS[option.property])))
                else:
                    self.assertEqual(get(filter_, option), default_of(option))

    def test_the_filters_have_its_ranges(self):
        for option in TABLE:
            if option.type not in ("integer", "number") or option.open:
                continue
            with self.subTest(option.cls, property=option.property):
                filter_ = filter_of(option)
                kind = int if option.type == "integer" else float
                least = min(option.minimum, default_of(option))
                for value, clamped in ((least - 1, least), (option.maximum * 2, option.maximum)):
                    if abs(value) < (2**31 if option.type == "integer" else 1e300):
                        getattr(filter_, "Set" + option.property)(kind(value))
                        self.assertEqual(get(filter_, option), clamped)

    def test_the_filters_have_its_words(self):
        for option in TABLE:
            filter_ = filter_of(option)
            names = [name for _, name in option.words if name]  # one without is a filter of its own
            for place, name in enumerate(names):
                getattr(filter_, f"Set{option.property}To{name}")()
                self.assertEqual(get(filter_, option), place)
                self.assertEqual(getattr(filter_, f"Get{option.property}AsString")(), name)
            if names:
                getattr(filter_, "Set" + option.property)(len(option.words))
                self.assertEqual(get(filter_, option), len(names) - 1, option.property)

    def test_every_property_is_in_the_table(self):
        listed = {(option.cls, option.property) for option in TABLE}
        for name in {option.cls for option in TABLE} | {"vtkKeyCurvePrices"}:
            for method in vars(getattr(sf, name)):
                found = re.fullmatch(r"Set(\w+?)(?:To[A-Z]\w*|Connection|Data)?", method)
                if found and not method.endswith(("Connection", "Data")) and found.group(1) not in OTHERS:
                    self.assertIn((name, found.group(1)), listed)

    def test_the_papers_method_is_one_call(self):
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetSolverToSequential()
        filter_.UsePaperMethod()
        self.assertEqual((filter_.GetScheme(), filter_.GetInterior(), filter_.GetSolver()),
                         (filter_.GLOBAL, filter_.LAPLACIAN, filter_.SEQUENTIAL))

    def test_type_checkers_see_the_same_keywords_and_defaults(self):
        stub = os.path.join(os.path.dirname(sf.__file__), "_calls.pyi")
        with open(stub, encoding="utf-8") as file:
            functions = [node for node in ast.parse(file.read()).body if isinstance(node, ast.FunctionDef)]
        self.assertEqual(len(functions), 7)
        for node in functions:
            seen = {argument.arg: ast.literal_eval(default)
                    for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults)}
            parameters = inspect.signature(getattr(sf, node.name)).parameters.values()
            shown = {parameter.name: parameter.default for parameter in parameters
                     if parameter.kind is parameter.KEYWORD_ONLY}
            self.assertEqual(seen, shown, node.name)
            self.assertLessEqual(set(sf.Options.__annotations__), set(seen))

    def test_resew_has_the_defaults_of_the_table(self):
        parameters = inspect.signature(sf.resew).parameters
        for option in TABLE:
            if option.cls == "vtkSewnShape":
                self.assertEqual(parameters[option.name].default or option.default, option.default, option.name)

    def test_help_has_a_sentence_for_every_option(self):
        for function, cls in ((sf.flatten, sf.vtkWireWarpingFilter), (sf.suggest, sf.vtkFeatureCurveSuggestion),
                              (sf.make_flattenable, sf.vtkMakeFlattenable)):
            names = {base.__name__ for base in cls.__mro__} if function is sf.flatten else {cls.__name__}
            for option in TABLE:
                if option.cls in names:
                    self.assertIn(f"        {option.name}: ", function.__doc__)

    def test_the_headers_document_the_defaults(self):
        count = 0
        for path in sorted(glob.glob(os.path.join(SOURCE, "Filters", "vtk*.h"))
                           + [os.path.join(SOURCE, "IO", "vtkPatternWriter.h")]):
            name = os.path.splitext(os.path.basename(path))[0]
            class_ = getattr(sf, MADE.get(name, name), None)
            if class_ is None or name == "vtkFlatteningAlgorithm":
                continue
            filter_ = class_()
            for names, text in documented(path):
                with self.subTest(header=os.path.basename(path), names=names):
                    self.assertIsNotNone(text, "no default is documented")
                    values = [getattr(filter_, "Get" + name)() for name in names]
                    texts = text.split(" and ") if len(values) > 1 else [text]
                    if text.startswith("all "):
                        texts = [text[4:]] * len(values)
                    self.assertEqual(len(texts), len(values))
                    for one, value in zip(texts, values):
                        self.assertTrue(same(one, value, filter_), f"{one}, {value}")
                        count += 1
        self.assertGreater(count, 25)


if __name__ == "__main__":
    unittest.main()
