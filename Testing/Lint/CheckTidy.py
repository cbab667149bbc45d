# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy finds nothing in the sources of the build.

Usage: CheckTidy.py <clang-tidy> <build directory>

A file that passed is not looked at again until it, a header of ours that it includes, its compile
command or .clang-tidy changes.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

from Sources import ROOT, cxx_files, read

CLANG_TIDY, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDERS = ("Filters/", "Interaction/", "Applications/", "Examples/")
CACHE = BUILD / "tidy"

headers = {pathlib.PurePath(name).name: name for name in cxx_files(*FOLDERS) if name.endswith(".h")}


def with_headers(name):
    """The file and all our headers that it includes, directly or not."""
    found, waiting = set(), [name]
    while waiting:
        current = waiting.pop()
        if current in found:
            continue
        found.add(current)
        for include in re.findall(r'^\s*#\s*include\s*"([^"]+)"', read(current), re.MULTILINE):
            header = headers.get(pathlib.PurePath(include).name)
            if header:
                waiting.append(header)
    return sorted(found)


def key(name, command):
    digest = hashlib.sha256()
    digest.update(VERSION.encode())
    digest.update(command.encode())
    for part in [".clang-tidy", *with_headers(name)]:
        digest.update(read(part).encode())
    return digest.hexdigest()


def check(name, command):
    stamp = CACHE / key(name, command)
    if stamp.exists():
        return True, ""
    result = subprocess.run(
        [CLANG_TIDY, "--quiet", "-p", str(BUILD), str(ROOT / name)],
        capture_output=True, text=True, check=False)
    if result.returncode == 0:
        stamp.touch()
    return result.returncode == 0, result.stdout + ("" if result.stdout else result.stderr)


VERSION = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, text=True, check=True).stdout
CACHE.mkdir(exist_ok=True)
tracked = set(cxx_files(*FOLDERS))
commands = {}
for entry in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8")):
    path = pathlib.Path(entry["directory"], entry["file"]).resolve()
    if ROOT in path.parents and str(path.relative_to(ROOT)) in tracked:
        commands[str(path.relative_to(ROOT))] = entry["command"]
if not commands:
    sys.exit("No source found in compile_commands.json: the check would be empty.")

failed = []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for name, (passed, output) in zip(commands, pool.map(check, commands, commands.values())):
        if not passed:
            failed.append(name)
            print(output)
print(f"{len(commands)} files, {len(failed)} with findings")
sys.exit(bool(failed))
