# SPDX-License-Identifier: BSD-3-Clause
"""The types of the Python package hold: mypy --strict finds nothing in it and in the examples, and finds
what is wrong in programs that use it wrongly.

Usage: CheckTypes.py MYPY PACKAGES_FOLDER CACHE_FOLDER
"""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = os.path.join(SOURCE, "Examples", "Python")
MYPY, PACKAGES, CACHE = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)

# A line that is wrong, and a word of what mypy says of it.
WRONG = (
    ('sf.flatten(points, triangles, scheme="fast")', "scheme"),
    ('sf.flatten(points, triangles, max_iterations="many")', "max_iterations"),
    ("sf.flatten(points, triangles, colour=1)", "colour"),
    ('sf.flatten_polydata(sf.make_surface(points, triangles), schem="x")', "schem"),
    ('sf.suggest(points, triangles, cuts="dart")', "cuts"),
    ('sf.suggest(points, triangles, schem="x")', "schem"),
    ('sf.suggest_polydata(sf.make_surface(points, triangles), cuts="dart")', "cuts"),
    ('sf.suggest_polydata(sf.make_surface(points, triangles), bounds=0.1)', "bounds"),
    ('sf.make_flattenable(points, triangles, schem="x")', "schem"),
    ('sf.make_flattenable_polydata(sf.make_surface(points, triangles), kept=["hem"])', "kept"),
    ('sf.price_keys(points, triangles, [[0, 1]], solver="newtons")', "solver"),
    ('sf.resew(result, "panels")', "resew"),
    ('sf.Curve([0, 1], type="hem")', "type"),
    ('result.report["peices"]', "peices"),
    ('result.report["pieces"][0]["E_lenght"]', "E_lenght"),
    ('result.report["status"] + 1', "operand"),
    ('result.write_pattern("a.svg", unit="ft")', "unit"),
    ('result.to_polydata("all")', "to_polydata"),
    ('result.plot("beauty")', "plot"),
    ("result.wires[0].lenght", "lenght"),
    ('options: sf.Options = {"scheem": "global"}', "scheem"),
    ('sf.vtkWireWarpingFilter().SetScheme("global")', "SetScheme"),
    ("sf.vtkWireWarpingFilter().GetSchemeAsString() + 1", "operand"),
    ('sf.vtkLeastSquaresConformalFilter().SetPins("ab", 1)', "SetPins"),
)
RIGHT = """
options: sf.Options = {"scheme": "global", "close_cuts": True}
result = sf.flatten(points, triangles, [sf.Curve([0, 1], "key")], **options)
suggestion: sf.Suggestion = sf.suggest(points, triangles, cuts="darts", bound=0.1, **options)
moved: sf.Flattenable = sf.make_flattenable(points, triangles, keep=["hem"], **options)
prices: sf.KeyPrices = sf.price_keys(points, triangles, [[0, 1]], **options)
again = sf.flatten_polydata(sf.make_surface(points, triangles), [cut.curve for cut in suggestion.cuts])
length: float = result.report["curves"][0]["length_2d"]
wire: sf.Wire = result.wires[0]
kind: sf.WireType = wire.type
filter_ = sf.vtkWireWarpingFilter()
filter_.SetScheme(filter_.ISOMETRIC)
conformal = sf.vtkLeastSquaresConformalFilter()
conformal.SetPins(0, 1)
conformal.SetPins((0, 1))
name: str = filter_.GetSchemeAsString()
"""
HEAD = "import surfaceflattening as sf\npoints = [[0.0, 0.0, 0.0]]\ntriangles = [[0, 0, 0]]\n"


def mypy(*arguments):
    path = os.pathsep.join((PACKAGES, EXAMPLES))
    run = subprocess.run(
        [MYPY, "--config-file", os.path.join(HERE, "mypy.ini"), "--cache-dir", CACHE, *arguments],
        env={**os.environ, "MYPYPATH": path}, capture_output=True, text=True, check=False)
    return run.returncode, run.stdout + run.stderr


def check(program):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "program.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(program)
        return mypy(path)


class Types(unittest.TestCase):
    def test_the_package_is_clean(self):
        code, text = mypy("-p", "surfaceflattening")
        self.assertEqual(code, 0, text)

    def test_the_examples_are_clean_as_a_user_checks_them(self):
        run = subprocess.run(
            [MYPY, "--cache-dir", CACHE, "--strict", *sorted(glob.glob("*.py", root_dir=EXAMPLES))], cwd=EXAMPLES,
            env={**os.environ, "PYTHONPATH": PACKAGES}, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_the_program_of_the_readme_is_clean(self):
        with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
            section = re.search(r"^### Python\n(.*?)^##", file.read(), re.DOTALL | re.MULTILINE).group(1)
        block = next(block for block in re.findall(r"(?:^(?: {4}.*)?\n)+", section, re.MULTILINE)
                     if "import" in block)
        code, text = check(re.sub(r"(?m)^ {4}", "", block))
        self.assertEqual(code, 0, text)

    def test_what_is_right_passes(self):
        code, text = check(HEAD + RIGHT)
        self.assertEqual(code, 0, text)

    def test_what_is_wrong_is_found_at_its_line(self):
        lines = HEAD.splitlines() + ["result = sf.flatten(points, triangles)"]
        lines += [line for line, _ in WRONG]
        code, text = check("\n".join(lines) + "\n")
        self.assertEqual(code, 1, text)
        first = len(lines) - len(WRONG) + 1
        for number, (line, word) in enumerate(WRONG, first):
            self.assertRegex(text, rf"program.py:{number}: error: .*{word}", line)
        found = {int(number) for number in re.findall(r"program.py:(\d+): error", text)}
        self.assertEqual(found, set(range(first, first + len(WRONG))))

    def test_every_class_and_method_of_the_filters_has_types(self):
        text = ""
        for name in glob.glob(os.path.join(PACKAGES, "surfaceflattening", "vtk*.pyi")):
            with open(name, encoding="utf-8") as file:
                text += file.read()
        for header in glob.glob(os.path.join(SOURCE, "Filters", "vtk*.h")) + glob.glob(os.path.join(SOURCE, "I*", "vtk*.h")):
            class_ = os.path.splitext(os.path.basename(header))[0]
            part = re.search(rf"^class {class_}\(\w+\):\n((?: .*\n)+)", text, re.MULTILINE)
            self.assertIsNotNone(part, class_)
            with open(header, encoding="utf-8") as file:
                setters = re.findall(r"vtkSet(?:Clamp|FilePath|Vector2)?Macro\((\w+)", file.read())
            for name in setters:
                self.assertRegex(part.group(1), rf"def Set{name}\(self, ", class_)
        self.assertNotIn("*args: Any", text)


if __name__ == "__main__":
    unittest.main()
