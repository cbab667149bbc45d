# SPDX-License-Identifier: BSD-3-Clause
import glob
import math
import os

import command


def curve_sets():
    """(surface, curves) for every curve set in Data/."""
    found = []
    for curves in sorted(glob.glob(os.path.join(command.DATA, "*_curves*.vtp"))):
        surface = curves[: curves.rindex("_curves")] + ".vtp"
        if os.path.exists(surface):
            found.append((surface, curves))
    return found


class Pieces(command.CommandTest):
    """The promise of the method, on all pieces that come with the project."""

    def flipped(self):
        """How many triangles of flat.vtp are turned over or without area, as their points say."""
        values, corners = self.array("out/flat.vtp", "Points"), self.array(
            "out/flat.vtp", "connectivity", "Polys")
        self.assertEqual(len(corners) % 3, 0)
        count = 0
        for k in range(0, len(corners), 3):
            (ax, ay), (bx, by), (cx, cy) = (values[3 * v : 3 * v + 2] for v in corners[k : k + 3])
            count += (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) <= 0.0
        return count

    def worst_length_error(self):
        """Of all edges of wires.vtp, whose points are those of flat.vtp and of cut.vtp."""
        places = [self.array("out/%s.vtp" % name, "Points") for name in ("flat", "cut")]
        ids, ends = (self.array("out/wires.vtp", name, "Lines") for name in ("connectivity", "offsets"))
        connector = self.array("out/wires.vtp", "Connector")
        worst = 0.0
        for row, (begin, end) in enumerate(zip([0, *ends], ends)):
            for a, b in zip(ids[begin : end - 1], ids[begin + 1 : end]):
                flat, space = (
                    math.dist(place[3 * a : 3 * a + 3], place[3 * b : 3 * b + 3]) for place in places)
                if not connector[row]:
                    worst = max(worst, abs(flat - space) / space)
        return worst

    def check_unsolved(self, pieces):
        """Where an iteration that does not converge is stopped hangs on the last bits, and so on the BLAS:
        it may or may not be where the lengths can be corrected. What is said of it must be true."""
        worst = self.worst_length_error()
        self.assertEqual([piece["status"] for piece in pieces],
                         ["LengthError" if worst > 1e-10 else "NotConverged"])
        self.assertAlmostEqual(max(piece["E_len_max"] for piece in pieces), worst, delta=1e-9)

    def check(self, *options, unsolved=(), flips_nothing=False):
        sets = curve_sets()
        self.assertEqual(len(sets), 20, "curves in Data/")
        for surface, curves in sets:
            with self.subTest(os.path.basename(curves)):
                run = self.run_command(surface, curves, "--output", "out", *options)
                self.assertIn(run.returncode, (0, 4), run.stderr)
                report = self.report("out")
                if os.path.basename(curves) in unsolved:
                    self.check_unsolved(report["pieces"])
                    continue
                self.assertLessEqual(self.worst_length_error(), 1e-10)
                flipped = self.flipped()
                self.assertEqual(flipped, sum(piece["flipped"] for piece in report["pieces"]))
                if flips_nothing:
                    self.assertEqual(flipped, 0)
                for piece in report["pieces"]:
                    self.assertLessEqual(piece["E_len_max"], 1e-10, piece["message"])
                    self.assertNotIn(piece["status"], ("NotConverged", "LengthError"))
                for curve in report["curves"]:
                    self.assertLessEqual(curve["error"], 1e-10, curve["name"])

    def test_global_scheme_keeps_every_length(self):
        self.check("--scheme", "global")

    def test_global_scheme_keeps_every_length_with_the_papers_solver_and_interior(self):
        # On the paper's Fig. 14, two wires that cross on the quarter-sphere, its iteration never ends.
        self.check(
            "--paper-method", "--solver", "sequential",
            unsolved=("quarter_sphere_curves_two.vtp",),
        )

    def test_isometric_scheme_keeps_every_length_and_flips_nothing(self):
        self.check("--scheme", "isometric", flips_nothing=True)
        self.check(
            "--scheme", "isometric", "--energy", "dirichlet", "--no-keys", flips_nothing=True)

    def test_progressive_scheme_keeps_every_length(self):
        self.check("--scheme", "progressive")

    def test_global_scheme_keeps_every_length_with_keys_released(self):
        self.check("--scheme", "global", "--no-keys")


if __name__ == "__main__":
    command.main()
