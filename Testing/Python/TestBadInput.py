# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with arrays, processes and installations ends in an exception that says so, never in a crash."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import surfaceflattening as sf

POINTS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]])
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]])


def run(program, **environment):
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=120,
                          env={**os.environ, **environment})


class Arrays(unittest.TestCase):
    def test_arrays_of_other_layouts_give_the_same(self):
        expected = sf.flatten(POINTS, TRIANGLES)
        read_only = POINTS.copy()
        read_only.flags.writeable = False
        wide = np.zeros((8, 6))
        wide[::2, ::2] = POINTS
        for points in (np.asfortranarray(POINTS), read_only, wide[::2, ::2], POINTS.astype(np.float32), POINTS.astype(">f8"),
                       np.flip(np.flip(POINTS, 0).copy(), 0), POINTS.tolist()):
            for triangles in (TRIANGLES, TRIANGLES.astype(np.uint8), TRIANGLES.astype(">i4"), np.asfortranarray(TRIANGLES),
                              np.repeat(TRIANGLES, 2, axis=1)[:, ::2]):
                result = sf.flatten(points, triangles)
                self.assertTrue(result == expected)
        self.assertFalse(read_only.flags.writeable)

    def test_arrays_of_other_kinds_are_refused(self):
        for points, triangles, words in (
                (POINTS.astype(complex), TRIANGLES, "points must be real numbers"),
                (POINTS.astype(str), TRIANGLES.astype(str), "triangles must be whole numbers"),
                (POINTS > 0, TRIANGLES, "points must be numbers, not bool"),
                (np.full((4, 3), None), TRIANGLES, "points .* not a finite number"),
                (POINTS.astype("M8[s]"), TRIANGLES, "points must be numbers, not datetime64"),
                (POINTS, TRIANGLES.astype(float), "triangles must be whole numbers"),
                (POINTS, TRIANGLES > 1, "triangles must be whole numbers"),
                (POINTS[:, :2], TRIANGLES, r"points must have the shape \(n, 3\)"),
                (POINTS.ravel(), TRIANGLES, r"points must have the shape \(n, 3\)"),
                (POINTS, TRIANGLES[None], r"triangles must have the shape \(m, 3\)"),
                (POINTS, [[0, 1, 2], [0, 1]], "triangles"),
                (POINTS, 7, "triangles must have the shape")):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                sf.flatten(points, triangles)

    def test_ids_beyond_all_points_are_refused_by_name(self):
        for id_ in (4, -1, 2**31, 2**32, 2**32 + 1, 2**62, -2**63):
            with self.assertRaises(sf.FlatteningError) as caught:
                sf.flatten(POINTS, [[0, 1, 2], [0, 2, id_]])
            self.assertEqual((caught.exception.name, caught.exception.ids), ("InvalidPointId", [1]))
        with self.assertRaisesRegex(ValueError, r"ids are below 2\*\*63"):
            sf.flatten(POINTS, [[0, 1, 2], [0, 2, 2**63]])
        with self.assertRaisesRegex(ValueError, "names point 4"):
            sf.flatten(POINTS, TRIANGLES, [[0, 4]])


class Processes(unittest.TestCase):
    def test_without_numpy_it_is_named(self):
        ended = run("import sys; sys.modules['numpy'] = None; import surfaceflattening")
        self.assertEqual(ended.returncode, 1)
        self.assertRegex(ended.stderr.splitlines()[-1], "^(ModuleNotFound|Import)Error: .*numpy")

    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork")
    def test_a_fork_after_threads_flattens(self):
        ended = run("""
import os
import numpy as np
import surfaceflattening as sf
x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, 60), np.linspace(0, 1, 60)))
first = (np.arange(59)[:, None] * 60 + np.arange(59)).ravel()
points, triangles = np.column_stack([x, y, x * x * y]), np.concatenate([
    np.column_stack([first, first + 1, first + 61]), np.column_stack([first, first + 61, first + 60])])
before = sf.flatten(points, triangles)
child = os.fork()
if child == 0:
    os._exit(0 if sf.flatten(points, triangles) == before else 1)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), sf.flatten(points, triangles) == before)
""")
        self.assertEqual(ended.stdout, "0 True\n", ended.stderr)

    def test_an_interrupted_run_ends_and_another_one_begins(self):
        def interrupt(_):
            raise KeyboardInterrupt

        for _ in range(3):
            with self.assertRaises(KeyboardInterrupt):
                sf.flatten(POINTS, TRIANGLES, progress=interrupt)
        self.assertEqual(sf.flatten(POINTS, TRIANGLES).report["status"], "Ok")

    def test_two_versions_in_one_process_work_beside_each_other(self):
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder) / "surfaceflattening"
            shutil.copytree(os.path.dirname(sf.__file__), other, ignore=shutil.ignore_patterns("vtk*", "__pycache__"))
            version = other / "_version.py"
            version.write_text("BUILT_WITH_VTK = BUILT_FOR = ''\n__version__ = '0.0'\n", "utf-8")
            ended = run("""
import os
import sys
import surfaceflattening as first
for name in [name for name in sys.modules if name.split(".")[0] == "surfaceflattening"]:
    del sys.modules[name]
sys.path.insert(0, os.environ["OTHER"])
import surfaceflattening as second
assert first.__version__ != second.__version__ == "0.0" and first._flatten._core is not second._flatten._core
points, triangles = [[0, 0, 0], [1, 0, 0], [1, 1, 1]], [[0, 1, 2]]
assert (first.flatten(points, triangles).positions == second.flatten(points, triangles).positions).all()
sizes = [{size: sf.flatten(points, triangles) for size in "AB"} for sf in (first, second)]
print(len(first.grade(sizes[0]).rules), len(second.grade(sizes[1]).rules))
try:
    first.resew(sizes[1]["A"])
except first.FlatteningError as error:
    print(error)
""", OTHER=folder)
        self.assertRegex(ended.stdout, "^3 3\nflattening is Flattening; it must be what flatten", ended.stderr)


if __name__ == "__main__":
    unittest.main()
