# SPDX-License-Identifier: BSD-3-Clause
"""Threads and processes flatten at the same time, and each gets what one alone would."""

import concurrent.futures
import multiprocessing
import signal
import threading
import time
import unittest
import warnings

import numpy as np

import surfaceflattening as sf
from surfaces import grid, quarter_sphere, read

NAMES = ("pants_front", "tshirt", "shirt_front", "quarter_sphere")


def flatten(name):
    return sf.flatten_polydata(read(name), read(name + "_curves"))


def curved_grid(size):
    points, triangles = grid(size, size)
    points[:, 2] = np.sin(points[:, 0] / 9) * np.sin(points[:, 1] / 9)
    return points, triangles


def closed():
    return sf.flatten([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                      [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


class Threads(unittest.TestCase):
    def test_each_gets_what_one_alone_gets(self):
        alone = {name: flatten(name) for name in NAMES}
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            names = NAMES * 4
            for name, result in zip(names, pool.map(flatten, names)):
                self.assertTrue(result == alone[name], name)

    def test_one_surface_may_be_read_by_many(self):
        surface, curves = read("tshirt"), read("tshirt_curves")
        alone = sf.flatten_polydata(surface, curves)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for run in [pool.submit(sf.flatten_polydata, surface, curves) for _ in range(8)]:
                self.assertTrue(run.result() == alone)

    def test_refusals_reach_the_thread_that_caused_them(self):
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            good = [pool.submit(flatten, "pants_front") for _ in range(4)]
            bad = [pool.submit(closed) for _ in range(4)]
            for run in bad:
                self.assertEqual(run.exception().name, "ClosedSurface")
            for run in good:
                self.assertEqual(run.result().report["status"], "Ok")

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
        points, triangles = curved_grid(60)
        done, beats = threading.Event(), []

        def beat():
            while not done.is_set():
                beats.append(time.monotonic())
                time.sleep(1e-4)

        heart = threading.Thread(target=beat)
        heart.start()
        try:
            began = time.monotonic()
            sf.flatten(points, triangles)
            ended = time.monotonic()
        finally:
            done.set()
            heart.join()
        self.assertGreater(sum(began < at < ended for at in beats), 2)


class Processes(unittest.TestCase):
    def test_results_and_errors_come_back(self):
        context = multiprocessing.get_context("spawn")
        with concurrent.futures.ProcessPoolExecutor(2, context) as pool:
            runs = {name: pool.submit(flatten, name) for name in NAMES[:2]}
            refused = pool.submit(closed)
            for name, run in runs.items():
                self.assertTrue(run.result() == flatten(name))
            self.assertEqual(refused.exception().name, "ClosedSurface")

    def test_warnings_are_given_where_the_call_is(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            flatten("wetsuit_upper_front")
        self.assertEqual(caught[0].filename, __file__)


if __name__ == "__main__":
    unittest.main()
