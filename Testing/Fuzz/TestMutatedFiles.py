# SPDX-License-Identifier: BSD-3-Clause
"""Feeds damaged files of every format to the command.

Usage: TestMutatedFiles.py COUNT [FIRST]; a case is made from its number alone, and what fails is kept.
"""

import collections
import concurrent.futures
import functools
import math
import os
import shutil
import subprocess
import sys
import tempfile

import command
from mutated_files import CLASSES, mutated
from specimen_files import POINTS, SPECIMENS, TRIANGLES

CASES_AT_A_TIME = 400  # in one batch
SECONDS_FOR_THEM = 900
SINGLE = 61  # so many cases, one of them alone
RESULTS = ["cut.vtp", "flat.vtp", "report.json", "wires.vtp"]


class Wrong(Exception):
    pass


def expect(condition, text):
    if not condition:
        raise Wrong(text)


def run(folder, *arguments):
    try:
        result = subprocess.run(
            [command.EXECUTABLE, *arguments], cwd=folder, capture_output=True, check=False,
            timeout=SECONDS_FOR_THEM, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        raise Wrong("came to no end") from None
    expect(result.returncode in (0, 2, 3, 4), f"exit code {result.returncode}")
    for line in result.stderr.split(b"\n")[:-1]:
        expect(line.startswith(b"wirewarp: "), f"foreign line {line!r}")
    for stream in (result.stdout, result.stderr):
        expect(not any(byte < 32 and byte != 10 for byte in stream), f"control characters: {stream!r}")
    return result.returncode


def check_result(folder, code):
    """All files of a result or, after a refusal, none but the report; no number that is none."""
    names = sorted(os.listdir(folder))
    report = command.read_json(os.path.join(folder, "report.json"))
    expect(report["exit_code"] == code, f"report.json says {report['exit_code']}, the command {code}")
    if code == 3:
        expect(names == ["report.json"], f"files of a refusal: {names}")
        expect(report["status"] != "Crashed" and report["message"], "a refusal without words")
        return report["status"]
    expect(names == RESULTS, f"files of a result: {names}")
    for name in ("cut.vtp", "flat.vtp", "wires.vtp"):
        values = command.read_array(os.path.join(folder, name), "Points")
        expect(len(values) > 0 and all(map(math.isfinite, values)), f"points of {name}")
    return report["status"]


def arguments_of(name, path):
    return ("sound.obj", path) if name.startswith("curves") else (path,)


def write(folder, stem, name, data):
    """A file with the ending of `name`."""
    path = stem + os.path.splitext(name)[1]
    with open(os.path.join(folder, path), "wb") as file:
        file.write(data)
    return path


def run_many(folder, cases, seen):
    """Cases in one batch; names those that are wrong."""
    lines = []
    for number, (name, _, data) in cases.items():
        path = write(folder, f"{number:06d}", name, data)
        arguments = arguments_of(name, path)
        if len(arguments) == 2:  # so that its folder has its number
            shutil.copyfile(os.path.join(folder, "sound.obj"), os.path.join(folder, f"{number:06d}.obj"))
            arguments = (f"{number:06d}.obj", path)
        lines.append(" ".join(arguments))
    with open(os.path.join(folder, "batch.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    worst = run(folder, "batch", "batch.txt", "--output", "out", "--quiet")
    rows = command.read_json(os.path.join(folder, "out", "batch.json"))["surfaces"]
    expect(len(rows) == len(cases), "rows of batch.json")
    codes = {row["exit_code"] for row in rows}
    expect(worst == (3 if 3 in codes else max(codes)), f"exit code {worst} of {codes}")
    for number, row in zip(cases, rows):
        try:
            expect(row["status"] != "Crashed", "its process died")
            seen[check_result(os.path.join(folder, "out", row["folder"]), row["exit_code"])] += 1
        except Exception as error:  # whatever it is, the case has to be named
            yield number, repr(error)


def run_alone(folder, name, data, seen):
    path = write(folder, "alone", name, data)
    if name == "list.txt":
        code = run(folder, "batch", path, "--output", "out")
        expect(code != 2, "bad usage")
        if os.path.exists(os.path.join(folder, "out", "batch.json")):
            rows = command.read_json(os.path.join(folder, "out", "batch.json"))["surfaces"]
            expect(all(row["status"] != "Crashed" for row in rows), "a process died")
            seen["list of %d" % len(rows)] += 1
        else:
            expect(code == 3, "a list without a result")
        return []
    code = run(folder, *arguments_of(name, path), "--output", "out", "--table")
    seen[check_result(os.path.join(folder, "out"), code)] += 1
    return []


def new_folder(parent):
    folder = tempfile.mkdtemp(dir=parent)
    os.mkdir(os.path.join(folder, "a folder"))
    for path in ("sound.obj", "a folder/sound.obj"):
        with open(os.path.join(folder, path), "w", encoding="utf-8") as file:
            file.write(command.obj(POINTS, TRIANGLES))
    with open(os.path.join(folder, "curves.txt"), "wb") as file:
        file.write(SPECIMENS["curves.txt"])
    return folder


def specimens_are_sound(parent):
    for name, data in SPECIMENS.items():
        folder = new_folder(parent)
        try:
            run_alone(folder, name, data, collections.Counter())
            folders = ("out/sound", "out/sound_2", "out/sound_3") if name == "list.txt" else ("out",)
            for out in folders:
                expect(command.read_json(os.path.join(folder, out, "report.json"))["status"] == "Ok", "not Ok")
        except Wrong as error:
            raise SystemExit(f"the specimen {name} is not sound: {error}") from None


def keep(number, name, data):
    return os.path.join(tempfile.gettempdir(), write(tempfile.gettempdir(), f"mutated_{number}_{name}", name, data))


def attempt(parent, first, tried):
    """Lets a function try cases in a folder. What came of them, and what is wrong with which."""
    folder, seen, wrong = new_folder(parent), collections.Counter(), []
    try:
        wrong += tried(folder, seen=seen)
    except Exception as error:  # whatever it is, the case has to be named
        wrong.append((first, repr(error)))
    shutil.rmtree(folder)
    return seen, wrong


def jobs(count, first, tried):
    """The first case of each job, and a function of a folder that tries all of its cases."""
    waiting = {}
    for number in range(first, first + count):
        name, kind, data = mutated(number)
        tried[name, kind] += 1
        if name == "list.txt" or number % SINGLE == 0:
            yield number, functools.partial(run_alone, name=name, data=data)
        else:
            waiting[number] = name, kind, data
        if waiting and (len(waiting) == CASES_AT_A_TIME or number == first + count - 1):
            yield min(waiting), functools.partial(run_many, cases=waiting)
            waiting = {}


def test(count, first):
    wrong = []
    seen = collections.Counter()
    tried = collections.Counter()
    with tempfile.TemporaryDirectory(prefix="mutated ") as parent:
        specimens_are_sound(parent)
        # Most of a run alone is one process that starts, so several run at a time.
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            running = [pool.submit(attempt, parent, *job) for job in jobs(count, first, tried)]
            for done in running:
                counts, faults = done.result()
                seen += counts
                wrong += faults
    for number, text in wrong:
        name, kind, data = mutated(number)
        print(f"case {number} ({name}, {kind}): {text}; kept as {keep(number, name, data)}")
    print(f"{count} files, {len(tried)} pairs of format and class of bytes; {dict(seen)}")
    # A test that refuses everything, or nothing, would try nothing.
    pairs = sum(sum(any(byte in members for byte in data) for members in CLASSES.values())
                for data in SPECIMENS.values())
    if len(tried) < pairs or seen["Ok"] < count / 50 or seen["UnreadableInput"] < count / 10:
        print("these cases try too little")
        return 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(test(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0))
