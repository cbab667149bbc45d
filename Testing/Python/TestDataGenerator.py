"""The pieces of Data/ are what their generator writes."""

import os
import subprocess
import sys
import unittest

import numpy as np

from surfaces import DATA, command, points_of, polylines_of, read, read_file, triangles_of

# Triangle counts: the paper's Table 1 where it has the piece (within 5 %), else our own.
TRIANGLES = {
    "quarter_sphere": 56,
    "shirt_front": 1414,
    "shirt_back": 1234,
    "shirt_shoulder": 182,
    "pants_front": 1729,
    "pants_back": 1729,
    "wetsuit_upper_front": 658,
    "wetsuit_upper_back": 928,
    "wetsuit_pants_front": 1729,
    "wetsuit_pants_back": 1729,
    "shoe_upper": 1500,
    "cylinder": 960,
    "cone": 672,
    "tangent_developable": 900,
    "tshirt": 3448,
}
DEVELOPABLES = ("cylinder", "cone", "tangent_developable")


class Data(command.CommandTest):
    def test_the_generator_writes_exactly_the_committed_files(self):
        script, names = os.path.join(DATA, "Generate", "generate.py"), list(TRIANGLES)
        runs = [subprocess.Popen([sys.executable, script, self.folder, *part], stdout=subprocess.DEVNULL)
                for part in (names[::2], names[1::2])]
        self.assertEqual([run.wait() for run in runs], [0, 0])
        committed = sorted(name for name in os.listdir(DATA) if name.endswith(".vtp"))
        self.assertEqual(sorted(os.listdir(self.folder)), committed)
        for name in committed:
            with self.subTest(name):
                mine, theirs = read_file(self.path(name)), read_file(os.path.join(DATA, name))
                self.assertEqual(theirs.GetPoints().GetData().GetDataTypeAsString(), "double")
                size = np.ptp(points_of(theirs), axis=0).max()
                np.testing.assert_allclose(points_of(mine), points_of(theirs), rtol=0, atol=1e-9 * size)
                np.testing.assert_array_equal(triangles_of(mine), triangles_of(theirs))
                for one, other in zip(polylines_of(mine), polylines_of(theirs), strict=True):
                    np.testing.assert_array_equal(one, other)

    def test_pieces_have_the_triangles_of_the_paper_and_exact_unrollings(self):
        for name, count in TRIANGLES.items():
            piece = read(name)
            self.assertLessEqual(abs(piece.GetNumberOfPolys() - count), 0.05 * count, name)
            self.assertEqual(bool(piece.GetPointData().HasArray("ExactUnrolling")), name in DEVELOPABLES, name)


if __name__ == "__main__":
    unittest.main()
