# SPDX-License-Identifier: BSD-3-Clause
"""Names of pieces and seams that the faces of an OBJ file bring with them."""
import math
import time
from xml.etree import ElementTree

import command


class SeamsFrom(command.CommandTest):
    def names(self, *arguments):
        self.run_command("pattern", *arguments, "--unit", "cm", "-o", "out/pattern.svg", "--smooth", "0",
                         "--output", "out", code=0)
        layers = [group.get(command.INKSCAPE + "label") for group in ElementTree.parse(self.path("out/pattern.svg")).getroot()]
        return [layer for layer in layers if layer and layer != "scale check"]

    def sheets(self, *heads):
        """Squares beside each other, each below its lines; several under one head are apart."""
        text, first = "# a file\n", 1
        for k, (head, count) in enumerate(heads):
            text += head
            for n in range(count):
                x, y = 20 * k, 20 * n
                text += "".join(f"v {x + a} {y + b} 0\n" for a, b in ((0, 0), (10 + k, 0), (10 + k, 4), (0, 4)))
                text += "f " + " ".join(str(first + c) for c in range(4)) + "\n"
                first += 4
        return self.write("sheets.obj", text)

    def test_objects_or_groups_give_pieces_their_names(self):
        for front, back in (("o Front\n", "o Back\n"), ("g Front\n", "g Back\r\n"), ("o A\ng Front\n", "g  Back \n"),
                            ("g left\no Front\n", "g right\no Back\n")):
            with self.subTest(front=front, back=back):
                self.assertEqual(self.names(self.sheets((front, 1), (back, 1))), ["Front", "Back"])
        self.assertEqual(self.names(self.sheets(("o Vorder ärmel\n", 2), ("o Back\n", 1), ("", 1))),
                         ["Vorder ärmel 1", "Vorder ärmel 2", "Back 1", "Back 2"])
        # One name tells nothing apart, and what is given goes before it.
        self.assertEqual(self.names(self.sheets(("o Cube.001\n", 2))), ["sheets 1", "sheets 2"])
        self.assertEqual(self.names(self.sheets(("o Front\n", 1), ("o Back\n", 1)), "--piece", "left"),
                         ["left", "Back"])
        # Files that are written keep the names, and the table and report.json tell them.
        for second in (("o Back\n", 1), ("o Back \u202e\x07part\n", 2)):
            run = self.run_command(self.sheets(("o Front\n", 1), second), "--output", "out", "--table")
            name = second[0][2:-1]
            wanted = ["Front"] + ([name] if second[1] == 1 else [name + " 1", name + " 2"])
            self.assertEqual([piece["name"] for piece in self.report("out")["pieces"]], wanted)
            rows = run.stdout.splitlines()[1:1 + len(wanted)]
            for row, text in zip(rows, ["1 Front ", "2 Back ", "3 Back "]):
                self.assertTrue(row.startswith(text), row)
            self.assertNotIn("\x07", run.stdout)
        self.flatten(self.sheets(("", 2)))
        self.assertEqual([piece["name"] for piece in self.report("out")["pieces"]], ["", ""])
        self.flatten(self.sheets(("o Front\n", 1), ("o Back\n", 1)))
        self.run_command("out/cut.vtp", "--output", "again")
        self.assertEqual(self.names("again/cut.vtp"), ["Front", "Back"])

    def patches(self, side, rows, kind, scale=1.0, doubled=False):
        """A bent sheet of rows x rows patches of side x side squares each, told apart by `kind`; `doubled`: each
        corner of a face has a texture of its own, many of them alike."""
        count = side * rows
        text = "".join(f"v {scale * math.sin(i / count)} {scale * j / count} {scale * math.cos(i / count)}\n"
                       for j in range(count + 1) for i in range(count + 1))
        textures, faces = {}, ""
        for patch in range(rows * rows):
            faces += {"uv": "", "material": f"usemtl m{patch}\n", "group": f"g patch {patch}\n"}[kind]
            shift = 2 * patch if kind == "uv" else 0
            for square in range(side * side):
                i = patch % rows * side + square % side
                j = patch // rows * side + square // side
                faces += "f"
                for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                    place = len(textures) if doubled else 0, f"vt {a / count + shift:.6f} {b / count:.6f}\n"
                    faces += f" {b * (count + 1) + a + 1}/{textures.setdefault(place, len(textures) + 1)}"
                faces += "\n"
        return self.write("patches.obj", text + "".join(line for _, line in textures) + faces)

    def test_each_patch_becomes_a_piece(self):
        for kind in ("uv", "material", "group"):
            for side, rows, scale, doubled in ((2, 2, 1.0, False), (3, 3, 1e-3, True), (1, 4, 5e3, False)):
                with self.subTest(kind=kind, side=side, rows=rows):
                    file = self.patches(side, rows, kind, scale, doubled)
                    self.assertEqual(len(self.flatten(file)["pieces"]), 1)
                    report = self.flatten(file, "--seams-from", kind.upper() if rows == 2 else kind)
                    self.assertEqual([piece["triangles"] for piece in report["pieces"]], [2 * side * side] * rows**2)
                    self.assertTrue(all(piece["E_len_max"] < 1e-9 for piece in report["pieces"]))
                    seams = [curve for curve in report["curves"] if curve["type"] == "seam"]
                    self.assertEqual(len({curve["name"] for curve in seams}), 2 * rows * (rows - 1))
                    self.assertTrue(all(curve["name"].startswith(kind + " seam ") for curve in seams))

    def test_curves_are_cut_as_well_and_points_may_be_doubled(self):
        self.write("dart.txt", "dart d 0 6\n")
        report = self.flatten(self.patches(2, 2, "uv"), "dart.txt", "--seams-from", "uv", "--weld")
        self.assertEqual(len(report["pieces"]), 4)
        self.assertIn("d", [curve["name"] for curve in report["curves"]])

    def test_many_seams_take_little_time(self):
        file = self.patches(5, 12, "uv")
        begin = time.monotonic()
        report = self.flatten(file, "--seams-from", "uv", "--scheme", "global")
        self.assertEqual(len(report["pieces"]), 144)
        # 1,320 edges of seams; far below a limit that an overloaded machine keeps as well.
        self.assertLess(time.monotonic() - begin, 60.0)

    def test_what_the_file_does_not_have_is_said(self):
        self.write("plain.obj", command.obj(*command.sheet()))
        self.write("sheet.stl", command.stl(*command.sheet()))
        for file in ("plain.obj", "sheet.stl"):
            for kind, word in (("uv", "texture coordinates"), ("material", "two materials"), ("group", "two groups")):
                self.assert_stderr((file, word), file, "--seams-from", kind)
        file = self.sheets(("o Front\n", 1), ("o Back\n", 1))
        run = self.run_command(file, "--seams-from", "group", "--output", "out")
        self.assertIn("found no edge to cut along", run.stderr)
        self.assertEqual(self.run_command("plain.obj", "--seams-from", "colour").returncode, 2)


command.main()
