#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a material gains over the isotropic sheet on a folder of pieces, and what it costs.

Usage: cloth.py WIREWARP FOLDER [MATERIAL]

FOLDER has NAME.vtp and NAME_curves.vtp, as Data has, or a folder NAME with surface.vtk and curves.vtk. All
keys are released. The root mean square strain of both threads is compared with that of the isotropic sheet
at its best angle, both with a free grain; the time, of the processor, with that of the isotropic scheme at
the same settings, with the grain upright."""

import json
import math
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile


def pieces(folder):
    """(name, surface, curves)."""
    for path in sorted(pathlib.Path(folder).iterdir()):
        curves = path.with_name(path.stem + "_curves.vtp")
        if path.suffix == ".vtp" and curves.exists():
            yield path.stem, path, curves
        elif (path / "surface.vtk").exists():
            yield path.name, path / "surface.vtk", path / "curves.vtk"


def flatten(command, piece, folder, *options):
    """(report of the first piece, seconds of the processor)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [command, *piece, "--no-keys", "--no-release-trials",
         "--quiet", "--threads", "1", "--output", folder, *options],
        capture_output=True, check=False, timeout=300)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return report, seconds


def rms(cloth):
    return math.hypot(cloth["strain_warp_rms"], cloth["strain_weft_rms"]) / math.sqrt(2)


def main(command, folder, material="twill"):
    ratios, times, worse = [], [], []
    print(f"{'piece':30} {'isotropic':>9} {material:>9} {'ratio':>6} {'over 5 %':>15} {'length':>8} {'status':>14} "
          f"{'time':>6}")
    for piece_name, *piece in pieces(folder):
        with tempfile.TemporaryDirectory() as out:
            base = flatten(command, piece, out, "--material", "isotropic", "--grain", "free")[0]
            free = flatten(command, piece, out, "--material", material, "--grain", "free")[0]
            plain = flatten(command, piece, out, "--material", "isotropic")[1]
            cloth = flatten(command, piece, out, "--material", material)[1]
        # Of a garment in several pieces the mean counts.
        before, after = ([piece["cloth"] for piece in report["pieces"]] for report in (base, free))
        strain = [statistics.fmean(map(rms, cloths)) for cloths in (before, after)]
        ratio = strain[1] / strain[0] if strain[0] > 1e-9 else 0.0
        share = [statistics.fmean(cloth["share_over_5_percent"] for cloth in cloths) for cloths in (before, after)]
        if strain[0] > 1e-9:
            ratios.append(ratio)
        times.append(cloth / plain)
        if share[1] > share[0] + 1e-6:
            worse.append(piece_name)
        length = max(entry["E_len_max"] for entry in free["pieces"])
        print(f"{piece_name:30} {strain[0]:9.5f} {strain[1]:9.5f} {ratio:6.3f} {share[0]:7.3f} {share[1]:7.3f} "
              f"{length:8.0e} {free['status']:>14} {cloth / plain:6.2f}", flush=True)
    print(f"thread strain: median {statistics.median(ratios):.3f}, largest {max(ratios):.3f} of the isotropic "
          f"sheet's; time: median {statistics.median(times):.2f}, largest {max(times):.2f} times; more beyond 5 %: "
          f"{', '.join(worse) or 'none'}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:4])
