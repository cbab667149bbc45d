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


def dome(*sides, **options):
    points, triangles = command.dome(*sides, **options)
    return np.array(points), np.array(triangles)


def cap(*measures):
    points, triangles = command.cap(*measures)
    return np.array(points), np.array(triangles)


def distances(positions):
    return np.linalg.norm(positions[:, None] - positions[None], axis=2)
