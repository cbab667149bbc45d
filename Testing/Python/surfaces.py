# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that the tests of the Python package share."""

import contextlib
import os
import sys
import warnings
from xml.etree import ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "Command"))
import command  # noqa: E402  - it lies in another folder
from command import DATA, SOURCE  # noqa: E402, F401

FLIPPED_STRAIN = 100.0  # what a flipped triangle counts as


@contextlib.contextmanager
def quiet():
    """Warnings are ignored."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


@contextlib.contextmanager
def warned():
    """The list of warnings that are given meanwhile."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield caught


def read_file(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read(name):
    """A vtkPolyData of Data/."""
    return read_file(os.path.join(DATA, name + ".vtp"))


def vtk_points(places):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in places:
        points.InsertNextPoint(place)
    return points


def flattened(name, **options):
    """A piece of Data/ with its curves."""
    import surfaceflattening as sf
    return sf.flatten_polydata(read(name), read(name + "_curves"), **options)


def table_rows(html):
    """The texts of the cells of tables, row by row, of HTML whose tags fit."""
    page = ElementTree.fromstring(f"<div>{html}</div>")
    return [["".join(cell.itertext()) for cell in row] for row in page.iter("tr")]


def points_of(polydata):
    return np.array(vtk_to_numpy(polydata.GetPoints().GetData()), float)


def triangles_of(polydata):
    return np.array(vtk_to_numpy(polydata.GetPolys().GetConnectivityArray())).reshape(-1, 3)


def polylines_of(polydata):
    lines = polydata.GetLines()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    return [np.array(ids[a:b]) for a, b in zip(offsets[:-1], offsets[1:])]


def lengths_of(polydata):
    """Of its polylines."""
    points = points_of(polydata)
    return [np.linalg.norm(np.diff(points[line], axis=0), axis=1).sum() for line in polylines_of(polydata)]


def quarter_sphere():
    """The paper's quarter-sphere (Fig. 11): points, triangles, its arc."""
    points, triangles, arc = command.quarter_sphere()
    return np.array(points), np.array(triangles), arc


def grid(columns=4, rows=3, place=lambda i, j: (i, j, 0.0), **options):
    """Squares, of a plane by default, each two triangles."""
    points, triangles = command.grid(columns, rows, place, **options)
    return np.array(points, float), np.array(triangles)


def shell(columns=10, rows=12, height=0.25):
    """A doubly curved patch, whose diagonals alternate."""
    return grid(columns, rows, lambda i, j: (
        i / columns, j / columns, height * np.sin(np.pi * i / columns) * np.sin(np.pi * j / rows)),
        other=lambda i, j: (i + j) % 2)


def column_of(columns, rows, i):
    """The vertices of a column of a grid; those of a row follow each other."""
    return [(columns + 1) * j + i for j in range(rows + 1)]


def cylinder(columns=40, rows=20):
    """A part of a polyhedral cylinder of radius 1 and height 2."""
    return grid(columns, rows, lambda i, j: (np.cos(3 * i / columns), np.sin(3 * i / columns), 2 * j / rows))


def cone(columns, rows):
    """A sector of a polyhedral cone about the z axis with its apex left out, seen from outside."""
    def place(i, j):
        radius, turn = 0.4 + 1.1 * j / rows, -2.4 * i / columns
        return radius * np.sin(0.45) * np.cos(turn), radius * np.sin(0.45) * np.sin(turn), radius * np.cos(0.45)
    return grid(columns, rows, place)


def moved_rigidly(points):
    """Turned by 1.2 about (1, -2, 0.5), and moved."""
    x, y, z = np.array([1.0, -2.0, 0.5]) / np.sqrt(5.25)
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + np.sin(1.2) * across + (1 - np.cos(1.2)) * across @ across
    return points @ turn.T + (3, -7, 11)


def dome(*sides, **options):
    points, triangles = command.dome(*sides, **options)
    return np.array(points), np.array(triangles)


def cap(*measures):
    points, triangles = command.cap(*measures)
    return np.array(points), np.array(triangles)


def distances(positions):
    return np.linalg.norm(positions[:, None] - positions[None], axis=2)
