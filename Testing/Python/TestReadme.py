# SPDX-License-Identifier: BSD-3-Clause
"""What the README tells Python users works as it stands there, and help() can be read."""

import contextlib
import inspect
import io
import os
import pathlib
import pydoc
import re
import shutil
import subprocess
import sys
import textwrap
import typing
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

import surfaceflattening as sf
from surfaces import SOURCE, command


README = pathlib.Path(SOURCE, "README.md").read_text("utf-8")


def run_program():
    """What its program in Python prints, and the names that it has then."""
    section = re.search(r"^### Python\n(.*?)^##", README, re.DOTALL | re.MULTILINE).group(1)
    block = next(block for block in re.findall(r"(?:^(?: {4}.*)?\n)+", section, re.MULTILINE) if "import" in block)
    names = {}
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(compile(textwrap.dedent(block), "README.md", "exec"), names)  # pylint: disable=exec-used
    return printed.getvalue(), names


os.environ["MPLBACKEND"] = "Agg"  # for what it plots


class Readme(command.CommandTest):
    def test_its_program_keeps_the_lengths_that_it_prints(self):
        printed, names = run_program()
        report = names["result"].report
        self.assertEqual(report["status"], "Ok")
        (curve,) = report["curves"]
        self.assertEqual(curve["name"], "middle")
        self.assertAlmostEqual(curve["length_2d"], curve["length_3d"], delta=1e-12)
        self.assertIn("middle", printed)

    def run_copy(self, leave_out, before=""):
        """What `import surfaceflattening` says of a copy of the package without a file."""
        shutil.copytree(os.path.dirname(sf.__file__), self.path("surfaceflattening"),
                        ignore=shutil.ignore_patterns(leave_out, "__pycache__"))
        run = subprocess.run([sys.executable, "-c", before + "import surfaceflattening"], capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": self.folder}, check=False)
        self.assertEqual(run.returncode, 1)
        return run.stderr

    def test_a_package_that_is_not_built_says_what_to_build(self):
        said = self.run_copy("*.so")
        self.assertIn("--target surfaceflattening-python", README)
        self.assertIn("target surfaceflattening-python", said)

    def test_a_python_without_its_vtk_is_told_which_one_it_needs(self):
        said = self.run_copy("nothing", "import sys; sys.modules['vtkmodules'] = None; ")
        self.assertIn(f"Python {sys.version_info.major}.{sys.version_info.minor} with VTK "
                      f"{vtkVersion.GetVTKVersion()[:3]}", said)
        self.assertIn(sys.executable, said)
        self.assertIn("python3-vtk9", said)

    def test_another_vtk_is_named_before_its_libraries_meet(self):
        other = "import sys, types; names = types.ModuleType('surfaceflattening._version'); " \
            "names.__version__ = names.BUILT_FOR = '1'; names.BUILT_WITH_VTK = '8.90.0'; " \
            "sys.modules[names.__name__] = names; "
        said = self.run_copy("nothing", other)
        self.assertIn(f"this is VTK {vtkVersion.GetVTKVersion()}", said)
        self.assertNotIn("ParaView", said)

    def test_what_it_says_of_results_works(self):
        _, names = run_program()
        calls = re.findall(r"`(result\.\w+\(.*?\))`", README)
        self.assertEqual(len(calls), 4)
        self.addCleanup(os.chdir, os.getcwd())
        with warnings.catch_warnings():
            os.chdir(self.folder)
            warnings.simplefilter("error", sf.FlatteningWarning)
            for call in calls:
                eval(call, names)  # pylint: disable=eval-used
            self.assertEqual(sorted(os.listdir()), ["sheet.pdf", "sheet.png"])
        millimetres = {"mm": 1, "cm": 10, "m": 1000}[re.search(r'unit="(\w+)"', calls[0]).group(1)]
        self.assertGreater(np.ptp(names["result"].positions, axis=0).min() * millimetres, 100)  # of allowances of 10 mm
        for name in re.findall(r"`help\((sf[.\w]*)\)`", README):
            self.assertTrue(eval(name, names).__doc__, name)  # pylint: disable=eval-used

    def test_help_of_the_package_names_the_calls_first_and_can_be_read(self):
        text = pydoc.plain(pydoc.render_doc(sf))
        self.assertLess(text.count("\n"), 5000)
        self.assertNotIn("class vtk", text)
        names = re.findall(r"help\(surfaceflattening\.(\w+)\)", text)
        self.assertEqual(names[0], "flatten")
        self.assertLess(text.index(f"help(surfaceflattening.{names[-1]})"), text.index("PACKAGE CONTENTS"))
        for name in names:
            self.assertTrue(getattr(sf, name).__doc__, name)
        self.assertIn("vtkWireWarpingFilter", names)
        for name in sf.__all__:
            self.assertTrue(hasattr(sf, name), name)

    def test_hints_are_short_in_help_and_can_be_evaluated(self):
        self.assertLess(len(str(inspect.signature(sf.flatten))), 1000)
        hints = typing.get_type_hints(sf.flatten)
        self.assertIs(hints["return"], sf.Flattening)
        self.assertEqual(set(hints) - {"return"}, set(inspect.signature(sf.flatten).parameters))


if __name__ == "__main__":
    unittest.main(verbosity=2)
