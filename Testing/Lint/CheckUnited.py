# SPDX-License-Identifier: BSD-3-Clause
"""The sources of a folder can be compiled as one: no two name alike what is only theirs.

Usage: CheckUnited.py <build directory>

For builds that compile them one by one; where SURFACEFLATTENING_UNITE_SOURCES is on, the build itself tells.
"""

import concurrent.futures
import hashlib
import os
import pathlib
import sys

from CompileCommands import Passed, commands_of, compiled, options_of
from Sources import ROOT

BUILD = pathlib.Path(sys.argv[1]).resolve()
FOLDERS = ("Filters/", "IO/", "Figures/", "Applications/")
# Headers of X and of JSON define macros and aliases that are theirs alone.
ALONE = {"Display.cxx", "GarmentCodeFile.cxx", "ClothInput.cxx"}


def check(members):
    """What the compiler says of the members as one source; nothing where it finds no fault."""
    # Of all together: two that passed each beside an earlier version of the other may collide.
    digest = hashlib.sha256(" ".join(known.stamp(name, commands[name]).name for name in members).encode()).hexdigest()
    stamp = known.folder / digest
    if stamp.exists():
        return members, ""
    source = known.folder / (digest[:16] + ".cxx")
    source.write_text("".join(f'#include "{ROOT / name}"\n' for name in members), encoding="utf-8")
    result = compiled(source, commands[members[0]], BUILD)
    source.unlink()
    if result.returncode == 0:
        stamp.touch()
    return members, result.stderr


known = Passed(BUILD / "united", "", FOLDERS)
commands = commands_of(BUILD, *FOLDERS)
united = {}
for file_name, command in commands.items():
    path = pathlib.PurePath(file_name)
    if path.name not in ALONE:
        united.setdefault((path.parent, options_of(command)), []).append(file_name)
united = [members for members in united.values() if len(members) > 1]
if not united:
    sys.exit("No source found in compile_commands.json: the check would be empty.")
failed = False
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for tried, said in pool.map(check, united):
        if said:
            failed = True
            print(pathlib.PurePath(tried[0]).parent, "cannot be compiled as one:")
            print("\n".join(line for line in said.splitlines() if "error:" in line))
print(f"{sum(map(len, united))} files in {len(united)} sources")
sys.exit(failed)
