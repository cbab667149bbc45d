# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy finds nothing in the sources of the build.

Usage: CheckTidy.py <clang-tidy> <build directory>

A file that passed is not looked at again until it, a header of ours that it includes, its compile
command or .clang-tidy changes. Files of one target are looked at several at a time, one after the other in
one source, since the headers of Eigen and VTK cost more than what is ours; where that source is not clean,
or is none because two files name something of their own alike, each is looked at alone.
"""

import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import sys

from CompileCommands import Passed, commands_of, options_of
from Sources import ROOT, read

CLANG_TIDY, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
FOLDERS = ("Filters/", "IO/", "Interaction/", "Applications/", "Examples/")
TOGETHER = 8  # files in one source


def run_tidy(source, options):
    result = subprocess.run(
        [CLANG_TIDY, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", str(source), "--", *options],
        capture_output=True, text=True, check=False)
    return result.returncode == 0, result.stdout + ("" if result.stdout else result.stderr)


def names_declared(text):
    """What a file declares in a namespace, where two files may name alike what is only theirs."""
    found = set()
    for line in re.findall(r"^[A-Za-z#].*(?<!\);)$", text, re.MULTILINE):
        match = (re.match(r"#\s*define\s+(\w+)", line) or re.match(r"(?:struct|class|enum class|enum|using)\s+(\w+)", line)
                 or re.match(r"[^(=]*?(?<!::)\b(~?\w+)\s*[(={\[;]", line))
        if match:
            found.add(match[1])
    return found - {"namespace"}


def batches(names):
    """The files in lists of few, with one set of options and no name twice."""
    made = []
    for name in names:
        options, declared = options_of(commands[name]), names_declared(read(name))
        for batch in made:
            if batch[0] == options and len(batch[2]) < TOGETHER and not batch[1] & declared:
                batch[1].update(declared)
                batch[2].append(name)
                break
        else:
            made.append((options, declared, [name]))
    return [(options, members) for options, _, members in made]


def joined(members):
    """The files one after the other; what an earlier one includes is not included again."""
    lines, included = [], set()
    for name in members:
        mine = set()
        for line in read(name).splitlines():
            match = re.match(r"\s*#\s*include\s*(\S+)", line)
            if match and match[1] in included:
                continue
            if match:
                mine.add(match[1])
            lines.append(line)
        included |= mine
    return "\n".join(lines) + "\n"


def check_alone(name):
    stamp = known.stamp(name, commands[name])  # of what is looked at, should it change meanwhile
    passed, output = run_tidy(ROOT / name, options_of(commands[name]))
    if passed:
        stamp.touch()
    return name, passed, output


def check(batch):
    options, members = batch
    if len(members) > 1:
        stamps = [known.stamp(name, commands[name]) for name in members]
        source = known.folder / (hashlib.sha256(" ".join(members).encode()).hexdigest()[:16] + ".cxx")
        source.write_text(joined(members), encoding="utf-8")
        folders = sorted({f"-iquote{(ROOT / name).parent}" for name in members})
        passed, _ = run_tidy(source, [*options, *folders])
        source.unlink()
        if passed:
            for stamp in stamps:
                stamp.touch()
            return [(name, True, "") for name in members]
    return [check_alone(name) for name in members]


VERSION = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, text=True, check=True).stdout
known = Passed(BUILD / "tidy", VERSION + read(".clang-tidy"), FOLDERS)
commands = commands_of(BUILD, *FOLDERS)
if not commands:
    sys.exit("No source found in compile_commands.json: the check would be empty.")

waiting = [name for name, command in commands.items() if not known.stamp(name, command).exists()]
failed = []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for found in pool.map(check, batches(waiting)):
        for name, passed, output in found:
            if not passed:
                failed.append(name)
                print(output)
print(f"{len(commands)} files, {len(waiting)} of them looked at, {len(failed)} with findings")
sys.exit(bool(failed))
