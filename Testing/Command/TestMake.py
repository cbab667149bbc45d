# SPDX-License-Identifier: BSD-3-Clause
"""`wirewarp make`: from a surface to a pattern in one command."""

import math
import os
import pty
import re
import subprocess

import command


class Make(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune(20)
        self.write("box.obj", command.obj(*command.TETRAHEDRON))

    def make(self, *arguments, code=0):
        return self.run_command("make", *arguments, code=code)

    def layers(self, name):
        return set(re.findall(r"LAYER\r\n  5\r\n\w+\r\n  2\r\n(\w+)", self.read(name)))

    def test_it_says_in_five_lines_what_was_made(self):
        run = self.make("lune.obj", "--unit", "cm", "-o", "cap.pdf", "-o", "cap.vtp")
        lines = run.stdout.splitlines()
        self.assertEqual([line.split(":")[0] for line in lines], ["surface", "cuts", "pieces", "fit", "open"])
        self.assertIn("lune.obj, 20 x 20 x 40 cm", lines[0])
        self.assertRegex(lines[1], r"cuts: (\d+ (dart|seam)s?, )+[\d.]+ cm long in all")
        self.assertRegex(lines[2], r"pieces: \d+, the (size|longest) \d+ x \d+ cm")
        self.assertRegex(lines[3], r"fit: fits with a strain of [\d.]+ %, worst .*")
        self.assertIn("cap.pdf, cap.vtp; print at 100 %", lines[4])
        self.assertEqual(sorted(os.listdir(self.folder)), ["arc.txt", "box.obj", "cap.pdf", "cap.vtp", "lune.obj"])

    def test_a_closed_surface_of_no_size_becomes_pieces_of_foam(self):
        run = self.make("box.obj", "--for", "foam", "--height", "300mm", "-o", "box.dxf", "-o", "box.csv")
        self.assertIn("surface: box.obj, 300 x 300 x 300 mm", run.stdout)
        self.assertNotIn("unit", run.stderr)
        self.assertEqual(self.layers("box.dxf"), {"CUT", "MARK", "TEXT"})
        rows = [line.split(",") for line in self.read("box.csv").splitlines()][1:]
        self.assertTrue({"A", "B", "C"} <= {row[-2] for row in rows})
        for row in rows:
            self.assertAlmostEqual(float(row[7]), float(row[8]), delta=1e-6)
        bends = [float(row[-1]) for row in rows if row[-2]]
        # Between its upright faces 90 degrees, to the slanted one about 125.
        self.assertTrue(all(-1e-6 < bend < 125.3 for bend in bends), bends)
        self.assertGreater(max(bends), 80)
        # Three edges of a corner at least are cut to lay the tetrahedron flat.
        self.assertGreater(sum(float(row[7]) for row in rows), 900 - 1e-6)

    def test_each_kind_sets_what_is_not_given(self):
        for words, bound, material, layers in (
                ((), 0.05, None, "1"), (("--for", "tent"), 0.02, None, "1"),
                (("--for=sheet",), 0.01, "isotropic", "CUT"),
                (("--for", "sheet", "--max-strain", "3%", "--material=leather", "--style", "sewing"), 0.03, "leather", "1")):
            with self.subTest(words):
                # One short cut is not enough for any of them.
                run = self.make("lune.obj", "--unit", "cm", "-o", "out", "-o", "cap.dxf", *words, "--max-cuts", "1",
                                "--max-length", "1", code=4)
                self.assertIn(f"above the bound of {100 * bound:g} %", run.stderr)
                self.assertEqual(self.report("out")["material"], material)
                self.assertIn(layers, self.layers("cap.dxf"))

    def test_the_default_file_is_named_after_the_surface(self):
        run = self.make("lune.obj", "-q")
        self.assertEqual((run.stdout, run.stderr), ("", ""))
        self.assertTrue(os.path.exists(self.path("lune_pattern.pdf")))

    def test_a_bound_that_is_missed_is_said(self):
        run = self.make("lune.obj", "--unit", "cm", "--max-strain", "0.1%", "--max-cuts", "1", "-o", "a.svg", code=4)
        self.assertIn("does not fit: strain", run.stdout)
        self.assertIn("--max-cuts", run.stderr)
        self.assertNotIn("\x1b", run.stderr)  # no terminal, no color

    def test_templates_begin_with_seams_where_makers_place_them(self):
        """A tube is parted at its sides, a ball by planes through its axis."""
        self.write("tube.obj", command.obj(*command.tube(24, 6, lambda j: (20, 10 * j), deep=0.6)))
        run = self.make("tube.obj", "--unit", "cm", "--template", "front-back", "-o", "out")
        self.assertIn("cuts: none are needed", run.stdout)
        report = self.report("out")
        self.assertEqual(len(report["pieces"]), 2)
        self.assertEqual([curve["name"] for curve in report["curves"]], ["side", "side"])
        self.write("ball.obj", command.obj(*command.tube(16, 8, lambda j: (
            15 * math.sin(math.pi * (j + 1) / 10), 15 * math.cos(math.pi * (j + 1) / 10)))))
        self.make("ball.obj", "--unit", "cm", "--template", "gores", "--pieces", "7", "--max-strain", "50%",
                  "-o", "out")
        self.assertEqual(len(self.report("out")["pieces"]), 7)
        for words, wanted in (("--template strips", "--max-width"), ("--template sleeves", "sleeves"),
                              ("--for boat", "garment")):
            self.assert_stderr(wanted, "make", "ball.obj", *words.split(), code=2)
        self.write("belt.txt", "accessory belt plane z=0\n")
        self.assert_stderr("front-back, strips, foam-shell", "make", "ball.obj", "belt.txt", "--template", "gores")

    def test_side_seams_lie_alike_on_a_body_that_stands_askew(self):
        """Its front is wavy: seams further ahead on one side than on the other differ by 0.4 %."""
        cosine, sine = math.cos(0.14), math.sin(0.14)

        def place(i, j):
            x, y = math.cos(math.pi * i / 12), math.sin(math.pi * i / 12)
            x *= 20 * (1 + 0.3 * max(y, 0) * math.sin(j))
            return cosine * x - sine * 12 * y, sine * x + cosine * 12 * y, 10 * j

        self.write("tube.obj", command.obj(*command.grid(24, 6, place, closed=True)))
        self.make("tube.obj", "--unit", "cm", "--template", "front-back", "--max-strain", "90%", "-o", "out")
        left, right = (curve["length_3d"] for curve in self.report("out")["curves"])
        self.assertAlmostEqual(left / right, 1, delta=1e-4)

    def test_pages_are_counted_before_the_search(self):
        """A square of 100 m has an area of over 200 pages, however it is folded."""
        self.write("field.obj", command.obj(*command.grid(4, 4, lambda i, j: (25 * i, 25 * j, i * j))))
        run = self.make("field.obj", "--unit", "m", "-o", "a.pdf", code=3)
        self.assertRegex(run.stderr, r"at least \d+ pages A4, more than 200")
        self.assertIn("--paper", run.stderr)
        # As it was drawn: other files are not kept back.
        self.assert_stderr("would need about", "make", "field.obj", "--unit", "m", "-o", "a.svg", "-o", "b.pdf")
        self.assertTrue(os.path.exists(self.path("a.svg")))

    def test_a_shell_lies_within_the_stated_height_and_keeps_sharp_edges(self):
        """Planes of a block move inwards by 2.5 mm each; those of a wedge of 4 degrees meet 36 mm behind its edge."""
        block = [(x, y, z) for z in (0, 2) for y in (0, 3) for x in (0, 4)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.write("block.obj", command.obj(block, faces))
        for up, sizes in (((), "395 x 295 x 195"), (("--up", "x"), "295 x 220 x 145")):
            run = self.make("block.obj", "--height", "300mm", *up, "--template", "foam-shell", "-o", "a.svg")
            self.assertIn(f"block.obj, {sizes} mm", run.stdout)
        flat = [(x, y, z * (4 - x) / 28) for x, y, z in block]
        self.write("wedge.obj", command.obj([flat[k] for k in (0, 1, 2, 3, 4, 6)],
                                            [(0, 2, 3, 1), (4, 1, 3, 5), (0, 1, 4), (2, 5, 3), (0, 4, 5, 2)]))
        run = self.make("wedge.obj", "--height", "300mm", "--template", "foam-shell", "-o", "a.svg")
        self.assertGreater(int(re.search(r"wedge.obj, (\d+) x", run.stdout).group(1)), 391)

    def test_a_missed_bound_is_red_on_a_terminal_and_nowhere_else(self):
        arguments = [command.EXECUTABLE, "make", "lune.obj", "--unit", "cm", "--max-strain", "0.1%", "--max-cuts", "1",
                     "-o", "a.svg"]
        for colors, red in (({}, True), ({"NO_COLOR": "1"}, False)):
            try:
                ours, theirs = pty.openpty()
            except OSError as error:  # a root without /dev/pts
                self.skipTest(str(error))
            run = subprocess.run(arguments, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs, check=False,
                                 env={**os.environ, **colors}, timeout=120)
            os.close(theirs)
            text = b""
            try:
                while chunk := os.read(ours, 65536):
                    text += chunk
            except OSError:  # all is read
                pass
            os.close(ours)
            self.assertEqual(run.returncode, 4)
            self.assertEqual(re.search(rb"\x1b\[31m[^\x1b]*--max-cuts[^\x1b]*\x1b\[0m", text) is not None, red, text)

    def test_a_tent_is_drawn_on_one_sheet_with_the_grain_along_its_strips(self):
        """A sheet of 6 x 2.4 m that hangs a little, whose upright axis says nothing of its cloth."""
        self.write("tent.obj", command.obj(*command.grid(
            24, 12, lambda i, j: (0.25 * i, 0.2 * j, 0.1 * math.sin(math.pi * i / 24)))))
        run = self.make("tent.obj", "--unit", "m", "--for", "tent", "--template", "strips", "--max-width", "150cm",
                        "-o", "out", "-o", "tent.pdf", "-o", "tent.svg")
        self.assertIn("pieces: 2, the longest", run.stdout)
        grains = re.findall(r'class="grain".*?d="M([-\d.]+),([-\d.]+) L([-\d.]+),([-\d.]+)"',
                            self.read("tent.svg"), re.S)
        self.assertEqual(len(grains), 2)
        for x0, y0, x1, y1 in (map(float, grain) for grain in grains):
            self.assertAlmostEqual(x0, x1, delta=1e-6)
            self.assertGreater(abs(y1 - y0), 3000)  # along 6 m
        self.assertIn("tent.pdf", run.stdout)  # hundreds of A4 would be an error

    def test_strips_are_within_the_roll_with_their_allowances(self):
        """1.2 m of strips and twice 15 mm are more than 1.22 m, and 1.22 m is what is said in any unit."""
        self.write("tent.obj", command.obj(*command.grid(24, 12, lambda i, j: (0.25 * i, 0.2 * j, 0.0))))
        widths = (("1.25m", "1.5cm"), ("1.25", "15"), ("1250mm", "0.015m"), ("1.22m", "15mm"), ("122cm", "0"))
        pieces = []
        for width, allowance in widths:
            self.make("tent.obj", "--unit", "m", "--for", "tent", "--template", "strips", "--max-width", width,
                      "--allowance", allowance, "-o", "out", "-o", "a.svg")
            pieces.append(len(self.report("out")["pieces"]))
        self.assertEqual(pieces, [2, 2, 2, 3, 2])
        strips = ("make", "tent.obj", "--unit", "m", "--template", "strips")
        self.assert_stderr("'1furlong' is neither a length", *strips, "--max-width", "15", "--allowance", "1furlong", code=2)
        self.assert_stderr("both allowances", *strips, "--max-width", "2cm")

    def test_what_lies_over_itself_does_not_fit(self):
        """A ramp of 1.4 turns, which is strained by nothing."""
        self.write("ramp.obj", command.obj(*command.grid(60, 1, lambda i, j: (
            (1 + j) * math.cos(0.147 * i), (1 + j) * math.sin(0.147 * i), 0.03 * i))))
        run = self.run_command("flatten", "ramp.obj", "--unit", "m", "-o", "out", code=4)
        self.assertIn("does not fit: it lies over itself", run.stdout)
        self.assertNotIn("fits", run.stdout)


if __name__ == "__main__":
    command.main()
