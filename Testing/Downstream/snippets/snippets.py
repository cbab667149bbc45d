# SPDX-License-Identifier: BSD-3-Clause
"""Writes a source file with the snippets of all headers in some folders, each in a function of its
own that is given a surface and curves: snippets.py OUTPUT FOLDER... Every class must have one, and
say what to beware of."""

import glob
import os
import re
import sys


def main():
    output, *folders = sys.argv[1:]
    headers = sorted(path for folder in folders for path in glob.glob(os.path.join(folder, "vtk*.h")))
    functions, includes, faults = [], set(), []
    for path in headers:
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if "@class" not in text:
            continue
        name = os.path.splitext(os.path.basename(path))[0]
        page = text[:text.index("*/")]
        snippets = re.findall(r"@code\n(.*?)\s*@endcode", page, re.S)
        if not snippets:
            faults.append(f"{name} has no snippet")
        if "@warning" not in page:
            faults.append(f"{name} has no warning")
        for number, snippet in enumerate(snippets):
            lines = [re.sub(r"^ \* ?", "", line) for line in snippet.splitlines()]
            includes |= set(re.findall(r"\bvtk[A-Z]\w+", "\n".join(lines)))
            functions.append(f"void {name}{number}(vtkPolyData* surface, vtkPolyData* curves)\n{{\n"
                             "  static_cast<void>(surface);\n  static_cast<void>(curves);\n  {\n    "
                             + "\n    ".join(lines) + "\n  }\n}\n")
    if faults or len(functions) < 10:
        sys.exit("\n".join(faults) or f"only {len(functions)} snippets in {folders}")
    includes |= {"vtkNew", "vtkPolyData", "vtkPointData", "vtkCellArray"}
    with open(output, "w", encoding="utf-8") as file:
        file.write("".join(f"#include <{name}.h>\n" for name in sorted(includes)))
        file.write("#include <iostream>\n\n" + "\n".join(functions))


if __name__ == "__main__":
    main()
