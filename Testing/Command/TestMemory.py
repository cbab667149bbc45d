# SPDX-License-Identifier: BSD-3-Clause
"""Memory that runs out, wherever it does, is a refusal of its own that leaves nothing half written."""

import math
import os
import resource

import command

MEGABYTE = 1 << 20


class Memory(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write("bump.obj", command.obj(*command.grid(
            120, 120, lambda x, y: (x, y, 10 * math.sin(x / 40) * math.sin(y / 30)))))

    def run_within(self, megabytes, *arguments):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (megabytes * MEGABYTE,) * 2)
        return self.run_command(*arguments, preexec_fn=limit)

    def test_every_limit_between_none_and_enough_is_told(self):
        least = 64
        while self.run_within(least, "--version").returncode != 0:
            least += 16  # the libraries alone want so much
        for options in ((), ("--paper-method", "--solver", "sequential")):
            with self.subTest(options):
                refused = 0
                for megabytes in range(least, least + 2000, 2):
                    # An earlier result must not be taken for that of a run that failed.
                    os.makedirs(self.path("out"), exist_ok=True)
                    self.write("out/flat.vtp", "earlier")
                    run = self.run_within(megabytes, "bump.obj", *options, "--output", "out")
                    if run.returncode != 3:
                        break
                    refused += 1
                    with self.subTest(megabytes):
                        self.assertIn("memory ran out", command.error_lines(run)[0])
                        self.assertEqual(os.listdir(self.path("out")), ["report.json"])
                        self.assertEqual(self.report("out")["status"], "OutOfMemory")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertGreater(refused, 5)
                self.assertEqual(self.report("out")["status"], "Ok")


if __name__ == "__main__":
    command.main()
