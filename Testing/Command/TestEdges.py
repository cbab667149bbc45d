# SPDX-License-Identifier: BSD-3-Clause
"""Edges with names, eased seams, and what patterns make of them, through the command."""
import math
import os

import command

SIZE = 8
at = command.grid_ids(SIZE)


def sheet(height):
    """A sheet of 800 mm x 800 mm, bulged by a height."""
    return command.grid(
        SIZE, SIZE, lambda i, j: (100.0 * i, 100.0 * j,
                                  height * math.sin(math.pi * i / SIZE) * math.sin(math.pi * j / SIZE)),
        other=lambda i, j: i >= SIZE // 2)


class Edges(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("flat.obj", command.obj(*sheet(0.0)))
        self.write("bulged.obj", command.obj(*sheet(150.0)))

    def curves(self, text):
        return self.write("curves.txt", text)

    def test_an_edge_goes_the_shorter_way_along_the_boundary(self):
        for word, corners, wanted in (("edge", ((1, 0), (6, 0)), 500), ("EDGE", ((6, 0), (0, 3)), 900),
                                      ("edge", ((1, 0), (8, 4), (2, 8)), 2100), ("edge", ((3, 0), (3, 0)), 3200)):
            text = f"{word} hem {' '.join(str(at(*corner)) for corner in corners)}\n"
            self.assertAlmostEqual(self.flatten("flat.obj", self.curves(text))["curves"][0]["length_3d"], wanted)

    def test_an_edge_of_a_table_goes_the_same_way(self):
        points, _ = sheet(0.0)
        for corners, wanted in ((((1, 0), (8, 4), (2, 8)), 2100.0), (((3, 0), (3, 0)), 3200.0)):
            rows = [points[at(*corner)] for corner in corners]
            for text in ("name,type,x,y,z\n" + "".join("hem,Edge,%.7g,%.7g,%.7g\n" % row for row in rows),
                         "z;y;x;name\n" + "".join("%.7g;%.7g;%.7g;edge hem\n" % row[::-1] for row in rows)):
                self.write("hem.csv", text)
                curve, = self.flatten("flat.obj", "hem.csv", "--unit", "mm")["curves"]
                self.assertEqual((curve["name"], curve["type"]), ("hem", "accessory"))
                self.assertAlmostEqual(curve["length_3d"], wanted, delta=1e-9 * wanted)
        for name, text, words in (
            ("off.csv", "hem,edge,0,0,0\nhem,edge,400,10,0\n", ("off.csv:3:", "is 10 off", f"vertex {at(4, 0)}")),
            ("far.csv", "hem,edge,0,0,0\nhem,edge,800,800,0\n\n", ("far.csv:4:", "one length")),
        ):
            self.write(name, "name,type,x,y,z\n" + text)
            self.assert_stderr((*words, "'hem'"), "flat.obj", name, "--output", "none")

    def test_points_of_an_edge_lie_on_the_boundary_whatever_the_format(self):
        for places, wanted in (((101, 2, 0, 598, -3, 1), 500.0), ((140, 0, 0, 560, 0, 0), 500.0), ((60, 0, 0, 640, 0, 0), 500.0),
                               ((400, 20, 0, 0, 0, 0), "20 off the boundary"), ((0, 0, 0, 300, 300, 0), "300 off the boundary")):
            ends = [",".join(map(str, places[k:k + 3])) for k in (0, 3)]
            for name, text in (("hem.txt", "edge hem " + " ".join(ends) + "\n"),
                               ("hem.csv", "name,type,x,y,z\n" + "".join(f"hem,edge,{end}\n" for end in ends))):
                self.write(name, text)
                if isinstance(wanted, float):
                    curve, = self.flatten("flat.obj", name, "--unit", "mm")["curves"]
                    self.assertAlmostEqual(curve["length_3d"], wanted, delta=1e-9 * wanted)
                    continue
                self.assert_stderr((name + ":", "edge 'hem'", wanted), "flat.obj", name, "--output", "none")

    def test_names_of_curves_in_text_may_be_in_quotes(self):
        names = ['"left # hem"', '"centre ""front"" x"', "it's\"here\""]
        text = (f'edge {names[0]} {at(1, 0)} {at(6, 0)} # "a" remark\n'
                f"key {names[1]} {at(4, 0)} {at(4, 4)}\naccessory {names[2]} {at(2, 2)} {at(2, 4)}\n")
        report = self.flatten("flat.obj", self.curves(text))
        self.assertEqual([(curve["name"], curve["type"]) for curve in report["curves"]],
                         [("left # hem", "accessory"), ('centre "front" x', "key"), ("it's\"here\"", "accessory")])
        for text, word in ((f'key "centre front {at(4, 0)} {at(4, 4)}\n', "quotes"),
                           (f'key "" {at(4, 0)} {at(4, 4)}\n', "no name")):
            self.assert_stderr(("curves.txt:1: ", word), "flat.obj", self.curves(text), "--output", "none")

    def test_an_edge_that_cannot_be_is_refused_by_line_and_name(self):
        for text, *words in ((f"edge hem {at(3, 3)} {at(3, 0)}\n", str(at(3, 3)), "not on the boundary"),
                             (f"edge hem {at(0, 0)} {at(8, 8)}\n", "one length", "between"),
                             (f"edge hem {at(0, 0)}\n", "two vertices")):
            run = self.assert_stderr(("curves.txt:2:", "'hem'", *words), "flat.obj", self.curves("# edges\n" + text),
                                     "-o", "none")
            self.assertEqual(run.stdout, "")

    def walk(self):
        """The rows, the lengths of the first piece and of the second, and whether the first one is a: 1 or -1."""
        rows = self.table("out/walk.csv")
        self.assertGreater(len(rows), 5)
        for row in rows:
            longer = 1 if row["piece_a"].endswith(" 1") else -1
            yield row, [float(row["length_a_mm"]), float(row["length_b_mm"])][::longer], longer

    def test_the_walk_of_an_eased_seam_tells_the_ease_of_every_interval(self):
        seam = self.curves("seam side " + " ".join(str(at(4, j)) for j in range(SIZE + 1)) + "\n")
        words = ("--unit", "mm", "-o", "out/walk.csv", "--notch-spacing", "100", "--tolerance", "side=0.05")
        self.flatten("pattern", "bulged.obj", seam, *words, "--ease", "side:1=+3%")
        for row, lengths, longer in self.walk():
            self.assertAlmostEqual(lengths[0] / lengths[1], 1.03, places=6)
            self.assertAlmostEqual(lengths[1], float(row["to_mm"]) - float(row["from_mm"]), places=4)
            self.assertAlmostEqual(float(row["ease_percent"]), 3.0 if longer > 0 else 100 / 1.03 - 100, places=3)

    def test_a_file_of_curves_brings_its_eases(self):
        points, _ = sheet(150.0)

        def ease(fraction, piece):
            fields = (("CurveType", "int", 3), ("LengthTolerance", "double", 0.05), ("LengthEase", "double", fraction),
                      ("EasedPiece", "int", piece))
            return self.write("eased.vtk", command.legacy(points, polylines=[[at(4, j) for j in range(SIZE + 1)]], cell_data=(
                "CELL_DATA 1\nFIELD FieldData 4\n" + "".join(f"{name} 1 1 {kind}\n{value}\n" for name, kind, value in fields))))

        words = ("--unit", "mm", "-o", "out/walk.csv", "--notch-spacing", "100")
        self.flatten("pattern", "bulged.obj", ease(0.03, 0), *words)
        for _, lengths, _ in self.walk():
            self.assertAlmostEqual(lengths[0] / lengths[1], 1.03, places=6)
        self.flatten("pattern", "bulged.obj", ease(0.03, 0), *words, "--ease", "curve 0:1=-2%")  # in its place
        for _, lengths, _ in self.walk():
            self.assertAlmostEqual(lengths[0] / lengths[1], 0.98, places=6)
        for fraction, piece, says in ((0.06, 0, ["6 %", "5 %"]), (0.03, 2, ["piece 3"]), (0.03, -1, ["1, 2"]),
                                      (1.0, 0, ["LengthEase", "(-1, 1)"]), (0.03, -2, ["EasedPiece"])):
            self.assert_stderr(says, "pattern", "bulged.obj", ease(fraction, piece), *words, "--output", "none")

    def test_an_ease_that_cannot_be_is_refused(self):
        seam = self.curves("seam side " + " ".join(str(at(4, j)) for j in range(SIZE + 1)) + "\n")
        for ease, code, says in (("side:1=3%", 3, ["side", "3 %", "tolerance"]), ("side:1=3", 2, ["--ease", "PERCENT%"]),
                                 ("side:0=3%", 2, ["--ease", "from 1"])):
            self.assert_stderr(says, "bulged.obj", seam, "--ease", ease, "--output", "none", code=code)

    def test_a_fold_along_a_curve_about_which_its_piece_is_not_symmetric_leaves_no_pattern(self):
        beside = "straight beside " + " ".join(str(at(3, j)) for j in range(SIZE + 1)) + "\n"
        self.assert_stderr(("front", "beside", "symmetric", "200 mm"), "pattern", "flat.obj", self.curves(beside), "--unit", "mm",
                           "-o", "none/pattern.dxf", "--piece", "front", "--fold", "beside")
        self.assertEqual(os.listdir(self.path("none")), [])


command.main()
