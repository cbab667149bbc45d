# SPDX-License-Identifier: BSD-3-Clause
"""Memory that runs out is raised; the interpreter lives on."""

import os
import resource
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools

import surfaceflattening as sf
from surfaces import grid

ENOUGH, RAISED, OTHER = 0, 10, 11


def held():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[0]) * resource.getpagesize()


def flatten_with(megabytes, points, triangles):
    """Exit code of a child that flattens with so much more memory than it has."""
    child = os.fork()
    if child == 0:
        code = OTHER
        try:
            limit = held() + (megabytes << 20)
            resource.setrlimit(resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
            sf.flatten(points, triangles)
            code = ENOUGH
        except MemoryError:
            code = RAISED
        except sf.FlatteningError as error:
            code = RAISED if error.name == "OutOfMemory" else OTHER
        finally:
            os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


class Memory(unittest.TestCase):
    def setUp(self):
        # A thread for whose own data there is no memory ends the process in the C library.
        vtkSMPTools.SetBackend("Sequential")

    def test_every_limit_between_none_and_enough_is_raised(self):
        points, triangles = grid(120, 120)
        points[:, 2] = 10 * np.sin(points[:, 0] / 40) * np.sin(points[:, 1] / 30)
        codes = []
        while not codes or (codes[-1] != ENOUGH and len(codes) < 300):
            codes.append(flatten_with(2 * len(codes), points, triangles))
        self.assertEqual(codes[-1], ENOUGH)
        self.assertEqual(set(codes[:-1]), {RAISED}, codes)
        self.assertGreater(len(codes), 10)


if __name__ == "__main__":
    unittest.main()
