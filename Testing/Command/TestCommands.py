# SPDX-License-Identifier: BSD-3-Clause
"""What one command writes another reads."""

import math
import os
import re

import command


class Commands(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune(20)
        os.rename(self.path("lune.obj"), self.path("a.obj"))
        os.rename(self.path("arc.txt"), self.path("a.txt"))

    def run_well(self, *arguments):
        return self.run_command(*arguments, code=0)

    def test_a_result_is_drawn_as_its_surface_is(self):
        self.run_well("flatten", "a.obj", "a.txt", "--unit", "cm", "-o", "out")
        before = self.report("out")
        drawn = ("-o", "%s.svg", "-o", "%s.dxf", "-o", "%s.json", "-o", "%s.csv", "--allowance", "7",
                 "--allowance", "boundary=12", "--piece", "front:2")
        self.run_well("pattern", "out", *[word.replace("%s", "one") for word in drawn])
        self.run_well("pattern", "a.obj", "a.txt", "--unit", "cm", *[word.replace("%s", "two") for word in drawn])
        for ending in (".svg", ".dxf", ".json", ".csv"):
            self.assertEqual(self.read("one" + ending), self.read("two" + ending), ending)
        self.assertEqual(self.report("out"), before)

    def test_files_of_a_pattern_are_made_without_a_result_beside_them(self):
        run = self.run_well("--unit", "cm", "pattern", "a.obj", "-o", "new/front.svg")
        self.assertEqual(os.listdir(self.path("new")), ["front.svg"])
        self.assertIn("written to new: front.svg", run.stdout)

    def test_a_result_is_laid_on_cloth(self):
        self.run_well("a.obj", "--unit", "cm", "-o", "out")
        self.run_well("nest", "out", "--roll-width", "1400", "--up", "none", "-o", "lay.svg", "-o", "lay.plt")
        self.run_well("nest", "a.obj", "--unit", "cm", "--roll-width", "1400", "--up", "none", "-o", "two.svg", "-o", "two")
        self.assertEqual(self.read("lay.svg"), self.read("two.svg"))
        for folder in ("out", "two"):
            lay = self.report(folder)["lay"]
            self.assertEqual(lay["width_mm"], 1400)
            self.assertAlmostEqual(lay["length_mm"], 407.26, delta=0.5)
            self.assertTrue(0.2 < lay["used"] < 1)

    def made(self, *arguments):
        """The pattern of a surface, which may be strained beyond the limits of its material."""
        self.run_command("pattern", *arguments, "-o", "made.svg", "--smooth", "0", code=(0, 4))
        return self.read("made.svg")

    def test_sheets_have_no_allowance_by_default_and_cloth_has_one_of_10_mm(self):
        self.write("card.json", '{"warp": 2000, "weft": 2000, "shear": 800, "sheet": true}')
        self.write("cloth.json", '{"warp": 2000, "weft": 2000, "shear": 800}')
        surface = ("a.obj", "--unit", "cm", "--scheme", "global")
        stated = {mm: self.made(*surface, "--allowance", mm) for mm in ("0", "10")}
        self.assertNotEqual(*stated.values())
        self.assertEqual(self.made(*surface), stated["10"])
        for material, mm in (("leather", "0"), ("isotropic", "0"), ("card.json", "0"), ("plain", "10"), ("cloth.json", "10")):
            with self.subTest(material):
                made = (*surface, "--material", material)
                self.assertEqual(self.made(*made), self.made(*made, "--allowance", mm))

    def test_notches_lie_at_a_sixth_of_the_largest_piece(self):
        self.write("seam.txt", self.read("a.txt").replace("accessory", "seam"))
        for scale, spacing in ((2, "5"), (20, "50"), (45, "100"), (200, "500")):
            self.write_lune(scale)
            surface = ("lune.obj", "seam.txt", "--unit", "cm", "--scheme", "global")
            self.assertEqual(self.made(*surface), self.made(*surface, "--notch-spacing", spacing), scale)

    def test_legs_that_fold_tell_what_they_cost(self):
        pieces = {}
        for legs in ("mirrored", "free"):
            self.run_well(*command.data_files("shirt_back"), "-o", "out", "--dart-legs", legs)
            (pieces[legs],) = self.report("out")["pieces"]
        numbers = re.search(r"leave a strain of ([\d.]+) %, free ones would leave ([\d.]+) %",
                            pieces["mirrored"]["fallbacks"]).groups()
        for number, legs in zip(numbers, ("mirrored", "free")):
            self.assertAlmostEqual(float(number), 100 * pieces[legs]["strain_p95"], 2)
        self.assertNotIn("leave a strain", pieces["free"]["fallbacks"])

    def test_a_result_is_sewn_into_its_folder(self):
        self.run_well("a.obj", "--unit", "cm", "-o", "out")
        pieces = self.report("out")["pieces"]
        self.run_well("sew", "out", "--once")
        report = self.report("out")
        self.assertEqual(report["pieces"], pieces)
        self.run_well("sew", "a.obj", "--unit", "cm", "--once", "-o", "two")
        for mine, other in zip(report["resewn"], self.report("two")["resewn"]):
            self.assertEqual(mine, other)
        self.assertEqual(self.read("out/sewn.vtp"), self.read("two/sewn.vtp"))

    def test_proposals_are_curves_to_flatten_with(self):
        self.run_well("cut", "a.obj", "--kind", "darts", "--max-strain", "4%", "--effort", "quick", "-o", "cuts.vtp")
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.obj", "a.txt", "cuts.vtp"])
        report = self.flatten("flatten", "a.obj", "cuts.vtp", "--unit", "cm")
        self.assertTrue(report["curves"])
        self.assertEqual({curve["type"] for curve in report["curves"]} - {"accessory"}, {"dart"})

    def test_a_moved_surface_is_flattened(self):
        self.run_well("reshape", "a.obj", "--max-strain", "3%", "-o", "moved.vtp")
        report = self.flatten("moved.vtp", "--unit", "cm")
        self.assertLess(report["pieces"][0]["strain_p95"], 0.031)

    def test_sizes_are_named_with_their_surfaces(self):
        self.write_lune(22)
        run = self.run_well("grade", "M=a.obj", "L=lune.obj", "a.txt", "--unit", "cm", "-o", "nest.svg", "-o", "rules.csv")
        self.assertIn("written: nest.svg, rules.csv", run.stdout)
        self.run_well("grade", "S=a.obj", "M=lune.obj", "--base", "M", "--unit", "cm")
        self.assertIn("lune_nest.svg", os.listdir(self.folder))

    def test_a_batch_runs_a_command_on_each_surface(self):
        self.write("list.txt", "a.obj a.txt\n")
        self.run_well("batch", "list.txt", "-o", "out", "--unit", "cm", "pattern", "-o", "front.svg", "--allowance", "7")
        self.run_well("pattern", "a.obj", "a.txt", "--unit", "cm", "-o", "front.svg", "--allowance", "7")
        self.assertEqual(self.read("out/a/front.svg"), self.read("front.svg"))
        self.run_well("batch", "list.txt", "-o", "cuts", "cut", "--kind", "darts", "--effort", "quick")
        self.assertIn("curves.vtp", os.listdir(self.path("cuts/a")))

    def test_check_tells_size_unit_and_openings(self):
        self.assert_words(("20 x 20 x 40", "openings: 1", "--unit cm"), self.run_well("check", "a.obj").stdout)
        self.write("box.obj", command.obj(*command.TETRAHEDRON))
        run = self.run_command("check", "box.obj", code=4)
        self.assertIn("closed: it lies flat with seams alone", run.stdout)
        self.run_well("check", "a.obj", "--unit", "cm", "-o", "mended.vtp")
        self.assertEqual(self.flatten("mended.vtp")["unit_stated"], True)

    def test_check_tells_symmetry_and_what_is_of_this_size(self):
        # A tube of 38 x 26 x 60 cm, wider on one side of the plane x = 3 where it is not symmetric.
        for bulge, symmetry in ((1.0, "about the plane x=3, to less than 0.01 % of its size"), (1.7, "none is found")):
            def place(i, j):
                x, y = math.cos(math.pi * i / 12), math.sin(math.pi * i / 12)
                return 3 + 19 * x * (bulge if x > 0 else 1), (13 if y > 0 else 3) * y * (1 + 0.02 * j), 5 * j
            self.write("tube.obj", command.obj(*command.grid(24, 12, place, closed=True)))
            run = self.run_well("check", "tube.obj", "--unit", "cm")
            self.assertIn("symmetry: " + symmetry, run.stdout)
            self.assertIn("likely: a garment, by its size\nnext: wirewarp make tube.obj --unit cm --for garment\n", run.stdout)

    def test_what_check_names_next_reads_the_surface_alike(self):
        for words, following in ((("--unit", "cm"), "a.obj --unit cm"), (("--height", "12in"), "a.obj --height 304.8"),
                                 (("--scale", "1.5", "--unit", "mm", "--weld", "0.5"), "a.obj --weld 0.5 --scale 1.5 --unit mm"),
                                 (("--unit", "cm", "-o", "b.vtp"), "b.vtp")):
            run = self.run_command("check", "a.obj", *words)
            self.assertRegex(run.stdout, f"next: wirewarp make {re.escape(following)} --for [a-z]+\n")

    def test_check_scales_a_surface(self):
        for words, sides, unit in ((("--height", "300mm"), (150, 150, 300), "mm"),
                                   (("--height", "1.7m", "--unit", "cm"), (85, 85, 170), "cm"),
                                   (("--scale", "2.54", "--unit", "mm"), (50.8, 50.8, 101.6), "mm")):
            with self.subTest(words):
                run = self.run_well("check", "a.obj", *words, "-o", "b.vtp")
                self.assertIn(" x ".join("%.4g" % side for side in sides) + " " + unit, run.stdout)
                points = self.array("b.vtp", "Points")
                for k, side in enumerate(sides):
                    self.assertAlmostEqual(max(points[k::3]) - min(points[k::3]), side, delta=1e-9 * side)
                self.assertEqual(self.flatten("b.vtp", "--scheme", "global")["unit"], unit)

    def test_what_does_not_fit_the_command_is_bad_usage(self):
        self.run_well("a.obj", "-o", "out")
        for words, arguments in (
                ("see wirewarp pattern", "flatten a.obj -o a.pdf"), ("see wirewarp picture", "pattern a.obj -o a.png"),
                ("leave out --scheme", "pattern out --scheme global"), ("leave out 'a.txt'", "pattern out a.txt"),
                ("two folders", "pattern a.obj -o one -o two"), ("two sizes", "grade M=a.obj a.txt"),
                ("--roll-width is required", "nest out"), ("--allowance", "pattern out --allowance wide"),
                ("--scale", "check a.obj --scale 2 --height 3mm"), ("not a length", "check a.obj --height tall")):
            self.assert_stderr(words, *arguments.split(), code=2)

    def test_a_folder_without_a_result_is_refused(self):
        os.mkdir(self.path("empty"))
        self.assert_stderr("empty: holds no result", "pattern", "empty")
        self.run_well("a.obj", "-o", "out")
        self.write("out/report.json", "{}")
        self.assert_stderr("report.json: is not a report", "pattern", "out")


if __name__ == "__main__":
    command.main()
