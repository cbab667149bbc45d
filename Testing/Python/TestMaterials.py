# SPDX-License-Identifier: BSD-3-Clause
"""Pieces cut from cloth: the measures are those of the geometry, whatever computed them."""

import inspect
import json
import os
import pathlib
import re
import unittest
import warnings

import numpy as np

import surfaceflattening as sf
from surfaces import SOURCE, column_of, command, cone, cylinder, grid, moved_rigidly, quiet, shell


def tangent_developable(strips=5, division=4):
    """The tangents of a helix between two distances from it. Each strip between neighboring tangents is two flat
    triangles, so that it can be unrolled as it is; no two of them lie in one plane."""
    def tangent(turn, distance):
        way = np.array([-np.sin(turn), np.cos(turn), 0.4]) / np.hypot(1, 0.4)
        return np.array([np.cos(turn), np.sin(turn), 0.4 * turn]) + distance * way

    def place(i, j):
        strip = min(i // division, strips - 1)
        a, b = i / division - strip, j / division
        near, far = (lambda distance: tangent(0.2 * strip, distance)), (lambda distance: tangent(0.2 * (strip + 1), distance))
        if a >= b:
            return (1 - a) * near(0.3) + (a - b) * far(0.3) + b * far(1.5)
        return (1 - b) * near(0.3) + (b - a) * near(1.5) + a * far(1.5)

    return grid(division * strips, division, place)


# Of the shell.
CURVES = [sf.Curve(column_of(10, 12, 5), name="column"), sf.Curve(range(66, 77), name="row")]


@quiet()
def flatten(*arguments, **options):
    return sf.flatten(*arguments, **options)


def cloth_of(result):
    return result.report["pieces"][0]["cloth"]


def thread_rms(result):
    return np.hypot(cloth_of(result)["strain_warp_rms"], cloth_of(result)["strain_weft_rms"])


def threads_of(points, result):
    """Strain of warp and weft and the shear of each triangle, from its corners alone."""
    origin = result.point_arrays["vtkOriginalPointIds"]
    space = points[origin][result.triangles]
    flat = result.positions[result.triangles]
    along = space[:, 1:] - space[:, :1]
    plane = np.swapaxes(flat[:, 1:] - flat[:, :1], 1, 2)
    # What takes vectors of the plane to the surface: a 3 x 2 matrix a triangle.
    onto = np.swapaxes(along, 1, 2) @ np.linalg.inv(plane)
    weft, warp = onto[:, :, 0], onto[:, :, 1]
    lengths = np.linalg.norm(warp, axis=1), np.linalg.norm(weft, axis=1)
    angle = np.degrees(np.arccos((weft * warp).sum(axis=1) / (lengths[0] * lengths[1])))
    area = np.linalg.norm(np.cross(along[:, 0], along[:, 1]), axis=1)
    return lengths[0] - 1, lengths[1] - 1, angle - 90, area / area.sum()


class Materials(command.CommandTest):
    def test_strains_are_those_of_the_geometry(self):
        points, triangles = shell()
        for scheme in ("isometric", "global"):
            result = flatten(points, triangles, material="twill", grain=25, scheme=scheme)
            warp, weft, shear, share = threads_of(points, result)
            cells = result.cell_arrays
            np.testing.assert_allclose(cells["StrainWarp"], warp, atol=1e-12)
            np.testing.assert_allclose(cells["StrainWeft"], weft, atol=1e-12)
            np.testing.assert_allclose(np.abs(cells["ShearAngle"]), np.abs(shear), atol=1e-5)
            cloth = result.report["pieces"][0]["cloth"]
            for key, values in (("strain_warp_rms", warp), ("strain_weft_rms", weft), ("shear_rms", shear)):
                self.assertAlmostEqual(cloth[key], np.sqrt((share * values**2).sum()), 6)
            over = (np.abs(warp) > 0.05) | (np.abs(weft) > 0.05)
            self.assertAlmostEqual(cloth["share_over_5_percent"], share[over].sum(), 12)
            (twill,) = (material for material in sf.materials() if material["name"] == "twill")
            out = np.zeros(len(warp), bool)
            for values, name in ((warp, "warp"), (weft, "weft")):
                out |= (100 * values < twill[name + "_least"]) | (100 * values > twill[name + "_greatest"])
            out |= np.abs(shear) > twill["shear_limit"]
            np.testing.assert_array_equal(cells["OutOfLimit"], out)
            self.assertAlmostEqual(cloth["share_out_of_limit"], share[out].sum(), 12)
            locked = np.abs(shear) > twill["shear_limit"]
            self.assertAlmostEqual(cloth["share_locked"], share[locked].sum(), 12)

    def test_the_triangle_farthest_beyond_its_limits_is_named_first(self):
        points, triangles = shell()
        result = flatten(points, triangles, CURVES, material="laminate")
        warp, weft, shear, _ = threads_of(points, result)
        (laminate,) = (material for material in sf.materials() if material["name"] == "laminate")
        beyond = np.max([np.abs(100 * warp) / laminate["warp_greatest"], np.abs(100 * weft) / laminate["weft_greatest"],
                         np.abs(shear) / laminate["shear_limit"]], axis=0)
        self.assertEqual(set(result.report["ids"]), set(np.flatnonzero(beyond > 1)))
        self.assertGreater(beyond[result.report["ids"][0]], (1 - 1e-9) * beyond.max())
        self.assertTrue({"AddDarts", "TakeSofterCloth"} <= {remedy["name"] for remedy in result.report["remedies"]})
        self.assertLess(result.report["pieces"][0]["E_len_max"], 1e-12)

    def test_the_worst_of_several_broken_promises_is_the_status_and_tells_the_others(self):
        report = flatten(*shell(), CURVES, material="laminate", grain="waist").report
        self.assertEqual(report["status"], "MissingGrain")
        self.assertIn("beyond the limits", report["message"])
        self.assertTrue({"NameGrain", "AddDarts"} <= {remedy["name"] for remedy in report["remedies"]})

    def test_the_isotropic_sheet_is_the_plain_scheme(self):
        plain, sheet = flatten(*shell(), CURVES), flatten(*shell(), CURVES, material="isotropic")
        np.testing.assert_allclose(sheet.positions, plain.positions, atol=1e-6)
        self.assertGreater(thread_rms(sheet), 0)
        self.assertNotEqual(sheet.report["pieces"][0]["energy_used"], "cloth")
        self.assertNotIn("StrainWarp", plain.cell_arrays)

    def test_threads_are_strained_less_than_in_the_isotropic_sheet_and_lengths_hold(self):
        before = thread_rms(flatten(*shell(), CURVES, material="isotropic"))
        for material in ("plain", "twill", "woven-carbon"):
            result = flatten(*shell(), CURVES, material=material)
            piece, = result.report["pieces"]
            with self.subTest(material, message=piece["message"]):
                self.assertIn(piece["status"], ("Ok", "BeyondLimits"))
                self.assertLess(thread_rms(result), 0.75 * before)
                self.assertLess(piece["E_len_max"], 1e-12)
                self.assertEqual((piece["flipped"], piece["energy_used"]), (0, "cloth"))

    def test_developable_pieces_are_exact_at_any_grain(self):
        for surface in (cylinder(12, 6), cone(12, 6), grid(8, 9), tangent_developable()):
            for material in ("twill", "jersey", "laminate"):
                for grain in (0, 23, 45, -80, "free"):
                    result = sf.flatten(*surface, material=material, grain=grain)
                    self.assertEqual(result.report["status"], "Ok")
                    self.assertLess(max(thread_rms(result), np.radians(cloth_of(result)["shear_rms"])), 1e-8)
                    self.assertEqual(cloth_of(result)["share_out_of_limit"], 0)

    def test_turning_the_surface_with_its_grain_changes_nothing(self):
        points, triangles = shell()
        for material, grain in (("twill", 20), ("twill", "column:10"), ("jersey", "row:-35")):
            one, other = (flatten(places, triangles, CURVES, material=material, grain=grain)
                          for places in (points, moved_rigidly(points)))
            np.testing.assert_allclose(one.positions, other.positions, atol=1e-7)

    def test_a_free_grain_is_no_worse_than_any_that_is_given(self):
        free, *given = (flatten(*shell(), CURVES, material="stretch-woven", grain=grain).report["pieces"][0]["energy_sheet"]
                        for grain in ("free", *range(0, 180, 30)))
        self.assertLessEqual(free, 1.02 * min(given))

    def test_limits_take_back_what_is_beyond_them(self):
        points, triangles = shell()
        (jersey,) = (material for material in sf.materials() if material["name"] == "jersey")
        material = {key: jersey[key] for key in ("warp", "weft", "shear", "compression")}
        self.write("cloth.json", json.dumps(material))
        without = flatten(points, triangles, CURVES, material=self.path("cloth.json"))
        self.assertEqual(cloth_of(without)["share_out_of_limit"], 0)
        rms = cloth_of(without)["strain_warp_rms"]
        self.write("cloth.json", json.dumps({**material, "limits": {"warp": [-100 * rms, 100 * rms]}}))
        limited = flatten(points, triangles, CURVES, material=self.path("cloth.json"))
        self.assertLess(cloth_of(limited)["strain_warp_rms"], rms)
        before, after = ((share * np.maximum(np.abs(warp) - rms, 0)**2).sum()
                         for warp, _, _, share in (threads_of(points, result) for result in (without, limited)))
        self.assertLess(after, 0.6 * before)

    def test_strains_that_the_boundary_forces_are_not_spread_beyond_those_of_the_isotropic_sheet(self):
        for height in (0.3, 0.5):
            sheet, *woven = (cloth_of(flatten(*shell(12, 12, height), material=material, grain="free"))["share_over_5_percent"]
                             for material in ("isotropic", "plain", "twill"))
            self.assertLessEqual(max(woven), sheet)

    def test_wires_between_slivers_are_not_given_up_for_the_cloth(self):
        # Half of it is pressed to a billionth of its width.
        sheet = grid(8, 8, lambda i, j: (
            i / 8 if i < 4 else 0.5 + 1e-9 * (i / 8 - 0.5), j / 8, 0.2 * np.sin(6 * j / 8) * i / 8))
        before, *after = (flatten(*sheet, **cloth).report["pieces"][0]["E_len_max"]
                          for cloth in ({}, {"material": "twill"}, {"material": "jersey"}))
        self.assertLess(max(after), max(1e-6, 10 * before))

    def test_the_dominant_stretch_is_the_largest(self):
        points, triangles = shell()
        result = flatten(points, triangles, material="jersey")
        cells = result.cell_arrays
        strain = cells["DominantStretch"] / 100 - 1
        for thread, name in ((0, "StrainWarp"), (1, "StrainWeft")):
            self.assertTrue((np.abs(strain) >= np.abs(cells[name]) - 1e-12).all())
            rows = cells["DominantThread"] == thread
            np.testing.assert_allclose(strain[rows], cells[name][rows], atol=1e-12)

    def test_materials_are_names_or_files(self):
        points, triangles = shell()
        self.write("cloth.json", json.dumps({"warp": 2000, "weft": 1000, "shear": 20, "one_way": True}))
        cloth = flatten(points, triangles, material=self.path("cloth.json")).report["pieces"][0]["cloth"]
        self.assertTrue(cloth["one_way"])
        self.assertEqual(cloth["share_out_of_limit"], 0)  # without limits
        with self.assertRaisesRegex(ValueError, r"grain is for a material; .*, or leave grain out$"):
            sf.flatten(points, triangles, grain=30)
        with self.assertRaisesRegex(TypeError, "name or the path"):
            sf.flatten(points, triangles, material=3)

    def test_an_unknown_material_is_raised_wherever_a_name_is_taken(self):
        points, triangles = shell()
        curves = [sf.Curve([0, 1], "key", "a")]
        surface, lines = sf.make_surface(points, triangles), sf.make_curves(curves, points)
        inputs = {"points": points, "triangles": triangles, "curves": curves, "surface": surface,
                  "flattening": flatten(points, triangles)}
        functions = {name: getattr(sf, name) for name in sf.__all__ if inspect.isfunction(getattr(sf, name))}
        takers = {name: inspect.signature(function).parameters for name, function in functions.items()
                  if "material" in inspect.signature(function).parameters}
        self.assertEqual(takers.keys(), {
            "flatten", "flatten_polydata", "make_flattenable", "make_flattenable_polydata", "price_keys", "resew",
            "suggest", "suggest_polydata"})
        unknown = (("felt", None), ("Demin", "denim"), ("twill ", "twill"), (pathlib.Path("no") / "cloth.json", None))
        for function, parameters in takers.items():
            needed = {name: inputs["surface" if parameters[name].annotation == "vtkPolyData" else name]
                      for name, parameter in parameters.items()
                      if parameter.default is parameter.empty and parameter.kind is parameter.POSITIONAL_OR_KEYWORD}
            for name, near in unknown:
                with self.subTest(function, material=name), warnings.catch_warnings():
                    warnings.simplefilter("error")  # raised, not said
                    error = self.assert_raises(sf.ArgumentError, (
                        f"material is {name!r}; it must be one of isotropic, plain",
                        f"did you mean '{near}'?" if near else "JSON file"), functions[function], **needed, material=name)
                    self.assertEqual("did you mean" in str(error), near is not None)
        for scheme in ("lscm", "global", "progressive"):
            with self.assertRaisesRegex(sf.ArgumentError, "material is 'felt'"):
                sf.flatten(points, triangles, scheme=scheme, material="felt")

        classes = [class_ for name, class_ in vars(sf).items() if hasattr(class_, "SetMaterial") and "Algorithm" not in name]
        self.assertGreaterEqual(len(classes), 6)
        for class_ in classes:
            filter_ = class_()
            errors = []
            filter_.AddObserver("ErrorEvent", lambda *_: errors.append(1))
            filter_.SetInputData(surface)
            if class_ is sf.vtkSewnShape:
                filter_.SetInputData(0, inputs["flattening"].to_polydata())
                filter_.SetInputData(1, surface)
            if hasattr(class_, "SetCurvesData"):
                filter_.SetCurvesData(lines)
            filter_.SetMaterial("felt")
            filter_.Update()
            self.assertEqual((filter_.GetStatusName(), len(errors)), ("InvalidOption", 1), class_)
            self.assertIn("one of isotropic, plain", filter_.GetStatusMessage())
            self.assertEqual(filter_.GetOutput().GetNumberOfPoints(), 0)
            filter_.SetMaterial("twill")
            filter_.Update()
            self.assertFalse(filter_.IsRefused(), class_)

    def test_a_grain_is_an_angle_or_names_of_curves(self):
        points, triangles = shell()
        angles = [flatten(points, triangles, material="twill", grain=grain)
                  for grain in (25, 25.0, np.float32(25), np.int64(25), "25")]
        for result in angles:
            np.testing.assert_array_equal(result.positions, angles[0].positions)
        for grain in (float("nan"), float("inf"), 10**400):
            with self.assertRaisesRegex(ValueError, "finite angle"):
                sf.flatten(points, triangles, material="twill", grain=grain)
        for grain in (b"hem", [25], [b"hem"], True, object()):
            with self.assertRaisesRegex(TypeError, "NAME|name of a curve"):
                sf.flatten(points, triangles, material="twill", grain=grain)

    def test_the_page_has_the_numbers_of_every_material(self):
        with open(os.path.join(SOURCE, "Documentation", "materials.md"), encoding="utf-8") as file:
            rows = [line.strip("|\n").split("|") for line in file if line.startswith("| `")]
        rows = {row[0].strip(" `"): [cell.strip() for cell in row[1:]] for row in rows if len(row) == 7}

        def numbers(text):
            return [float(number) for number in re.findall(r"-?[\d.]+(?:e\d+)?", text)]

        known = {material["name"]: material for material in sf.materials() if material["warp"] > 0}
        self.assertEqual(rows.keys(), known.keys())
        for name, material in known.items():
            stiffness, source, compression, strains, allowed_by, shear = rows[name]
            self.assertEqual(numbers(stiffness), [material[key] for key in ("warp", "weft", "shear")], name)
            self.assertEqual(numbers(compression), [material["compression"]], name)
            np.testing.assert_allclose(numbers(strains), [material[key] for key in (
                "warp_least", "warp_greatest", "weft_least", "weft_greatest")], atol=1e-12, err_msg=name)
            np.testing.assert_allclose(numbers(shear), [material["shear_limit"]], atol=1e-9, err_msg=name)
            self.assertTrue(source and allowed_by, name)


if __name__ == "__main__":
    unittest.main()
