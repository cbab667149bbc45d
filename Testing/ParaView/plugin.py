# SPDX-License-Identifier: BSD-3-Clause
"""What the tests in ParaView's Python share: the loaded plugin and the pieces of Data/."""

import os
import sys
import unittest

import paraview.simple as pv
from paraview import servermanager

SOURCE = os.environ["FLATTENING_SOURCE"]
OUTPUT = os.environ["FLATTENING_OUTPUT"]
DATA = os.path.join(SOURCE, "Data")
PLUGIN = os.environ["FLATTENING_PLUGIN"]
COMMAND = os.environ["WIREWARP"]

pv.LoadPlugin(PLUGIN, remote=False)


def read(name):
    return pv.XMLPolyDataReader(FileName=[os.path.join(DATA, name + ".vtp")])


def fetch(proxy, port=0):
    """The output as an object of VTK."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, idx=port)


def values(data, name):
    """A column of a table, or an array of the field data of another data set, as Python values."""
    array = (data.GetRowData() if data.IsA("vtkTable") else data.GetFieldData()).GetAbstractArray(name)
    return [array.GetValue(row) for row in range(array.GetNumberOfValues())]


def main():
    """Runs the tests of a script that draws: at its end ParaView closes windows without an OpenGL context, an X error."""
    outcome = unittest.main(exit=False).result
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if outcome.wasSuccessful() else 1)
