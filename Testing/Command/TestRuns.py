# SPDX-License-Identifier: BSD-3-Clause
"""Runs beside each other and runs that are ended: no mixed results, no process left."""

import contextlib
import fcntl
import glob
import os
import signal
import subprocess
import time

import command

SECONDS = 60  # for what takes an instant on an idle machine


def state_and_parent(process):
    """As /proc tells them; X and 0 of a process that is gone."""
    with contextlib.suppress(OSError), open(f"/proc/{process}/stat", encoding="utf-8", errors="replace") as file:
        state, parent = file.read().rsplit(")", 1)[1].split()[:2]
        return state, int(parent)
    return "X", 0


def children(process):
    """Ids of the processes below one."""
    found = [int(name) for name in os.listdir("/proc") if name.isdigit() and state_and_parent(name)[1] == process]
    return [id_ for child in found for id_ in (child, *children(child))]


def has_open(process, path):
    for place in glob.glob(f"/proc/{process}/fd/*"):
        with contextlib.suppress(OSError):
            if os.readlink(place) == path:
                return True
    return False


def is_alive(process):
    return state_and_parent(process)[0] not in "ZX"


def wait_until(condition):
    deadline = time.monotonic() + SECONDS
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.01)
    return condition()


class Runs(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("good.obj", command.obj(*command.sheet()))
        # VTK's reader is busy with it for seconds.
        self.write("slow.vtk", command.legacy(*command.sheet()) + "FIELD f 1\nn 1 200000000 string\n")

    def start(self, *arguments):
        process = subprocess.Popen([command.EXECUTABLE, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def are_busy(self, processes):
        """Whether each one reads the slow file or waits for one that does. Stopped before that, one that has just been forked
        has not yet tied its life to its parent's."""
        slow = os.path.realpath(self.path("slow.vtk"))
        return all(children(process) or has_open(process, slow) for process in processes)

    def end(self, process, signal_number, count):
        """Ends a run once so many processes below it are busy; all of them must be gone with it."""
        below = []

        def are_there():
            below[:] = children(process.pid)
            return len(below) >= count and self.are_busy(below)

        self.assertTrue(wait_until(are_there), "has no processes")
        for child in below:
            os.kill(child, signal.SIGSTOP)  # so that none ends by itself
        process.send_signal(signal_number)
        process.wait()
        left = lambda: [child for child in below if is_alive(child)]
        gone = wait_until(lambda: not left())
        for child in left():
            os.kill(child, signal.SIGKILL)
        self.assertTrue(gone, "processes are left")

    def test_a_run_that_is_ended_ends_its_workers_and_readers(self):
        self.write("list.txt", "slow.vtk\nslow.vtk\n")
        for signals, count, *arguments in (
                ((signal.SIGTERM, signal.SIGKILL, signal.SIGINT, signal.SIGHUP), 4, "batch", "list.txt", "--threads", "2"),
                ((signal.SIGTERM, signal.SIGKILL), 1, "slow.vtk")):
            for signal_number in signals:
                with self.subTest(signal_number, arguments=arguments):
                    self.end(self.start(*arguments, "--output", "out"), signal_number, count)

    def test_a_reader_leaves_no_process_behind(self):
        self.write("fine.vtp", command.xml_polydata(*command.sheet()))
        self.write("list.txt", "fine.vtp\n" * 5 + "slow.vtk\n")
        run = self.start("batch", "list.txt", "--output", "out", "--threads", "1")
        self.assertTrue(wait_until(lambda: os.path.exists(self.path("out/fine_5/report.json"))))
        self.assertTrue(wait_until(lambda: len(children(run.pid)) == 2))  # worker and reader, no zombie
        self.end(run, signal.SIGKILL, 2)

    def test_a_second_run_into_one_folder_is_refused_and_changes_nothing(self):
        self.write("list.txt", "good.obj\n")
        self.write("slow_list.txt", "slow.vtk\n")
        for first, second in ((("slow.vtk",), ("good.obj",)), (("batch", "slow_list.txt"), ("batch", "list.txt")),
                              (("batch", "slow_list.txt"), ("good.obj",))):
            with self.subTest(first=first, second=second):
                run = self.start(*first, "--output", "out")
                reading = 1 if first[0] != "batch" else 2  # its reader; a worker and that one's reader
                self.assertTrue(wait_until(lambda: len(children(run.pid)) >= reading))
                before = sorted(os.listdir(self.path("out")))
                self.assert_stderr(("out: another run is writing to this folder", "--output"), *second, "--output", "out")
                self.assertEqual(sorted(os.listdir(self.path("out"))), before)
                run.kill()
                run.wait()
                # An ended run holds the folder no longer than its processes live.
                self.assertTrue(wait_until(lambda: not self.is_locked("out")))
                self.assertEqual(self.flatten("good.obj")["status"], "Ok")

    def is_locked(self, folder):
        descriptor = os.open(self.path(folder), os.O_RDONLY)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return False
        except BlockingIOError:
            return True
        finally:
            os.close(descriptor)

    def test_many_runs_at_once_leave_the_whole_result_of_one(self):
        names = [self.write(f"sheet{rows}.obj", command.obj(*command.sheet(4, rows))) for rows in range(3, 9)]
        for _ in range(5):
            runs = [self.start(name, "--output", "out") for name in names]
            codes = [run.wait() for run in runs]
            self.assertLessEqual(set(codes), {0, 3})
            self.assertIn(0, codes)
            self.assertEqual(
                sorted(os.listdir(self.path("out"))), ["cut.vtp", "flat.vtp", "report.json", "wires.vtp"])
            report = self.report("out")
            self.assertEqual(codes[names.index(report["surface"])], 0)
            for file in ("flat.vtp", "cut.vtp"):
                self.assertEqual(len(self.array("out/" + file, "Points")), 3 * report["pieces"][0]["vertices"])


if __name__ == "__main__":
    command.main()
