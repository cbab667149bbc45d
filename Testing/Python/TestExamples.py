# SPDX-License-Identifier: BSD-3-Clause
"""Every program of Examples/Python runs from a command line and gives what it promises."""

import glob
import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from surfaces import DATA, SOURCE

EXAMPLES = os.path.join(SOURCE, "Examples", "Python")


def data(name):
    return os.path.join(DATA, name + ".vtp")


def colors_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


def share(colors, lowest, highest):
    """Share of the pixels between two colours."""
    return ((colors[:, :3] >= lowest) & (colors[:, :3] <= highest)).all(axis=1).mean()


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_example(self, name, *arguments, code=0):
        run = subprocess.run(
            [sys.executable, os.path.join(EXAMPLES, name), *arguments],
            cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return run.stdout

    def test_flatten_and_plot(self):
        output = self.run_example("flatten_and_plot.py", data("wetsuit_upper_front"),
                                  data("wetsuit_upper_front_curves"), "map.png")
        lengths = [float(line.split("EdgeLengthError")[1].split()[0])
                   for line in output.splitlines()]
        self.assertLess(max(lengths[:2]), 1e-9)
        self.assertGreater(lengths[2], 1e-3)
        colors = colors_of(os.path.join(self.folder, "map.png"))
        self.assertEqual(len(colors), 1200 * 600)
        self.assertGreater(share(colors, (0, 0, 150), (60, 110, 255)), 0.02)  # blue: ideal
        self.assertGreater(share(colors, (0, 0, 0), (40, 40, 40)), 0.002)  # outlines
        self.assertGreater(share(colors, (250, 250, 250), (255, 255, 255)), 0.2)  # ground

    def test_key_curve_sweep(self):
        output = self.run_example(
            "key_curve_sweep.py", data("pants_front"), data("pants_front_curves"),
            data("pants_front_curves_set2"), data("pants_front_curves_set3"), "--png", "sweep.png")
        rows = output.splitlines()[1:]
        self.assertEqual(len(rows), 4)
        self.assertEqual([" Ok " in row for row in rows], [True, True, False, True])  # Fig. 13
        self.assertIn("midthigh, midcalf", rows[2])
        self.assertIn("released", rows[3])
        colors = colors_of(os.path.join(self.folder, "sweep.png"))
        self.assertGreater(share(colors, (200, 0, 0), (230, 40, 40)), 1e-4)  # keys
        self.assertGreater(share(colors, (215, 215, 210), (235, 235, 230)), 0.05)  # pieces

    def test_every_example_is_tried(self):
        with open(__file__, encoding="utf-8") as file:
            tests = file.read()
        for path in glob.glob(os.path.join(EXAMPLES, "*.py")):
            with open(path, encoding="utf-8") as file:
                program = "__main__" in file.read()
            if program:
                self.assertIn(f'"{os.path.basename(path)}"', tests)


if __name__ == "__main__":
    unittest.main()
