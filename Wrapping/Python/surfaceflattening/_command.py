# SPDX-License-Identifier: BSD-3-Clause
"""The command wirewarp of a package without VTK: a function of the extension, which has the algorithms already; under
Windows a program beside it, since names of files are UTF-8 in a program that says so alone."""

import os
import signal
import subprocess
import sys


def main() -> None:
    program = os.path.join(os.path.dirname(__file__), "wirewarp.exe")
    if os.path.exists(program):
        sys.exit(subprocess.call([program, *sys.argv[1:]]))
    for name in ("SIGINT", "SIGPIPE"):  # as in a program that is not Python's
        signal.signal(getattr(signal, name), signal.SIG_DFL)
    from . import _core
    _core.run_command([os.fsencode(word) for word in sys.argv])
