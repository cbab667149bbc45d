#!/usr/bin/python3
"""The pieces of Data/ are what their generator writes.

Usage: TestDataGenerator.py SOURCE_FOLDER
"""
import glob
import os
import subprocess
import sys
import tempfile

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

# Triangle counts: the paper's Table 1 where it has the piece (within 5 %), else our own.
TRIANGLES = {
    "quarter_sphere": 56,
    "shirt_front": 1414,
    "shirt_back": 1234,
    "shirt_shoulder": 182,
    "pants_front": 1729,
    "pants_back": 1729,
    "wetsuit_upper_front": 658,
    "wetsuit_upper_back": 928,
    "wetsuit_pants_front": 1729,
    "wetsuit_pants_back": 1729,
    "shoe_upper": 1500,
    "cylinder": 960,
    "cone": 672,
    "tangent_developable": 900,
    "tshirt": 3448,
}
DEVELOPABLES = ("cylinder", "cone", "tangent_developable")
failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)
        print("FAILED:", message)


def read(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def pointsOf(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def connectivity(cells):
    return [vtk_to_numpy(a) for a in (cells.GetOffsetsArray(), cells.GetConnectivityArray())]


def sameAsCommitted(fresh, committed, name):
    a, b = read(fresh), read(committed)
    x, y = pointsOf(a), pointsOf(b)
    expect(y.dtype == np.float64, f"{name}: points are double")
    if x.shape != y.shape:
        expect(False, f"{name}: {len(x)} points generated, {len(y)} committed")
        return
    size = np.ptp(y, axis=0).max()
    expect(np.abs(x - y).max() <= 1e-9 * size, f"{name}: coordinates differ by {np.abs(x - y).max()}")
    for mine, theirs in ((a.GetPolys(), b.GetPolys()), (a.GetLines(), b.GetLines())):
        if mine.GetNumberOfCells() != theirs.GetNumberOfCells():
            expect(False, f"{name}: number of cells differs")
        elif mine.GetNumberOfCells():
            same = all(np.array_equal(u, v) for u, v in zip(connectivity(mine), connectivity(theirs)))
            expect(same, f"{name}: connectivity differs")
    for data in (a.GetPointData(), b.GetPointData()):
        if name[: -len(".vtp")] in DEVELOPABLES:
            expect(data.HasArray("ExactUnrolling"), f"{name}: has ExactUnrolling")


def regenerate(source, folder, names):
    """Run the generator in two processes."""
    script = os.path.join(source, "Data", "Generate", "generate.py")
    runs = [
        subprocess.Popen([sys.executable, script, folder, *part], stdout=subprocess.DEVNULL)
        for part in (names[::2], names[1::2])
    ]
    for run in runs:
        expect(run.wait() == 0, "the generator ran")


def main(source):
    folder = os.path.join(source, "Data")
    committed = sorted(os.path.basename(p) for p in glob.glob(os.path.join(folder, "*.vtp")))
    with tempfile.TemporaryDirectory() as fresh:
        regenerate(source, fresh, list(TRIANGLES))
        expect(committed == sorted(os.listdir(fresh)), "the generator writes exactly the committed files")
        for name in sorted(set(committed) & set(os.listdir(fresh))):
            sameAsCommitted(os.path.join(fresh, name), os.path.join(folder, name), name)
    for name, count in TRIANGLES.items():
        triangles = read(os.path.join(folder, name + ".vtp")).GetNumberOfPolys()
        expect(abs(triangles - count) <= 0.05 * count, f"{name}: {triangles} triangles")
    print("failed" if failures else "passed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
