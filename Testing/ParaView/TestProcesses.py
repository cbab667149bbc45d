# SPDX-License-Identifier: BSD-3-Clause
"""A collection flattened by two processes of pvbatch is what one process gives."""

import ast
import csv
import os
import subprocess
import sys
import tempfile
import textwrap
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLPolyDataReader, vtkXMLPolyDataWriter

PRELUDE = """
import os
import tempfile
import paraview.simple as pv
pv.LoadPlugin(os.environ["FLATTENING_PLUGIN"], remote=False)


def read(name):
    return pv.XMLPolyDataReader(FileName=[os.path.join(os.environ["FLATTENING_SOURCE"], "Data", name + ".vtp")])


def told(proxy):
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    information = proxy.GetDataInformation()
    return proxy.Status, information.GetNumberOfCells(), tuple(information.GetBounds())


"""
SOURCE = os.environ["FLATTENING_SOURCE"]
DATA = os.path.join(SOURCE, "Data")
# Debian 12's ParaView 5.11 cannot read appended data, in files or between its own processes, since its
# Expat was updated: files here have their data within the elements, and no filter hands data on as XML.
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


def write_halves(name, folder):
    """The surface as two files, a half of its triangles each, and the .pvtp that gives one to each process."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(DATA, name + ".vtp"))
    reader.Update()
    whole = reader.GetOutput()
    cells = whole.GetPolys()
    middle = cells.GetNumberOfCells() // 2
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()
    for half, ids in enumerate((range(middle), range(middle, cells.GetNumberOfCells()))):
        part = vtkCellArray()
        for cell in ids:
            part.InsertNextCell(whole.GetCell(cell))
        piece = vtkPolyData()
        piece.SetPoints(whole.GetPoints())
        piece.SetPolys(part)
        writer.SetInputData(piece)
        writer.SetFileName(os.path.join(folder, f"half{half}.vtp"))
        writer.Write()
    path = os.path.join(folder, "halves.pvtp")
    with open(path, "w", encoding="utf-8") as file:
        file.write('''<VTKFile type="PPolyData" version="0.1" byte_order="LittleEndian"><PPolyData GhostLevel="0">
            <PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>
            <Piece Source="half0.vtp"/><Piece Source="half1.vtp"/></PPolyData></VTKFile>''')
    return path


class Processes(unittest.TestCase):
    def run_batch(self, *command, code=0):
        environment = {
            **os.environ, "PYTHONPATH": os.environ["PARAVIEW_PYTHONPATH"],
            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            # What containers forbid: to read the other process's memory.
            "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        if code == 0:
            self.assertNotIn("ERR", run.stderr)
        return run.stdout

    def run_script(self, processes, text):
        """What a script prints on so many processes, which must give no error, as Python values."""
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "script.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write(PRELUDE + textwrap.dedent(text))
            batch = [os.environ["PVBATCH"], script]
            if processes > 1:
                batch = [os.environ["MPIEXEC"], "--oversubscribe", "-n", str(processes), *batch]
            return ast.literal_eval(self.run_batch(*batch).strip().splitlines()[-1])

    def test_a_plain_file_is_flattened_by_the_process_that_has_it(self):
        program = """
            flat = pv.FlattenSurfaceWireWarping(Input=read("shirt_front"), Curves=read("shirt_front_curves"))
            print(told(flat))
        """
        one, two = self.run_script(1, program), self.run_script(2, program)
        self.assertEqual(one[0], "Ok")
        self.assertGreater(one[1], 1000)
        self.assertEqual(two, one)

    def test_curves_of_one_process_are_those_of_every_block(self):
        program = """
            pair = pv.GroupDatasets(Input=[read("shirt_front"), read("shirt_front")])
            with tempfile.TemporaryDirectory() as folder:
                pv.SaveData(folder + "/pair.vtm", proxy=pair, DataMode="Binary")
                blocks = pv.XMLMultiBlockDataReader(FileName=[folder + "/pair.vtm"])
                flat = pv.FlattenSurfaceWireWarping(Input=blocks, Curves=read("shirt_front_curves"))
                print(told(flat))
        """
        one, two = self.run_script(1, program), self.run_script(2, program)
        alone = self.run_script(1, """
            print(told(pv.FlattenSurfaceWireWarping(Input=read("shirt_front"), Curves=read("shirt_front_curves"))))
        """)
        self.assertEqual(one[1], 2 * alone[1])
        # Cells, and the place of each block beside the others: that of both together.
        self.assertEqual(two[1:], one[1:])

    def test_a_surface_spread_over_processes_is_refused_until_it_is_gathered(self):
        with tempfile.TemporaryDirectory() as folder:
            status, cells, gathered, gathered_cells, errors = self.run_script(2, f"""
                spread = pv.XMLPartitionedPolydataReader(FileName=[{write_halves("shirt_front", folder)!r}])
                with tempfile.TemporaryFile() as file:
                    kept = os.dup(2)
                    os.dup2(file.fileno(), 2)  # the refusal is said there
                    flat = told(pv.FlattenSurfaceWireWarping(Input=spread))
                    os.dup2(kept, 2)
                    file.seek(0)
                    errors = file.read().decode().count("is spread over 2 processes")
                whole = pv.AggregateDataset(Input=spread, NumberOfTargetProcesses=1)
                gathered = told(pv.FlattenSurfaceWireWarping(Input=whole, CoincidentPoints="Join"))
                print((*flat[:2], *gathered[:2], errors))
            """)
        self.assertEqual((status, cells), ("InvalidOption", 0))
        self.assertEqual(errors, 1)
        self.assertEqual((gathered, gathered_cells), ("Ok", 1414))

    def test_developability_is_measured_part_by_part(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.run_script(2, f"""
                spread = pv.XMLPartitionedPolydataReader(FileName=[{write_halves("shirt_front", folder)!r}])
                print(told(pv.SurfaceDevelopability(Input=spread)))
            """)[:2], ("Ok", 1414))

    @staticmethod
    def table(path):
        with open(path.replace(".vtm", ".csv"), encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def goes_on_after_a_fault(self, batch, pieces, folder):
        """A run died in the first portion, the one before it in its second piece alone."""
        flat = os.path.join(folder, "again.vtm")
        os.makedirs(os.path.join(folder, "again"))
        for name in ("000000-000002.begun", "000001-000002.begun"):
            with open(os.path.join(folder, "again", name), "w", encoding="utf-8"):
                pass
        said = self.run_batch(*batch, pieces, flat, "--portion", "2")
        self.assertIn("one by one", said)
        self.assertEqual([row["Status"] for row in self.table(flat)], ["Ok", "Died", "Ok", "Ok", "Ok"])
        self.assertEqual(len(leaves(flat)), len(PIECES) - 1)
        # What is done is not done again.
        before = os.stat(os.path.join(folder, "again", "000002-000004.csv")).st_mtime_ns
        self.run_batch(*batch, pieces, flat, "--portion", "2")
        self.assertEqual(os.stat(os.path.join(folder, "again", "000002-000004.csv")).st_mtime_ns, before)

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
            two_batch = [os.environ["MPIEXEC"], "--oversubscribe", "-n", "2", *batch]
            self.run_batch(*two_batch, pieces, parallel, "--portion", "3")
            one, two = leaves(serial), leaves(parallel)
            tables = [self.table(path) for path in (serial, parallel)]
            # With two processes a portion of one piece leaves nothing to one of them.
            self.goes_on_after_a_fault(two_batch, pieces, folder)

        self.assertEqual([row["Name"] for row in tables[0]], list(PIECES))
        self.assertEqual({row["Status"] for row in tables[0]}, {"Ok"})
        self.assertLess(max(float(row["MaxEdgeLengthError"]) for row in tables[0]), 1e-9)
        self.assertEqual(tables[0], tables[1])
        self.assertEqual(len(one), len(PIECES))
        self.assertEqual(len(two), len(PIECES))
        for flat, other in zip(one, two):
            self.assertEqual(flat.GetNumberOfCells(), other.GetNumberOfCells())
            self.assertTrue((vtk_to_numpy(flat.GetPoints().GetData())
                             == vtk_to_numpy(other.GetPoints().GetData())).all())
            mine, theirs = (data.GetFieldData().GetAbstractArray("RunStatus").GetValue(0) for data in (flat, other))
            self.assertEqual(mine, theirs)


if __name__ == "__main__":
    unittest.main()
