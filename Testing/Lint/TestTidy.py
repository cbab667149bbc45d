# SPDX-License-Identifier: BSD-3-Clause
"""clang-tidy's check finds in files that are looked at together what it finds in each alone.

Usage: TestTidy.py <clang-tidy>
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
FUNCTION = "namespace\n{{\nint {0}(int k)\n{{\n  return k + {1};\n}}\n}}\nint {2}(int k)\n{{\n  return {0}(k);\n}}\n"
PATH = ("int {0}(int k)\n{{\n  int* p = nullptr;\n  if (k > 3)\n  {{\n    p = &k;\n  }}\n  return *p;\n}}\n")
FILES = {
    "A.cxx": "#include <vector>\n" + FUNCTION.format("more", 1, "a"),
    "B.cxx": "#include <vector>\n" + FUNCTION.format("most", 2, "b"),
    "C.cxx": FUNCTION.format("more", 3, "c"),  # one name of its own is another file's as well
    "D.cxx": "#include <vector>\nint d(std::vector<int> v)\n{\n  return v.empty() ? 1 : 2;\n}\n",
    "E.cxx": "" + PATH.format("e"),
    "F.cxx": "#include <map>\n#include <map>\n",
    "G.cxx": "#define int_pointer int*\nint_pointer g();\nstatic const int most(5);\nint h()\n{\n  return most;\n}\n",
}
FINDINGS = {"D.cxx": "performance-unnecessary-value-param", "E.cxx": "clang-analyzer-core.NullDereference",
            "F.cxx": "readability-duplicate-include"}


def run(root, names):
    commands = [{"directory": str(root), "file": f"Filters/{name}",
                 "command": f"/usr/bin/c++ -std=c++17 -Werror --param=ggc-min-expand=100 -Winvalid-pch -include {root}/build/cmake_pch.hxx -o {name}.o -c {root}/Filters/{name}"} for name in names]
    (root / "build" / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")
    result = subprocess.run(
        [sys.executable, str(root / "Testing" / "Lint" / "CheckTidy.py"), sys.argv[1], str(root / "build")],
        capture_output=True, text=True, check=False)
    return result.returncode, result.stdout


failures = []
with tempfile.TemporaryDirectory() as folder:
    tree = pathlib.Path(folder)
    for part in ("Filters", "Testing/Lint", "build"):
        (tree / part).mkdir(parents=True)
    for part in ("CheckTidy.py", "CompileCommands.py", "Sources.py"):
        shutil.copy(HERE / part, tree / "Testing" / "Lint" / part)
    shutil.copy(HERE.parents[1] / ".clang-tidy", tree / ".clang-tidy")
    for file_name, text in FILES.items():
        (tree / "Filters" / file_name).write_text(text, encoding="utf-8")
    clean = [name for name in FILES if name not in FINDINGS]
    for _ in range(2):
        status, said = run(tree, clean)
        if status != 0:
            failures.append(f"{clean} are not clean: {said}")
    if "0 of them looked at" not in said:
        failures.append(f"files that passed are looked at again: {said}")
    for file_name, check in FINDINGS.items():
        (tree / "build" / "tidy").rename(tree / f"passed with {file_name}")
        status, said = run(tree, [*clean, file_name])
        if status == 0 or f"Filters/{file_name}" not in said or check not in said or "1 with findings" not in said:
            failures.append(f"{check} in {file_name} is not what is found: {said}")
print("\n".join(failures))
sys.exit(bool(failures))
