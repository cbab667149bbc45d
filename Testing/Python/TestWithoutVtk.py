# SPDX-License-Identifier: BSD-3-Clause
"""The package without VTK, as pip installs it, gives what the filters give; what it lacks it names.

Usage: TestWithoutVtk.py, or TestWithoutVtk.py --write FILE to keep pieces of Data with the filters' results, and
TestWithoutVtk.py --compare FILE, which needs numpy alone, to compare an installed package with them."""

import os
import pathlib
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


def write_pieces(path):
    """Surfaces and curves of Data as arrays, and what the filters make of them."""
    import surfaceflattening as sf
    from surfaces import DATA, points_of, polylines_of, read, triangles_of
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = {}
    for file in sorted(pathlib.Path(DATA).glob("*_curves.vtp")):
        name = file.stem[:-len("_curves")]
        surface, lines = read(name), read(file.stem)
        cells = lines.GetCellData()
        names = cells.GetAbstractArray("CurveName")
        chains = polylines_of(lines)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sf.FlatteningWarning)
            result = sf.flatten_polydata(surface, lines)
        arrays.update({
            f"{name}/points": points_of(surface), f"{name}/triangles": triangles_of(surface),
            f"{name}/curve_points": points_of(lines), f"{name}/chains": np.concatenate(chains),
            f"{name}/ends": np.cumsum([0] + [len(chain) for chain in chains]),
            f"{name}/types": vtk_to_numpy(cells.GetArray("CurveType")),
            f"{name}/shapes": vtk_to_numpy(cells.GetArray("KeyShape")) if cells.GetArray("KeyShape") else
                np.zeros(len(chains), int),
            f"{name}/names": np.array([names.GetValue(k) for k in range(len(chains))]),
            f"{name}/positions": result.positions, f"{name}/status": np.array(result.report["status"]),
            f"{name}/E_area": np.array([piece["E_area"] for piece in result.report["pieces"]])})
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
        version.write_text(version.read_text("utf-8").replace(f'BUILT_WITH_VTK = "{sf.vtk.BUILT_WITH_VTK}"',
                                                              'BUILT_WITH_VTK = ""'), "utf-8")

    def run_program(self, *words):
        run = subprocess.run([sys.executable, *words], capture_output=True, text=True, check=False,
                             env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_pieces_are_flattened_as_by_the_filters(self):
        write_pieces(self.folder / "pieces.npz")
        self.assertRegex(self.run_program(__file__, "--compare", str(self.folder / "pieces.npz")), r"^1\d pieces")

    def test_it_is_loaded_in_no_time(self):
        said = self.run_program("-c", "import numpy, time; begin = time.perf_counter(); import surfaceflattening; "
                                "print(time.perf_counter() - begin)")
        self.assertLess(float(said), 0.5)

    def test_what_needs_vtk_is_named_with_a_remedy(self):
        self.run_program("-c", """
import sys
sys.modules["vtkmodules"] = None
import surfaceflattening as sf
from surfaceflattening import *
assert "resew" not in sf.__all__ and not hasattr(sf, "resew")
result = flatten([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
for call in (lambda: sf.resew, lambda: sf.read_surface, lambda: result.write_pattern("a.svg")):
    try:
        call()
    except (AttributeError, ImportError) as error:
        assert "with VTK" in str(error), error
    else:
        raise AssertionError(call)
try:
    sf.no_such
except AttributeError as error:
    assert "no_such" in str(error)
""")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--write"]:
        write_pieces(sys.argv[2])
    elif sys.argv[1:2] == ["--compare"]:
        compare_pieces(sys.argv[2])
    else:
        unittest.main()
