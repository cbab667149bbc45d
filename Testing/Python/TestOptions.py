# SPDX-License-Identifier: BSD-3-Clause
"""The properties of the filters, their documentation, and the functions of Python have the names, defaults,
ranges and words of the table of options."""

import ast
import inspect
import pathlib
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
    for part in path.read_text("utf-8").split("///@{")[1:]:
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
    def test_the_filters_have_the_defaults_ranges_and_words_of_the_table(self):
        for option in TABLE:
            with self.subTest(option.cls, property=option.property):
                filter_, set_ = filter_of(option), "Set" + option.property
                if option.type == "list":
                    self.assertTrue(callable(getattr(filter_, ADDERS[option.property])))
                    continue
                self.assertEqual(get(filter_, option), default_of(option))
                if option.type in ("integer", "number") and not option.open:
                    kind, largest = (int, 2**31) if option.type == "integer" else (float, 1e300)
                    least = min(option.minimum, default_of(option))
                    for value, clamped in ((least - 1, least), (option.maximum * 2, option.maximum)):
                        if abs(value) < largest:
                            getattr(filter_, set_)(kind(value))
                            self.assertEqual(get(filter_, option), clamped)
                names = [name for _, name in option.words if name]  # one without is a filter of its own
                for place, name in enumerate(names):
                    getattr(filter_, f"{set_}To{name}")()
                    self.assertEqual(get(filter_, option), place)
                    self.assertEqual(getattr(filter_, f"Get{option.property}AsString")(), name)
                if names:
                    getattr(filter_, set_)(len(option.words))
                    self.assertEqual(get(filter_, option), len(names) - 1)

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
        stub = pathlib.Path(sf.__file__).with_name("_calls.pyi").read_text("utf-8")
        functions = [node for node in ast.parse(stub).body if isinstance(node, ast.FunctionDef)]
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
        for path in (*pathlib.Path(SOURCE, "Filters").glob("vtk*.h"), pathlib.Path(SOURCE, "IO", "vtkPatternWriter.h")):
            class_ = getattr(sf, MADE.get(path.stem, path.stem), None)
            if class_ is None or path.stem == "vtkFlatteningAlgorithm":
                continue
            filter_ = class_()
            for names, text in documented(path):
                with self.subTest(header=path.name, names=names):
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
