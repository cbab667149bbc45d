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
from surfaces import SOURCE, command, grid, quiet


def shell(columns=10, rows=12, height=0.25):
    return grid(columns, rows, lambda i, j: (
        i / columns, j / columns, height * np.sin(np.pi * i / columns) * np.sin(np.pi * j / rows)))


@quiet()
def flatten(*arguments, **options):
    return sf.flatten(*arguments, **options)


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
