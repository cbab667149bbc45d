# SPDX-License-Identifier: BSD-3-Clause
"""Every program of Examples/Python runs from a command line and gives what it promises."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import unittest
from xml.etree import ElementTree

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

import surfaceflattening as sf
from pattern_files import SVG, bezier_length, curves_of
from surfaces import DATA, SOURCE, command, flattened, points_of, polylines_of, read, triangles_of

EXAMPLES = os.path.join(SOURCE, "Examples", "Python")


def data(name):
    return os.path.join(DATA, name + ".vtp")


def share(colors, lowest, highest):
    """Share of the pixels between two colors."""
    return ((colors >= lowest) & (colors <= highest)).all(axis=2).mean()


def write_obj(path, name):
    """A piece of Data/ as a modeller writes it: an object a curve, a line an edge. Lengths and sides by curve."""
    surface, curves = read(name), read(name + "_curves")
    points, ends, data = points_of(surface), points_of(curves), curves.GetCellData()
    ids = {tuple(point): index + 1 for index, point in enumerate(points)}
    lengths = {}
    with open(path, "w", encoding="utf-8") as file:
        file.write("# exported\no surface\n")
        file.writelines("v %.17g %.17g %.17g\n" % tuple(point) for point in points)
        file.writelines("f %d/1/1 %d/2/2 %d//3\n" % tuple(ids) for ids in triangles_of(surface) + 1)
        for row, line in enumerate(polylines_of(curves)):
            kind = ("", "key ", "dart ", "seam ")[int(data.GetArray("CurveType").GetValue(row))]
            name = data.GetAbstractArray("CurveName").GetValue(row)
            lengths[name] = np.linalg.norm(np.diff(ends[line], axis=0), axis=1).sum(), 2 if kind == "dart " else 1
            chain = [ids[tuple(ends[point])] for point in line]
            file.write(f"o {kind}{name}\n")
            file.writelines(f"l {a} {b}\n" for a, b in zip(chain, chain[1:]))
    return lengths


class Examples(command.CommandTest):
    def run_example(self, name, *arguments, code=0):
        run = subprocess.run([sys.executable, os.path.join(EXAMPLES, name), *arguments], cwd=self.folder,
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return run.stdout

    def test_flatten_without_vtk(self):
        places = "".join(f"v {x} {y} {0.1 * x * y}\n" for y in range(3) for x in range(3))
        faces = "".join(f"f {a} {a + 1} {a + 4} {a + 3}\n" for a in (1, 2, 4, 5))
        self.write("a.obj", f"# units: cm\n{places}{faces}")
        self.write("a.txt", "key middle 3 5\n")
        output = self.run_example("flatten_without_vtk.py", "a.obj", "a.png", "--curves", "a.txt")
        self.assertRegex(output, r"^piece 1: Ok, area error \d")
        self.assertGreater(command.read_png(self.path("a.png")).size, 30000)

    def test_flatten_and_plot(self):
        output = self.run_example("flatten_and_plot.py", data("wetsuit_upper_front"),
                                  data("wetsuit_upper_front_curves"), "map.png")
        lengths = [float(line.split("E_len")[1].split()[0]) for line in output.splitlines()]
        self.assertLess(max(lengths[:2]), 1e-9)
        self.assertGreater(lengths[2], 1e-3)
        colors = command.read_png(self.path("map.png"))
        self.assertEqual(colors.shape, (600, 1200, 3))
        self.assertGreater(share(colors, (0, 0, 0), (40, 40, 40)), 0.002)  # outlines
        self.assertGreater(share(colors, (250, 250, 250), (255, 255, 255)), 0.2)  # ground

    def test_garment_seams(self):
        output = self.run_example("garment_seams.py", data("tshirt"), data("tshirt_curves"))
        rows = output.splitlines()
        self.assertEqual(rows[0], "pieces 4")
        self.assertEqual(len(rows), 11)
        for row in rows[1:]:
            one, two = row.split("lengths")[1].split()[:2]
            self.assertEqual(one, two)
            self.assertLess(float(row.split()[-1]), 1e-11)

    def test_obj_to_pattern(self):
        lengths = write_obj(self.path("pants.obj"), "pants_front")
        self.run_example("obj_to_pattern.py", "pants.obj", "pants.svg", "--unit", "cm")
        drawn = {}
        for path in ElementTree.parse(self.path("pants.svg")).getroot().iter(SVG + "path"):
            if path.get("data-curve") and path.get("data-length"):  # no notches, no outline
                length = sum(map(bezier_length, curves_of(path)))
                drawn.setdefault(path.get("data-curve"), []).append(length)
        self.assertEqual(set(drawn), set(lengths))
        for name, (length, sides) in lengths.items():
            self.assertEqual(len(drawn[name]), sides, name)
            for millimetres in drawn[name]:
                self.assertAlmostEqual(millimetres, 10.0 * length, delta=1e-6 * length, msg=name)

        self.run_example("obj_to_pattern.py", "pants.obj", "nowhere/pants.svg", "--unit", "cm", code=1)

    def test_make_collection(self):
        names = ("shirt_front", "pants_back")
        self.run_example("make_collection.py", "pieces.vtm",
                         *(f"{data(name)},{data(name + '_curves')}" for name in names))
        reader = vtkXMLMultiBlockDataReader()
        reader.SetFileName(self.path("pieces.vtm"))
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetInputConnection(reader.GetOutputPort())
        filter_.Update()
        for block, name in enumerate(names):
            flat = filter_.GetOutputDataObject(0).GetBlock(block)
            np.testing.assert_allclose(points_of(flat)[:, :2], flattened(name).positions, atol=1e-9)

    @unittest.skipIf(importlib.util.find_spec("pyvista") is None, "PyVista is not installed")
    def test_flatten_with_pyvista(self):
        output = self.run_example("flatten_with_pyvista.py", data("tshirt"), data("tshirt_curves"), "areas.png")
        self.assertEqual([line.split(",")[0] for line in output.splitlines()],
                         [f"piece {number}: Ok" for number in (1, 2, 3, 4)])
        colors = command.read_png(self.path("areas.png"))
        self.assertEqual(colors.shape, (600, 1200, 3))
        self.assertGreater(share(colors, (0, 0, 0), (40, 40, 40)), 0.002)  # curves and wires

    def test_every_example_is_tried(self):
        tests = pathlib.Path(__file__).read_text("utf-8")
        for path in pathlib.Path(EXAMPLES).glob("*.py"):
            if "__main__" in path.read_text("utf-8"):
                self.assertIn(f'"{path.name}"', tests)


if __name__ == "__main__":
    unittest.main()
