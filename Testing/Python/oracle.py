# SPDX-License-Identifier: BSD-3-Clause
"""What a result must say of itself, computed anew from its geometry with numpy alone: angles by the law of
cosines, stretches by singular values, pieces and wire-patches by walking over triangles."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from surfaces import points_of, polylines_of, read_file, triangles_of


def arrays_of(attributes):
    """Name to values; strings as a list."""
    result = {}
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(k)
        if array.IsNumeric():
            result[array.GetName()] = np.array(vtk_to_numpy(array))
        else:
            result[array.GetName()] = [array.GetValue(row) for row in range(array.GetNumberOfValues())]
    return result


def corner_angles(points, triangles):
    """Angle at each corner, by the law of cosines."""
    sides = [np.linalg.norm(points[triangles[:, (k + 1) % 3]] - points[triangles[:, (k + 2) % 3]], axis=1)
             for k in range(3)]
    angles = []
    for k in range(3):
        a, b, c = sides[k], sides[(k + 1) % 3], sides[(k + 2) % 3]
        angles.append(np.arccos(np.clip((b**2 + c**2 - a**2) / (2 * b * c), -1, 1)))
    return np.column_stack(angles)


def maps(space, flat, triangles):
    """The linear map of each triangle from its plane in space to the plane, as 2 x 2 matrices."""
    u, v = (space[triangles[:, k]] - space[triangles[:, 0]] for k in (1, 2))
    first = u / np.linalg.norm(u, axis=1)[:, None]
    normal = np.cross(u, v)
    second = np.cross(normal / np.linalg.norm(normal, axis=1)[:, None], first)
    source = np.stack([[(u * first).sum(1), (v * first).sum(1)],
                       [(u * second).sum(1), (v * second).sum(1)]]).transpose(2, 0, 1)
    p, q = (flat[triangles[:, k], :2] - flat[triangles[:, 0], :2] for k in (1, 2))
    return np.stack([p, q], axis=2) @ np.linalg.inv(source)


def edges_of(triangles):
    """Undirected edges of all triangles, three rows a triangle, smaller vertex first."""
    return np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)


def regions(triangles, walls=()):
    """Number of the connected region of each triangle; walls are edges that separate."""
    walls = {tuple(sorted(edge)) for edge in walls}
    beside = {}
    for row, edge in enumerate(map(tuple, edges_of(triangles))):
        if edge not in walls:
            beside.setdefault(edge, []).append(row // 3)
    neighbours = [[] for _ in triangles]
    for owners in beside.values():
        for t in owners:
            neighbours[t] += [other for other in owners if other != t]
    region = np.full(len(triangles), -1)
    count = 0
    for start in range(len(triangles)):
        if region[start] >= 0:
            continue
        region[start], stack = count, [start]
        while stack:
            for other in neighbours[stack.pop()]:
                if region[other] < 0:
                    region[other] = count
                    stack.append(other)
        count += 1
    return region


def crossing_pairs(positions, edges):
    """How many pairs of edges without a common end cross each other, each pair tried."""
    count = 0
    a, b = positions[edges[:, 0], :2], positions[edges[:, 1], :2]

    def side(p, q, r):
        return np.sign((q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1])
                       - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0]))

    for k in range(len(edges) - 1):
        c, d = a[k + 1:], b[k + 1:]
        apart = (edges[k + 1:, :, None] != edges[k][None, None, :]).all(axis=(1, 2))
        cross = (side(a[k], b[k], c) * side(a[k], b[k], d) < 0) & (side(c, d, a[k]) * side(c, d, b[k]) < 0)
        count += int((apart & cross).sum())
    return count


class Result:
    """A flat surface, its surface in space and its wires, measured."""

    def __init__(self, flat, wires, cut):
        self.flat, self.space = points_of(flat), points_of(cut)
        self.triangles = triangles_of(flat)
        self.lines = polylines_of(wires)
        self.points, self.cells = arrays_of(flat.GetPointData()), arrays_of(flat.GetCellData())
        self.field, self.wires = arrays_of(flat.GetFieldData()), arrays_of(wires.GetCellData())
        self.maps = maps(self.space, self.flat, self.triangles)
        stretches = np.linalg.svd(self.maps, compute_uv=False)
        self.area_ratio = np.linalg.det(self.maps)
        self.large = stretches[:, 0]
        self.small = np.sign(self.area_ratio) * stretches[:, 1]
        self.angles = corner_angles(self.space, self.triangles)
        flat_angles = corner_angles(self.flat, self.triangles)
        self.angle_error = (np.abs(flat_angles - self.angles) / self.angles).mean(axis=1)
        u, v = (self.space[self.triangles[:, k]] - self.space[self.triangles[:, 0]] for k in (1, 2))
        self.areas = 0.5 * np.linalg.norm(np.cross(u, v), axis=1)
        self.piece = regions(self.triangles)

    def wire_edges(self, connectors=False):
        """Each edge of a wire once, as pairs of points."""
        edges = [np.column_stack([line[:-1], line[1:]]) for row, line in enumerate(self.lines)
                 if connectors or not self.wires["Connector"][row]]
        return np.unique(np.sort(np.concatenate(edges), axis=1), axis=0)

    def length_errors(self, edges):
        """Relative error of the length of each edge."""
        flat, space = (np.linalg.norm(where[edges[:, 0]] - where[edges[:, 1]], axis=1)
                       for where in (self.flat, self.space))
        return np.abs(flat - space) / space

    def boundary_edges(self):
        edges, counts = np.unique(edges_of(self.triangles), axis=0, return_counts=True)
        return edges[counts == 1]

    def cell_measures(self):
        """Name to the values that each triangle must have."""
        ratio = self.area_ratio
        return {
            "AreaRatio": ratio,
            "HomogeneityOfDistortion": np.where(ratio > 0, np.minimum(ratio, 1 / np.abs(ratio)), 0),
            "AspectRatio": self.small / self.large,
            "AngleError": self.angle_error,
            "Flipped": (ratio <= 0).astype(int),
        }

    def developability(self):
        """|2 pi - sum of angles| at each point, 0 on the boundary."""
        sums = np.zeros(len(self.space))
        np.add.at(sums, self.triangles, self.angles)
        result = np.abs(2 * np.pi - sums)
        result[np.unique(self.boundary_edges())] = 0
        return result

    def strain_quantile(self, own, share):
        """The largest |ln sigma| of a triangle that is not exceeded on this share of the area."""
        strain = np.where(self.small[own] > 0,
                          np.maximum(np.log(self.large[own]), -np.log(np.abs(self.small[own]))), 100)
        order = np.argsort(strain)
        area = np.cumsum(self.areas[own][order])
        return strain[order][np.searchsorted(area, share * area[-1])]

    def cut_length(self, piece):
        """Of the cuts at a piece, each once, though a dart has two banks there."""
        piece_of = np.empty(len(self.space), int)
        piece_of[self.triangles] = self.piece[:, None]
        return sum(np.linalg.norm(self.space[a] - self.space[b])
                   for (a, b, c, _, _), closed in zip(
                       self.field.get("SeamPairs", ()), self.field.get("SeamClosed", ()))
                   if not closed and piece in (piece_of[a], piece_of[c]))

    def piece_measures(self, piece):
        """Column of the table of pieces to the value that the piece must have."""
        own = self.piece == piece
        vertices = np.unique(self.triangles[own])
        edges = self.wire_edges()
        edges = edges[np.isin(edges[:, 0], vertices)]
        errors = self.length_errors(edges)
        ratio, areas = self.area_ratio[own], self.areas[own]
        patches = regions(self.triangles[own], self.wire_edges(connectors=True))
        boundary = self.boundary_edges()
        boundary = boundary[np.isin(boundary[:, 0], vertices)]
        every = self.wire_edges(connectors=True)
        inside = np.isin(every[:, 0], vertices).sum() - len(boundary)
        return {
            "Triangles": own.sum(),
            "Vertices": len(vertices),
            "WirePatches": patches.max() + 1,
            # A node for each side that has a triangle; around a hole there are more.
            "WireNodes": len(boundary) + 2 * inside,
            "FlippedTriangles": (ratio <= 0).sum(),
            "Overlaps": crossing_pairs(self.flat, boundary),
            "EdgeLengthError": errors.mean(),
            "MaxEdgeLengthError": errors.max(),
            "AngleErrorMean": self.angle_error[own].mean(),
            "GlobalHomogeneity": ratio.min() / ratio.max(),
            "GlobalAspectRatio": self.small[own].min() / self.large[own].max(),
            "AreaError": (areas * np.abs(ratio - 1)).sum() / areas.sum(),
            "StrainP95": self.strain_quantile(own, 0.95),
            "RigidEnergy": (areas * ((self.large[own] - 1)**2 + (self.small[own] - 1)**2)).sum() / areas.sum(),
            "CutLength": self.cut_length(piece),
        }
