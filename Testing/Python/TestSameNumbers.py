# SPDX-License-Identifier: BSD-3-Clause
"""flatten() from arrays gives what the C++ program wirewarp gives from files."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
import warnings

import surfaceflattening as sf
from surfaces import DATA, points_of, polylines_of, read, triangles_of

COMMAND = os.environ["WIREWARP"]
TYPES = ("accessory", "key", "dart", "seam")


class SameNumbers(unittest.TestCase):
    def report_of_command(self, name, *options):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run(
                [COMMAND, os.path.join(DATA, name + ".vtp"), os.path.join(DATA, name + "_curves.vtp"),
                 *options, "--quiet", "--output", folder],
                capture_output=True, text=True, check=False)
            self.assertIn(run.returncode, (0, 4), run.stderr)
            with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
                return json.load(file)

    def compare(self, mine, theirs, where):
        if isinstance(mine, dict):
            self.assertEqual(set(mine), set(theirs), where)
            for key in mine:
                self.compare(mine[key], theirs[key], f"{where}.{key}")
        elif isinstance(mine, list):
            self.assertEqual(len(mine), len(theirs), where)
            for row, (one, other) in enumerate(zip(mine, theirs)):
                self.compare(one, other, f"{where}[{row}]")
        elif isinstance(mine, float):
            self.assertAlmostEqual(mine, theirs, delta=1e-9 * max(1.0, abs(theirs)), msg=where)
        else:
            self.assertEqual(mine, theirs, where)

    def test_pieces_and_curves(self):
        for name, scheme, interior in (
            ("quarter_sphere", "progressive", "laplacian"),
            ("quarter_sphere", "global", "laplacian"),
            ("quarter_sphere", "lscm", None),
            ("shirt_shoulder", "isometric", "arap"),
            ("pants_front", "global", "arap"),
        ):
            with self.subTest(piece=name, scheme=scheme):
                chosen = {"scheme": scheme, "interior": interior} if interior else {"scheme": scheme}
                theirs = self.report_of_command(
                    name, *(word for option, value in chosen.items() for word in ("--" + option, value)))
                surface, lines = read(name), read(name + "_curves")
                positions, data = points_of(lines), lines.GetCellData()
                curves = [
                    sf.Curve(positions[line], type=TYPES[data.GetArray("CurveType").GetValue(row)],
                             name=data.GetAbstractArray("CurveName").GetValue(row))
                    for row, line in enumerate(polylines_of(lines))
                ]
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", sf.FlatteningWarning)
                    mine = sf.flatten(points_of(surface), triangles_of(surface), curves,
                                      **chosen).report
                self.assertGreater(len(theirs["curves"]), 0)
                for part in ("status", "message", "ids", "pieces", "curves"):
                    self.compare(mine[part], theirs[part], part)


if __name__ == "__main__":
    if not COMMAND:
        sys.exit("the command wirewarp is not built")
    unittest.main()
