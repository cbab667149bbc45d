#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Proposed darts beside designed ones: of each piece of Data that has darts these are taken away, and the
command proposes cuts of no more length in all.

Usage: suggestions.py [path of wirewarp] [piece ...]
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
DART = 2


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def text_curves(surface, curves, kinds, path):
    """The curves of some types as text, by the ids of the surface's points."""
    ids = {surface.GetPoint(k): k for k in range(surface.GetNumberOfPoints())}
    types = curves.GetCellData().GetArray("CurveType")
    points = vtkIdList()
    count = 0
    with open(path, "w", encoding="utf-8") as file:
        for cell in range(curves.GetNumberOfCells()):
            if types.GetTuple1(cell) in kinds:
                curves.GetCellPoints(cell, points)
                chain = [ids[curves.GetPoint(points.GetId(k))] for k in range(points.GetNumberOfIds())]
                file.write(f"dart given{cell} {' '.join(map(str, chain))}\n")
                count += 1
    return count


def measures(command, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        run = subprocess.run([command, *arguments, "--quiet", "--output", folder], check=False,
                             capture_output=True, text=True)
        seconds = time.monotonic() - start
        if run.returncode not in (0, 4):
            sys.exit(run.stderr)
        with open(f"{folder}/report.json", encoding="utf-8") as file:
            report = json.load(file)
    triangles = sum(piece["triangles"] for piece in report["pieces"])
    mean = {key: sum(piece[key] * piece["triangles"] for piece in report["pieces"]) / triangles
            for key in ("energy_rigid", "E_area")}
    length = sum(curve["length_3d"] for curve in report["curves"])
    return {**mean, "p95": max(piece["strain_p95"] for piece in report["pieces"]), "length": length,
            "overlaps": sum(piece["overlaps"] for piece in report["pieces"]), "seconds": seconds,
            "cuts": len(report["curves"])}


def main():
    command = sys.argv[1] if len(sys.argv) > 1 else "wirewarp"
    names = sys.argv[2:] or sorted(
        path.stem for path in DATA.glob("*.vtp") if "_curves" not in path.stem)
    print(f"{'piece':22} {'cuts':>9} {'length':>13} {'energy_rigid':>19} {'E_area':>15} {'p95':>15} "
          f"{'overlaps':>8} {'s':>6}")
    for name in names:
        surface = str(DATA / f"{name}.vtp")
        with tempfile.NamedTemporaryFile(suffix=".txt") as given:
            count = text_curves(read(surface), read(DATA / f"{name}_curves.vtp"), {DART}, given.name)
            if count == 0:
                continue
            designed = measures(command, surface, given.name)
        proposed = measures(command, surface, "--suggest", "all", "--bound", "0", "--max-cut-length",
                            repr(designed["length"]), "--max-cuts", "10")
        print(f"{name:22} {count:4}/{proposed['cuts']:<4} {designed['length']:6.1f}/{proposed['length']:<6.1f} "
              f"{designed['energy_rigid']:9.2e}/{proposed['energy_rigid']:<9.2e} "
              f"{designed['E_area']:7.4f}/{proposed['E_area']:<7.4f} "
              f"{designed['p95']:7.4f}/{proposed['p95']:<7.4f} "
              f"{designed['overlaps']:3}/{proposed['overlaps']:<3} {proposed['seconds']:6.1f}", flush=True)


if __name__ == "__main__":
    main()
