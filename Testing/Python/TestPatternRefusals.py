# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be a pattern is refused with a message, and nothing half-written is left."""

import os
import re
import unittest

from ezdxf.lldxf.encoding import decode_dxf_unicode

import pattern_files as pattern
from pattern_files import command

# Quotes, tags, an entity, accents, right to left, an astral letter, control characters, a CJK name.
NAMES = (
    "a <b> & 'c' \"d\"",
    "]]> &amp; --",
    "Größe Ärmel çà",
    "שלום",
    "𝔘 plane",
    "tab\tline\nend",
    "裤子",
    "x" * 400,
    "%s %d {}",
)


class Refusals(pattern.PatternTest):
    def arguments(self, *options):
        return ("pattern", *command.data_files("quarter_sphere"), "--output", "out", *options)

    def test_absurd_scales_are_refused_in_no_time(self):
        for paper in ("A4", "A0", "sheet"):
            self.assert_stderr("wirewarp: error: ", *self.arguments(
                "-o", "out/pattern.pdf", "--unit", "m", "--paper", paper, "--allowance", "1e6"))
            self.assertFalse([name for name in os.listdir(self.path("out"))
                              if "pattern" in name or name.endswith(".part")])

    def write_plate(self, unit):
        """A plate of 100 x 80 mm with a fish-eye dart and a hole's curve in its middle."""
        side = 10 / pattern.MILLIMETRES[unit]
        return (self.write("plate.obj", command.obj(*command.grid(10, 8, lambda i, j: (side * i, side * j, 0.0)))),
                self.write("fish.txt", "dart fish " + " ".join(str(44 + i) for i in range(3, 8)) + "\n"))

    def test_formats_that_fail_leave_the_others_and_are_named(self):
        every = [word for name in ("pattern.svg", "pattern.dxf", "pattern.plt", "walk.csv") for word in ("-o", "out/" + name)]
        pdf = ("-o", "out/pattern.pdf", "--max-pages", "1")
        for unit in ("mm", "cm", "inch"):
            plate = self.write_plate(unit)
            for asked, failed, words in (
                    (("-o", "out/pattern.json"), {"pattern.json"}, "hole"),
                    ((*pdf, "--paper", "A4", "--quantity", "3"), set(), ""),
                    ((*pdf, "--allowance", "200"), {"pattern.pdf"}, "pages"),
                    ((*pdf, "--paper", "sheet", "--allowance", "3000"), {"pattern.pdf"}, "5.08 m")):
                with self.subTest(unit=unit, asked=asked):
                    run = self.run_command("pattern", *plate, *every, *asked, "--unit", unit, "--output", "out",
                                           code=3 if failed else 0)
                    report = self.report("out")
                    self.assertEqual((report["exit_code"], report["status"]), (run.returncode, "Ok"))
                    errors = [line for line in run.stderr.splitlines() if line.startswith("wirewarp: error: ")]
                    self.assertEqual(errors, ["wirewarp: error: " + text for text in report["unwritten"]])
                    self.assertEqual({name for name in os.listdir(self.path("out")) if name in " ".join(errors)}, set())
                    for name in failed:
                        self.assertEqual(sum(os.path.join("out", name) in error for error in errors), 1)
                    self.assertIn(words, "\n".join(errors))
                    wanted = {"flat.vtp", "wires.vtp", "cut.vtp", "report.json",
                              "pattern.svg", "pattern.dxf", "pattern.plt", "walk.csv"}
                    if "out/pattern.pdf" in asked:
                        wanted.add("pattern.pdf")
                    self.assertEqual(set(os.listdir(self.path("out"))), wanted - failed)

    def test_in_a_batch_a_format_that_fails_leaves_the_others(self):
        plate = self.write_plate("mm")
        self.write("list.txt", " ".join(plate) + "\nplate.obj\n")
        run = self.run_command("batch", "list.txt", "--unit", "mm", "--output", "out", "pattern", "-o", "pattern.svg", "-o",
                               "pattern.json", code=3)
        self.assertEqual(run.stderr.count("wirewarp: error: "), 1)
        rows = self.report("out", "batch.json")["surfaces"]
        self.assertEqual([row["exit_code"] for row in rows], [3, 0])
        self.assertEqual([len(row["unwritten"]) for row in rows], [1, 0])
        for folder, json_there in (("plate", False), ("plate_2", True)):
            files = os.listdir(self.path("out", folder))
            self.assertIn("pattern.svg", files)
            self.assertEqual("pattern.json" in files, json_there)

    def test_allowances_that_meet_across_a_gap_are_told_and_both_loops_drawn(self):
        corners = ((0, 0), (100, 0), (100, 45), (80, 45), (80, 20), (20, 20), (20, 80), (80, 80), (80, 55), (100, 55),
                   (100, 100), (0, 100))
        faces = ((1, 2, 3), (1, 3, 4), (0, 1, 4), (0, 4, 5), (11, 0, 5), (11, 5, 6), (11, 6, 7), (7, 8, 9), (7, 9, 10),
                 (7, 10, 11))
        for unit in ("mm", "cm", "m"):
            for allowance, met in (("4.9", False), ("5.1", True), ("6", True), ("40", True), ("0", False)):
                with self.subTest(unit=unit, allowance=allowance):
                    size = pattern.MILLIMETRES[unit]
                    self.write("c.obj", command.obj([(x / size, y / size, 0.0) for x, y in corners], faces))
                    run = self.run_command("pattern", "c.obj", "-o", "out/pattern.svg", "-o", "out/pattern.dxf", "--unit", unit,
                                           "--allowance", allowance, "-o", "out", code=0)
                    self.assertEqual("allowances meet" in run.stderr, met, run.stderr)
                    holes = len(pattern.svg_paths(self.svg(), "cut-out"))
                    self.assertEqual(holes, 1 if met and allowance != "40" else 0)
                    _, (block,) = self.dxf()
                    self.assertEqual(len(pattern.block_lines(block, "11")), holes)

    def test_a_pattern_never_replaces_what_keeps_a_result(self):
        surface = self.arguments()[1]
        self.run_command(surface, "--unit", "cm", "-o", "out")
        kept = self.report("out")
        for source, words, says in ((["out"], ["-o", "out/report.json"], "is an input"),
                                    ([surface], ["-o", "other", "-o", "./other/report.json"], "is a file of the result itself")):
            self.assert_stderr("report.json: " + says, "pattern", *source, *words, "--unit", "cm")
        self.assertEqual(self.report("out"), kept)
        self.assertFalse(os.path.exists(self.path("other")))

    def test_a_pattern_of_an_earlier_run_does_not_survive_a_new_flattening(self):
        surface = self.arguments()[1]
        self.run_command(surface, "--unit", "cm", "-o", "out")
        flattened = set(os.listdir(self.path("out")))
        drawn = {"pattern.svg", "pattern.dxf", "pattern.plt", "pattern.json", "walk.csv"}
        self.run_command("pattern", "out", *(word for name in drawn for word in ("-o", os.path.join("out", name))))
        self.assertEqual(set(os.listdir(self.path("out"))) - flattened, drawn)
        self.run_command("pattern", surface, "-o", "out", "-o", "out/pattern.pdf", "--unit", "cm")
        self.assertEqual(set(os.listdir(self.path("out"))) - flattened, {"pattern.pdf"})

    def test_names_of_any_characters_survive_in_every_format(self):
        for name in NAMES:
            with self.subTest(name):
                self.run_command(*self.arguments(
                    "-o", "out/pattern.svg", "-o", "out/pattern.pdf", "-o", "out/pattern.dxf", "--unit", "m", "--paper", "A0",
                    "--name", name, "--size", name, "--piece", name), code=0)
                shown = name.replace("\t", " ").replace("\n", " ")
                root = self.svg()
                self.assertEqual(pattern.pieces_of(root)[0].get("data-name"), shown)
                self.assertEqual(root.find(pattern.SVG + "title").text, shown)
                self.assertLess(max(self.content("pattern.dxf")), 128)
                _, (block,) = self.dxf()
                said = [decode_dxf_unicode(text.dxf.text) for text in block.query("TEXT")]
                wanted = "Piece Name: " + "".join(c if ord(c) < 0x10000 else "?" for c in shown)
                # Texts of DXF end at 250 characters.
                self.assertIn(wanted[:250], [text[:250] for text in said])
                pdf = self.path("out", "pattern.pdf")
                information = pattern.run_tool("pdfinfo", "-enc", "UTF-8", pdf).decode()
                self.assertEqual(re.search("^Title: +(.*)$", information, re.M)[1], shown)
                # What is drawn may be too long for its line, and goes from left to right in any script.
                drawn = pattern.run_tool("pdftotext", "-enc", "UTF-8", pdf, "-").decode()
                word = shown[:60] if shown.isascii() else shown.split()[0]
                self.assertTrue(word in drawn or word[::-1] in drawn, drawn)

    def test_bytes_that_are_no_text_are_replaced_in_every_format(self):
        self.write("curves.txt", b"seam \xc4rmel 16 17 18 19 20\n")
        run = self.run_command(
            "pattern", os.path.join(pattern.DATA, "quarter_sphere.vtp"), "curves.txt", "-o", "out", "-o", "out/pattern.svg",
            "-o", "out/pattern.pdf", "-o", "out/pattern.dxf", "--unit", "m", "--paper", "A0", "--allowance", "10", "--name",
            b"caf\xe9 \xff\xc3".decode("utf-8", "surrogateescape"))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        root = self.svg()
        self.assertEqual(root.find(pattern.SVG + "title").text, "caf\ufffd \ufffd\ufffd")
        self.assertIn("\ufffdrmel", {element.get("data-curve") for element in root.iter()})
        # The name of a curve is turned, and read in parts.
        self.assertIn("\n\ufffd\n", pattern.run_tool("pdftotext", self.path("out", "pattern.pdf"), "-").decode())


if __name__ == "__main__":
    unittest.main()
