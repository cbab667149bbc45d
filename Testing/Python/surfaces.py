# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that the tests of the Python package share."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SOURCE = os.environ["FLATTENING_SOURCE"]
DATA = os.path.join(SOURCE, "Data")


def read_file(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read(name):
    """A vtkPolyData of Data/."""
    return read_file(os.path.join(DATA, name + ".vtp"))


def points_of(polydata):
    return np.array(vtk_to_numpy(polydata.GetPoints().GetData()), float)


def triangles_of(polydata):
    return np.array(vtk_to_numpy(polydata.GetPolys().GetConnectivityArray())).reshape(-1, 3)


def polylines_of(polydata):
    lines = polydata.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    return [np.array(ids[a:b]) for a, b in zip(offsets[:-1], offsets[1:])]


def quarter_sphere():
    """The 90 degree lune of the unit sphere of the paper's Fig. 11: points, triangles, its arc."""
    latitudes, longitudes = 8, 4
    south = 1 + (latitudes - 1) * (longitudes + 1)

    def at(i, j):
        return 0 if j == 0 else south if j == latitudes else 1 + (j - 1) * (longitudes + 1) + i

    points = np.zeros((south + 1, 3))
    for j in range(latitudes + 1):
        for i in range(longitudes + 1):
            polar, azimuth = np.pi * j / latitudes, np.pi / 2 * i / longitudes
            points[at(i, j)] = (np.cos(polar), np.sin(polar) * np.cos(azimuth),
                                np.sin(polar) * np.sin(azimuth))
    points[[0, south]] = [[1, 0, 0], [-1, 0, 0]]
    triangles = []
    for j in range(latitudes):
        for i in range(longitudes):
            for corners in ((at(i, j), at(i, j + 1), at(i + 1, j + 1)),
                            (at(i, j), at(i + 1, j + 1), at(i + 1, j))):
                if len(set(corners)) == 3:
                    triangles.append(corners)
    arc = [at(i, latitudes // 2) for i in range(longitudes + 1)]
    return points, np.array(triangles), arc


def grid(columns=4, rows=3):
    """A plane grid of unit squares, each two triangles."""
    points = np.array([[x, y, 0.0] for y in range(rows + 1) for x in range(columns + 1)])
    triangles = []
    for y in range(rows):
        for x in range(columns):
            a = y * (columns + 1) + x
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            triangles += [(a, b, c), (a, c, d)]
    return points, np.array(triangles)


def distances(positions):
    return np.linalg.norm(positions[:, None] - positions[None], axis=2)
