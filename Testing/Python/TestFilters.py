# SPDX-License-Identifier: BSD-3-Clause
"""Every public class is there, documented, and takes what Python programs hand over."""

import glob
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import surfaceflattening as sf
from surfaces import SOURCE, quarter_sphere, read


def table_of(mesh):
    """Points, cells and all arrays but those of time, as values."""
    yield [mesh.GetPoint(k) for k in range(mesh.GetNumberOfPoints())]
    yield [[mesh.GetCell(k).GetPointId(i) for i in range(mesh.GetCell(k).GetNumberOfPoints())]
           for k in range(mesh.GetNumberOfCells())]
    for data in (mesh.GetPointData(), mesh.GetCellData(), mesh.GetFieldData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetAbstractArray(k)
            if not array.GetName().startswith("Seconds"):
                yield array.GetName(), [array.GetVariantValue(i).ToString() for i in range(array.GetNumberOfValues())]


class PolyData(vtkPolyData):
    """A Python class over vtkPolyData, as PyVista has."""

    def __init__(self, other):
        super().__init__()
        self.ShallowCopy(other)


class Filters(unittest.TestCase):
    def test_every_public_header_has_its_class(self):
        headers = [path for folder in ("Filters", "IO", "IO/Flattening") for path in glob.glob(os.path.join(SOURCE, folder, "vtk*.h"))]
        self.assertGreaterEqual(len(headers), 7)
        for header in headers:
            name = pathlib.Path(header).stem
            self.assertTrue(hasattr(sf, name), name)
            if name != "vtkFeatureCurveEditor":  # is worked with by commands
                self.assertTrue(issubclass(getattr(sf, name), vtkAlgorithm), name)

    def test_classes_and_methods_are_documented(self):
        self.assertIn("wires", sf.vtkWireWarpingFilter.__doc__)
        self.assertIn("PROGRESSIVE", sf.vtkWireWarpingFilter.SetScheme.__doc__)
        for name in ("flatten", "flatten_polydata", "Curve", "Flattening", "FlatteningError"):
            self.assertTrue(getattr(sf, name).__doc__, name)

    def test_the_unit_of_surface_or_curves_goes_with_the_pieces_into_a_pattern(self):
        points, triangles, arc = quarter_sphere()

        def made(of_surface, of_curves, folder, **options):
            surface, curves = sf.make_surface(points, triangles), sf.make_curves([sf.Curve(arc)], points)
            for data, unit in ((surface, of_surface), (curves, of_curves)):
                word = vtkStringArray()
                word.SetName("LengthUnit")
                word.InsertNextValue(unit)
                data.GetFieldData().AddArray(word)
            result = sf.flatten_polydata(surface, curves)
            path = os.path.join(folder, "piece.dxf")
            result.write_pattern(path, **options)
            with open(path, "rb") as file:
                return result, file.read()

        # The file says when it was made.
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="1000000000"):
            for unit in ("mm", "cm", "m", "inch"):
                with self.subTest(unit), warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    _, wanted = made("", "", folder, unit=unit)
                    for of_surface, of_curves in ((unit.upper(), ""), ("", unit), (unit, "cm")):
                        result, pattern = made(of_surface, of_curves, folder)
                        self.assertEqual(pattern, wanted)
                        for part in ("flat", "wires", "cut"):
                            self.assertEqual(sf.vtkFlatteningAlgorithm.GetLengthUnitOf(result.to_polydata(part)), unit)
                    # Of a sphere's quarter with the radius 1.
                    small = ["the largest piece"] * (3 if unit in ("mm", "cm") else 0)
                    self.assertEqual([str(warning.message).split(" is ")[0] for warning in caught], small)
            for word in ("", "furlong"):
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    result, pattern = made(word, "", folder)
                    self.assertIn("taken as cm", str(caught[0].message))
                    self.assertEqual(sf.vtkFlatteningAlgorithm.GetLengthUnitOf(result.to_polydata("flat")), "")
                    self.assertEqual(pattern, made("", "", folder, unit="cm")[1])

    def test_enumerations_are_python_values(self):
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetScheme(filter_.ISOMETRIC)
        self.assertEqual(filter_.GetSchemeAsString(), "Isometric")
        self.assertEqual(sf.vtkFeatureCurveAlgorithm.SEAM, 3)
        self.assertEqual(sf.vtkFlatteningAlgorithm.OK, 0)

    def test_lists_of_curves_are_printed_and_forgotten(self):
        filter_ = sf.vtkWireWarpingFilter()
        filter_.AddCurveEase("a=b:c", 1, -0.02)
        filter_.AddCurveEase("hem", -7, 0.5)
        filter_.AddCurveEase("hem", -1, 0.015)
        filter_.AddCurveTolerance("hem", 0.125)

        def listed():
            return [line.strip() for line in str(filter_).splitlines() if line.strip().startswith("Curve")]
        self.assertEqual(listed(), ["CurveTolerance hem: 0.125", "CurveEase a=b:c in piece 1: -0.02",
                                    "CurveEase hem in piece -1: 0.015"])
        filter_.RemoveAllCurveEases()
        filter_.RemoveAllCurveTolerances()
        self.assertEqual(listed(), [])

    def test_weights_are_an_input_array(self):
        filter_ = sf.vtkFeatureCurveSuggestion()
        self.assertEqual(filter_.GetWeightArray(), "")
        filter_.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "care")
        self.assertEqual(filter_.GetWeightArray(), "care")
        time = filter_.GetMTime()
        filter_.SetWeightArray("care")
        self.assertEqual(filter_.GetMTime(), time)

    def test_the_same_value_set_twice_changes_nothing(self):
        entries = {
            "AddCurveTolerance": ("a", 0.25), "AddCurveEase": ("a", 0, 0.25), "AddPreference": ("a", 2.0),
            "AddKeptCurve": ("a",), "AddDoubleNotches": ("a",), "AddFold": ("a",), "SetCurveAllowance": ("a", 3.0),
            "SetCurveDartTip": ("a", 3.0), "SetCurveFairTolerance": ("a", 3.0), "SetPieceName": (1, "a"),
            "SetPieceQuantity": (1, 3), "SetSizeName": (1, "a"), "SetMaterial": ("twill",), "AddGrain": ("a:45",)}
        seen = set()
        for name, class_ in vars(sf).items():
            if not (isinstance(class_, type) and issubclass(class_, vtkAlgorithm)):
                continue
            try:
                filter_ = class_()
            except (TypeError, NotImplementedError):
                continue  # abstract
            for method, values in entries.items():
                if hasattr(filter_, method):
                    before = filter_.GetMTime()
                    getattr(filter_, method)(*values)
                    changed = filter_.GetMTime()
                    self.assertGreater(changed, before, f"{name}.{method}")
                    getattr(filter_, method)(*values)
                    self.assertEqual(filter_.GetMTime(), changed, f"{name}.{method}")
                    seen.add(method)
            for method in dir(filter_):
                if method.startswith("RemoveAll") and not re.search("Input|Observer", method):
                    getattr(filter_, method)()
                    changed = filter_.GetMTime()
                    getattr(filter_, method)()
                    self.assertEqual(filter_.GetMTime(), changed, f"{name}.{method}")
        self.assertEqual(seen, set(entries))

    def test_a_kept_filter_gives_what_a_fresh_one_gives(self):
        # A lune, and a deep cap with a forecast; every ordered pair of settings once.
        points, triangles, arc = quarter_sphere()
        rings, sides = 6, 16
        polar, turn = np.meshgrid(np.linspace(0.2, 1.6, rings), np.arange(sides) * 2 * np.pi / sides, indexing="ij")
        cap = np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], -1).reshape(-1, 3)
        cells = [[a, b, c] for r in range(rings - 1) for s in range(sides)
                 for a, b, c in ((sides * r + s, sides * (r + 1) + s, sides * (r + 1) + (s + 1) % sides),
                                 (sides * r + s, sides * (r + 1) + (s + 1) % sides, sides * r + (s + 1) % sides))]
        cells += [[len(cap), s, (s + 1) % sides] for s in range(sides)]
        cap = np.vstack([cap, [[0.0, 0.0, 1.0]]])
        meridian = [sides * r for r in range(rings)]
        for surface, curve in (((points, triangles), arc), ((cap, np.array(cells)), meridian)):
            mesh = sf.make_surface(*surface)
            curves = {None: None, "key": sf.make_curves([sf.Curve(curve, "key", "a")], surface[0]),
                      "dart": sf.make_curves([sf.Curve(curve[::-1][:4], "dart", "a")], surface[0])}
            settings = [(scheme, kind, material) for scheme in range(4) for kind, material in (
                (None, ""), ("key", "twill"), ("dart", ""))]

            def give(filter_, setting):
                filter_.SetScheme(setting[0])
                filter_.SetCurvesData(curves[setting[1]])
                filter_.SetMaterial(setting[2])
                filter_.Update()
                return [list(table_of(filter_.GetOutput(port))) for port in range(3)]

            def quiet():
                filter_ = sf.vtkWireWarpingFilter()
                for event in ("ErrorEvent", "WarningEvent"):
                    filter_.AddObserver(event, lambda *_: None)
                filter_.SetInputData(mesh)
                return filter_
            fresh = {setting: give(quiet(), setting) for setting in settings}
            kept = quiet()
            for first in settings:
                for second in settings:
                    self.assertEqual(give(kept, first), fresh[first], (first, second))
                    self.assertEqual(give(kept, second), fresh[second], (first, second))

    def test_objects_of_derived_python_classes_are_handed_over(self):
        surface, curves = PolyData(read("pants_front")), PolyData(read("pants_front_curves"))
        expected = sf.vtkWireWarpingFilter()
        expected.SetInputData(read("pants_front"))
        expected.SetCurvesData(read("pants_front_curves"))
        expected.Update()
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetInputData(surface)
        filter_.SetCurvesData(curves)
        filter_.Update()
        self.assertGreater(filter_.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(filter_.GetOutput().GetBounds(), expected.GetOutput().GetBounds())

        result = sf.flatten_polydata(surface, curves)
        self.assertEqual(result.report["status"], "Ok")
        self.assertEqual(len(result.triangles), filter_.GetOutput().GetNumberOfCells())

    def test_no_screen_is_needed(self):
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        program = (
            "import surfaceflattening as sf\n"
            "r = sf.flatten([[0,0,0],[1,0,0],[1,1,0],[0,1,0]], [[0,1,2],[0,2,3]])\n"
            "assert r.report['status'] == 'Ok'\n"
        )
        subprocess.run([sys.executable, "-c", program], env=environment, check=True)


if __name__ == "__main__":
    unittest.main()
