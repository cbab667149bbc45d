# SPDX-License-Identifier: BSD-3-Clause
"""Every public class is there, documented, and takes what Python programs hand over."""

import os
import pathlib
import re
import unittest
import unittest.mock

from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import surfaceflattening as sf
from surfaces import SOURCE, command, quarter_sphere, warned


class Filters(command.CommandTest):
    def test_every_public_header_has_its_class(self):
        names = [path.stem for folder in ("Filters", "IO", "IO/Flattening")
                 for path in pathlib.Path(SOURCE, folder).glob("vtk*.h")]
        self.assertGreaterEqual(len(names), 7)
        for name in names:
            self.assertTrue(hasattr(sf, name), name)
            if name != "vtkFeatureCurveEditor":  # is worked with by commands
                self.assertTrue(issubclass(getattr(sf, name), vtkAlgorithm), name)

    def test_the_unit_of_surface_or_curves_goes_with_the_pieces_into_a_pattern(self):
        points, triangles, arc = quarter_sphere()

        def made(of_surface, of_curves, **options):
            surface, curves = sf.make_surface(points, triangles), sf.make_curves([sf.Curve(arc)], points)
            for data, unit in ((surface, of_surface), (curves, of_curves)):
                word = vtkStringArray()
                word.SetName("LengthUnit")
                word.InsertNextValue(unit)
                data.GetFieldData().AddArray(word)
            result = sf.flatten_polydata(surface, curves)
            result.write_pattern(self.path("piece.dxf"), **options)
            return result, self.read("piece.dxf")

        # The file says when it was made.
        with unittest.mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="1000000000"):
            for unit in ("m", "inch"):
                _, wanted = made("", "", unit=unit)
                for of_surface, of_curves in ((unit.upper(), ""), ("", unit), (unit, "cm")):
                    with self.subTest(unit, of_surface=of_surface):
                        result, pattern = made(of_surface, of_curves)
                        self.assertEqual(pattern, wanted)
                        for part in ("flat", "wires", "cut"):
                            self.assertEqual(sf.vtkFlatteningAlgorithm.GetLengthUnitOf(result.to_polydata(part)), unit)
            for word in ("", "furlong"):
                with warned() as caught:
                    result, pattern = made(word, "")
                self.assertIn("taken as cm", str(caught[0].message))
                self.assertEqual(sf.vtkFlatteningAlgorithm.GetLengthUnitOf(result.to_polydata("flat")), "")
                self.assertEqual(pattern, made("", "", unit="cm")[1])

    def test_eases_of_curves_are_listed_and_forgotten(self):
        filter_ = sf.vtkWireWarpingFilter()
        filter_.AddCurveEase("a=b:c", 1, -0.02)
        self.assertIn("CurveEase a=b:c in piece 1: -0.02", str(filter_))
        filter_.RemoveAllCurveEases()
        self.assertNotIn("a=b:c", str(filter_))

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


if __name__ == "__main__":
    unittest.main()
