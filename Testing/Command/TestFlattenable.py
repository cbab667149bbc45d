# SPDX-License-Identifier: BSD-3-Clause
"""wirewarp reshape moves the surface until its flat pieces are strained by no more than a bound."""

import os
import pathlib

import command


class Flattenable(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("hill.obj", command.obj(*command.hill(0.15)))
        self.write("curves.txt", "accessory middle 21 22 23 24 25 26 27\n")

    def bytes_of(self, name):
        return pathlib.Path(self.path(name)).read_bytes()

    def test_the_bound_is_met_and_both_reports_are_there(self):
        report = self.flatten("reshape", "hill.obj", "--max-strain", "0.02")
        moved = report["flattenable"]
        self.assertTrue(moved["bound_met"])
        self.assertEqual((moved["bound"], moved["keep"], moved["keep_boundary"]), (0.02, [], True))
        before, = moved["pieces_before"]
        after, = report["pieces"]
        self.assertEqual(before["strain_p95"], moved["strain_p95_before"])
        self.assertEqual(after["strain_p95"], moved["strain_p95_after"])
        self.assertGreater(before["strain_p95"], 0.02)
        self.assertLessEqual(after["strain_p95"], 0.02)
        self.assertGreater(moved["shift_mean"], 0)
        self.assertLessEqual(moved["shift_mean"], moved["shift_max"])

    def test_what_it_writes_lies_flat_by_itself_and_goes_with_the_next_run(self):
        strain = self.flatten("reshape", "hill.obj", "curves.txt", "--max-strain", "0.03")["pieces"][0]["strain_p95"]
        self.run_command("out/flattenable.vtp", "out/curves.vtp", "--output", "out", code=0)
        self.assertAlmostEqual(self.report("out")["pieces"][0]["strain_p95"], strain, 9)
        self.assertIsNone(self.flatten("hill.obj")["flattenable"])

    def test_what_may_have_been_edited_is_replaced_by_what_writes_it_alone(self):
        self.flatten("reshape", "hill.obj", "curves.txt", "--max-strain", "0.03")
        kept = {name: self.bytes_of(f"out/{name}") for name in ("flattenable.vtp", "curves.vtp")}
        self.flatten("hill.obj")
        self.write("typo.txt", "dert middle 1 2 3\n")
        self.run_command("hill.obj", "typo.txt", "--output", "out", code=3)
        self.assertNotIn("flat.vtp", os.listdir(self.path("out")))
        for name, before in kept.items():
            self.assertEqual(self.bytes_of(f"out/{name}"), before)
        run = self.run_command("reshape", self.path("out/flattenable.vtp"), "--max-strain", "0.02", "--output", "out")
        self.assertIn("is an input, which the result would replace", run.stderr)
        self.assertEqual(self.bytes_of("out/flattenable.vtp"), kept["flattenable.vtp"])

    def test_it_says_how_far_the_surface_moved_and_what_was_written(self):
        said = self.run_command("reshape", "hill.obj", "--max-strain", "0.02", "--unit", "mm", "--output", "out").stdout
        moved = self.report("out")["flattenable"]
        self.assertIn(f"surface moved by {moved['shift_mean']:.3g} mm in the mean "
                      f"({100 * moved['shift_mean_relative']:.3g} % of its size)", said)
        self.assertIn("curves.vtp, flattenable.vtp, flat.vtp", said)

    def test_kept_curves_are_named(self):
        report = self.flatten("reshape", "hill.obj", "curves.txt", "--max-strain", "0.1", "--keep", "middle")
        self.assertEqual(report["flattenable"]["keep"], ["middle"])
        run = self.assert_stderr('no curve is named "centre"; the curves are middle', "reshape", "hill.obj", "curves.txt",
                                 "--max-strain", "0.1", "--keep", "centre", "--output", "refused")
        self.assertNotIn("--tolerance", run.stderr)
        self.assertNotIn("flattenable.vtp", os.listdir(self.path("refused")))

    def test_a_bound_that_is_not_met_is_told(self):
        lines = "".join(f"accessory row{j} " + " ".join(str(7 * j + i) for i in range(7)) + "\n" for j in range(1, 6))
        self.write("all.txt", lines)
        keep = [word for j in range(1, 6) for word in ("--keep", f"row{j}")]
        self.assert_stderr("above the bound of 1 %", "reshape", "hill.obj", "all.txt", "--max-strain", "0.01", *keep,
                           "--output", "out", code=0)
        moved = self.report("out")["flattenable"]
        self.assertEqual((moved["bound_met"], moved["shift_max"]), (False, 0))
        self.assertEqual(moved["strain_p95_after"], moved["strain_p95_before"])

    def test_the_moved_surface_is_sewn_again(self):
        self.flatten("reshape", "hill.obj", "--max-strain", "0.02")
        self.assertEqual(self.run_command("sew", "out").returncode, 0)
        row, = self.report("out")["resewn"]
        plain, = self.flatten("sew", "hill.obj", "--mode", "panel")["resewn"]
        self.assertLess(row["distance_mean"], 0.7 * plain["distance_mean"])

    def test_bad_usage_is_refused(self):
        for arguments in (("--outward", "1.5"), ("--max-strain", "0"), ("--max-strain", "100%"), ("--max-strain", "nan"),
                          ("--kind", "darts")):
            self.run_command("reshape", "hill.obj", *arguments, code=2)


if __name__ == "__main__":
    command.main()
