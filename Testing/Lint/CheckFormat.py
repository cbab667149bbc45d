# SPDX-License-Identifier: BSD-3-Clause
"""Every C++ file is laid out as .clang-format says. Usage: CheckFormat.py <clang-format>"""

import subprocess
import sys

from Sources import ROOT, cxx_files

files = cxx_files()
if not files:
    sys.exit("No C++ file found: the check would be empty.")
result = subprocess.run([sys.argv[1], "--dry-run", "-Werror", *files], cwd=ROOT, check=False)
if result.returncode:
    sys.exit("Run clang-format -i on the files named above.")
print(f"{len(files)} files")
