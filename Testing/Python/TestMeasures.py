# SPDX-License-Identifier: BSD-3-Clause
"""Every number that a result gives of itself, in arrays, report.json and the table, is that of
its own points: computed anew from flat.vtp, wires.vtp and cut.vtp."""

import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

import oracle
from surfaces import DATA

COMMAND = os.environ["WIREWARP"]
CASES = (
    ("quarter_sphere", "", "progressive", ("--interior", "laplacian")),
    ("quarter_sphere", "", "lscm", ()),
    ("shirt_front", "", "isometric", ()),
    ("wetsuit_upper_front", "", "isometric", ()),  # overlaps
    ("tshirt", "", "isometric", ()),  # four pieces
    ("pants_front", "", "global", ()),
    ("pants_front", "_set3", "isometric", ()),  # keys that contradict each other
    ("shirt_back", "", "progressive", ("--interior", "laplacian")),
)
# Key in report.json to the column of the table of pieces.
PIECE_KEYS = {
    "triangles": "Triangles", "vertices": "Vertices", "wire_patches": "WirePatches",
    "wire_nodes": "WireNodes", "flipped": "FlippedTriangles", "overlaps": "Overlaps",
    "E_len": "EdgeLengthError", "E_len_max": "MaxEdgeLengthError", "E_ang": "AngleErrorMean",
    "E_h": "GlobalHomogeneity", "E_r": "GlobalAspectRatio", "E_area": "AreaError",
    "strain_p95": "StrainP95", "energy_rigid": "RigidEnergy", "cut_length": "CutLength",
}
COUNTS = ("Triangles", "Vertices", "WirePatches", "WireNodes", "FlippedTriangles", "Overlaps")
TYPES = ["accessory", "key", "dart", "seam"]


class Measures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = []
        for name, curves, scheme, options in CASES:
            with tempfile.TemporaryDirectory() as folder:
                run = subprocess.run(
                    [COMMAND, f"{DATA}/{name}.vtp", f"{DATA}/{name}_curves{curves}.vtp",
                     "--scheme", scheme, *options, "--table", "--output", folder],
                    capture_output=True, text=True, check=False)
                with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
                    report = json.load(file)
                files = [oracle.read_file(os.path.join(folder, part + ".vtp"))
                         for part in ("flat", "wires", "cut")]
            cls.results.append((f"{name}{curves}, {scheme}", run, report, oracle.Result(*files)))

    def each_result(self, check):
        for name, run, report, result in self.results:
            with self.subTest(name):
                self.assertEqual(run.returncode, 0 if report["status"] == "Ok" else 4, run.stderr)
                check(report, result, run.stdout)

    def test_each_triangle_and_point_has_its_own_measures(self):
        def check(report, result, _table):
            for name, values in result.cell_measures().items():
                # Angles by the law of cosines have half of the digits where they are small.
                np.testing.assert_allclose(result.cells[name], values, rtol=1e-7, atol=1e-7, err_msg=name)
            np.testing.assert_allclose(
                result.points["Developability"], result.developability(), atol=1e-7)
            np.testing.assert_array_equal(result.cells["PieceId"], result.piece)
            walls = result.wire_edges(connectors=True)
            self.assertEqual(
                len(set(zip(result.cells["WirePatchId"], oracle.regions(result.triangles, walls)))),
                sum(piece["wire_patches"] for piece in report["pieces"]))

        self.each_result(check)

    def test_each_piece_has_the_measures_of_its_triangles_and_wires(self):
        def check(report, result, _table):
            self.assertEqual(len(report["pieces"]), result.piece.max() + 1)
            for row, piece in enumerate(report["pieces"]):
                expected = result.piece_measures(row)
                for key, name in PIECE_KEYS.items():
                    if name in COUNTS:
                        self.assertEqual(piece[key], expected[name], name)
                    else:
                        self.assertAlmostEqual(
                            piece[key], expected[name], delta=1e-7 * abs(expected[name]) + 1e-13, msg=name)
            self.assertEqual([report["status"]], result.field["RunStatus"])

        self.each_result(check)

    def test_each_curve_has_the_lengths_of_its_edges(self):
        def check(report, result, _table):
            for row, kind, name in zip(*(result.wires[name] for name in ("CurveId", "CurveType", "CurveName"))):
                if row >= 0:
                    curve = report["curves"][row]
                    self.assertEqual((curve["name"], TYPES.index(curve["type"])), (name, kind))
            for row, line in enumerate(result.lines):
                edges = np.column_stack([line[:-1], line[1:]])
                lengths = [np.linalg.norm(np.diff(where[line], axis=0), axis=1).sum()
                           for where in (result.space, result.flat)]
                np.testing.assert_allclose(result.wires["RestLength"][row], lengths[0], rtol=1e-12)
                np.testing.assert_allclose(result.wires["FlatLength"][row], lengths[1], rtol=1e-12)
                self.assertAlmostEqual(
                    result.wires["LengthError"][row], result.length_errors(edges).max(), delta=1e-13)
            for row, curve in enumerate(report["curves"]):
                own = [k for k, line in enumerate(result.lines) if result.wires["CurveId"][k] == row]
                if not own:
                    continue  # a curve on the boundary: its edges are wires of the boundary
                sides = 2 if curve["type"] in ("dart", "seam") else 1
                for key, name in (("length_3d", "RestLength"), ("length_2d", "FlatLength")):
                    self.assertAlmostEqual(sides * curve[key], result.wires[name][own].sum(),
                                           delta=1e-9 * curve[key], msg=curve["name"])
                self.assertAlmostEqual(
                    curve["error"], result.wires["LengthError"][own].max(), delta=1e-13)

        self.each_result(check)

    def test_the_table_has_the_numbers_of_the_report_rounded(self):
        def check(report, _result, table):
            rows = [line.split() for line in table.splitlines()[1:] if line[:1].isdigit()]
            self.assertEqual(len(rows), len(report["pieces"]))
            for row, piece in zip(rows, report["pieces"]):
                # Whoever cuts counts pieces from 1; ids of arrays and of the report count from 0.
                self.assertEqual(row[:2] + row[3:4], [
                    str(piece["piece"] + 1), str(piece["triangles"]), str(piece["wire_patches"])])
                for cell, value in zip(row[4:11], (
                        1e3 * piece["E_len"], piece["E_len_max"], 1e3 * piece["E_ang"], piece["E_h"],
                        piece["E_r"], piece["E_area"], piece["strain_p95"])):
                    unit = 10.0 ** (int(cell.partition("e")[2] or 0)
                                    - len(cell.partition("e")[0].partition(".")[2]))
                    self.assertAlmostEqual(float(cell), value, delta=0.501 * unit)
                self.assertEqual(row[11:14], [str(piece[key]) for key in ("flipped", "overlaps", "iterations")])
                self.assertEqual(row[16], piece["status"])

        self.each_result(check)


if __name__ == "__main__":
    unittest.main()
