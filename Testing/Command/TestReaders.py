# SPDX-License-Identifier: BSD-3-Clause
import itertools

import command


class Readers(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles, self.arc = command.quarter_sphere()
        self.write("arc.txt", "accessory arc " + " ".join(map(str, self.arc)) + "\n")

    def measures(self, *files):
        piece = self.flatten(*files)["pieces"][0]
        return [piece[key] for key in ("triangles", "vertices", "wire_patches", "objective", "E_ang")]

    def coordinates(self):
        return [x for point in self.points for x in point]

    def test_every_format_that_holds_doubles_gives_them_to_the_last_bit(self):
        files = {
            "a.obj": command.obj(self.points, self.triangles),
            "a.vtk": command.legacy(self.points, self.triangles),
            "a.vtp": command.xml_polydata(self.points, self.triangles),
            "ascii.ply": command.ply(self.points, self.triangles, ""),
            "little.ply": command.ply(self.points, self.triangles, "<"),
            "big.PLY": command.ply(self.points, self.triangles, ">"),
        }
        for name, content in files.items():
            with self.subTest(name):
                self.flatten(self.write(name, content))
                self.assertEqual(self.array("out/cut.vtp", "Points"), self.coordinates())

    def test_stl_is_read_in_its_single_precision_with_corners_joined(self):
        self.write("a.obj", command.obj(self.points, self.triangles))
        self.write("a.stl", command.stl(self.points, self.triangles))
        wanted = self.measures("a.obj")
        found = self.measures("a.stl")
        self.assertEqual(found[:3], wanted[:3])
        self.assertAlmostEqual(found[4], wanted[4], delta=1e-6)
        self.assertNotEqual(found[4], wanted[4])

    def test_strips_of_a_ply_are_triangles_all_of_one_side(self):
        points, _ = command.sheet(2, 2)
        # Two strips, of which the second is two that corners twice over join.
        strip = [0, 1, 3, 4, 6, 7, -1, 1, 2, 4, 5, 5, 4, 4, 5, 7, 8, -1, 0, 1]
        triangles = [(0, 1, 3), (3, 1, 4), (3, 4, 6), (6, 4, 7), (1, 2, 4), (4, 2, 5),
                     (4, 5, 7), (7, 5, 8)]
        self.write("plain.obj", command.obj(points, triangles))
        self.write("strips.ply", command.ply_strips(points, [strip], ""))
        self.write("lists.ply", command.ply_strips(points, [strip[:6], strip[7:17]], "<"))
        self.flatten("plain.obj")
        wanted = self.array("out/cut.vtp", "connectivity", "Polys")
        self.assertEqual(len(wanted), 3 * len(triangles))
        for name in ("strips.ply", "lists.ply"):
            self.flatten(name)
            self.assertEqual(self.array("out/cut.vtp", "connectivity", "Polys"), wanted)
        self.write("bad.ply", command.ply_strips(points, [[0, 1, -2]], ""))
        run = self.run_command("bad.ply", "--output", "out")
        self.assertEqual(run.returncode, 3)
        self.assertIn("strip 0", command.error_lines(run)[0])

    def test_texture_seams_of_an_obj_split_nothing(self):
        text = "".join("v %r %r %r\n" % point for point in self.points)
        number = itertools.count(1)
        for triangle in self.triangles:
            text += "vt 0.5 0.5\n" * 3 + "vn 0 0 1\n"
            text += "f " + " ".join("%d/%d/1" % (v + 1, next(number)) for v in triangle) + "\n"
        self.write("seams.obj", text)
        self.write("plain.obj", command.obj(self.points, self.triangles))
        self.assertEqual(self.measures("seams.obj", "arc.txt"), self.measures("plain.obj", "arc.txt"))

    def test_obj_takes_backward_ids_normals_colours_continued_lines_and_windows_line_ends(self):
        text = "# comment\r\nmtllib x.mtl\r\no piece\r\n"
        text += "".join("v %r %r %r 0.1 0.2 0.3\r\n" % point for point in self.points)
        count = len(self.points)
        for a, b, c in self.triangles:
            text += "f %d//1 \\\r\n %d//1 %d//1\r\n" % (a - count, b - count, c - count)
        self.write("odd.obj", text)
        self.write("plain.obj", command.obj(self.points, self.triangles))
        self.assertEqual(self.measures("odd.obj"), self.measures("plain.obj"))

    def test_a_byte_order_mark_before_the_text_is_no_part_of_it(self):
        plain = command.obj(self.points, self.triangles)
        arc = "accessory arc " + " ".join(map(str, self.arc)) + "\n"
        self.write("plain.obj", plain)
        self.write("marked.obj", "\ufeff" + plain)
        self.write("marked.txt", "\ufeff" + arc)
        self.assertEqual(
            self.measures("marked.obj", "marked.txt"), self.measures("plain.obj", "arc.txt"))

    def test_lines_of_an_obj_are_feature_curves(self):
        lines = "l " + " ".join(str(v + 1) for v in self.arc) + "\n"
        self.write("lines.obj", command.obj(self.points, self.triangles) + lines)
        self.write("plain.obj", command.obj(self.points, self.triangles))
        self.assertEqual(self.measures("lines.obj"), self.measures("plain.obj", "arc.txt"))
        self.assertEqual(self.report("out")["pieces"][0]["wire_patches"], 2)

    def test_polygons_are_triangulated(self):
        points, triangles = command.sheet()
        squares = [(a[0], a[1], a[2], b[2]) for a, b in zip(triangles[::2], triangles[1::2])]
        self.write("squares.obj", command.obj(points, squares))
        piece = self.flatten("squares.obj")["pieces"][0]
        self.assertEqual(piece["triangles"], 2 * len(squares))

    def test_text_curves_and_polydata_curves_give_the_same_result(self):
        self.write("a.obj", command.obj(self.points, self.triangles))
        self.write("keys.txt", "key arc %s # the middle\n" % " ".join(map(str, self.arc)))
        self.write("keys.vtk", command.legacy_curves(self.points, [(1, "arc", self.arc)]))
        results = []
        for curves in ("keys.txt", "keys.vtk"):
            report = self.flatten("a.obj", curves)
            results.append((report["pieces"], report["curves"], self.array("out/flat.vtp", "Points")))
        self.assertEqual(results[0], results[1])
        self.assertEqual([c["name"] for c in results[0][1]], ["arc"])
        self.assertEqual([c["type"] for c in results[0][1]], ["key"])

    def test_several_curve_files_add_up(self):
        self.write("a.obj", command.obj(self.points, self.triangles))
        self.write("long.txt", "accessory long 0 3 8 13 18 23 28 33 36\n")
        report = self.flatten("a.obj", "arc.txt", "long.txt")
        self.assertEqual([curve["name"] for curve in report["curves"]], ["arc", "long"])
        self.assertEqual(report["pieces"][0]["wire_patches"], 4)

    def test_dart_and_seam_in_text_open_and_divide(self):
        points, triangles = command.sheet()
        self.write("a.obj", command.obj(points, triangles))
        self.write("dart.txt", "dart d 2 7 12\n")
        self.write("seam.txt", "seam s 2 7 12 17 22\n")
        opened = self.flatten("a.obj", "dart.txt")["pieces"]
        self.assertEqual([piece["vertices"] for piece in opened], [27])
        divided = self.flatten("a.obj", "seam.txt")["pieces"]
        self.assertEqual([piece["vertices"] for piece in divided], [15, 15])


if __name__ == "__main__":
    command.main()
