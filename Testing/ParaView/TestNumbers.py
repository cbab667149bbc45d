# SPDX-License-Identifier: BSD-3-Clause
"""The plugin gives the numbers of the paper and those of the C++ program wirewarp."""

import json
import os
import subprocess
import tempfile
import unittest

import paraview.simple as pv

from plugin import COMMAND, DATA, fetch, read, values

SCHEMES = {"progressive": "Progressive", "global": "Global", "isometric": "Isometric"}
INTERIORS = {"laplacian": "Laplacian", "arap": "As rigid as possible"}
COLUMNS = {"E_len": "EdgeLengthError", "E_ang": "AngleErrorMean", "E_h": "GlobalHomogeneity",
           "E_r": "GlobalAspectRatio", "E_area": "AreaError", "strain_p95": "StrainP95",
           "energy_rigid": "RigidEnergy", "cut_length": "CutLength", "objective": "Objective",
           "iterations": "Iterations", "flipped": "FlippedTriangles", "overlaps": "Overlaps",
           "status": "Status", "message": "StatusMessage"}


class Numbers(unittest.TestCase):
    def test_numbers_are_those_of_the_command(self):
        for name, scheme, interior in (
            ("quarter_sphere", "progressive", "laplacian"),
            ("quarter_sphere", "lscm", None),
            ("pants_front", "global", "arap"),
            ("wetsuit_upper_front", "isometric", "arap"),
            ("tshirt", "global", "arap"),
        ):
            with self.subTest(piece=name, scheme=scheme), tempfile.TemporaryDirectory() as folder:
                run = subprocess.run(
                    [COMMAND, os.path.join(DATA, name + ".vtp"),
                     os.path.join(DATA, name + "_curves.vtp"), "--scheme", scheme,
                     *(("--interior", interior) if interior else ()),
                     "--quiet", "--output", folder],
                    capture_output=True, text=True, check=False)
                self.assertIn(run.returncode, (0, 4), run.stderr)
                with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
                    report = json.load(file)
                # ParaView opens what the command wrote; with some Expats it cannot read appended data.
                path = os.path.join(folder, "flat.vtp")
                with open(path, encoding="utf-8") as file:
                    self.assertNotIn("<AppendedData", file.read())
                written = fetch(pv.XMLPolyDataReader(FileName=[path]))
                self.assertEqual(written.GetNumberOfCells(),
                                 sum(piece["triangles"] for piece in report["pieces"]))
                inputs = {"Input": read(name), "Curves": read(name + "_curves")}
                filter_ = (pv.LeastSquaresConformalMap(**inputs) if scheme == "lscm" else pv.FlattenSurfaceWireWarping(
                    **inputs, Scheme=SCHEMES[scheme], Interior=INTERIORS[interior]))
                flat, pieces = fetch(filter_), fetch(filter_, 3)
                self.assertEqual(values(flat, "RunStatus"), [report["status"]])
                self.assertGreater(len(report["pieces"]), 0)
                for key, column in COLUMNS.items():
                    mine = values(pieces, column)
                    theirs = [piece[key] for piece in report["pieces"]]
                    self.assertEqual(len(mine), len(theirs))
                    for one, other in zip(mine, theirs):
                        if isinstance(other, float):
                            self.assertAlmostEqual(one, other, delta=1e-8 * max(1.0, abs(other)))
                        elif key == "message":
                            # The command names its own option.
                            self.assertEqual(one.replace("CloseCuts = on", "--close-cuts"), other)
                        else:
                            self.assertEqual(one, other, key)


if __name__ == "__main__":
    unittest.main()
