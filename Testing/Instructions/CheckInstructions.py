# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of flattenSurface() on fixed cases and compares them with baseline.json.

A count above the baseline by more than its tolerance fails; one below it asks for a new baseline. Where
nothing can be compared (no valgrind, another compiler or kind of build) the test is skipped.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BASELINE = pathlib.Path(__file__).with_name("baseline.json")
SKIPPED = 77


def count(options, case):
    """Instructions executed within flattenSurface(): reading the piece is not counted."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        run = subprocess.run(
            [options.valgrind, "--tool=callgrind", "--toggle-collect=flattening::flattenSurface(*",
             f"--callgrind-out-file={out}", options.program, options.data, case],
            capture_output=True, text=True, check=False,
            # One thread, whatever BLAS is installed.
            env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})
        if run.returncode != 0:
            raise RuntimeError(f"case {case}: {run.stderr}")
        found = re.search(r"Collected : (\d+)", run.stderr)
        if not found or int(found.group(1)) == 0:
            raise RuntimeError(f"case {case}: callgrind saw no call of flattenSurface()")
        return int(found.group(1))


def counts(options):
    cases = subprocess.run([options.program], capture_output=True, text=True, check=True).stdout.split()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip(cases, pool.map(lambda case: count(options, case), cases)))


def processor():
    """Products of the sparse solver are as wide as the processor's registers, of which valgrind knows AVX2's."""
    try:
        flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").split()
    except OSError:
        flags = []
    return " AVX2" if "avx2" in flags else ""


def skip(reason):
    print(f"Skipped: {reason}")
    sys.exit(SKIPPED)


def compare(now, baseline):
    """What to say, line by line, and which cases take more."""
    tolerance, lines, worse = baseline["tolerance"], [], []
    for case, instructions in now.items():
        before = baseline["instructions"].get(case)
        if before is None:
            lines.append(f"{case}: {instructions:,} instructions, not in the baseline; renew it")
            worse.append(case)
            continue
        change = instructions / before - 1
        lines.append(f"{case}: {instructions:,} instructions, baseline {before:,}, {change:+.1%}")
        if change > tolerance:
            lines[-1] += f": more than {tolerance:.0%} above it"
            worse.append(case)
        elif change < -tolerance:
            lines[-1] += ": well below it, renew it"
    return lines, worse


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="InstructionCase")
    parser.add_argument("data", help="folder of the pieces")
    parser.add_argument("--build", required=True, help="compiler and kind of build")
    parser.add_argument("--valgrind", default="valgrind")
    parser.add_argument("--renew", action="store_true", help="write baseline.json anew")
    options = parser.parse_args()

    options.build += processor()
    baseline = json.loads(BASELINE.read_text(encoding="utf-8"))
    if not options.valgrind:
        skip("valgrind is not installed; packages-test.txt lists it")
    if options.renew:
        baseline["build"] = options.build
        baseline["instructions"] = counts(options)
        BASELINE.write_text(json.dumps(baseline, indent=2) + "\n", encoding="utf-8")
        print(BASELINE.read_text(encoding="utf-8"))
        return
    if options.build != baseline["build"]:
        skip(f"the baseline is of '{baseline['build']}', this build is '{options.build}'")
    lines, worse = compare(counts(options), baseline)
    print("\n".join(lines))
    if worse:
        sys.exit("If the result is worth it: cmake --build build --target renew-instructions")


if __name__ == "__main__":
    main()
