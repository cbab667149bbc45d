# SPDX-License-Identifier: BSD-3-Clause
"""Memory that runs out is raised; the interpreter lives on."""

import contextlib
import ctypes
import os
import resource
import unittest
import warnings

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools

import surfaceflattening as sf
from surfaces import command, grid

ENOUGH, RAISED, OTHER = 0, 10, 11
M_MMAP_THRESHOLD = -3


def setUpModule():
    # Blocks of this size go back to the system when they are freed; otherwise the C library raises the limit as it goes,
    # and a child would work in what earlier tests have left between other blocks, which no limit of memory counts.
    ctypes.CDLL(None).mallopt(M_MMAP_THRESHOLD, 1 << 16)


def used():
    """Bytes of addresses, and of memory."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return [int(pages) * resource.getpagesize() for pages in file.read().split()[:2]]


def take_what_is_free():
    """What earlier work has given back to the process but not to the system.

    Not for flattening: with all of it taken there are limits at which the stack cannot grow by the 128 KB that Eigen's
    products of matrices may take there, and that ends the process.
    """
    taken = []
    for size in (1 << 20, 1 << 16, 1 << 12):
        with contextlib.suppress(MemoryError):
            while True:
                taken.append(bytes(size))
    return taken


def run_with(bytes_, run, full):
    """Exit code of a child that runs with so much more memory than it has, or than is in use."""
    child = os.fork()
    if child == 0:
        code = OTHER
        try:
            ctypes.CDLL(None).malloc_trim(0)  # what earlier tests have given back to the process goes to the system
            limit, _ = used()
            resource.setrlimit(resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
            taken = take_what_is_free() if full else []
            resource.setrlimit(resource.RLIMIT_AS, (limit + bytes_, resource.RLIM_INFINITY))
            run()
            code = ENOUGH
        except MemoryError:
            code = RAISED
        except sf.FlatteningError as error:
            code = RAISED if error.name == "OutOfMemory" else OTHER
        finally:
            os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


class Memory(command.CommandTest):
    def setUp(self):
        super().setUp()
        # A thread for whose own data there is no memory ends the process in the C library.
        vtkSMPTools.SetBackend("Sequential")
        processors = os.sched_getaffinity(0)
        os.sched_setaffinity(0, {min(processors)})  # one thread, without memory of its own
        self.addCleanup(os.sched_setaffinity, 0, processors)

        self.points, self.triangles = grid(120, 120)
        self.points[:, 2] = 10 * np.sin(self.points[:, 0] / 40) * np.sin(self.points[:, 1] / 30)

    def raised_up_to_enough(self, step, run, full=False, least=10):
        codes = []
        while not codes or (codes[-1] != ENOUGH and len(codes) < 300):
            codes.append(run_with(step * len(codes), run, full))
        self.assertEqual(codes[-1], ENOUGH)
        self.assertEqual(set(codes[:-1]), {RAISED}, codes)
        self.assertGreater(len(codes), least)

    def test_every_limit_between_none_and_enough_is_raised(self):
        self.raised_up_to_enough(1 << 20, lambda: sf.flatten(self.points, self.triangles))

    def test_a_triangle_is_sewn_in_six_and_a_half_kilobytes(self):
        flattening = sf.flatten(self.points, self.triangles)

        def sew():
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", sf.FlatteningWarning)  # one iteration takes what all take
                sf.resew(flattening, max_iterations=1, second_start=False)

        sew()  # what the first run alone takes, such as code that is loaded
        self.assertEqual(run_with(6500 * len(self.triangles), sew, True), ENOUGH)

    def test_a_thousand_calls_leave_nothing(self):
        points, triangles = grid(6, 4)
        points[:, 2] = 0.1 * points[:, 0] * points[:, 1]
        for calls in (200, 1000):  # what is kept for later calls is taken in the first ones
            before = used()[1]
            for _ in range(calls):
                sf.flatten(points, triangles, [sf.Curve([0, 1, 2], "key", "hem")])
        self.assertLess(used()[1] - before, 1 << 20)

    def test_the_pattern_of_a_result_as_well(self):
        result = sf.flatten(self.points, self.triangles, scheme="global")
        # With smooth borders, as while flattening, Eigen's products may need the stack.
        for kind in ("svg", "pdf", "dxf"):
            with self.subTest(kind):
                self.raised_up_to_enough(1 << 20, lambda: result.write_pattern(
                    self.path("pattern." + kind), unit="mm", paper="A0", fair=0), full=True, least=3)


if __name__ == "__main__":
    unittest.main()
