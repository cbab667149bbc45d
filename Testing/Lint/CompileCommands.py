# SPDX-License-Identifier: BSD-3-Clause
"""The compile commands of a build, for the checks of this folder that compile."""

import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess

from Sources import ROOT, cxx_files, read


def compiler_of(command):
    """The compiler of a compile command, without what starts it."""
    words = shlex.split(command)
    return words[next(k for k, word in enumerate(words) if word.startswith("-")) - 1]


def options_of(command):
    """A compile command without the compiler, its launcher, the names of the file and its object, headers
    that were read once for many, and what gcc alone knows."""
    words = shlex.split(command)
    words = words[next(k for k, word in enumerate(words) if word.startswith("-")):]
    precompiled = [k for k, word in enumerate(words) if "cmake_pch.hxx" in word and words[k - 1] == "-include"]
    left_out = {k for k, word in enumerate(words) if word in ("-o", "-c", "-MT", "-MF")}
    left_out |= {k + 1 for k in left_out} | set(precompiled) | {k - 1 for k in precompiled}
    return tuple(word for k, word in enumerate(words) if k not in left_out and
                 word not in ("-Winvalid-pch", "-MD", "-Wno-subobject-linkage") and not word.startswith("--param=ggc-"))


def compiled(source, command, build):
    """What the compiler of a command finds in a source without making its object."""
    return subprocess.run([compiler_of(command), *options_of(command), "-fsyntax-only", str(source)], cwd=build,
                          capture_output=True, text=True, check=False)


def reached(source, compiler, options, build):
    """The source and the files that it includes, and those that these include."""
    rule = subprocess.run([compiler, *options, "-M", str(source)], cwd=build, capture_output=True, text=True, check=True)
    return {os.path.normpath(name) for name in rule.stdout.replace("\\\n", " ").split(":", 1)[1].split()}


def sources_of(path):
    """A source, or those that CMake has put into one."""
    if re.fullmatch(r"unity_\w+_cxx\.cxx", path.name):
        included = re.findall(r'^#include "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)
        return [pathlib.Path(name).resolve() for name in included]
    return [path]


def commands_of(build, *folders):
    """The compile command of each source of the folders that the build compiles, by its name."""
    tracked = set(cxx_files(*folders))
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        for path in sources_of(pathlib.Path(entry["directory"], entry["file"]).resolve()):
            if ROOT in path.parents and str(path.relative_to(ROOT)) in tracked:
                commands[str(path.relative_to(ROOT))] = entry["command"]
    return commands


class Passed:
    """Which files passed a check as they are: they, the headers of ours that they include, and their options."""

    def __init__(self, folder, seed, folders):
        self.folder, self.seed = folder, seed
        folder.mkdir(exist_ok=True)
        self.headers = {pathlib.PurePath(name).name: name for name in cxx_files(*folders) if name.endswith(".h")}
        self.read = functools.lru_cache(maxsize=None)(read)

    def stamp(self, name, command):
        """The file that is there if the source passed."""
        digest = hashlib.sha256(self.seed.encode())
        digest.update(" ".join(options_of(command)).encode())
        for part in self._with_headers(name):
            digest.update(self.read(part).encode())
        return self.folder / digest.hexdigest()

    def _with_headers(self, name):
        found, waiting = set(), [name]
        while waiting:
            current = waiting.pop()
            if current in found:
                continue
            found.add(current)
            for include in re.findall(r'^\s*#\s*include\s*"([^"]+)"', self.read(current), re.MULTILINE):
                header = self.headers.get(pathlib.PurePath(include).name)
                if header:
                    waiting.append(header)
        return sorted(found)
