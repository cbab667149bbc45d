# SPDX-License-Identifier: BSD-3-Clause
"""What Documentation/architecture.md promises of the sources.

Usage: CheckArchitecture.py <name of a check below>; each prints every violation and fails on any.
"""

import pathlib
import re
import sys

from Sources import ROOT, cxx_files, read, tracked_files

# The directories of Filters/Core, the uppermost first: each includes itself and what stands below.
DIRECTORIES = ("Report", "Input", "Options", "Design", "Suggestion", "Reshaping", "Sewing", "Flattening", "Reference", "Isometric", "Cloth", "Embedding", "Angles", "Wires", "Cut", "Editing", "Paths", "Imprint", "Quality", "Sparse",
         "Surface", "Base")
# Those of IO/Pattern, which stand above Core.
PATTERN_DIRECTORIES = ("Formats", "Nesting", "Grading", "Drawing", "Fairing", "Outlines")
# Folder, its directories, and those of other folders that it includes as well.
LAYERED = (("Filters/Core", DIRECTORIES, ()), ("IO/Pattern", PATTERN_DIRECTORIES, DIRECTORIES))


def code_lines(name):
    """Numbered lines without comments and without the text of string literals."""
    text = read(name)
    text = re.sub(r"/\*.*?\*/", lambda found: "\n" * found.group().count("\n"), text, flags=re.DOTALL)
    for number, line in enumerate(text.split("\n"), 1):
        if not line.lstrip().startswith("#"):
            line = re.sub(r'"(?:[^"\\]|\\.)*"', '""', line)
        yield number, line.split("//")[0]


def includes(name):
    for number, line in code_lines(name):
        found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if found:
            yield number, found.group(1) == '"', found.group(2)


def headers_of(folder):
    return {pathlib.PurePath(name).name for name in cxx_files(folder) if name.endswith(".h")}


def core_includes_no_vtk():
    """Core, and the drawing of patterns beside it, build and run without VTK."""
    for name in cxx_files("Filters/Core/", "IO/Pattern/"):
        for number, _, header in includes(name):
            if re.match(r"(vtk|pq|pv)\w*", header):
                yield f"{name}:{number}: includes {header}"


def the_command_needs_no_vtk():
    """What the command and its readers need of VTK stands in files of their own."""
    adapters = ("Applications/wirewarp/Vtk/", "IO/Flattening/Readers/PolyData", "IO/Flattening/Readers/VtkMessages")
    for name in cxx_files("Applications/wirewarp/", "IO/Flattening/Readers/"):
        for number, _, header in includes(name):
            if header.startswith("vtk") and not name.startswith(adapters):
                yield f"{name}:{number}: includes {header}"


def layers_are_one_way():
    """Each folder includes only what stands below it."""
    core = headers_of("Filters/Core/")
    # What needs the standard library alone.
    options = {"Option.h", "OptionTable.h", "OptionValues.h", "PatternOptionTable.h", "RemedyWords.h"}
    pattern = headers_of("IO/Pattern/")
    pattern_bridge = headers_of("IO/Private/")
    private = headers_of("Filters/Private/") | pattern_bridge
    public = {header for header in headers_of("Filters/") | headers_of("IO/") if header.startswith("vtk")} - private
    for name in cxx_files("Filters/", "IO/", "Figures/", "Interaction/", "Applications/", "Examples/"):
        # The command and its readers build without VTK.
        if name.startswith(("IO/Testing/", "IO/Flattening/Readers/", "Applications/wirewarp/")):
            continue
        if name.startswith("Filters/Core/"):
            forbidden, layer = pattern | private | public, "Core"
        elif name.startswith("IO/Pattern/"):
            forbidden, layer = private | public, "the drawing of patterns"
        elif name.startswith("Filters/Private/"):
            forbidden, layer = public | pattern | pattern_bridge, "the bridge"
        elif name.startswith("IO/Private/"):
            forbidden, layer = public, "the bridge of patterns"
        elif name.startswith(("Filters/", "IO/")) and name.endswith(".h"):
            # Public headers are installed, what they include has to be as well.
            forbidden, layer = core | pattern | private, "a public header"
        elif name.startswith("Filters/"):
            forbidden, layer = pattern | pattern_bridge, "the filters"
        elif name.startswith("IO/"):
            continue
        elif name.startswith("Applications/wirewarp/"):
            forbidden, layer = (pattern - options) | private, "the command"
        else:
            forbidden, layer = (core | pattern | private) - options, "a user of the library"
        for number, quoted, header in includes(name):
            if quoted and pathlib.PurePath(header).name in forbidden:
                yield f"{name}:{number}: {layer} includes {header}"


def directories_are_one_way():
    """Each directory includes only directories below, written with the directory: "Wires/WireNetwork.h"."""
    for folder, directories, below in LAYERED:
        for name in cxx_files(folder + "/"):
            directory = pathlib.PurePath(name).relative_to(folder).parts[0]
            if directory not in directories:
                yield f"{name}: not in one of the directories {', '.join(directories)}"
                continue
            for number, quoted, header in includes(name):
                if not quoted:
                    continue
                other = pathlib.PurePath(header).parts[0]
                if other not in directories + below or "/" not in header:
                    yield f"{name}:{number}: {header} is written without its directory"
                elif other in directories and directories.index(other) < directories.index(directory):
                    yield f"{name}:{number}: {directory} includes {header}, which stands above"


def units_make_no_cycles():
    """Header and source of a unit together include no unit that includes them."""
    for folder, _, _ in LAYERED:
        yield from cycles_of(folder)


def cycles_of(folder):
    below = {}
    for name in cxx_files(folder + "/"):
        unit = str(pathlib.PurePath(name).relative_to(folder).with_suffix(""))
        below.setdefault(unit, set()).update(
            header.removesuffix(".h") for _, quoted, header in includes(name) if quoted)
    for units in below.values():
        units.intersection_update(below)
    for unit, units in below.items():
        units.discard(unit)
    # What is left when units that include nothing more are taken away, again and again.
    while True:
        lowest = {unit for unit, units in below.items() if not units}
        if not lowest:
            break
        below = {unit: units - lowest for unit, units in below.items() if unit not in lowest}
    for unit, units in sorted(below.items()):
        yield f"{folder}/{unit}: in or above a cycle with {', '.join(sorted(units))}"


def core_neither_prints_nor_throws():
    """A stage of Core answers with a Status and nothing else; memory that runs out ends in withinMemory()."""
    pattern = re.compile(r"\bthrow\b|\bstd::c(out|err|log)\b|\b(f|v)?printf\s*\(|\babort\s*\(|\bexit\s*\(")
    for name in cxx_files("Filters/Core/"):
        if name == "Filters/Core/Base/Memory.cxx":
            continue
        for number, line in code_lines(name):
            found = pattern.search(line)
            if found:
                yield f"{name}:{number}: {found.group().strip()}"


def every_source_is_built():
    """A source or test that no CMakeLists.txt names would never be compiled or run."""
    lists = "\n".join(read(name) for name in tracked_files()
                      if pathlib.PurePath(name).name == "CMakeLists.txt")
    named = set(re.findall(r"[\w.]+", lists))
    for name in cxx_files("Filters/", "IO/", "Figures/", "Interaction/", "Examples/", "Testing/"):
        path = pathlib.PurePath(name)
        if path.suffix == ".cxx" and not {path.name, path.stem} & named:
            yield f"{name}: in no CMakeLists.txt"


def the_paper_is_mapped_to_functions():
    """Every file and function that the table of architecture.md names exists."""
    page = "Documentation/architecture.md"
    if not (ROOT / page).is_file():
        yield f"{page} is missing"
        return
    # The table stands between two marks; its last column holds the names in backticks.
    found = re.search(r"<!-- paper-to-code -->(.*?)<!-- /paper-to-code -->", read(page), re.DOTALL)
    if not found:
        yield f"{page}: no table between <!-- paper-to-code --> and <!-- /paper-to-code -->"
        return
    rows = [line for line in found.group(1).split("\n") if line.startswith("|")][2:]
    code = {}
    for name in cxx_files("Filters/", "IO/", "Figures/", "Interaction/", "Applications/", "Examples/"):
        code[name] = "\n".join(line for _, line in code_lines(name))
    everything = "\n".join(code.values())
    named = 0
    for row in rows:
        names = re.findall(r"`([^`]+)`", row.strip("| ").split("|")[-1])
        if not names:
            yield f"{page}: no name in the row {row}"
        for name in names:
            named += 1
            if name.endswith((".h", ".cxx")):
                if not any(pathlib.PurePath(path).name == name for path in code):
                    yield f"{page}: no file {name}"
            elif not re.search(r"\b" + re.escape(name.removesuffix("()").split("::")[-1]) + r"\b", everything):
                yield f"{page}: nothing is called {name}"
    print(f"{len(rows)} rows, {named} names")
    if named < 20:
        yield f"{page}: only {named} names, the table cannot cover the paper"


CHECKS = {check.__name__: check for check in (
    core_includes_no_vtk,
    the_command_needs_no_vtk,
    layers_are_one_way,
    directories_are_one_way,
    units_make_no_cycles,
    core_neither_prints_nor_throws,
    every_source_is_built,
    the_paper_is_mapped_to_functions,
)}

if __name__ == "__main__":
    violations = list(CHECKS[sys.argv[1]]())
    print("\n".join(violations))
    sys.exit(bool(violations))
