# SPDX-License-Identifier: BSD-3-Clause
"""Patterns of GarmentCode read back: what was written comes back bit for bit, and panels of others are pieces
with the curves, seams and places in space that the rules of the format say."""

import copy
import functools
import json
import math
import operator
import os
import re
import unittest

import numpy as np
import surfaceflattening as sf

import pattern_files as pattern
from TestPatternGarmentCode import bezier, rotation

# A skirt of two panels with every kind of edge: the front runs counter-clockwise, the back clockwise, as
# files of GarmentCode have both. Waists are arcs of a circle, hems quadratic, sides cubic, and the back has
# a dart between its vertices 2, 3 and 4.
FRONT = {
    "translation": [1.0, 70.0, 25.0], "rotation": [0.0, 0.0, 10.0], "label": "leg",
    "vertices": [[-30.0, 0.0], [30.0, 0.0], [20.0, 55.0], [-20.0, 55.0]],
    "edges": [
        {"endpoints": [0, 1], "curvature": {"type": "quadratic", "params": [[0.5, -0.05]]}, "label": "hem"},
        {"endpoints": [1, 2], "curvature": {"type": "cubic", "params": [[0.3, -0.04], [0.7, -0.06]]}},
        {"endpoints": [2, 3], "curvature": {"type": "circle", "params": [60.0, False, False]}, "label": "waist"},
        {"endpoints": [3, 0], "curvature": {"type": "cubic", "params": [[0.3, -0.06], [0.7, -0.04]]}},
    ],
}
BACK = {
    "translation": [0.0, 70.0, -25.0], "rotation": [0.0, 180.0, 0.0],
    "vertices": [[-30.0, 0.0], [-20.0, 55.0], [-2.0, 55.0], [0.0, 43.0], [2.0, 55.0], [20.0, 55.0], [30.0, 0.0]],
    "edges": [
        {"endpoints": [0, 1], "curvature": {"type": "cubic", "params": [[0.3, 0.04], [0.7, 0.06]]}},
        {"endpoints": [1, 2]},
        {"endpoints": [2, 3]},
        {"endpoints": [3, 4]},
        {"endpoints": [4, 5]},
        {"endpoints": [5, 6], "curvature": {"type": "cubic", "params": [[0.3, 0.06], [0.7, 0.04]]}},
        {"endpoints": [6, 0], "curvature": {"type": "circle", "params": [200.0, 0, 1]}},
    ],
}


def side(panel, edge):
    return {"panel": panel, "edge": edge}


SKIRT = {
    "pattern": {
        "panels": {"front": FRONT, "back": BACK},
        "stitches": [[side("front", 1), side("back", 0)], [side("front", 3), side("back", 5), "right_wrong"],
                     [side("back", 2), side("back", 3)]],
    },
    "parameters": {"length": {"value": 55}},
    "parameter_order": ["length"],
    "properties": {"curvature_coords": "relative", "units_in_meter": 100},
}


def edge_length(panel, edge):
    shape = edge.get("curvature", {"type": "straight"})
    if shape["type"] == "circle":  # by the rules of SVG: radius, larger arc, direction
        radius, large, _ = shape["params"]
        angle = 2 * math.asin(math.dist(*(panel["vertices"][k] for k in edge["endpoints"])) / 2 / radius)
        return radius * (2 * math.pi - angle if large else angle)
    if shape["type"] == "quadratic":
        # The same curve as a cubic one.
        (x, y), = shape["params"]
        edge = {**edge, "curvature": {"type": "cubic", "params": [
            [2 / 3 * x, 2 / 3 * y], [1 / 3 + 2 / 3 * x, 2 / 3 * y]]}}
    return pattern.bezier_length(bezier(panel, edge))


class Reading(pattern.PatternTest):
    def load(self, document):
        return sf.read_garmentcode(self.path(self.write("read.json", json.dumps(document))))

    def again(self, garment):
        garment.write_pattern(self.path("again.json"))
        return self.read("again.json")

    def wire(self, garment, name, number=0):
        return [wire for wire in garment.wires if wire.name == name][number]

    def test_what_was_written_comes_back_bit_for_bit(self):
        for piece, options in (("tshirt", ()), ("tshirt", ("--smooth", "1.0")), ("shirt_front", ()),
                               ("shirt_front", ("--smooth", "0.5"))):
            with self.subTest(piece=piece, options=options):
                self.make(piece, "-o", "out/pattern.json", *options)
                garment = sf.read_garmentcode(self.path("out", "pattern.json"))
                self.assertEqual(self.again(garment), self.read("out", "pattern.json"))

    def drawn(self, garment, **options):
        """The sew lines of its SVG, as their paths say."""
        garment.write_pattern(self.path("again.svg"), **options)
        root = pattern.svg_root(self.path("again.svg"))
        return [element.get("d") for _, element in pattern.svg_elements(root, "sew-line")]

    def test_panels_keep_their_chords_unless_smoothness_is_asked_for(self):
        garment = self.load(SKIRT)
        usual = self.drawn(garment)
        self.assertEqual(usual, self.drawn(garment, fair=0.0))
        self.assertFalse(any("C" in path for path in usual))
        corners = sum(len(re.findall("[ML]", path)) for path in usual)
        self.assertGreater(corners, len(garment.positions) // 2)
        smooth = self.drawn(garment, fair=0.2)
        self.assertTrue(any("C" in path for path in smooth))
        self.assertLess(4 * sum(len(re.findall("[MLC]", path)) for path in smooth), corners)
        hem = self.drawn(garment, curve_fairs={"hem": 0.2})
        self.assertEqual(sum("C" in path for path in hem), 1)
        self.assertEqual(hem, self.drawn(garment, fair=0.0, curve_fairs={"hem": 0.2}))

    def test_panels_of_others_are_written_with_the_edges_and_stitches_that_were_read(self):
        written = json.loads(self.again(self.load(SKIRT)))["pattern"]
        wanted = copy.deepcopy(SKIRT["pattern"])
        for panel in wanted["panels"].values():
            for edge in panel["edges"]:
                if edge.get("curvature", {}).get("type") == "circle":
                    edge["curvature"]["params"][1:] = map(bool, edge["curvature"]["params"][1:])
        self.assertEqual(written["panels"], wanted["panels"])
        self.assertEqual(written["stitches"], wanted["stitches"])
        self.assertEqual(written["panel_order"], ["front", "back"])

    def test_curved_edges_have_their_lengths_and_chords_near_them(self):
        garment = self.load(SKIRT)
        names = {("front", 0): ("hem", 0), ("front", 1): ("stitch 1", 0), ("front", 2): ("waist", 0),
                 ("front", 3): ("stitch 2", 0), ("back", 0): ("stitch 1", 1), ("back", 5): ("stitch 2", 1),
                 ("back", 2): ("stitch 3", 0)}
        for (name, number), key in names.items():
            panel = SKIRT["pattern"]["panels"][name]
            wanted = edge_length(panel, panel["edges"][number])
            wire = self.wire(garment, *key)
            self.assertLess(abs(wire.flat_length - wanted), 1e-3 + 1e-5 * wanted, key)
            self.assertLessEqual(wire.flat_length, wanted + 1e-9)  # of chords
        # The waist goes left and turns right, so that its centre is above it.
        points = garment.positions[self.wire(garment, "waist").vertices]
        centre = np.array([0.0, 55.0 + math.sqrt(60.0**2 - 20.0**2)])
        self.assertLess(np.max(np.abs(np.linalg.norm(points - centre, axis=1) - 60.0)), 1e-9)
        middles = (points[1:] + points[:-1]) / 2
        self.assertLess(np.max(60.0 - np.linalg.norm(middles - centre, axis=1)), 0.002)

    def test_stitched_edges_have_as_many_points_at_even_lengths(self):
        garment = self.load(SKIRT)
        for name in ("stitch 1", "stitch 2", "stitch 3"):
            sides = [garment.positions[self.wire(garment, name, k).vertices] for k in (0, 1)]
            self.assertEqual(*map(len, sides))
            for points in sides:
                steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
                self.assertLess(np.ptp(steps), 1e-4 * steps.mean())
        pairs = garment.seam_pairs
        self.assertEqual(len(pairs), sum(len(self.wire(garment, f"stitch {k}").vertices) - 1 for k in (1, 2, 3)))
        # Start to end, but start to start where the file says so.
        front, back = FRONT["vertices"], BACK["vertices"]
        ends = {tuple(np.round(garment.positions[a], 9)): tuple(np.round(garment.positions[c], 9))
                for a, _, c, _, curve in pairs if curve < 2}
        ends.update({tuple(np.round(garment.positions[b], 9)): tuple(np.round(garment.positions[d], 9))
                     for _, b, _, d, curve in pairs if curve < 2})
        self.assertEqual(ends[tuple(front[1])], tuple(back[1]))
        self.assertEqual(ends[tuple(front[2])], tuple(back[0]))
        self.assertEqual(ends[tuple(front[3])], tuple(back[5]))
        self.assertEqual(ends[tuple(front[0])], tuple(back[6]))

    def test_edges_that_meet_in_a_point_and_are_sewn_are_a_dart(self):
        garment = self.load(SKIRT)
        kinds = {wire.name: wire.type for wire in garment.wires}
        self.assertEqual(kinds, {"hem": "accessory", "stitch 1": "seam", "waist": "accessory", "stitch 2": "seam",
                                 "stitch 3": "dart", "boundary": "boundary"})

    def test_pieces_fill_their_borders_and_are_placed_in_space(self):
        garment = self.load(SKIRT)
        for number, panel in enumerate((FRONT, BACK)):
            mine = garment.triangles[garment.piece_ids == number]
            a, b, c = (garment.positions[mine[:, k]] for k in range(3))
            areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
            self.assertGreater(areas.min(), 0.0)
            border = []
            for edge in garment.panels[number].edges:
                wire = next(w for w in garment.wires if w.piece == number and {
                    tuple(garment.panels[number].vertices[end]) for end in edge.ends} <= {
                    tuple(garment.positions[v]) for v in w.vertices})
                ids = list(wire.vertices)
                points = [tuple(garment.positions[v]) for v in ids]
                first, last = (points.index(tuple(garment.panels[number].vertices[end])) for end in edge.ends)
                border += points[first:last] if first < last else points[first:last:-1]
            ring = np.array(border)
            after = np.roll(ring, -1, axis=0)
            whole = abs(np.sum(ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0])) / 2
            self.assertAlmostEqual(areas.sum(), whole, delta=1e-9 * whole)
            ids = np.unique(mine)
            flat = np.column_stack([garment.positions[ids], np.zeros(len(ids))])
            placed = flat @ rotation(panel["rotation"]).T + panel["translation"]
            self.assertLess(np.abs(garment.points[ids] - placed).max(), 1e-12)

    def test_lengths_are_those_of_the_panel_in_space_and_in_the_plane(self):
        garment = self.load(SKIRT)
        for wire in garment.wires:
            space, plane = (np.linalg.norm(np.diff(points[wire.vertices], axis=0), axis=1)
                            for points in (garment.points, garment.positions))
            self.assertAlmostEqual(wire.rest_length, space.sum(), delta=1e-12 * space.sum())
            self.assertAlmostEqual(wire.flat_length, plane.sum(), delta=1e-12 * plane.sum())
            self.assertAlmostEqual(wire.length_error, np.max(np.abs(plane / space - 1.0)), delta=1e-13)

    def test_a_file_in_another_unit_with_control_points_of_the_panel_is_the_same(self):
        millimetres = copy.deepcopy(SKIRT)
        millimetres["properties"] = {"curvature_coords": "absolute", "units_in_meter": 1000}
        for panel in millimetres["pattern"]["panels"].values():
            panel["vertices"] = [[10 * x, 10 * y] for x, y in panel["vertices"]]
            panel["translation"] = [10 * x for x in panel["translation"]]
            for edge in panel["edges"]:
                shape = edge.get("curvature", {"type": "straight"})
                if shape["type"] == "circle":
                    shape["params"][0] *= 10
                elif shape["type"] != "straight":
                    start, end = (np.array(panel["vertices"][k]) for k in edge["endpoints"])
                    left = np.array([start[1] - end[1], end[0] - start[0]])
                    shape["params"] = [list(start + x * (end - start) + y * left) for x, y in shape["params"]]
        one, other = self.load(SKIRT), self.load(millimetres)
        self.assertEqual(one.positions.shape, other.positions.shape)
        self.assertLess(np.abs(one.positions - other.positions).max(), 1e-9)
        self.assertLess(np.abs(one.points - other.points).max(), 1e-9)
        old = copy.deepcopy(SKIRT)
        hem = old["pattern"]["panels"]["front"]["edges"][0]
        hem["curvature"] = hem["curvature"]["params"][0]  # as files had it before there were others
        self.assertTrue((self.load(old).positions == one.positions).all())

    def test_panels_are_drawn_at_true_scale_with_their_names(self):
        garment = self.load(SKIRT)
        garment.write_pattern(self.path("skirt.dxf"), allowance=12.0, curve_allowances={"hem": 40.0})
        document, complaints = pattern.read_dxf(self.path("skirt.dxf"))
        self.assertEqual(complaints, [])
        blocks = [block for block in document.blocks if block.name[0] not in "*$"]
        self.assertEqual(sorted(block.name for block in blocks), ["BACK", "FRONT"])
        front = next(block for block in blocks if block.name == "FRONT")
        total = sum(sum(pattern.edge_lengths(points, closed))
                    for points, closed in pattern.block_lines(front, "14", "8"))
        wanted = 10 * sum(edge_length(FRONT, edge) for edge in FRONT["edges"])
        self.assertAlmostEqual(total, wanted, delta=0.05)
        for name in ("skirt.svg", "skirt.pdf", "skirt.plt", "walk.csv"):
            garment.write_pattern(self.path(name))
            self.assertGreater(os.path.getsize(self.path(name)), 100)

    def test_what_cannot_be_is_refused_by_panel_and_edge(self):
        def changed(*path, value):
            document = copy.deepcopy(SKIRT)
            functools.reduce(operator.getitem, path[:-1], document)[path[-1]] = value
            return document

        front = ("pattern", "panels", "front")
        named = changed(*front, "edges", 2, "endpoints", value=[2, 9])
        named["pattern"]["panels"]["a\0b"] = named["pattern"]["panels"].pop("front")
        cases = (
            (changed(*front, "edges", 1, "endpoints", value=[1, 3]), ["edge 1", "front", "ring"]),
            (changed(*front, "edges", 2, "endpoints", value=[2, 9]), ["edge 2", "front", "vertex 9"]),
            (changed(*front, "vertices", 1, value=[-30.0, 0.0]), ["edge 0", "front", "no length"]),
            (changed(*front, "vertices", 2, value=[0.0, -20.0]), ["front", "crosses"]),
            (changed(*front, "edges", 2, "curvature", "params", value=[19.0, False, False]),
             ["edge 2", "front", "19", "40"]),
            (changed(*front, "edges", 2, "curvature", "type", value="ellipse"), ["edge 2", "front", "circle"]),
            (changed(*front, "edges", 1, "curvature", "params", value=[[0.3, 0.1]]), ["edge 1", "front", "2"]),
            (changed(*front, "vertices", 0, value=[0.0, "a"]), ["vertex 0", "front"]),
            (changed("pattern", "stitches", 0, value=[side("front", 7), side("back", 0)]), ["stitch 0", "front", "4"]),
            (changed("pattern", "stitches", 0, value=[side("sleeve", 1), side("back", 0)]), ["stitch 0", "sleeve"]),
            (changed("pattern", "stitches", 1, value=[side("front", 1), side("back", 5)]),
             ["edge 1", "front", "more than one"]),
            ({"pattern": {"panels": {}, "stitches": []}}, ["no panel"]),
            (changed("properties", "units_in_meter", value=0), ["units_in_meter"]),
            ({"pattern": {}}, ["panels"]),
            ([], ["pattern"]),
            (named, ["a\0b", "ends at the vertex 9"]),
        )
        for document, words in cases:
            self.assert_raises(ValueError, words, self.load, document)
        self.assert_raises(FileNotFoundError, "none.json", sf.read_garmentcode, self.path("none.json"))
        self.write("cut.json", json.dumps(SKIRT, indent=1)[:500])
        self.assert_raises(ValueError, "not JSON at line", sf.read_garmentcode, self.path("cut.json"))
        self.assert_raises(TypeError, "unit", self.load(SKIRT).write_pattern, self.path("a.svg"), unit="mm")

    def test_the_reader_gives_empty_outputs_after_a_refusal(self):
        reader = sf.vtkGarmentCodeReader()
        reader.AddObserver("ErrorEvent", lambda *_: None)
        for name in (None, ""):
            reader.SetFileName(name)
            reader.Update()
            self.assertEqual(reader.GetErrorMessage(), "there is no file name; give FileName")
        self.load(SKIRT)
        reader.SetFileName(self.path("read.json"))
        reader.Update()
        self.assertEqual((reader.GetStatusName(), reader.GetErrorMessage()), ("Ok", ""))
        self.assertEqual(reader.CanReadFile(self.path("read.json")), 1)
        self.write("report.json", '{"status": "Ok"}')
        self.assertEqual(reader.CanReadFile(self.path("report.json")), 0)
        reader.SetFileName(self.path("report.json"))
        reader.Update()
        self.assertEqual(reader.GetStatusName(), "InvalidPattern")
        for port in range(3):
            self.assertEqual(reader.GetOutput(port).GetNumberOfPoints(), 0)
        reader.Modified()
        self.assertEqual(reader.GetExecutive().Update(), 0)  # filters behind it do not run
        self.assertNotEqual(reader.GetErrorCode(), 0)


if __name__ == "__main__":
    unittest.main()
