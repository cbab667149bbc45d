# SPDX-License-Identifier: BSD-3-Clause
"""Every source of the product includes what it uses: it compiles without headers that were read once for many.

Usage: CheckIncludes.py <build directory>

A file that passed is not compiled again until it, a header of ours that it includes or its options change.
"""

import concurrent.futures
import os
import pathlib
import sys

from CompileCommands import Passed, commands_of, compiled
from Sources import ROOT

BUILD = pathlib.Path(sys.argv[1])
FOLDERS = ("Filters/", "IO/", "Figures/", "Applications/")


def check(name):
    stamp = known.stamp(name, commands[name])
    result = compiled(ROOT / name, commands[name], BUILD)
    if result.returncode == 0:
        stamp.touch()
    return name, result.returncode == 0, result.stderr


known = Passed(BUILD / "includes", "", FOLDERS)
commands = {name: command for name, command in commands_of(BUILD, *FOLDERS).items() if "cmake_pch.hxx" in command}
waiting = [name for name, command in commands.items() if not known.stamp(name, command).exists()]
failed = []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for file_name, passed, said in pool.map(check, waiting):
        if not passed:
            failed.append(file_name)
            print(said)
print(f"{len(commands)} files, {len(waiting)} of them compiled, {len(failed)} without what they use")
sys.exit(bool(failed))
