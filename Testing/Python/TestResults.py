# SPDX-License-Identifier: BSD-3-Clause
"""What can be done with a result: compare, send, show, hand on as a mesh, cut from paper."""

import copy
import os
import pathlib
import pickle
import pydoc
import re
import subprocess
import unittest
from xml.etree import ElementTree

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray

import surfaceflattening as sf
from surfaces import (
    command, flattened, grid, points_of, polylines_of, quarter_sphere, quiet, read, table_rows, triangles_of, warned)


def pants(**options):
    return flattened("pants_front", **options)


def outputs(name="pants_front", material="", grain="", surface=None):
    filter_ = sf.vtkWireWarpingFilter()
    filter_.SetInputData(surface or read(name))
    filter_.SetMaterial(material)
    if grain:
        filter_.AddGrain(grain)
    filter_.SetCurvesData(read(name + "_curves"))
    filter_.Update()
    return filter_


class Equality(unittest.TestCase):
    def test_two_runs_of_the_same_are_equal_and_others_are_not(self):
        one, again, other = pants(), pants(), pants(scheme="global")
        self.assertNotEqual(one.report["seconds"], again.report["seconds"])
        self.assertTrue(one == again)
        self.assertFalse(one != again or one == other or one == "pants")
        again.positions[3, 1] += 1e-9
        self.assertFalse(one == again)

    def test_each_part_counts(self):
        one = flattened("tshirt")
        for change in (lambda result: result.triangles.__setitem__((0, 0), 7),
                       lambda result: result.cell_arrays["AreaRatio"].__setitem__(5, 0.5),
                       lambda result: result.point_arrays.pop("Developability"), lambda result: result.wires.pop(),
                       lambda result: result.wires[2].vertices.__setitem__(0, 1),
                       lambda result: result.report["curves"][0].__setitem__("name", "other"),
                       lambda result: result.seam_pairs.__setitem__((0, 0), 3)):
            other = copy.deepcopy(one)
            self.assertTrue(one == other)
            change(other)
            self.assertFalse(one == other)

    def test_curves_of_arrays_are_compared_by_value(self):
        self.assertTrue(sf.Curve(np.array([1, 2, 3]), "key") == sf.Curve(np.array([1, 2, 3]), "key"))
        self.assertTrue(sf.Curve(np.zeros((2, 3))) == sf.Curve(np.zeros((2, 3))))
        self.assertFalse(sf.Curve(np.array([1, 2, 3])) == sf.Curve(np.array([1, 2, 4])))
        self.assertFalse(sf.Curve(np.array([1, 2, 3])) == sf.Curve(np.array([1, 2])))
        self.assertFalse(sf.Curve([1, 2], name="hem") == sf.Curve([1, 2]))

    def test_results_and_curves_go_to_other_processes(self):
        result = pants()
        self.assertTrue(pickle.loads(pickle.dumps(result)) == result)
        curve = sf.Curve(np.array([1, 2]), "key", "hem")
        self.assertTrue(pickle.loads(pickle.dumps(curve)) == curve)


class Shown(command.WordsTest):
    def test_a_prompt_shows_a_line(self):
        result = flattened("tshirt")
        self.assertRegex(repr(result), r"^<Flattening: 4 pieces, \d+ triangles, Ok, ")
        self.assertLess(len(repr(result)), 120)
        self.assertIn(result.wires[0].name, repr(result.wires[0]))
        self.assertLess(len(repr(result.wires[0])), 120)
        self.assertIn("1 piece,", repr(pants()))

    def test_other_results_are_shown_in_a_line_too(self):
        points, triangles, arc = quarter_sphere()
        sewn = sf.resew(sf.flatten(points, triangles))
        prices = sf.price_keys(points, triangles, [sf.Curve(arc, "key", "arc")])
        moved = sf.make_flattenable(points, triangles, bound=0.1)
        measured = sf.measure(points, triangles, np.asarray(points)[:, :2])
        for result, words in ((measured, ["Quality: 56 triangles", "E_area"]),
                              (sewn, ["Resewn: 1 shape", f"{sewn.shapes[0].distance_max:.4g}"]),
                              (prices, ["KeyPrices", f"arc {prices.keys[0].price:.3g}"]),
                              (moved, ["Flattenable", f"{moved.shift_max:.4g}", "bound met"])):
            self.assert_words(words, repr(result))
            self.assertNotIn("array", repr(result))
            self.assertLess(len(repr(result)), 200)

    def test_a_notebook_shows_every_triangle_every_wire_and_the_measures(self):
        result = flattened("tshirt")
        text = result._repr_html_()
        picture = ElementTree.fromstring(re.search("<svg.*</svg>", text, re.DOTALL).group(0))
        paths = picture.findall(command.SVG + "path")
        triangles = sum(path.get("d").count("M") for path in paths if path.get("fill") != "none")
        self.assertEqual(triangles, len(result.triangles))
        wires = [path.find(command.SVG + "title").text for path in paths if path.get("fill") == "none"]
        self.assertEqual(wires, [f"{wire.name} ({wire.type})" for wire in result.wires])
        # Each piece has its number in the table on it.
        for number in picture.findall(command.SVG + "text"):
            low, high = (bound(result.positions[result.triangles[
                result.cell_arrays["PieceId"] == int(number.text) - 1]].reshape(-1, 2), axis=0)
                for bound in (np.min, np.max))
            whole = np.ptp(result.positions, axis=0)
            scale = min(640 / whole[0], 400 / whole[1])
            middle = ((low + high) / 2 - result.positions.min(axis=0)) * scale
            self.assertAlmostEqual(float(number.get("x")), middle[0], delta=0.06)
            self.assertAlmostEqual(float(number.get("y")), whole[1] * scale - middle[1], delta=0.06)
        self.assertEqual([number.text for number in picture.findall(command.SVG + "text")], ["1", "2", "3", "4"])
        for row, piece in zip(table_rows(text)[1:], result.report["pieces"], strict=True):
            self.assertIn(f"{piece['E_area']:.4f}", row)

    def test_the_picture_has_the_proportions_of_the_pieces(self):
        points, triangles = grid(4, 3)
        text = sf.flatten(points, triangles)._repr_html_()
        corners = np.array([[float(number) for number in pair.split(",")]
                            for pair in re.findall(r"[ML](-?[\d.]+,-?[\d.]+)", text)])
        extent = np.sort(corners.max(axis=0) - corners.min(axis=0))
        self.assertAlmostEqual(extent[1] / extent[0], 4 / 3, delta=1e-3)

    def test_names_are_text_and_no_markup(self):
        points, triangles, arc = quarter_sphere()
        result = sf.flatten(points, triangles, [sf.Curve(arc, name="<script>&")])
        text = result._repr_html_()
        self.assertNotIn("<script>", text)
        self.assertIn("&lt;script&gt;&amp;", text)

    def test_large_pieces_do_not_swell_a_notebook(self):
        self.assertLess(len(sf.flatten(*grid(100, 100), scheme="global")._repr_html_()), 1_500_000)

    def test_a_broken_promise_is_told(self):
        result = flattened("wetsuit_upper_front")
        self.assert_words(("Overlap", "waist_dart_left"), result._repr_html_())


class Help(unittest.TestCase):
    def test_every_key_of_the_report_is_explained(self):
        result = flattened("tshirt")
        release = next(piece["release"] for piece in result.report["pieces"] if piece["release"])
        for class_, values in ((sf.Report, result.report), (sf.PieceReport, result.report["pieces"][0]),
                               (sf.CurveReport, result.report["curves"][0])):
            self.assertEqual(set(class_.__annotations__), set(values), class_.__name__)
            text = pydoc.plain(pydoc.render_doc(class_))
            told = text[text.index("Keys:"):]
            for key in values:
                self.assertRegex(told, rf"(?m)^[ |]*(\w+[,:] )*{key}[,:]|; {key}:", class_.__name__)
        self.assertEqual(set(release), {"first", "objective_without_first", "ranking"})

    def test_every_attribute_of_a_result_is_explained(self):
        for class_ in (sf.Flattening, sf.Wire, sf.Curve):
            text = pydoc.plain(pydoc.render_doc(class_))
            told = text[text.index("Attributes:"):]
            for name in class_.__dataclass_fields__:
                if not name.startswith("_"):
                    self.assertRegex(told, rf"(?m)^[ |]+(\w+, )*{name}[,:]")

    def test_the_version_is_that_of_the_command(self):
        printed = subprocess.check_output([command.EXECUTABLE, "--version"], text=True)
        self.assertRegex(printed, rf"^wirewarp {re.escape(sf.__version__)} \(VTK \d+\.\d+")
        self.assertRegex(sf.__version__, r"^\d+\.\d+\.\d+$")


def arrays_of(data):
    return {data.GetArrayName(k): data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())}


class Meshes(unittest.TestCase):
    def compare(self, mine, theirs):
        np.testing.assert_array_equal(points_of(mine), points_of(theirs))
        for get in ("GetPointData", "GetCellData", "GetFieldData"):
            known = arrays_of(getattr(theirs, get)())
            self.assertEqual(set(arrays_of(getattr(mine, get)())), set(known))
            for name, array in arrays_of(getattr(mine, get)()).items():
                self.assertEqual(array.GetNumberOfComponents(), known[name].GetNumberOfComponents(), name)
                self.assertEqual(array.GetClassName(), known[name].GetClassName(), name)
                texts, wanted = ([values.GetVariantValue(k).ToString() for k in range(values.GetNumberOfValues())]
                                 for values in (array, known[name]))
                self.assertEqual(texts, wanted, name)

    def test_they_are_the_outputs_of_the_filter(self):
        for name, material, grain in (
                ("pants_front", "", ""), ("tshirt", "twill", "free"), ("shirt_front", "jersey", "centre_front:45"),
                ("wetsuit_upper_front", "neoprene", "nowhere")):
            surface = read(name)
            for data, cells in ((surface.GetPointData(), False), (surface.GetCellData(), True)):
                texts = vtkStringArray()
                texts.SetName("Label")
                for k in range(surface.GetNumberOfCells() if cells else surface.GetNumberOfPoints()):
                    texts.InsertNextValue(f"é {k}")
                data.AddArray(texts)
            owner = vtkStringArray()
            owner.SetName("Owner")
            owner.InsertNextValue("")
            surface.GetFieldData().AddArray(owner)
            filter_ = outputs(name, material, grain, surface)
            with quiet():
                result = sf.flatten_polydata(surface, read(name + "_curves"), **(
                    {"material": material, "grain": grain} if material else {}))
            for result in (result, pickle.loads(pickle.dumps(result))):
                self.check_outputs(result, filter_)

    def check_outputs(self, result, filter_):
        for port, part in enumerate(("flat", "wires", "cut")):
            self.compare(result.to_polydata(part), filter_.GetOutput(port))
            np.testing.assert_array_equal(
                triangles_of(result.to_polydata(part)), triangles_of(filter_.GetOutput(port)))
        wires, cut = (result.to_polydata(part) for part in ("wires", "cut"))
        for mine, theirs in zip(polylines_of(wires), polylines_of(filter_.GetOutput(1)), strict=True):
            np.testing.assert_array_equal(mine, theirs)
        self.assertEqual(cut.GetPointData().GetTCoords().GetName(), "FlatPositions")

    def test_they_are_of_the_caller(self):
        result = pants()
        first = result.to_polydata()
        first.GetPoints().SetPoint(0, 9.0, 9.0, 9.0)
        first.GetCellData().GetArray("AreaRatio").SetValue(0, -1.0)
        self.assertNotEqual(result.positions[0, 0], 9.0)
        self.assertNotEqual(result.cell_arrays["AreaRatio"][0], -1.0)

    def test_what_is_changed_in_a_result_is_changed_in_them(self):
        for result in (pants(), copy.deepcopy(pants())):
            result.positions[0] = (9.0, 8.0)
            result.cell_arrays["AreaRatio"][0] = -1.0
            for part in ("flat", "wires"):
                self.assertEqual(result.to_polydata(part).GetPoint(0), (9.0, 8.0, 0.0))
            self.assertEqual(result.to_polydata().GetCellData().GetArray("AreaRatio").GetValue(0), -1.0)

    def test_measures_of_an_earlier_material_do_not_stay(self):
        with quiet():
            first = flattened("shirt_front", material="twill", grain="centre_front:45")
        again = sf.flatten_polydata(first.to_polydata())
        self.assertIsNotNone(first.report["pieces"][0]["cloth"])
        self.assertIsNone(again.report["pieces"][0]["cloth"])
        self.assertNotIn("GrainAngle", arrays_of(again.to_polydata().GetFieldData()))

    def test_other_parts_are_refused(self):
        with self.assertRaisesRegex(ValueError, "part is 'all'; it must be one of flat, wires, cut"):
            pants().to_polydata("all")


class Patterns(command.CommandTest):
    def content(self, name):
        with open(self.path(name), "rb") as file:
            return re.sub(rb"(?i)creation (date|time): [0-9:/-]+", b"", file.read())  # a minute may pass

    def test_they_are_those_of_the_filters(self):
        filter_, result = outputs("tshirt"), flattened("tshirt")
        writer = sf.vtkPatternWriter()
        for port in range(3):
            writer.SetInputConnection(port, filter_.GetOutputPort(port))
        writer.SetUnitToCentimetre()
        for name in ("shirt.svg", "shirt.dxf"):
            writer.SetFileName(self.path("filter_" + name))
            self.assertTrue(writer.Write())
            result.write_pattern(pathlib.Path(self.path(name)), unit="cm")
            self.assertEqual(self.content(name), self.content("filter_" + name))

    def test_they_are_those_of_the_command_with_the_same_options(self):
        words = ["--unit", "inch", "--name", "Trousers", "--size", "40", "--quantity", "2", "--piece",
                 "front:4", "--allowance", "12", "--allowance", "boundary=20", "--mitre-limit", "3",
                 "--notch-spacing", "70", "--cut-darts-out", "--paper", "letter", "--page-overlap", "5",
                 "--max-pages", "900", "--style", "laser", "--fold", "symmetric", "--notch", "boundary=30",
                 "--double-notch", "boundary", "--notch-corners", "--notch-curve-ends", "--dart-tip", "9",
                "--dart-tip", "waist_dart=11", "--smooth", "boundary=0.4", "--symmetrize"]
        files = [word for kind in ("svg", "dxf", "pdf", "plt") for word in ("-o", f"out/pattern.{kind}")]
        self.run_command("pattern", *command.data_files("pants_front"), "--quiet", *files, *words, code=0)
        for kind in ("svg", "dxf", "pdf", "plt"):
            pants().write_pattern(
                self.path("own." + kind), unit="inch", name="Trousers", size="40", quantity=2, piece_quantities=[4],
                piece_names=["front"], allowance=12, curve_allowances={"boundary": 20.0}, mitre_limit=3,
                notch_spacing=70, cut_darts_out=True, paper="letter", page_overlap=5, max_pages=900,
                laser_colors=True, cutter_style=True, cut_on_fold=True, curve_notches={"boundary": [30]},
                double_notches=["boundary"], notch_corners=True, notch_curve_ends=True, dart_tip=9,
                curve_dart_tips={"waist_dart": 11}, curve_fairs={"boundary": 0.4}, symmetrize=True)
            mine, theirs = self.content("own." + kind), self.content(f"out/pattern.{kind}")
            if kind == "pdf":  # it holds the time
                self.assertAlmostEqual(len(mine), len(theirs), delta=64)
                self.assertTrue(mine.startswith(b"%PDF"))
            else:
                self.assertEqual(mine, theirs)

    def test_pieces_of_a_material_lie_along_its_warp_as_the_commands_do(self):
        # Angle from the chord of the first key curve to the warp.
        for name, curve, material, grain, angle, unit, options in (
                ("shirt_front", "centre_front", "twill", "centre_front:45", 45, "cm", {}),
                ("shirt_front", "centre_front", "isotropic", "-30", -30, "mm", {"fabric_width": 1400}),
                ("shirt_back", "centre_back", "jersey", "centre_back", 0, "inch", {"nap": True, "fabric_width": 1600}),
                ("quarter_sphere", "cross_arc", "neoprene", "free", None, "m", {"allowance": 3})):
            words = ["--unit", unit, "--name", "pattern"]
            laying = []
            for option, value in options.items():
                (words if option == "allowance" else laying).extend(
                    ["--" + option.replace("fabric", "roll").replace("_", "-")] + ([] if value is True else [str(value)]))
            folder = f"{name} {material}"
            self.run_command(*command.data_files(name), "--quiet", "--output", folder, "--material", material,
                             f"--grain={grain}", "--unit", unit)
            self.run_command("pattern", folder, "-o", folder + "/pattern.svg", "-o", folder + "/pattern.dxf", *words)
            self.run_command("nest", folder, *words, *laying)
            with quiet():
                result = flattened(name, material=material, grain=grain)
                laid = "fabric_width" in options
                for file, given in (("pattern.svg", {} if laid else options), ("pattern.dxf", {} if laid else options),
                                    *([("lay.svg", options)] if laid else [])):
                    result.write_pattern(self.path("own" + file), unit=unit, **given)
                    self.assertEqual(self.content("own" + file), self.content(f"{folder}/{file}"), folder)
            pairs = [line.strip() for line in self.read("ownpattern.dxf").splitlines()]
            groups = list(zip(pairs[::2], pairs[1::2]))
            arrows = [dict(groups[k + 1:k + 9]) for k, group in enumerate(groups)
                      if group == ("0", "LINE") and ("8", "7") in groups[k:k + 3]]
            self.assertEqual(len(arrows), len(result.report["pieces"]))
            for arrow in arrows:  # the warp lies along y
                self.assertAlmostEqual(float(arrow["10"]), float(arrow["11"]), delta=1e-5)
            if angle is not None:
                (wire,) = [wire for wire in result.wires if wire.name == curve]
                x, y = np.subtract(*result.positions[wire.vertices[[-1, 0]]])
                self.assertAlmostEqual(np.degrees(np.arctan2(y, x)) + angle, 90, delta=1e-6, msg=folder)

    def test_a_unit_that_is_not_given_and_a_grainline_that_bends_are_warned_of(self):
        with warned() as caught:
            pants().write_pattern(self.path("a.svg"))
            pants().write_pattern(self.path("b.svg"), unit="cm")
        self.assertEqual({(warning.category, warning.filename) for warning in caught},
                         {(sf.FlatteningWarning, __file__)})
        said = ["unit=" if "unit=" in str(warning.message) else str(warning.message) for warning in caught]
        self.assertEqual(len(said), 3)
        self.assertEqual(said[1], "unit=")
        for sentence in said[::2]:  # of both
            self.assert_words(("key curve grainline bends by", "mm", "upright", 'key_shape="straight"'), sentence)
        self.assertEqual(self.content("a.svg"), self.content("b.svg"))

    def test_what_is_wrong_is_raised_by_name_and_nothing_is_printed(self):
        result = pants()
        for kind, words, name, options in (
            (ValueError, [".svg, .pdf, .dxf"], "a.png", {}),
            (ValueError, ["unit", "'ft'", "mm, cm, m, inch"], "a.svg", {"unit": "ft"}),
            (ValueError, ["paper", "'A9'"], "a.pdf", {"paper": "A9"}),
            (ValueError, ["allowance", "-1", "[0, 1000000]"], "a.svg", {"allowance": -1}),
            (ValueError, ["quantity", "1"], "a.svg", {"quantity": 0}),
            (ValueError, ["no_such"], "a.svg", {"curve_allowances": {"no_such": 1.0}}),
            (TypeError, ["allowance", "'wide'"], "a.svg", {"allowance": "wide"}),
            (ValueError, ["piece_quantities[0]", "1"], "a.svg", {"piece_quantities": [0]}),
            (ValueError, ["piece 2", "1 piece"], "a.svg", {"piece_quantities": [1, 2]}),
            (ValueError, ["mm wide", "cloth 20 mm"], "a.svg", {"fabric_width": 20}),
            (TypeError, ["quantity", "1.5"], "a.svg", {"quantity": 1.5}),
            (TypeError, ["double_notches"], "a.svg", {"double_notches": "boundary"}),
            (ValueError, ["no_such"], "a.svg", {"double_notches": ["no_such"]}),
            (TypeError, ["folds"], "a.svg", {"folds": "grainline"}),
            *((ValueError, ["no_such"], "a.svg", {name: {"no_such": 1.0}})
              for name in ("curve_dart_tips", "curve_fairs")),
            (TypeError, ["piece_names"], "a.svg", {"piece_names": "front"}),
            (TypeError, ["piece_quantities = 5", "list"], "a.svg", {"piece_quantities": 5}),
            *((sf.ArgumentTypeError, [name, "dict"], "a.svg", {name: [("boundary", 3)]})
              for name in ("curve_allowances", "curve_notches", "curve_dart_tips", "curve_fairs")),
            (sf.ArgumentTypeError, ["curve_notches of 'boundary' = 5", "list"], "a.svg", {"curve_notches": {"boundary": 5}}),
            (ValueError, ["name", "UTF-8"], "a.svg", {"name": "a\ud800"}),
            (OSError, ["nowhere"], "nowhere/a.svg", {}),
        ):
            with self.subTest(name=name, options=options):
                self.assert_raises(kind, words, result.write_pattern, self.path(name), **{"unit": "cm", **options})
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
