#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks that build-benchmarks has built and keeps their numbers in build/benchmark.

    run.py                      all of them; on a quiet machine 15 minutes
    run.py --only solvers       some of: flattening, solvers, waiting
    run.py --bff PROGRAM        with boundary first flattening by a program of your own (see speed.md)
    run.py --page               afterwards writes Documentation/speed.json, and from it the tables and
                                pictures of Documentation/speed.md; --only none: from earlier runs
"""

import argparse
import json
import os
import resource
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
DATA = os.path.join(ROOT, "Data")


def run(*command):
    print("+", *command, flush=True)
    code = subprocess.run(command, check=False).returncode
    if code != 0:
        sys.exit(f"{os.path.basename(command[0])} ended with {code}")


def flattening(options, folder):
    run(f"{options.bin}/FlatteningBenchmark", DATA, "--threads", "1", "2", "--divisions",
        *map(str, options.divisions), *(["--bff", options.bff] if options.bff else []),
        "--json", f"{folder}/flattening.json")


def solvers(options, folder):
    """One thread for CHOLMOD's BLAS: more make it slower here."""
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    divisions = [str(division) for division in options.divisions if division <= 11]
    run(f"{options.bin}/SolverBenchmark", DATA, "--divisions", *divisions,
        "--json", f"{folder}/solvers.json")


def divided(folder):
    """The trouser leg with each edge divided by 4, in a file."""
    from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter
    reader, division, writer = vtkXMLPolyDataReader(), vtkLinearSubdivisionFilter(), vtkXMLPolyDataWriter()
    reader.SetFileName(f"{DATA}/pants_front.vtp")
    division.SetInputConnection(reader.GetOutputPort())
    division.SetNumberOfSubdivisions(2)
    writer.SetInputConnection(division.GetOutputPort())
    writer.SetFileName(f"{folder}/pants_front.vtp")
    writer.Write()
    return f"{folder}/pants_front.vtp"


def waiting(options, folder):
    """What the command takes from files to files, with what nobody turned off."""
    rows = []
    for scheme in ([], ["--scheme", "global"]):
        times = []
        for _ in range(5):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            run(f"{options.bin}/wirewarp", divided(folder), f"{DATA}/pants_front_curves.vtp", *scheme,
                "--output", f"{folder}/waiting", "--threads", "1", "--quiet")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        report = read(f"{folder}/waiting/report.json")
        rows.append({"scheme": report["scheme"], "cpu_seconds": min(times),
                     "triangles": sum(piece["triangles"] for piece in report["pieces"])})
    with open(f"{folder}/waiting.json", "w", encoding="utf-8") as file:
        json.dump(rows, file)


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.partition(":")[2].strip() for line in file if line.startswith("model name")]
    return names[0] if names else "unknown"


def write_numbers(folder):
    numbers = {
        "machine": {"processor": processor(), "cores": os.cpu_count()},
        "flattening": read(f"{folder}/flattening.json"),
        "solvers": read(f"{folder}/solvers.json"),
        "waiting": read(f"{folder}/waiting.json")}
    with open(f"{ROOT}/Documentation/speed.json", "w", encoding="utf-8") as file:
        json.dump(numbers, file, indent=1)
        file.write("\n")


def main():
    steps = {"flattening": flattening, "solvers": solvers, "waiting": waiting}
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", choices=[*steps, "none"], default=list(steps))
    parser.add_argument("--divisions", nargs="+", type=int, default=[1, 4, 11, 34],
                        help="parts of each edge of the trouser leg")
    parser.add_argument("--build", default=os.path.join(ROOT, "build"), help="build tree")
    parser.add_argument("--bff", metavar="PROGRAM")
    parser.add_argument("--page", action="store_true")
    options = parser.parse_args()
    options.bin = os.path.join(options.build, "bin")
    folder = os.path.join(options.build, "benchmark")
    os.makedirs(folder, exist_ok=True)
    for name, step in steps.items():
        if name in options.only:
            step(options, folder)
    if options.page:
        write_numbers(folder)
        run(sys.executable, f"{ROOT}/Documentation/speed.py", "--write")


if __name__ == "__main__":
    main()
