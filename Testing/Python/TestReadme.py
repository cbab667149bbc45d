# SPDX-License-Identifier: BSD-3-Clause
"""What the README tells Python users works as it stands there, and help() can be read."""

import contextlib
import inspect
import io
import os
import re
import textwrap
import typing
import unittest

import surfaceflattening as sf
from surfaces import SOURCE


def python_block():
    with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
        section = re.search(r"^### Python\n(.*?)^##", file.read(), re.DOTALL | re.MULTILINE).group(1)
    blocks = re.findall(r"(?:^(?: {4}.*)?\n)+", section, re.MULTILINE)
    return textwrap.dedent(next(block for block in blocks if "import" in block))


class Readme(unittest.TestCase):
    def test_its_program_keeps_the_lengths_that_it_prints(self):
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(python_block(), "README.md", "exec"), names)  # pylint: disable=exec-used
        report = names["result"].report
        self.assertEqual(report["status"], "Ok")
        (curve,) = report["curves"]
        self.assertEqual(curve["name"], "middle")
        self.assertAlmostEqual(curve["length_2d"], curve["length_3d"], delta=1e-12)
        self.assertIn("middle", printed.getvalue())

    def test_hints_are_short_in_help_and_can_be_evaluated(self):
        self.assertLess(len(str(inspect.signature(sf.flatten))), 1000)
        hints = typing.get_type_hints(sf.flatten)
        self.assertIs(hints["return"], sf.Flattening)
        self.assertEqual(set(hints) - {"return"}, set(inspect.signature(sf.flatten).parameters))


if __name__ == "__main__":
    unittest.main(verbosity=2)
