# SPDX-License-Identifier: BSD-3-Clause
"""Threads and processes flatten at the same time, and each gets what one alone would."""

import concurrent.futures
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import surfaceflattening as sf
from surfaces import command, flattened, grid, quarter_sphere, read

NAMES = ("pants_front", "tshirt", "shirt_front", "quarter_sphere")


def curved_grid(size):
    points, triangles = grid(size, size)
    points[:, 2] = np.sin(points[:, 0] / 9) * np.sin(points[:, 1] / 9)
    return points, triangles


def run(program, **environment):
    """In a process of its own, which has no screen."""
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, timeout=120,
                          env={**os.environ, "DISPLAY": "", **environment})


class Threads(unittest.TestCase):
    def test_each_gets_what_one_alone_gets(self):
        alone = {name: flattened(name) for name in NAMES}
        surface, curves = read("tshirt"), read("tshirt_curves")
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            names = NAMES * 4
            refused = [pool.submit(sf.flatten, *command.TETRAHEDRON) for _ in range(4)]
            of_one = [pool.submit(sf.flatten_polydata, surface, curves) for _ in range(8)]
            for name, result in zip(names, pool.map(flattened, names)):
                self.assertTrue(result == alone[name], name)
            for run in of_one:  # all read the same surface
                self.assertTrue(run.result() == alone["tshirt"])
            for run in refused:
                self.assertEqual(run.exception().name, "ClosedSurface")

    def test_what_progress_raises_ends_its_own_run_alone(self):
        points, triangles, arc = quarter_sphere()
        seen = []

        def stop(fraction):
            seen.append(threading.current_thread())
            raise InterruptedError

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            stopped = pool.submit(sf.flatten, points, triangles, [arc], progress=stop)
            other = pool.submit(sf.flatten, points, triangles, [arc])
            self.assertIsInstance(stopped.exception(), InterruptedError)
            self.assertEqual(other.result().report["status"], "Ok")
        self.assertEqual(len(seen), 1)
        self.assertIsNot(seen[0], threading.main_thread())

    def test_an_interrupt_ends_a_run_that_calls_nothing(self):
        points, triangles = curved_grid(120)
        timer = threading.Timer(0.2, signal.raise_signal, (signal.SIGINT,))
        began = time.monotonic()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            sf.make_flattenable(points, triangles, bound=1e-6)
        self.assertLess(time.monotonic() - began, 5.0)

    def test_another_thread_goes_on_beside_a_run(self):
        beats = 0
        with concurrent.futures.ThreadPoolExecutor(1) as pool:
            run = pool.submit(sf.flatten, *curved_grid(60))
            while not run.done():
                beats += 1
                time.sleep(1e-4)
        self.assertGreater(beats, 5)


class Processes(unittest.TestCase):
    def test_without_numpy_it_is_named(self):
        ended = run("import sys; sys.modules['numpy'] = None; import surfaceflattening")
        self.assertEqual(ended.returncode, 1)
        self.assertRegex(ended.stderr.splitlines()[-1], "^(ModuleNotFound|Import)Error: .*numpy")

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
