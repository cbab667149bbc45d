# SPDX-License-Identifier: BSD-3-Clause
"""A collection flattened by two processes of pvbatch is what one process gives."""

import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

SOURCE = os.environ["FLATTENING_SOURCE"]
DATA = os.path.join(SOURCE, "Data")
PIECES = ("shirt_front", "shirt_back", "shirt_shoulder", "pants_front", "pants_back")


def leaves(path):
    """The pieces of a collection; a process that had nothing to write leaves empty ones."""
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(path)
    reader.Update()
    result = []
    iterator = reader.GetOutput().NewIterator()
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        if isinstance(leaf, vtkPolyData) and leaf.GetNumberOfCells():
            result.append(leaf)
        iterator.GoToNextItem()
    return result


class Processes(unittest.TestCase):
    def run_batch(self, *command):
        environment = {
            **os.environ, "PYTHONPATH": os.environ["PARAVIEW_PYTHONPATH"],
            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            # What containers forbid: to read the other process's memory.
            "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertNotIn("ERR", run.stderr)
        return run.stdout

    def test_a_collection(self):
        script = os.path.join(SOURCE, "Examples", "ParaView", "flatten_collection.py")
        batch = [os.environ["PVBATCH"], script, "--plugin", os.environ["FLATTENING_PLUGIN"]]
        with tempfile.TemporaryDirectory() as folder:
            pieces = os.path.join(folder, "pieces.vtm")
            subprocess.run(
                [sys.executable, os.path.join(SOURCE, "Examples", "Python", "make_collection.py"),
                 pieces, *(f"{DATA}/{name}.vtp,{DATA}/{name}_curves.vtp" for name in PIECES)],
                check=True)
            serial, parallel = (os.path.join(folder, name) for name in ("one.vtm", "two.vtm"))
            self.run_batch(*batch, pieces, serial)
            self.run_batch(os.environ["MPIEXEC"], "--oversubscribe", "-n", "2", *batch, pieces, parallel)
            one, two = leaves(serial), leaves(parallel)

        self.assertEqual(len(one), len(PIECES))
        self.assertEqual(len(two), len(PIECES))
        for flat, other in zip(one, two):
            self.assertEqual(flat.GetNumberOfCells(), other.GetNumberOfCells())
            self.assertTrue((vtk_to_numpy(flat.GetPoints().GetData())
                             == vtk_to_numpy(other.GetPoints().GetData())).all())
            for name in ("RunStatus", "MaxEdgeLengthError", "AngleErrorMean", "GlobalHomogeneity"):
                mine, theirs = (data.GetFieldData().GetAbstractArray(name).GetValue(0)
                                for data in (flat, other))
                self.assertEqual(mine, theirs, name)
            error = flat.GetFieldData().GetArray("MaxEdgeLengthError").GetValue(0)
            self.assertLess(error, 1e-9)


if __name__ == "__main__":
    unittest.main()
