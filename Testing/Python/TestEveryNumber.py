# SPDX-License-Identifier: BSD-3-Clause
"""Every measure in report.json, in the table and in the arrays is what numpy finds in the files that were
written beside it."""

import os
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from surfaces import FLIPPED_STRAIN, command, points_of, polylines_of, read_file, triangles_of

# Surface, or surface+set of curves, and options.
CASES = (
    ("shirt_front",),
    ("shirt_back", "--scheme", "progressive", "--interior", "laplacian"),
    ("pants_front+_set3",),  # keys that contradict each other
    ("shirt_front", "--paper-method", "--solver", "sequential"),
    ("shoe_upper", "--scheme", "progressive", "--interior", "laplacian"),
    ("tshirt", "--scheme", "global", "--no-keys"),
    ("tshirt", "--tolerance", "shoulder_seam_left=0.03"),
    ("wetsuit_upper_front",),
    ("wetsuit_upper_front", "--close-cuts"),
    ("wetsuit_upper_front", "--scheme", "lscm", "--no-arrange"),
    ("quarter_sphere", "--energy", "dirichlet"),
    ("quarter_sphere", "--scheme", "lscm"),
)
TYPES = ("accessory", "key", "dart", "seam")


def array(attributes, name):
    """Its values; none where there is no such array, as of a list without rows."""
    found = attributes.GetArray(name)
    return np.array(vtk_to_numpy(found)) if found else np.array([])


def lengths(points, ids):
    return np.linalg.norm(np.diff(points[ids], axis=0), axis=1)


def angles(points, triangles):
    result = np.empty(triangles.shape)
    for k in range(3):
        u, v = (points[triangles[:, (k + step) % 3]] - points[triangles[:, k]] for step in (1, 2))
        result[:, k] = np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))
    return result


def edge(a, b):
    return (min(a, b), max(a, b))


def regions(triangles, walls):
    """Label of the connected region of each triangle; walls are edges that separate."""
    sides = np.sort(np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
    order = np.lexsort(sides.T)
    sides, owner = sides[order], np.tile(np.arange(len(triangles)), 3)[order]
    joined = (sides[1:] == sides[:-1]).all(1) & np.array([tuple(pair) not in walls for pair in sides[1:]])
    one, other = owner[:-1][joined], owner[1:][joined]
    labels = np.arange(len(triangles))
    while True:
        lower, new = np.minimum(labels[one], labels[other]), labels.copy()
        np.minimum.at(new, one, lower)
        np.minimum.at(new, other, lower)
        if (new == labels).all():
            return labels
        labels = new


class Output:
    """What the command has written, and what numpy makes of points and triangles alone."""

    def __init__(self, report, folder):
        self.report = report
        self.flat, self.wires, cut = (
            read_file(os.path.join(folder, name)) for name in ("flat.vtp", "wires.vtp", "cut.vtp"))
        self.plane, self.space = points_of(self.flat), points_of(cut)
        self.triangles = triangles_of(self.flat)
        self.chains = polylines_of(self.wires)
        self.piece = array(self.flat.GetCellData(), "PieceId")
        self.piece_of_point = np.zeros(len(self.plane), int)
        self.piece_of_point[self.triangles.ravel()] = np.repeat(self.piece, 3)
        sides = np.concatenate([self.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
        edges, counts = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
        self.boundary = {tuple(pair) for pair in edges[counts == 1]}
        self.pairs = array(self.flat.GetFieldData(), "SeamPairs").astype(int).reshape(-1, 5)
        self.closed = array(self.flat.GetFieldData(), "SeamClosed") != 0
        # Singular values S >= s, s negative where flipped, areas and errors of angles.
        a, b, c = self.triangles.T
        u, v = self.space[b] - self.space[a], self.space[c] - self.space[a]
        base = np.linalg.norm(u, axis=1)
        self.area = 0.5 * np.linalg.norm(np.cross(u, v), axis=1)
        before = np.zeros((len(a), 2, 2))
        before[:, 0, 0], before[:, 0, 1], before[:, 1, 1] = base, (u * v).sum(1) / base, 2 * self.area / base
        after = np.stack([(self.plane[b] - self.plane[a])[:, :2], (self.plane[c] - self.plane[a])[:, :2]], axis=2)
        maps = after @ np.linalg.inv(before)
        self.large, small = np.linalg.svd(maps, compute_uv=False).T
        self.small = small * np.sign(np.linalg.det(maps))
        self.ratio = self.large * self.small
        self.surface_angles = angles(self.space, self.triangles)
        flat_angles = angles(self.plane, self.triangles)
        self.angle_error = (np.abs(flat_angles - self.surface_angles) / self.surface_angles).mean(1)

    def strain(self, inside):
        """Not exceeded on 95 % of the area."""
        small = np.where(self.small > 0, self.small, 1.0)
        strain = np.maximum(np.abs(np.log(self.large)), np.abs(np.log(small)))
        strain = np.where(self.small > 0, strain, FLIPPED_STRAIN)[inside]
        order = np.argsort(strain)
        sums = np.cumsum(self.area[inside][order])
        return strain[order][np.searchsorted(sums, 0.95 * (1 - 1e-9) * sums[-1])]

    def rigid_edges(self, piece):
        """Relative errors of the edges of wires whose length is promised."""
        tolerances = [curve["tolerance"] for curve in self.report["curves"]]
        cells = self.wires.GetCellData()
        found = {}
        for chain, of, curve, connector in zip(
                self.chains, array(cells, "PieceId"), array(cells, "CurveId"), array(cells, "Connector")):
            if of == piece and not connector and not (curve >= 0 and tolerances[curve] > 0):
                rest, flat = lengths(self.space, chain), lengths(self.plane, chain)
                found.update(zip(map(edge, chain[:-1], chain[1:]), np.abs(flat - rest) / rest))
        return np.array(list(found.values()))

    def all_edges(self, piece):
        """Relative errors of all edges."""
        triangles = self.triangles[self.piece == piece]
        sides = np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
        ends = np.unique(np.sort(sides, axis=1), axis=0)
        rest, flat = (np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1) for points in (self.space, self.plane))
        return np.abs(flat - rest) / rest

    def cut_length(self, piece):
        """Of cuts, each pair of banks once."""
        total = 0.0
        for (a, b, c, _, _), closed in zip(self.pairs, self.closed):
            if not closed and piece in (self.piece_of_point[a], self.piece_of_point[c]):
                total += np.linalg.norm(self.space[a] - self.space[b])
        return total

    def crossings(self, piece):
        """Pairs of boundary edges without a common point that cross."""
        edges = np.array([pair for pair in sorted(self.boundary) if self.piece_of_point[pair[0]] == piece])
        i, j = np.triu_indices(len(edges), 1)
        one, other = edges[i], edges[j]
        apart = (one[:, :, None] != other[:, None, :]).all((1, 2))

        def side(p, q, r):
            u, v = self.plane[q] - self.plane[p], self.plane[r] - self.plane[p]
            return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]

        a, b, c, d = one[:, 0], one[:, 1], other[:, 0], other[:, 1]
        return (apart & (side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)).sum()


class EveryNumber(command.CommandTest):
    dirichlet = False

    def near(self, what, said, found, tolerance=1e-8):
        np.testing.assert_allclose(said, found, rtol=tolerance, atol=tolerance, err_msg=what)

    def test_of_pieces_of_each_scheme(self):
        for name, *options in CASES:
            with self.subTest(name, options=options):
                surface, _, curves = name.partition("+")
                run = self.run_command(*command.data_files(surface, "_curves" + curves), *options, "--table", "-o", "out")
                output = Output(self.report("out"), self.path("out"))
                self.assertEqual(run.returncode, 0 if output.report["status"] == "Ok" else 4, run.stderr)
                self.check_table(output.report, run.stdout)
                self.check_regions(output)
                self.dirichlet = "dirichlet" in options
                self.check_arrays(output)
                self.check_wires(output)
                self.check_curves(output)
                self.check_pairs(output)
                self.assertGreater(len(output.report["pieces"]), 0)
                for piece, report in enumerate(output.report["pieces"]):
                    self.check_piece(output, piece, report)

    def check_table(self, report, table):
        """The numbers of the report, rounded; whoever cuts counts pieces from 1."""
        rows = [line.split() for line in table.splitlines()[1:] if line[:1].isdigit()]
        self.assertEqual(len(rows), len(report["pieces"]))
        for row, piece in zip(rows, report["pieces"]):
            self.assertEqual(row[:2] + row[3:4], [
                str(piece["piece"] + 1), str(piece["triangles"]), str(piece["wire_patches"])])
            for cell, value in zip(row[4:12], (
                    1e3 * piece["E_len"], piece["E_len_max"], piece["E_len_all"], 1e3 * piece["E_ang"], piece["E_h"],
                    piece["E_r"], piece["E_area"], piece["strain_p95"])):
                digits, _, power = cell.partition("e")
                unit = 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))
                self.assertAlmostEqual(float(cell), value, delta=0.501 * unit)
            self.assertEqual(row[12:15], [str(piece[key]) for key in ("flipped", "overlaps", "iterations")])
            self.assertEqual(row[17], piece["status"])

    def check_regions(self, output):
        """Pieces and wire-patches are the regions between edges that are not shared, and between wires."""
        pieces = output.report["pieces"]
        for walls, ids, count in (
                (set(), output.piece, len(pieces)),
                ({edge(a, b) for chain in output.chains for a, b in zip(chain[:-1], chain[1:])},
                 array(output.flat.GetCellData(), "WirePatchId"), sum(piece["wire_patches"] for piece in pieces))):
            labels = regions(output.triangles, walls)
            self.assertEqual((len(set(labels)), len(set(zip(labels, ids)))), (count, count))
            if walls and not output.closed.any():
                # A node for each side of a wire that has a triangle.
                self.assertEqual(sum(piece["wire_nodes"] for piece in pieces),
                                 len(output.boundary) + 2 * len(walls - output.boundary))

    def check_arrays(self, output):
        cells = output.flat.GetCellData()
        ratio = output.ratio
        homogeneity = np.where(ratio > 0, np.minimum(ratio, 1 / np.where(ratio > 0, ratio, 1)), 0)
        for name, found in (("AreaRatio", ratio), ("HomogeneityOfDistortion", homogeneity),
                            ("AspectRatio", output.small / output.large),
                            ("AngleError", output.angle_error), ("Flipped", ratio <= 0)):
            self.near(name, array(cells, name), found, 1e-7)
        sums = np.bincount(output.triangles.ravel(), output.surface_angles.ravel(), len(output.space))
        sums[np.array(sorted(output.boundary)).ravel()] = 2 * np.pi
        self.near("Developability", array(output.flat.GetPointData(), "Developability"),
                  np.abs(2 * np.pi - sums))

    def check_wires(self, output):
        cells = output.wires.GetCellData()
        rest = [lengths(output.space, chain) for chain in output.chains]
        flat = [lengths(output.plane, chain) for chain in output.chains]
        self.near("RestLength", array(cells, "RestLength"), [part.sum() for part in rest])
        self.near("FlatLength", array(cells, "FlatLength"), [part.sum() for part in flat])
        self.near("LengthError", array(cells, "LengthError"),
                  [np.max(np.abs(a - b) / a) for a, b in zip(rest, flat)])
        self.near("PieceId", array(cells, "PieceId"),
                  [output.piece_of_point[chain[0]] for chain in output.chains])
        closed = {edge(*row[pair]) for row in output.pairs[output.closed] for pair in ([0, 1], [2, 3])}
        open_boundary = output.boundary - closed
        self.near("Boundary", array(cells, "Boundary"),
                  [all(edge(a, b) in open_boundary for a, b in zip(chain[:-1], chain[1:]))
                   for chain in output.chains])

    def check_curves(self, output):
        of_chain = array(output.wires.GetCellData(), "CurveId")
        names = output.wires.GetCellData().GetAbstractArray("CurveName")
        types = array(output.wires.GetCellData(), "CurveType")
        for row, curve in enumerate(output.report["curves"]):
            for chain in np.flatnonzero(of_chain == row):
                self.assertEqual((names.GetValue(chain), TYPES[int(types[chain])]), (curve["name"], curve["type"]))
            chains = [chain for chain, of in zip(output.chains, of_chain) if of == row]
            places = {}
            for chain in chains:
                for a, b in zip(chain[:-1], chain[1:]):
                    places[frozenset((tuple(output.space[a]), tuple(output.space[b])))] = \
                        np.linalg.norm(output.space[a] - output.space[b])
            rest = np.concatenate([lengths(output.space, chain) for chain in chains])
            flat = np.concatenate([lengths(output.plane, chain) for chain in chains])
            length = sum(places.values())
            self.near("length_3d", curve["length_3d"], length)
            # The mean of its banks where it is cut.
            self.near("length_2d", curve["length_2d"], flat.sum() * length / rest.sum())
            self.near("error", curve["error"], np.max(np.abs(flat - rest) / rest))
            closed = output.pairs[output.closed & (output.pairs[:, 4] == row)]
            self.near("closed_length", curve["closed_length"],
                      np.linalg.norm(output.space[closed[:, 0]] - output.space[closed[:, 1]], axis=1).sum())

    def check_pairs(self, output):
        for points, shut in ((output.space, np.ones(len(output.pairs), bool)), (output.plane, output.closed)):
            for one, other in ((0, 2), (1, 3)):
                self.near("banks", points[output.pairs[shut, one]], points[output.pairs[shut, other]])
        sewn = sum(seam["edges"] for seam in output.report["seams"])
        self.assertEqual(sewn, len(output.pairs))

    def check_piece(self, output, piece, report):
        inside = output.piece == piece
        area, ratio = output.area[inside], output.ratio[inside]
        large, small = output.large[inside], output.small[inside]
        errors = output.rigid_edges(piece)
        patches = array(output.flat.GetCellData(), "WirePatchId")[inside]
        energy = (area * ((large - 1)**2 + (small - 1)**2)).sum() / area.sum()
        for key, found, tolerance in (
            ("triangles", inside.sum(), 0),
            ("vertices", len(np.unique(output.triangles[inside])), 0),
            ("wire_patches", len(np.unique(patches)), 0),
            ("flipped", (ratio <= 0).sum(), 0),
            ("overlaps", output.crossings(piece), 0),
            ("overlaps_complete", True, 0),
            ("E_len", errors.mean(), 1e-11),
            ("E_len_max", errors.max(), 1e-11),
            ("E_len_all", output.all_edges(piece).mean(), 1e-8),
            ("E_ang", output.angle_error[inside].mean(), 1e-8),
            ("E_h", ratio.min() / ratio.max(), 1e-7),
            ("E_r", small.min() / large.max(), 1e-7),
            ("E_area", np.abs(area * (ratio - 1)).sum() / area.sum(), 1e-8),
            ("strain_p95", output.strain(inside), 1e-8),
            ("energy_rigid", energy, 1e-8),
            ("cut_length", output.cut_length(piece), 1e-10),
        ):
            self.near(key, report[key], found, tolerance)
        size, change = output.report["sizes"][piece], area * (np.abs(ratio) - 1)
        self.near("eased_in", size["eased_in"], change[change > 0].sum() / area.sum(), 1e-10)
        self.near("stretched", size["stretched"], -change[change < 0].sum() / area.sum(), 1e-10)
        corners = output.triangles[inside].ravel()
        around = np.bincount(corners, np.repeat(change, 3)) / np.maximum(np.bincount(corners, np.repeat(area, 3)), 1e-300)
        self.near("worst_change", size["worst_change"], around[np.argmax(np.abs(around))])
        if output.report["scheme"] == "isometric" and not self.dirichlet:
            self.near("energy_sheet", report["energy_sheet"], inside.sum() * energy, 1e-7)


if __name__ == "__main__":
    unittest.main()
