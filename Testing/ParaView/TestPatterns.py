# SPDX-License-Identifier: BSD-3-Clause
"""Save Data writes flat pieces as patterns, and what is shown first needs no choice of the user's."""

import json
import os
import re
import subprocess
import tempfile
import unittest

import paraview.simple as pv

from plugin import COMMAND, DATA, SOURCE, fetch, main, read


def lengths(svg):
    """Name of each curve of a pattern to the lengths on the surface of its wires."""
    found = {}
    for path in re.findall(r"<path[^>]*data-curve=[^>]*data-length=[^>]*>", svg):
        name, length = (re.search(rf'data-{key}="([^"]*)"', path).group(1) for key in ("curve", "length"))
        found.setdefault(name, []).append(length)
    return {name: sorted(values) for name, values in found.items()}


class Patterns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.flattening = pv.FlattenSurfaceWireWarping(Input=read("pants_front"), Curves=read("pants_front_curves"))

    def save(self, name, **options):
        path = os.path.join(self.folder, name)
        pv.SaveData(path, proxy=self.flattening, Unit="Centimetre", **options)
        return path

    def test_an_svg_has_the_curves_that_the_command_draws(self):
        with open(self.save("pattern.svg", PatternName="trousers", SeamAllowance=15),
                  encoding="utf-8") as file:
            drawn = file.read()
        subprocess.run(
            [COMMAND, "pattern", os.path.join(DATA, "pants_front.vtp"), os.path.join(DATA, "pants_front_curves.vtp"),
             "--unit", "cm", "--name", "trousers", "--allowance", "15", "-o", os.path.join(self.folder, "pattern.svg")],
            check=False, capture_output=True)
        with open(os.path.join(self.folder, "pattern.svg"), encoding="utf-8") as file:
            expected = file.read()
        self.assertGreater(len(lengths(drawn)), 3)
        self.assertEqual(lengths(drawn), lengths(expected))
        self.assertIn("trousers", drawn)
        self.assertEqual(drawn.count("<path"), expected.count("<path"))

    def test_pages_and_blocks_are_written(self):
        with open(self.save("pattern.pdf", Paper="A0"), "rb") as file:
            self.assertTrue(file.read().startswith(b"%PDF"))
        with open(self.save("pattern.dxf"), encoding="ascii") as file:
            self.assertIn("INSERT", file.read())

    def test_a_pattern_in_a_folder_that_is_missing_is_an_error_message(self):
        said, before = tempfile.TemporaryFile(), os.dup(2)
        with said:
            os.dup2(said.fileno(), 2)
            try:
                path = self.save(os.path.join("missing", "pattern.svg"))
            finally:
                os.dup2(before, 2)
                os.close(before)
            said.seek(0)
            self.assertRegex(said.read().decode(), r"ERR.*missing.pattern\.svg")
        self.assertFalse(os.path.exists(os.path.dirname(path)))

    def test_what_is_shown_first_is_colored(self):
        view = pv.CreateView("RenderView")
        shown = [pv.Show(pv.OutputPort(self.flattening, port), view) for port in range(3)]
        self.assertEqual([list(display.ColorArrayName) for display in shown],
                         [["CELLS", "HomogeneityOfDistortion"], ["CELLS", "WireKind"],
                          ["CELLS", "HomogeneityOfDistortion"]])
        quality = pv.GetColorTransferFunction("HomogeneityOfDistortion")
        self.assertEqual((quality.RGBPoints[0], quality.RGBPoints[-4]), (0.5, 1.0))
        wires = pv.GetColorTransferFunction("WireKind")
        names = dict(zip(wires.Annotations[::2], wires.Annotations[1::2]))
        self.assertEqual(names, {"-2": "connector", "-1": "boundary", "0": "accessory", "1": "key",
                                 "2": "dart", "3": "seam"})
        self.assertEqual(len(wires.IndexedColors), 18)
        map_ = [quality.RGBPoints[k + 1:k + 4] for k in range(0, len(quality.RGBPoints), 4)]
        for k in range(0, 18, 3):  # no wire has a color of the map
            near = min(max(abs(a - b) for a, b in zip(wires.IndexedColors[k:k + 3], color)) for color in map_)
            self.assertGreater(near, 0.15, names)
        # Beside the surface, so that one view shows both.
        flat, _, cut = (pv.OutputPort(self.flattening, port).GetDataInformation().GetBounds()
                        for port in range(3))
        self.assertGreater(flat[0], cut[1])

    def test_ranges_of_colors_that_are_fixed_hold_in_scripts(self):
        with open(os.path.join(SOURCE, "Plugin", "color_presets.json"), encoding="utf-8") as file:
            points = {array: preset["RGBPoints"] for preset in json.load(file) if "RGBPoints" in preset
                      for array in preset.get("Arrays", ())}
        fixed = {array: (numbers[0], numbers[-4]) for array, numbers in points.items()}
        self.assertGreater(len(fixed), 5)

        def colors_of(array):
            colors = pv.GetColorTransferFunction(array)
            return colors.RGBPoints[0], colors.RGBPoints[-4]

        def color(display, array):
            pv.ColorBy(display, ("CELLS", array))
            return colors_of(array)

        inputs = {"Input": read("shirt_front"), "Curves": read("shirt_front_curves")}
        cloth = pv.FlattenSurfaceWireWarping(**inputs, Material="twill")
        view = pv.CreateView("RenderView")
        for filter_, port in ((cloth, 0), (cloth, 2), (self.flattening, 0), (pv.LeastSquaresConformalMap(**inputs), 0),
                              (pv.KeyCurvePrices(**inputs), 2)):
            display = pv.Show(pv.OutputPort(filter_, port), view)
            for array, ends in fixed.items():
                if array not in display.Input.GetCellDataInformation().keys():
                    continue
                for _ in range(2):
                    self.assertEqual(color(display, array), ends)
                pv.Render(view)
                self.assertEqual(color(display, array), ends)
                pv.Show(pv.OutputPort(filter_, port), view)
                self.assertEqual(colors_of(array), ends)
        cloth.Scheme = "Global"
        cloth.UpdatePipeline()
        pv.Render(view)
        self.assertEqual({array: colors_of(array) for array in fixed}, fixed)
        # What a script asks for itself is done, and other arrays have the range of their data.
        display = pv.Show(pv.OutputPort(cloth, 0), view)
        for array, after in (("ShearAngle", None), ("StrainWarp", pv.Render), ("AngleError", None)):
            color(display, array)
            if after:
                after(view)
            if array in fixed:
                display.RescaleTransferFunctionToDataRange()
            for one, other in zip(colors_of(array), cloth.CellData.GetArray(array).GetRange()):
                self.assertAlmostEqual(one, other)
        color(display, "AreaRatio")
        pv.GetColorTransferFunction("AreaRatio").RescaleTransferFunction(0.9, 1.1)
        self.assertEqual(colors_of("AreaRatio"), (0.9, 1.1))
        self.assertEqual(color(display, "AreaRatio"), (0.9, 1.1))  # the script's range is as fixed

    def test_measures_are_tables(self):
        given = read("pants_front_curves")
        given.UpdatePipeline()
        count = given.GetDataInformation().GetNumberOfCells()
        for port, rows, first in ((3, 1, ["Piece", "Status", "Name"]), (4, count, ["Curve", "Name", "Type"])):
            table = fetch(self.flattening, port)
            self.assertEqual(table.GetNumberOfRows(), rows)
            self.assertEqual([table.GetColumnName(k) for k in range(3)], first)  # a spreadsheet view sorts them


if __name__ == "__main__":
    main()
