# SPDX-License-Identifier: BSD-3-Clause
"""Patterns as GarmentCode's JSON, read by the rules of its format: edges in the frames of their chords,
rotations about axes that stay, stitches of edges with equal lengths."""

import json
import math
import unittest

import numpy as np

import pattern_files as pattern
from pattern_files import command


def bezier(panel, edge):
    """Four control points of an edge."""
    start, end = (np.array(panel["vertices"][k]) for k in edge["endpoints"])
    if "curvature" not in edge:
        return np.array([start, start + (end - start) / 3, end - (end - start) / 3, end])
    assert edge["curvature"]["type"] == "cubic"
    chord = end - start
    left = np.array([-chord[1], chord[0]])
    return np.array([start, *(start + x * chord + y * left for x, y in edge["curvature"]["params"]), end])


def rotation(degrees):
    x, y, z = np.radians(degrees)
    about_x = np.array([[1, 0, 0], [0, math.cos(x), -math.sin(x)], [0, math.sin(x), math.cos(x)]])
    about_y = np.array([[math.cos(y), 0, math.sin(y)], [0, 1, 0], [-math.sin(y), 0, math.cos(y)]])
    about_z = np.array([[math.cos(z), -math.sin(z), 0], [math.sin(z), math.cos(z), 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


class GarmentCode(pattern.PatternTest):
    def document(self):
        return json.loads(self.content("pattern.json"))

    def check(self, tolerance):
        document = self.document()
        self.assertEqual(document["properties"]["units_in_meter"], 100)
        self.assertEqual(document["properties"]["curvature_coords"], "relative")
        panels = document["pattern"]["panels"]
        self.assertEqual(list(panels), document["pattern"]["panel_order"])
        for panel in panels.values():
            count = len(panel["vertices"])
            self.assertEqual([edge["endpoints"] for edge in panel["edges"]],
                             [[k, (k + 1) % count] for k in range(count)])
            ring = np.concatenate([pattern.bezier_points(bezier(panel, edge), 400)[:-1] for edge in panel["edges"]])
            after = np.roll(ring, -1, axis=0)
            self.assertGreater(float(np.sum(ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0])), 0.0)
        totals = {}
        stitched = set()
        for sides in document["pattern"]["stitches"]:
            edges = [panels[side["panel"]]["edges"][side["edge"]] for side in sides]
            lengths = [pattern.bezier_length(bezier(panels[side["panel"]], edge)) for side, edge in zip(sides, edges)]
            self.assertLess(abs(lengths[0] - lengths[1]), tolerance * lengths[0] + 1e-13)  # of slivers
            self.assertEqual(edges[0]["label"], edges[1]["label"])
            total = totals.setdefault(edges[0]["label"], [0.0, 0.0])
            for k in (0, 1):
                total[k] += lengths[k]
                stitched.add((sides[k]["panel"], sides[k]["edge"]))
        self.assertEqual(len(stitched), 2 * len(document["pattern"]["stitches"]))
        wanted = {wire.name: sum(wire.edges) / 10 for wire in pattern.wires_in_space(self.path("out"), "cm")
                  if wire.kind in (pattern.SEAM, pattern.DART)}
        self.assertEqual(set(totals), set(wanted))
        for name, sides in totals.items():
            for side in sides:
                self.assertLess(abs(side - wanted[name]), 1e-6, name)
        return document

    def test_edges_of_the_mesh_are_stitched_to_edges_of_equal_length(self):
        self.make_raw("tshirt", "-o", "out/pattern.json")
        document = self.check(1e-9)
        self.assertNotIn("curvature", json.dumps(document["pattern"]))

    def test_smooth_borders_are_cubic_edges_of_the_seams_lengths(self):
        self.make("tshirt", "-o", "out/pattern.json", "--smooth", "1.0")
        document = self.check(1e-6)
        self.assertIn("curvature", json.dumps(document["pattern"]))
        # Both sides of a seam are divided at the same lengths, without slivers in between.
        for panel in document["pattern"]["panels"].values():
            for edge in panel["edges"]:
                self.assertGreater(pattern.bezier_length(bezier(panel, edge)), 0.5)
        smooth = self.edge_count()
        self.make_raw("tshirt", "-o", "out/pattern.json")
        self.assertLess(2 * smooth, self.edge_count())

    def edge_count(self):
        return sum(len(panel["edges"]) for panel in self.document()["pattern"]["panels"].values())

    def test_smooth_edges_end_at_notches_of_the_usual_spacing_as_well(self):
        counts = []
        for options in ((), ("--notch-spacing", "0")):
            self.make("tshirt", "-o", "out/pattern.json", *options)
            counts.append(self.edge_count())
        self.assertGreater(counts[0], counts[1] + 5)

    def test_legs_of_a_dart_are_stitched_to_each_other(self):
        self.make("shirt_front", "-o", "out/pattern.json")
        document = self.check(1e-9)
        for sides in document["pattern"]["stitches"]:
            self.assertEqual(sides[0]["panel"], sides[1]["panel"])

    def test_a_piece_that_is_flat_in_space_is_placed_where_it_was(self):
        turn = rotation((20.0, -50.0, 130.0))
        corners = [(0, 0), (30, 0), (30, 20), (10, 25), (0, 20)]
        in_space = [turn @ (x, y, 0) + (5, -7, 11) for x, y in corners]
        self.write("flat.obj", command.obj([point.tolist() for point in in_space], [(0, 1, 2), (0, 2, 3), (0, 3, 4)]))
        self.run_command("pattern", "flat.obj", "-o", "out/pattern.json", "--unit", "cm", "-q", "-o", "out", code=0)
        (panel,) = self.document()["pattern"]["panels"].values()
        placed = [rotation(panel["rotation"]) @ (x, y, 0) + panel["translation"] for x, y in panel["vertices"]]
        for point in in_space:
            self.assertLess(min(np.linalg.norm(point - other) for other in placed), 1e-8)


if __name__ == "__main__":
    unittest.main()
