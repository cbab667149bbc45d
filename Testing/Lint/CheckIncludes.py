# SPDX-License-Identifier: BSD-3-Clause
"""Every source of the product includes what it uses: it compiles without headers that were read once for many.

Usage: CheckIncludes.py <build directory>

What such headers could hide is a header that the source does not reach by itself and of which it, or a header of ours
that it includes, has a word. Only these sources are compiled. A file that passed is not looked at again until it, a
header of ours that it includes or its options change.
"""

import concurrent.futures
import functools
import os
import pathlib
import re
import sys

from CompileCommands import Passed, commands_of, compiled, compiler_of, options_of, reached
from Sources import ROOT

BUILD = pathlib.Path(sys.argv[1])
FOLDERS = ("Filters/", "IO/", "Figures/", "Applications/")
# Words of headers that are named otherwise than these; of others it is the header's own name. Of "." there are too many.
WORDS = {
    "algorithm": ".", "cmath": ".", "cstdint": ".", "Eigen/Core": ".", "Eigen/Geometry": ".", "Eigen/SparseCore": "Sparse|Triplet",
    "cstddef": "size_t|ptrdiff_t|std::byte|nullptr_t", "vtkObjectFactory.h": "vtkStandardNewMacro",
    "functional": "std::(function|hash|less|greater|plus|minus|multiplies|divides|not_|logical_|equal_to|bind|c?ref|invoke|mem_fn)",
    "limits": "std::numeric_limits", "memory": "std::(unique_|shared_|weak_|make_|addressof|default_delete|allocator|uninitialized_)",
    "map": "std::(multi)?map", "set": "std::(multi)?set", "queue": "std::(priority_)?queue",
    "numeric": "std::(accumulate|iota|inner_product|partial_sum|adjacent_difference|reduce|transform_|gcd|lcm|midpoint)",
    "optional": "std::(optional|nullopt)", "tuple": "std::(tuple|tie|get|apply|make_tuple|forward_as_tuple|ignore)",
    "utility": "std::(pair|make_pair|move|swap|forward|exchange|declval|as_const|in_place|.*_sequence|piecewise)",
    "string": "std::(string|to_string|sto|getline)", "unordered_map": "std::unordered_"}


@functools.lru_cache(maxsize=None)
def read_once(header, compiler, options):
    """The headers that are read once for many, each with the files of its name."""
    files = reached(header, compiler, options, BUILD)
    names = re.findall(r"#include <([^>]+)>", pathlib.Path(header).read_text(encoding="utf-8"))
    return {name: {file for file in files if file.endswith("/" + name)} for name in names}


def may_lack(name, command):
    """Whether there is a header that the source does not reach by itself and a word of it."""
    header = re.search(r"-include (\S*cmake_pch\.hxx)", command)[1]
    compiler, options = compiler_of(command), options_of(command)
    files = reached(ROOT / name, compiler, options, BUILD)
    ours = [pathlib.Path(file) for file in files if file.startswith(f"{ROOT}/")]
    text = "\n".join(path.read_text(encoding="utf-8") for path in ours)
    text = re.sub(r"^#include.*|//.*|^class \w+;$|/\*[\s\S]*?\*/", "", text, flags=re.MULTILINE)
    return any(not files & places and re.search(WORDS.get(wanted, pathlib.PurePath(wanted).stem), text)
               for wanted, places in read_once(header, compiler, options).items())


def check(name):
    stamp = known.stamp(name, commands[name])
    looked_at = may_lack(name, commands[name])
    result = compiled(ROOT / name, commands[name], BUILD) if looked_at else None
    passed = not looked_at or result.returncode == 0
    if passed:
        stamp.touch()
    return name, looked_at, "" if passed else result.stderr or "it does not compile"


known = Passed(BUILD / "includes", "", FOLDERS)
commands = {name: command for name, command in commands_of(BUILD, *FOLDERS).items() if "cmake_pch.hxx" in command}
waiting = [name for name, command in commands.items() if not known.stamp(name, command).exists()]
count, failed = 0, []
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for file_name, was_compiled, said in pool.map(check, waiting):
        count += was_compiled
        if said:
            failed.append(file_name)
            print(said)
print(f"{len(commands)} files, {len(waiting)} looked at, {count} of them compiled, {len(failed)} without what they use")
sys.exit(bool(failed))
