# SPDX-License-Identifier: BSD-3-Clause
"""The checks of the architecture fail on a tree that breaks each rule, and name the place."""

import pathlib
import sys
import tempfile

import Sources

FILES = {
    "Filters/CMakeLists.txt": "set(classes\n  vtkFilter)\nset(private_sources)\n",
    "vtk.module": "",
    "Examples/vtk.module": "",
    "Filters/Core/Surface/Mesh.h": "#pragma once\n",
    "Filters/Core/Surface/Mesh.cxx": '#include "Surface/Mesh.h"\n#include <vtkPolyData.h>\n// throw away\nvoid f() { throw 1; }\n',
    "Filters/Core/Base/Types.h": '#include "Surface/Mesh.h"\n',
    "Filters/Core/Base/Status.h": '#include "Types.h"\n',
    "Filters/Core/Attic/Mesh.h": "#pragma once\n",
    "Filters/Core/Sparse/Front.h": '#include "Surface/Mesh.h"\n#include "Sparse/Solver.h"\n',
    "Filters/Core/Sparse/Solver.h": "#pragma once\n",
    "Filters/Core/Sparse/Solver.cxx": '#include "Sparse/Solver.h"\n#include "Sparse/Front.h"\n',
    "Filters/Private/Bridge.h": '#include "Mesh.h"\n#include "vtkFilter.h"\n',
    "Filters/vtkFilter.h": '#include "Bridge.h"\n',
    "Filters/vtkFilter.cxx": '#include "Bridge.h"\n#include "Mesh.h"\n',
    "Applications/wirewarp/main.cxx": '#include "Mesh.h"\n#include <vtkPolyData.h>\n',
    "Applications/wirewarp/Vtk/Picture.cxx": '#include <vtkPolyData.h>\n',
    "Applications/main.cxx": '#include "Mesh.h"\n#include "vtkFilter.h"\n',
    "Documentation/architecture.md":
        "<!-- paper-to-code -->\n| in the paper | in the code |\n|---|---|\n"
        "| Eq. 1 | `f` in `Mesh.cxx` |\n| Eq. 2 | `noSuchFunction` |\n<!-- /paper-to-code -->\n",
}
EXPECTED = {
    "core_includes_no_vtk": ["Filters/Core/Surface/Mesh.cxx:2"],
    "the_command_needs_no_vtk": ["Applications/wirewarp/main.cxx:2"],
    "layers_are_one_way":
        ["Applications/main.cxx:1", "Filters/Private/Bridge.h:2", "Filters/vtkFilter.h:1"],
    "core_neither_prints_nor_throws": ["Filters/Core/Surface/Mesh.cxx:4"],
    "directories_are_one_way":
        ["Filters/Core/Attic/Mesh.h: not in one", "Filters/Core/Base/Status.h:1: Types.h is written without",
         "Filters/Core/Base/Types.h:1: Base includes Surface/Mesh.h, which stands above"],
    "units_make_no_cycles":
        ["Filters/Core/Sparse/Front: in or above a cycle with Sparse/Solver",
         "Filters/Core/Sparse/Solver: in or above a cycle with Sparse/Front"],
    "every_source_is_built":
        ["Filters/Core/Sparse/Solver.cxx: in no", "Filters/Core/Surface/Mesh.cxx: in no"],
    "the_paper_is_mapped_to_functions":
        ["Documentation/architecture.md: nothing is called noSuchFunction",
         "Documentation/architecture.md: only 3 names"],
}

with tempfile.TemporaryDirectory() as folder:
    for file_name, text in FILES.items():
        path = pathlib.Path(folder, file_name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    Sources.ROOT = pathlib.Path(folder)
    import CheckArchitecture # after ROOT is set, because it imports the name

    failures = 0
    for check_name, check in CheckArchitecture.CHECKS.items():
        violations = list(check())
        expected = EXPECTED[check_name]
        if len(violations) != len(expected) or not all(
                violation.startswith(start) for violation, start in zip(violations, expected)):
            print(f"{check_name}: expected {expected}, got {violations}")
            failures += 1
sys.exit(failures)
