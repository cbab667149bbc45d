# SPDX-License-Identifier: BSD-3-Clause
"""The package without VTK, as pip installs it, gives what the filters give; what it lacks it names.

Usage: TestWithoutVtk.py, or TestWithoutVtk.py --write FILE [FOLDER] to keep pieces of Data, or those in folders of their
own with surface.vtk and curves.vtk, with the filters' results, and TestWithoutVtk.py --compare FILE, which needs numpy
alone, to compare an installed package with them."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np

TYPES = ("accessory", "key", "dart", "seam")
# Places in the plane are equal to this fraction of the size of the pieces.
PRECISION = 1e-12


def pieces_in(folder):
    """Name, surface and curves of each."""
    from surfaces import DATA, read
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader

    def legacy(path):
        reader = vtkPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()

    if folder is None:
        for file in sorted(pathlib.Path(DATA).glob("*_curves.vtp")):
            name = file.stem[:-len("_curves")]
            yield name, read(name), read(file.stem)
    for file in sorted(pathlib.Path(folder or "").glob("*/surface.vtk")):
        yield file.parent.name, legacy(file), legacy(file.with_name("curves.vtk"))


def write_pieces(path, folder=None):
    """Surfaces and curves as arrays, and what the filter makes of them."""
    import surfaceflattening as sf
    from surfaces import points_of, polylines_of, triangles_of
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = {}
    for name, surface, lines in pieces_in(folder):
        cells = lines.GetCellData()
        chains = polylines_of(lines)
        names = cells.GetAbstractArray("CurveName")
        filter_ = sf.vtkWireWarpingFilter()
        filter_.SetInputData(surface)
        filter_.SetCurvesData(lines)
        filter_.Update()
        areas = filter_.GetPieces().GetRowData().GetArray("AreaError")
        arrays.update({
            f"{name}/points": points_of(surface), f"{name}/triangles": triangles_of(surface),
            f"{name}/curve_points": points_of(lines), f"{name}/chains": np.concatenate(chains),
            f"{name}/ends": np.cumsum([0] + [len(chain) for chain in chains]),
            f"{name}/types": vtk_to_numpy(cells.GetArray("CurveType")).astype(int),
            f"{name}/shapes": vtk_to_numpy(cells.GetArray("KeyShape")) if cells.GetArray("KeyShape") else
                np.zeros(len(chains), int),
            f"{name}/names": np.array([names.GetValue(k) if names else f"curve {k}" for k in range(len(chains))]),
            f"{name}/positions": points_of(filter_.GetOutput(0))[:, :2], f"{name}/status": np.array(filter_.GetStatusName()),
            f"{name}/E_area": vtk_to_numpy(areas)})
    np.savez(path, **arrays)


def compare_pieces(path):
    """The largest difference of a place, as a fraction of the size of the pieces; asserts that it is none."""
    import surfaceflattening as sf

    assert not [name for name in sys.modules if name.startswith("vtk")], "VTK was loaded"
    arrays, worst = np.load(path), 0.0
    pieces = sorted({name.split("/")[0] for name in arrays.files})
    for name in pieces:
        of = {key: arrays[f"{name}/{key}"] for key in (
            "points", "triangles", "curve_points", "chains", "ends", "types", "shapes", "names", "positions", "status", "E_area")}
        curves = [
            sf.Curve(of["curve_points"][of["chains"][begin:end]], TYPES[kind], str(curve), ("surface", "straight")[shape])
            for begin, end, kind, shape, curve in zip(of["ends"], of["ends"][1:], of["types"], of["shapes"], of["names"])]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sf.FlatteningWarning)
            result = sf.flatten(of["points"], of["triangles"], curves)
        assert result.report["status"] == of["status"], name
        difference = np.abs(result.positions - of["positions"]).max() / np.ptp(of["positions"])
        worst = max(worst, difference)
        assert difference <= PRECISION, f"{name}: {difference}"
        areas = [piece["E_area"] for piece in result.report["pieces"]]
        assert np.abs(areas - of["E_area"]).max() <= PRECISION, name
    assert not [name for name in sys.modules if name.startswith("vtk")], "VTK was loaded"
    print(f"{len(pieces)} pieces, differences up to {worst:.1e}")


class WithoutVtk(unittest.TestCase):
    def setUp(self):
        import surfaceflattening as sf
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        package = self.folder / "surfaceflattening"
        shutil.copytree(os.path.dirname(sf.__file__), package, ignore=shutil.ignore_patterns("vtk*.so", "__pycache__"))
        version = package / "_version.py"
        text = version.read_text("utf-8")
        self.with_vtk = 'BUILT_WITH_VTK = ""' not in text
        version.write_text(re.sub('BUILT_WITH_VTK = ".*"', 'BUILT_WITH_VTK = ""', text), "utf-8")

    def run_program(self, *words):
        run = subprocess.run([sys.executable, *words], capture_output=True, text=True, check=False,
                             env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_pieces_are_flattened_as_by_the_filters(self):
        if not self.with_vtk:
            self.skipTest("there are no filters")
        write_pieces(self.folder / "pieces.npz")
        self.assertRegex(self.run_program(__file__, "--compare", str(self.folder / "pieces.npz")), r"^1\d pieces")

    def test_it_is_loaded_in_no_time(self):
        said = self.run_program("-c", "import numpy, time; begin = time.process_time(); import surfaceflattening; "
                                "print(time.process_time() - begin)")
        self.assertLess(float(said), 0.5)

    def test_pieces_are_sewn_drawn_and_graded(self):
        self.run_program("-c", """
import os, pathlib, sys
sys.modules["vtkmodules"] = None
import numpy as np
import surfaceflattening as sf
folder = pathlib.Path(os.environ["PYTHONPATH"])
points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]])
(folder / "a.obj").write_text("# units: cm\\n" + "".join(f"v {x} {y} {z}\\n" for x, y, z in points) + "f 1 2 3\\nf 1 3 4\\n"
                              "g dart left\\nl 1 3\\n")
(folder / "c.txt").write_text("key fold 0 2")
surface = sf.load_surface(folder / "a.obj")
assert (surface.points == points).all() and surface.triangles.tolist() == [[0, 1, 2], [0, 2, 3]] and surface.unit == "cm"
assert [(curve.type, curve.name) for curve in surface.curves] == [("dart", "left")]
curves = sf.load_curves(folder / "c.txt", surface.points, surface.triangles)
assert [(curve.type, curve.name) for curve in curves] == [("key", "fold")]
small, large = (sf.flatten(size * points, surface.triangles, [sf.Curve([0, 2], "key", "fold")]) for size in (1, 2))
assert sf.resew(small).distance.max() < 1e-6
for ending in ("svg", "dxf", "plt", "json", "csv"):
    small.write_pattern(str(folder / f"a.{ending}"), unit="cm", allowance=0)
    assert (folder / f"a.{ending}").stat().st_size > 10
grading = sf.grade({"S": small, "L": large}, base="S")
grading.write_rules(folder / "rules.csv")
assert len(grading.rules) == (folder / "rules.csv").read_text().count("\\n") - 1
garment = sf.read_garmentcode(folder / "a.json")
assert len(garment.panels) == 1 and len(garment.panels[0].edges) >= 4
for call, words in ((lambda: small.write_pattern("a.svg", quantity=0), "quantity"), (lambda: sf.load_surface("no.obj"), "no.obj"),
                    (lambda: sf.resew(small, material="stone"), "material")):
    try:
        call()
    except sf.FlatteningError as error:
        assert words in str(error), error
    else:
        raise AssertionError(words)
""")

    def test_meshes_of_any_vtk_are_flattened(self):
        if not importlib.util.find_spec("vtkmodules"):
            self.skipTest("there is no VTK")
        self.run_program("-c", """
import sys
import numpy as np
import surfaceflattening as sf
from vtkmodules.util.numpy_support import numpy_to_vtk
points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]])
mesh = sf.make_surface(points, [4, 0, 1, 2, 3])
weights = numpy_to_vtk(np.array([2], np.float32), deep=True)
weights.SetName("Weight")
mesh.GetCellData().AddArray(weights)
curves = sf.make_curves([sf.Curve([0, 2], "dart", "left")], points)
of_mesh, of_arrays = sf.flatten_polydata(mesh, curves), sf.flatten(points, [4, 0, 1, 2, 3], [sf.Curve([0, 2], "dart", "left")])
assert (of_mesh.positions == of_arrays.positions).all()
assert of_mesh.cell_arrays["Weight"].dtype == np.float32 and set(of_mesh.cell_arrays["Weight"]) == {2}
assert of_mesh.to_polydata("wires").GetCellData().GetAbstractArray("CurveName").GetValue(0) == of_mesh.wires[0].name
assert sf.suggest_polydata(mesh, bound=0.5, weights="Weight").bound_met
assert sf.make_flattenable_polydata(mesh, bound=0.5).bound_met
assert not [name for name in sys.modules if name.startswith("surfaceflattening.vtk")]
""")

    def test_what_needs_vtk_is_named_with_a_remedy(self):
        self.run_program("-c", """
import sys
sys.modules["vtkmodules"] = None
import surfaceflattening as sf
from surfaceflattening import *
points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
result = flatten(points, [[0, 1, 2]])
for call, words in ((lambda: sf.vtkWireWarpingFilter, "with VTK"), (lambda: sf.flatten_polydata(None), "pip install vtk"),
                    (lambda: sf.make_surface(points, [[0, 1, 2]]), "pip install vtk"), (result.to_polydata, "pip install vtk")):
    try:
        call()
    except (AttributeError, ImportError) as error:
        assert words in str(error), error
    else:
        raise AssertionError(call)
try:
    sf.no_such
except AttributeError as error:
    assert "no_such" in str(error)
""")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--write"]:
        write_pieces(*sys.argv[2:])
    elif sys.argv[1:2] == ["--compare"]:
        compare_pieces(sys.argv[2])
    else:
        unittest.main()
