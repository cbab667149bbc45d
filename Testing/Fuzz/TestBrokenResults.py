# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that no plane has room for, with all that the command can write of them.

Usage: TestBrokenResults.py COUNT [FIRST]; a case is made from its number alone.
"""

import collections
import concurrent.futures
import math
import os
import random
import re
import subprocess
import sys
import tempfile

import command

SECONDS = 120
PATTERNS = ("pattern.svg", "pattern.pdf", "pattern.dxf", "pattern.plt", "pattern.json", "walk.csv")
ALWAYS = {"cut.vtp", "flat.vtp", "wires.vtp", "report.json"}


def grid(chance):
    """A sheet, a tube or a deep bump with holes, needles and points that nearly meet; curves along its rows."""
    columns, rows = chance.randint(2, 24), chance.randint(2, 16)
    shape = chance.choice(("sheet", "tube", "bump", "saddle", "fold"))
    depth = chance.choice((0.0, 0.3, 1.0, 5.0))
    size = chance.choice((0.01, 1.0, 30.0, 30.0, 30.0, 1e4))
    wide = columns if shape == "tube" else columns + 1

    def place(i, j):
        u, v = i / columns, j / rows
        if shape == "tube":
            radius = 0.3 + 0.2 * depth * v
            return radius * math.cos(2 * math.pi * u), radius * math.sin(2 * math.pi * u), v
        if shape == "bump":
            return u, v, depth * math.sin(math.pi * u) * math.sin(math.pi * v)
        if shape == "saddle":
            return u, v, 4 * depth * (u - 0.5) * (v - 0.5)
        return u, v, depth * (abs(u - 0.5) if shape == "fold" else 0.0)

    points, triangles = command.grid(columns, rows, lambda i, j: [size * x for x in place(i, j)], shape == "tube")
    for _ in range(chance.choice((0, 0, 1, 4))):  # openings
        del triangles[chance.randrange(len(triangles))]
    for _ in range(chance.choice((0, 1, 3))):
        a, b = chance.choice(triangles)[:2]
        near = 10.0 ** -chance.uniform(0, 9)
        points[a] = [q + near * (p - q) for p, q in zip(points[a], points[b])]
    noise = chance.choice((0.0, 0.0, 0.02, 0.2)) * size / max(columns, rows)
    points = [[x + noise * chance.uniform(-1, 1) for x in point] for point in points]
    curves = []
    for k in range(chance.choice((0, 1, 2, 3))):
        row = chance.randint(0, rows)
        first = chance.randint(0, max(0, wide - 3))
        end = chance.randint(first + 2, wide)
        kind = chance.choice(("accessory", "key", "straight", "dart", "seam"))
        curves.append(f"{kind} c{k} " + " ".join(str(row * wide + i) for i in range(first, end)))
    return points, triangles, "\n".join(curves) + "\n"


def commands_of(chance, operands):
    """The runs of a case: from the surface alone, or from the result of the first run."""
    drawn = [name for name in PATTERNS if chance.random() < 0.7]
    scheme = chance.choice(("isometric", "isometric", "global", "progressive", "lscm"))
    flattening = ["--scheme", scheme, "--unit", chance.choice(("mm", "cm", "m", "inch"))]
    for flag, share in (("--close-cuts", 0.2), ("--weld", 0.3), ("--skip-closed", 0.3)):
        flattening += [flag] if chance.random() < share else []
    if scheme != "lscm" and chance.random() < 0.3:
        flattening += ["--max-iterations", "1"]
    drawing = ["--allowance", chance.choice(("0", "6", "10", "100")), "--smooth", chance.choice(("0", "0.2", "5"))]
    for flags, share in ((("--fold", "symmetric"), 0.3), (("--cut-darts-out",), 0.3), (("--notch-corners",), 0.3),
                         (("--pairs",), 0.3)):
        drawing += flags if chance.random() < share else []
    paper = ["--max-pages", "30"] if "pattern.pdf" in drawn else []
    files = [word for name in drawn for word in ("-o", "out/" + name)]
    if not drawn:
        runs = [["flatten", *operands, "-o", "out", *flattening]]
    elif chance.random() < 0.5:
        runs = [["pattern", *operands, "-o", "out", *files, *flattening, *drawing, *paper]]
    else:
        runs = [["flatten", *operands, "-o", "out", *flattening], ["pattern", "out", *files, *drawing, *paper]]
    if chance.random() < 0.4:
        runs.append(["nest", "out", "--roll-width", "1500", *drawing])
    if chance.random() < 0.3:
        runs.append(["sew", "out", "--once"])
    if os.environ.get("DISPLAY") and chance.random() < 0.3:
        runs.append(["picture", "out"])
    if chance.random() < 0.3:
        runs.append(["grade", "M=surface.obj", "L=large.obj", *operands[1:], "-o", "sizes", *flattening])
    return drawn, runs


def what_is_wrong(folder, drawn, run, told):
    """Of the first run and, where patterns are drawn by the second, of that one."""
    names = set(os.listdir(os.path.join(folder, "out")))
    report = command.read_json(os.path.join(folder, "out", "report.json"))
    if report["exit_code"] != run.returncode:
        return f"report.json says {report['exit_code']}, the command {run.returncode}"
    if run.returncode == 3 and not report["unwritten"]:
        return "" if names <= {"report.json"} else f"files of a refusal: {names}"
    if not ALWAYS <= names:
        return f"files of a result: {names}"
    for name in PATTERNS:
        if (name in drawn) != (name in names or "/" + name in told):
            return f"{name} is neither there nor told to be missing, or was not asked for"
        if name in names and name != "pattern.pdf":
            with open(os.path.join(folder, "out", name), encoding="utf-8") as file:
                if re.search(r"(?<![a-z])-?(nan|inf)(?![a-z])", file.read(), re.IGNORECASE):
                    return f"a number of {name} is none"
    return ""


def ends_wrong(folder, run):
    """Whatever the command."""
    if run.returncode not in (0, 3, 4):
        return f"exit code {run.returncode}"
    errors = [line for line in run.stderr.splitlines() if line.startswith("wirewarp: error: ")]
    if (run.returncode == 3) != bool(errors):
        return f"exit code {run.returncode} with the errors {errors}"
    halves = [name for _, _, names in os.walk(folder) for name in names if name.endswith(".part")]
    return f"half of a file: {halves}" if halves else ""


def attempt(number):
    """What came of one case, and what is wrong with it."""
    chance = random.Random(number)
    points, triangles, curves = grid(chance)
    with tempfile.TemporaryDirectory(prefix="broken ") as folder:
        def write(name, text):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        write("surface.obj", command.obj(points, triangles))
        write("large.obj", command.obj([[1.1 * x for x in point] for point in points], triangles))
        write("curves.txt", curves)
        drawn, runs = commands_of(chance, ["surface.obj", *(["curves.txt"] if curves.strip() else [])])
        words = ""
        try:
            first, told, wrong = None, "", ""
            for arguments in runs:
                words = " ".join(arguments)
                run = subprocess.run([command.EXECUTABLE, *arguments], cwd=folder, capture_output=True, text=True,
                                     timeout=SECONDS, check=False)
                first = first or run
                told += run.stderr if arguments[0] == "pattern" else ""
                wrong = wrong or ends_wrong(folder, run)
                if wrong:
                    return first.returncode, f"{wrong} ({words}): {run.stderr}"
            words = " ".join(runs[0])
            wrong = what_is_wrong(folder, drawn, first, told)
            return first.returncode, f"{wrong} ({words}): {first.stderr}" if wrong else ""
        except Exception as error:  # whatever it is, the case has to be named
            return "none", f"{error!r} ({words})"


def test(count, first):
    seen, faults = collections.Counter(), 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        numbers = range(first, first + count)
        for number, (code, wrong) in zip(numbers, pool.map(attempt, numbers)):
            seen[code] += 1
            if wrong:
                faults += 1
                print(f"case {number}: {wrong}")
    print(f"{count} surfaces, exit codes {dict(seen)}")
    # Where all is well or all is refused nothing is tried.
    return 1 if faults or seen[4] < count / 20 or seen[0] < count / 20 else 0


if __name__ == "__main__":
    sys.exit(test(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0))
