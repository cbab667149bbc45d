# SPDX-License-Identifier: BSD-3-Clause
"""Curves of every kind through the command: elastic ones, those to release, seams, darts, loose wires."""
import csv
import math

import command
import ezdxf

SIZE = 8
at = command.grid_ids(SIZE)


def dome():
    """A dome of SIZE x SIZE squares, whose cuts gape everywhere."""
    return command.grid(
        SIZE, SIZE, lambda i, j: (i / SIZE, j / SIZE, -0.4 * ((i / SIZE - 0.5) ** 2 + (j / SIZE - 0.5) ** 2)),
        other=lambda i, j: (i + j) % 2 == 1)


def chain(*places):
    return " ".join(str(at(i, j)) for i, j in places)


class Curves(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune()
        meridian = [0] + [5 * j - 2 for j in range(1, 8)] + [36]
        self.write("two.txt", self.read("arc.txt") + "accessory meridian " + " ".join(map(str, meridian)) + "\n")

    def test_a_number_where_the_name_should_be_is_told(self):
        self.write("forgotten.txt", self.read("arc.txt").replace("arc ", ""))
        self.assert_stderr("which is not one of its vertices; if it should be, put a name before it", "lune.obj", "forgotten.txt",
                           "--output", "out", code=0)

    def tube(self, height=2.0):
        """A tube of radius 1, from z = 0 to a height, wider at its upper end."""
        self.write("tube.obj", command.obj(*command.tube(16, 8, lambda j: (1 + 0.05 * j, height * j / 8))))

    def lengths(self, text):
        """Lengths on the surface of the curves of a text file, by their names."""
        report = self.flatten("tube.obj", self.write("words.txt", text), "--unit", "cm")
        self.assertLess(report["curve_distance_mm"], 1e-6)
        lengths = {}
        for curve in report["curves"]:
            lengths.setdefault(curve["name"], []).append(curve["length_3d"])
        return lengths

    def test_planes_boundaries_and_points_are_curves_of_their_lengths(self):
        side, rim, half = math.hypot(2.0, 0.4), 32 * math.sin(math.pi / 16), "seam side plane y=0 x>0\n"
        for height, text, wanted in (
                (2, "seam side plane y=0\n", {"side": 2 * side}), (2, half, {"side": side}),
                (2, half + "edge top opening 1\nedge hem opening 2\naccessory line -1,0,0 -1.2,0,1\n",
                 {"side": side, "top": 1.4 * rim, "hem": rim, "line": math.hypot(1.0, 0.2)}),
                (4, half + "edge neck boundary top\nedge hem boundary bottom\naccessory same boundary hem\n",
                 {"side": math.hypot(4.0, 0.4), "neck": 1.4 * rim, "hem": rim, "same": rim}),
                # The shortest way between two of them.
                (4, "seam side between boundary top and boundary bottom\n", {"side": math.hypot(4.0, 0.4)}),
                *((2, f'edge hem opening 2\nedge "the top" opening 1\nseam side between {ends}\n',
                   {"hem": rim, "the top": 1.4 * rim, "side": side})
                  for ends in ("opening 1 and hem", "opening 2 and opening 1", 'hem and "the top"'))):
            with self.subTest(text):
                self.tube(height)
                lengths = self.lengths(text)
                self.assertEqual(set(lengths), set(wanted))
                for name, length in wanted.items():
                    self.assertAlmostEqual(sum(lengths[name]), length, delta=1e-9)
        self.tube()
        lengths = self.lengths(half + "edge hem opening 2\naccessory waist plane z=0.9\naccessory line between waist and hem\n")
        self.assertAlmostEqual(sum(lengths["line"]), side * 0.45, delta=1e-9)
        # The waist is a polygon of 16 corners and of points on the diagonals of its quads.
        around = 2 * math.pi * (1 + 0.05 * 0.9 / 0.25)
        self.assertTrue(0.98 * around < sum(lengths["waist"]) < around, lengths)
        listed = self.run_command("check", "tube.obj", "--unit", "cm").stdout.replace("-0,", "0,")
        self.assert_words(("openings: 2", "opening 1: %.4g cm long, around 0, 0, 2" % (1.4 * rim)), listed)

    def test_a_table_names_planes_and_openings_too(self):
        self.tube()
        rows = (("side", "seam", "plane y=0 x>0"), ("top", "edge", "opening 1"), ("the hem", "edge", "opening 2"))
        text = "".join('%s "%s" %s\n' % (kind, name, form) for name, kind, form in rows)
        self.write("words.csv", "name,type,x,y,z\n" + "".join('%s,%s,"%s",,\n' % row for row in rows) +
                   "line,accessory,-1,0,0\nline,,-1.2,0,1\n")
        wanted = self.lengths(text + "accessory line -1,0,0 -1.2,0,1\n")
        report = self.flatten("tube.obj", "words.csv", "--unit", "cm")
        self.assertEqual({curve["name"] for curve in report["curves"]}, {"side", "top", "the hem", "line"})
        for curve in report["curves"]:
            self.assertTrue(any(abs(curve["length_3d"] - length) < 1e-9 for length in wanted[curve["name"]]), curve)

    def test_what_a_line_of_words_lacks_is_told(self):
        self.tube()
        for text, words in (("seam side plane w=0", "write plane x=NUMBER"), ("seam side plane x=0 y=1", "write plane x=NUMBER"),
                            ("seam side plane x=9", "does not meet the surface"),
                            ("edge hem opening 3", "N from 1 to 2"), ("edge hem opening", "N from 1 to 2"),
                            ("edge hem boundary waist", "name of a curve above"),
                            ("edge hem plane z=0", "lies along the boundary"),
                            ("seam side between hem and top", "names of curves above this line"),
                            ("seam side between opening 1 opening 2", "write between A and B"),
                            ("seam side between opening 1 and opening 1", "both meet"),
                            ("accessory line 1,0 2,0,0", "is not a point")):
            with self.subTest(text):
                self.assert_stderr(words, "tube.obj", self.write("words.txt", text + "\n"), "--unit", "cm", "-o", "out")

    def arc_rows(self):
        """Points of the arc of arc.txt."""
        return [self.points[int(word)] for word in self.read("arc.txt").split()[2:]]

    def assert_same_as_text(self, report, type_, name):
        self.write("text.txt", f"{type_} {name} " + self.read("arc.txt").split(maxsplit=2)[2])
        expected = self.flatten("lune.obj", "text.txt")
        self.assertEqual([(curve["name"], curve["type"]) for curve in report["curves"]],
                         [(curve["name"], curve["type"]) for curve in expected["curves"]])
        self.assertAlmostEqual(report["curves"][0]["length_3d"], expected["curves"][0]["length_3d"],
                               delta=1e-9)
        self.assertAlmostEqual(report["pieces"][0]["E_area"], expected["pieces"][0]["E_area"], delta=1e-6)

    def test_a_pattern_says_that_its_grainline_does_not_follow_a_bent_key(self):
        self.write("dome.obj", command.obj(*dome()))
        line = chain(*((i, 1 + (i > 3)) for i in range(SIZE + 1)))
        said = {}
        for kind in ("key", "straight"):
            self.write("fold.txt", f"{kind} fold {line}\n")
            run = self.run_command("pattern", "dome.obj", "fold.txt", "-o", "a.svg", "--unit", "m", code=(0, 4))
            said[kind] = [row for row in run.stderr.splitlines() if "grainline" in row]
        self.assertEqual((len(said["key"]), said["straight"]), (1, []))
        self.assert_words(("fold", "mm", "straight NAME"), said["key"][0])

    def test_a_pattern_says_of_all_darts_in_one_sentence_how_far_their_legs_miss_each_other(self):
        run = self.run_command("pattern", *command.data_files("pants_back"), "-o", "a.svg", "--unit", "cm", "--dart-legs",
                               "free", code=(0, 4))
        said, = [row for row in run.stderr.splitlines() if "miss each other" in row]
        for dart in ("waist_dart_inner", "waist_dart_outer"):
            self.assertEqual(said.count(dart), 1, said)

    def test_lines_of_an_obj_file_are_curves_named_by_their_group(self):
        ids = [int(word) + 1 for word in self.read("arc.txt").split()[2:]]
        lines = "".join(f"l {a} {b}\n" for a, b in zip(ids, ids[1:]))
        self.write("own.obj", command.obj(self.points, self.triangles) + "g key-arc\n" + lines)
        self.assert_same_as_text(self.flatten("own.obj"), "key", "arc")
        rows = self.arc_rows()
        self.write("curves.obj", "o Key arc\n" + "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in rows)
                   + "l " + " ".join(str(k + 1) for k in range(len(rows))) + "\n")
        self.assert_same_as_text(self.flatten("lune.obj", "curves.obj"), "key", "arc")

    def test_edges_without_a_face_in_the_object_of_the_faces_are_no_curves(self):
        surface = "o lune\n" + command.obj(self.points, self.triangles)
        count = len(self.points)
        loose = f"v 0 0 9\nv 0 1 9\nl {count + 1} {count + 2}\nl 1 {count + 1}\n"
        self.write("loose.obj", surface + loose)
        report = self.flatten("loose.obj")
        self.assertEqual(report["curves"], [])
        note = f"2 edges without a face are left out, the first at line {(surface + loose).count(chr(10)) - 1}"
        self.assert_words((note,), report["warnings"][0])
        self.assert_stderr(note, "check", "loose.obj", code=0)
        # What has a name of its own, or ends at corners of faces, is a curve.
        ids = [int(word) + 1 for word in self.read("arc.txt").split()[2:]]
        lines = "".join(f"l {a} {b}\n" for a, b in zip(ids, ids[1:]))
        self.write("both.obj", surface + loose + "g key-arc\n" + lines)
        self.assert_same_as_text(self.flatten("both.obj"), "key", "arc")

    def test_rows_of_a_csv_table_are_points_of_curves(self):
        rows = self.arc_rows()

        def table(form, head="name;x;y;z\r\n", some=rows):
            return head + "".join(form.format(*map(repr, row)) for row in some)

        semicolons = table("key arc;{};{};{}\r\n")
        for name, text in (
            ("a.csv", table("{},{},{},arc,key\n", "x,y,z,Name,Type\n")), ("b.csv", semicolons),
            # As tables are written where the decimal sign is a comma.
            ("h.csv", semicolons.replace(".", ",")),
            # No column of types: what stands behind the last one named is none.
            ("n.csv", table("key arc,{},{},{},dart\n", "name,x,y,z\n")),
        ):
            self.assert_same_as_text(self.flatten("lune.obj", self.write(name, text)), "key", "arc")
        self.write("o.csv", table("{},{},{},key arc\\\n", "x,y,z,name\n"))
        self.assert_same_as_text(self.flatten("lune.obj", "o.csv"), "key", "arc\\")
        # An empty row, as tables have it, begins another curve of the same name.
        self.write("i.csv", table("arc,{},{},{}\n", "name,x,y,z\n", rows[:2]) + table("arc,{},{},{}\n", ",,,\n", rows[2:4]))
        self.assertEqual([curve["name"] for curve in self.flatten("lune.obj", "i.csv")["curves"]
                          if curve["name"] == "arc"], ["arc", "arc"])
        # Fields in quotes hold dividers and quotes; a type may stand in the first row of a curve alone.
        for name, divider, quoting in (("j.csv", ",", csv.QUOTE_MINIMAL), ("k.csv", ";", csv.QUOTE_ALL),
                                       ("l.csv", "\t", csv.QUOTE_MINIMAL)):
            with open(self.path(name), "w", encoding="utf-8", newline="") as file:
                csv.writer(file, delimiter=divider, quoting=quoting).writerows([["x", "z", "name", "type", "y"]] + [
                    [repr(x), repr(z), 'side, "left"; low', "" if k else "Key", repr(y)] for k, (x, y, z) in enumerate(rows)])
            curves = self.flatten("lune.obj", name)["curves"]
            self.assertEqual([(curve["name"], curve["type"]) for curve in curves], [('side, "left"; low', "key")])
        for name, text, part in (("m.csv", 'name,type,x,y,z\n"open,key,0,0,0\n', "m.csv:2: a field in quotes"),
                                 ("c.csv", "x,y,z\n0,0,0\n", "'name'"),
                                 ("d.csv", "name,x,y,z\na,0,0\n", "coordinate"),
                                 ("e.csv", "name,type,x,y,z\na,hem,0,0,0\n", "'hem'"),
                                 ("f.csv", "name,x,y,z\na,0,0,0\n", "one point"),
                                 ("g.csv", "name,x,y,z\n", "no curve")):
            self.assert_stderr(part, "lune.obj", self.write(name, text))

    def test_polylines_of_a_dxf_file_are_curves_named_by_their_layer(self):
        rows = self.arc_rows()
        document = ezdxf.new("R2010")
        document.layers.add("key arc")
        document.modelspace().add_polyline3d(rows, dxfattribs={"layer": "key arc"})
        document.modelspace().add_text("not a curve")
        document.saveas(self.path("a.dxf"))
        self.assert_same_as_text(self.flatten("lune.obj", "a.dxf"), "key", "arc")
        document = ezdxf.new("R12")
        for a, b in zip(rows, rows[1:]):
            document.modelspace().add_line(a, b, dxfattribs={"layer": "KEY_arc"})
        document.saveas(self.path("b.dxf"))
        self.assert_same_as_text(self.flatten("lune.obj", "b.dxf"), "key", "arc")
        # A flat sheet at z = 1 takes a light polyline, which has one elevation, closed.
        self.write("flat.obj", command.obj(*command.grid(4, 4, lambda i, j: (i, j, 1.0))))
        document = ezdxf.new("R2010")
        document.modelspace().add_lwpolyline([(1, 1), (3, 1), (3, 3), (1, 3)], close=True,
                                             dxfattribs={"elevation": 1.0, "layer": "pocket"})
        document.saveas(self.path("c.dxf"))
        curve = self.flatten("flat.obj", "c.dxf")["curves"][0]
        self.assertEqual((curve["name"], curve["type"]), ("pocket", "accessory"))
        self.assertAlmostEqual(curve["length_3d"], 8.0, delta=1e-12)
        self.assert_stderr("group code", "lune.obj", self.write("text.dxf", "name,x\n1,2\n"))

    def sheet_of(self, size, elevation=0.0):
        """A flat sheet of 20 x 20 squares from -size to size."""
        self.write("sheet.obj", command.obj(*command.grid(20, 20, lambda i, j: (
            size * (i / 10 - 1), size * (j / 10 - 1), elevation))))

    def drawn_lengths(self, document):
        """Lengths in space of the curves of a drawing, by their names; the parts of one add up."""
        document.saveas(self.path("drawn.dxf"))
        run = self.run_command("sheet.obj", "drawn.dxf", "--unit", "mm", "--output", "out", code=(0, 4))
        self.assertNotIn("drawn.dxf", run.stderr)
        lengths = {}
        for curve in self.report("out")["curves"]:
            lengths[curve["name"]] = lengths.get(curve["name"], 0.0) + curve["length_3d"]
        return lengths

    def test_bulges_arcs_circles_and_ellipses_of_a_dxf_file_have_their_lengths(self):
        def ellipse(a, b, angle, steps=20000):
            return sum(math.hypot(a * math.sin(t), b * math.cos(t)) for t in
                       ((k + 0.5) * angle / steps for k in range(steps))) * angle / steps

        def bulged(bulge):
            return 0.3 * 4 * math.atan(bulge) * (1 + bulge**2) / (4 * bulge)

        for release, size, elevation in (("R2000", 400.0, 0.0), ("R2018", 0.4, 0.1)):
            self.sheet_of(size, elevation)
            document = ezdxf.new(release)
            space = document.modelspace()
            for name, bulge, y in (("half", 1.0, 0.0), ("flat", -0.1, -0.6), ("most", 2.0, 0.3)):
                space.add_lwpolyline([(-0.2 * size, y * size, bulge), (0.1 * size, y * size, 0.0)], format="xyb",
                                     dxfattribs={"layer": name, "elevation": elevation})
            space.add_circle((0.5 * size, 0.5 * size, elevation), 0.25 * size, dxfattribs={"layer": "circle"})
            space.add_arc((-0.6 * size, 0.6 * size, elevation), 0.2 * size, 300, 120, dxfattribs={"layer": "key arc"})
            space.add_ellipse((0.5 * size, -0.5 * size, elevation), (0.1 * size, 0.3 * size, 0), 0.4,
                              dxfattribs={"layer": "ellipse"})
            space.add_ellipse((-0.5 * size, -0.95 * size, elevation), (0.3 * size, 0, 0), 0.5, 0.0, math.pi,
                              dxfattribs={"layer": "half ellipse"})
            lengths = self.drawn_lengths(document)
            axis = math.hypot(0.1, 0.3)
            for name, wanted in (("half", bulged(1.0)), ("flat", bulged(0.1)), ("most", bulged(2.0)),
                                 ("circle", 0.5 * math.pi), ("arc", 0.2 * math.pi),
                                 ("half ellipse", ellipse(0.3, 0.15, math.pi)),
                                 ("ellipse", ellipse(axis, 0.4 * axis, 2 * math.pi))):
                with self.subTest(release=release, curve=name):
                    self.assertAlmostEqual(lengths[name] / size, wanted, delta=1e-3 * wanted)

    def test_bulges_of_polylines_of_old_releases_are_arcs(self):
        self.sheet_of(400.0, 25.0)
        document = ezdxf.new("R12")
        document.modelspace().add_polyline2d([(-200, 0, 1.0), (200, 0, 1.0)], format="xyb", close=True,
                                             dxfattribs={"layer": "ring", "elevation": (0, 0, 25)})
        self.assertAlmostEqual(self.drawn_lengths(document)["ring"], 400 * math.pi, delta=1.0)

    def test_splines_of_a_dxf_file_follow_their_control_points_knots_and_weights(self):
        self.sheet_of(400.0)
        document = ezdxf.new("R2010")
        space = document.modelspace()
        # A quarter of a circle is a rational spline of degree 2.
        space.add_rational_spline([(200, 0, 0), (200, 200, 0), (0, 200, 0)], [1, math.sqrt(0.5), 1], degree=2,
                                  dxfattribs={"layer": "quarter"})
        # A straight line at uneven speed.
        space.add_open_spline([(-300, -300, 0), (-200, -300, 0), (50, -300, 0), (300, -300, 0)],
                              dxfattribs={"layer": "key line"})
        control = [(-300, 100, 0), (-250, 300, 0), (-100, 350, 0), (-50, 150, 0), (-150, 50, 0), (-200, 250, 0)]
        wave = space.add_open_spline(control, degree=3, dxfattribs={"layer": "wave"})
        lengths = self.drawn_lengths(document)
        self.assertAlmostEqual(lengths["quarter"], 100 * math.pi, delta=0.3)
        self.assertAlmostEqual(lengths["line"], 600.0, delta=1e-6)
        places = list(wave.construction_tool().approximate(5000))
        wanted = sum(a.distance(b) for a, b in zip(places, places[1:]))
        self.assertAlmostEqual(lengths["wave"], wanted, delta=1e-3 * wanted)

    def test_entities_whose_plane_looks_down_are_mirrored_as_their_extrusion_says(self):
        self.sheet_of(400.0, -30.0)
        down = {"extrusion": (0, 0, -1)}
        document = ezdxf.new("R2010")
        space = document.modelspace()
        # In object coordinates x and z have the other sign.
        space.add_lwpolyline([(300, 100), (100, 100, 0, 0, 1.0), (100, 300)],
                             dxfattribs={"layer": "line", "elevation": 30, **down})
        space.add_circle((-200, 200, 30), 50, dxfattribs={"layer": "circle", **down})
        space.add_arc((200, -200, 30), 100, 0, 90, dxfattribs={"layer": "arc", **down})
        lengths = self.drawn_lengths(document)
        self.assertAlmostEqual(lengths["line"], 200 + 100 * math.pi, delta=0.4)
        self.assertAlmostEqual(lengths["circle"], 100 * math.pi, delta=0.4)
        self.assertAlmostEqual(lengths["arc"], 50 * math.pi, delta=0.2)
        points, wires = self.array("out/cut.vtp", "Points"), self.array("out/wires.vtp", "connectivity", "Lines")
        for x, y in ((-100, 200), (200, 200), (-200, -200)):  # in space
            near = [v for v in wires if math.dist((x, y), points[3 * v : 3 * v + 2]) < 101]
            self.assertGreater(len(near), 20, (x, y))

    def test_a_drawing_that_stands_on_edge_is_turned_into_space(self):
        self.write("sheet.obj", command.obj(*command.grid(10, 10, lambda i, j: (40.0 * i, -7.0, 40.0 * j))))
        document = ezdxf.new("R2010")
        circle = document.modelspace().add_circle((0, 0, 0), 100, dxfattribs={"layer": "ring", "extrusion": (0, -1, 0)})
        circle.dxf.center = circle.ocs().from_wcs((200, -7, 200))
        self.assertAlmostEqual(self.drawn_lengths(document)["ring"], 200 * math.pi, delta=0.6)

    def test_what_of_a_dxf_file_is_not_read_is_named_with_its_line_and_handle(self):
        self.sheet_of(400.0)
        document = ezdxf.new("R2010")
        space = document.modelspace()
        hem = space.add_lwpolyline([(-100, 0), (100, 0)], dxfattribs={"layer": "hem"})
        hatch = space.add_hatch()
        document.blocks.new("dart").add_circle((0, 0), 10)
        inserted = [space.add_blockref("dart", (k, 0)) for k in range(5)]
        space.add_text("C:\\texts that end in a backslash\\")
        document.saveas(self.path("some.dxf"))
        run = self.run_command("sheet.obj", "some.dxf", "--unit", "mm", "--output", "out")
        warning, = [line for line in run.stderr.splitlines() if "some.dxf" in line]
        lines = [line.strip() for line in self.read("some.dxf").splitlines()]
        entities = lines.index("ENTITIES")
        for entity in (hatch, inserted[0], inserted[2]):
            line = lines.index(entity.dxf.handle, entities) - 1
            self.assertEqual(lines[line - 1], entity.dxftype())
            self.assertIn(f"line {line}, handle {entity.dxf.handle}", warning)
            self.assertIn(entity.dxftype(), warning)
        self.assertIn("and 2 more", warning)
        self.assertNotIn("TEXT", warning)
        self.assertIn(warning.removeprefix("wirewarp: warning: "), self.report("out")["warnings"])
        space.delete_entity(hem)
        document.saveas(self.path("none.dxf"))
        self.assert_stderr("HATCH (line ", "sheet.obj", "none.dxf")

    def test_a_damaged_curve_of_a_dxf_file_is_refused_by_its_line(self):
        self.sheet_of(400.0)
        head = "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\nhem\n71\n3\n"
        for name, groups, part in (("a", "10\n0\n20\n0\n30\n0\n" * 4 + "40\n1\n" * 8, "knots"),
                                   ("b", "11\n0\n21\n0\n31\n0\n" * 4, "no control points"),
                                   ("c", "10\n0\n20\n0\n30\n0\n" * 3 + "40\n1\n" * 7, "3 control points"),
                                   ("d", "10\nnan\n", "'nan'")):
            with self.subTest(part):
                self.write(name + ".dxf", head + groups + "0\nENDSEC\n0\nEOF\n")
                self.assertRegex(self.assert_stderr(part, "sheet.obj", name + ".dxf").stderr, name + r"\.dxf:(6|12):")

    def test_a_tolerance_is_a_fraction(self):
        for text in ("arc=1", "arc=-0.1", "arc=nan", "arc=", "=0.1", "arc", "arc=2%"):
            with self.subTest(text):
                self.assert_stderr("NAME=FRACTION", "lune.obj", "arc.txt", "--tolerance", text, code=2)

    def test_the_curve_to_release_first_is_named_with_what_that_brings(self):
        # Fig. 14: without the meridian the quarter-sphere of Table 1 is left.
        run = self.run_command("lune.obj", "two.txt", "--output", "out", "--scheme", "global")
        self.assertIn("without the curve meridian the objective would fall from 3.148 to 0.1972", run.stdout)
        # The isometric scheme is judged by what it minimizes.
        run = self.run_command("lune.obj", "two.txt", "--output", "out")
        piece, = self.report("out")["pieces"]
        first = piece["release"]["ranking"][0]
        self.assertEqual((piece["release"]["first"], first["curve"]), ("meridian", "meridian"))
        self.assertIn(f"without the curve meridian E_area would fall from {piece['E_area']:.4g} to "
                      f"{first['E_area_without']:.4g}, E_h go from", run.stdout)
        # Following the advice gives what it says.
        followed = self.flatten("lune.obj", "arc.txt")["pieces"][0]
        self.assertAlmostEqual(first["E_area_without"], followed["E_area"], delta=1e-7)
        self.assertAlmostEqual(first["E_h_without"], followed["E_h"], delta=1e-7)
        self.assertLess(followed["E_area"], piece["E_area"])
        # A piece that lies well is left alone.
        self.assertNotIn("without the curve", self.run_command("lune.obj", "arc.txt").stdout)

    def test_the_walk_of_the_t_shirts_seams_adds_up_to_their_lengths_and_finds_no_difference(self):
        report = self.flatten("pattern", *command.data_files("tshirt"), "-o", "out/walk.csv", "--unit", "cm", "--name", "shirt")
        rows = self.table("out/walk.csv")
        walked = {}
        for row in rows:
            lengths = [float(row["length_a_mm"]), float(row["length_b_mm"])]
            self.assertAlmostEqual(*lengths, delta=2e-6)
            self.assertAlmostEqual(float(row["to_mm"]) - float(row["from_mm"]), lengths[0], delta=2e-6)
            self.assertLessEqual(lengths[0], 126.0, "one notch every 100 mm")
            walked[row["curve"]] = walked.get(row["curve"], 0.0) + lengths[0] / 10.0
        self.assertEqual(set(walked), {seam["curve"] for seam in report["seams"]})
        for seam in report["seams"]:
            self.assertAlmostEqual(walked[seam["curve"]], seam["lengths"][0], delta=1e-5)
        self.assertEqual({(row["piece_a"], row["piece_b"]) for row in rows if row["curve"] == "side_seam_left"},
                         {("shirt 1", "shirt 2")})

    def test_cuts_that_stop_an_edge_short_of_the_boundary_are_told_where_to_begin(self):
        self.write("dome.obj", command.obj(*dome()))
        self.write("short.txt", "dart left " + chain((4, 1), (4, 2), (4, 3)) + "\n")
        run = self.run_command("dome.obj", "short.txt", "--unit", "m", "--output", "out", code=0)
        warning = (f'dart "left" ends at point {at(4, 1)}, one edge inside the boundary, and does not open there; '
                   f"begin it at point {at(4, 0)}")
        self.assertIn("wirewarp: warning: " + warning, run.stderr.splitlines())
        self.assertEqual(self.report("out")["warnings"], [warning])
        self.write("seam.txt", "seam s " + chain(*((4, j) for j in range(1, SIZE + 1))) + "\n")
        self.assertEqual(self.flatten("dome.obj", "seam.txt", "--unit", "m")["warnings"], [
            f'seam "s" ends at point {at(4, 1)}, one edge inside the boundary, and divides nothing there; '
            f"begin it at point {at(4, 0)}"])


command.main()
