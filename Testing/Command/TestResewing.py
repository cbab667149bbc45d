# SPDX-License-Identifier: BSD-3-Clause
"""wirewarp sew sews the flat pieces together again and reports how far that is from the surface."""

import os

import command


class Resewing(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("tube.obj", command.obj(*command.tube(24, 4, lambda j: (1, j / 2))))
        seams = [" ".join(str(24 * j + i) for j in range(5)) for i in (0, 12)]
        self.write("seams.txt", f"seam front {seams[0]}\nseam back {seams[1]}\n")

    def test_panels_have_a_row_each(self):
        report = self.flatten("sew", "tube.obj", "seams.txt", "--mode", "panel")
        rows = report["resewn"]
        self.assertEqual([(row["test"], row["pieces"]) for row in rows], [("panel", 1)] * 2)
        for row in rows:
            self.assertTrue(row["converged"])
            self.assertLess(row["distance_max"], 0.01 * row["size"])
            self.assertIsNone(row["cloth"])
            self.assertLess(row["strain_p95"], 1e-3)
            self.assertEqual(row["distance_mean_relative"], row["distance_mean"] / row["size"])
        self.assertIn("sewn.vtp", os.listdir(self.path("out")))
        # Without it there is neither, and an earlier one is gone.
        self.assertEqual(self.flatten("tube.obj", "seams.txt")["resewn"], [])
        self.assertNotIn("sewn.vtp", os.listdir(self.path("out")))

    def test_once_does_not_look_for_other_shapes(self):
        row, = self.flatten("sew", "tube.obj", "seams.txt", "--mode", "product")["resewn"]
        self.assertFalse(row["several_shapes"])
        self.assertGreater(row["second_distance_mean"], 0)
        once, = self.flatten("sew", "tube.obj", "seams.txt", "--mode", "product", "--once")["resewn"]
        self.assertEqual((once["several_shapes"], once["second_distance_mean"]), (None, None))
        self.assertEqual(once["distance_mean"], row["distance_mean"])

    def test_it_says_how_far_the_cloth_is_and_what_was_written(self):
        run = self.run_command("sew", "tube.obj", "seams.txt", "--mode", "panel", "--unit", "m", "--output", "out")
        rows = self.report("out")["resewn"]
        said = [line for line in run.stdout.splitlines() if "sewn again" in line]
        self.assertEqual(len(said), 2)
        for number, (line, row) in enumerate(zip(said, rows), 1):
            self.assertIn(f"piece {number} sewn again: {row['distance_mean']:.2g} m from the surface", line)
        self.assertIn("sewn.vtp, flat.vtp", run.stdout)
        self.assertNotIn("sewn", self.run_command("tube.obj", "seams.txt", "--output", "out").stdout)
        product = self.run_command("sew", "tube.obj", "seams.txt", "--mode", "product", "--output", "out").stdout
        self.assertIn("product sewn again: ", product)

    def test_it_is_sewn_of_the_material_that_it_is_cut_from(self):
        self.write("hill.obj", command.obj(*command.hill(0.03)))
        knit, = self.flatten("sew", "hill.obj", "--mode", "panel", "--material", "jersey")["resewn"]
        self.assertEqual(sorted(knit["cloth"]), ["shear_rms", "strain_warp_rms", "strain_weft_rms"])
        self.assertGreater(min(knit["cloth"].values()), 0.0)
        self.assertEqual(len(self.array("out/sewn.vtp", "SewnShearAngle")), 72)
        self.assert_stderr("nothing holds", "sew", "tube.obj", "seams.txt", "--mode", "product",
                           "--gravity", "0", "0", "-0.001", "--output", "out")

    def test_cloth_that_is_not_at_rest_is_told(self):
        self.write("hill.obj", command.obj(*command.hill(0.2)))
        self.assert_stderr("raise --sewing-iterations", "sew", "hill.obj", "--mode", "panel", "--sewing-iterations", "1",
                           "--output", "out", code=4)
        self.assertFalse(self.report("out")["resewn"][0]["converged"])

    def test_bad_usage_is_refused(self):
        for arguments in (("--sewing-iterations", "0"), ("--mode", "dress"), ("--thickness", "2")):
            self.run_command("sew", "tube.obj", *arguments, code=2)


if __name__ == "__main__":
    command.main()
