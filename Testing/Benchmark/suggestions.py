#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Proposed cuts beside designed darts, and beside shortest paths to peaks of curvature.

Of each piece of Data that has darts these are taken away. The command proposes cuts of no more length in all; and
darts are laid from the boundary, or from earlier ones, along edges to the vertex around which most curvature lies,
one after the other, as conformal methods lay their cuts.

    suggestions.py [--write] [path of wirewarp [piece ...]]

With --write, for all pieces, the table of Documentation/suggestions.md is written anew, and its plot and picture, which needs an
X server.
"""

import heapq
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "Testing" / "Python"))
from surfaces import points_of, polylines_of, read, triangles_of  # noqa: E402  - it lies in another folder

PAGES = ROOT / "Documentation"
DATA = ROOT / "Data"
DART = 2
# Around a vertex curvature is summed up to so far, in sqrt(area / pi).
PEAK = 0.15
PATHS = 6
SHOWN = ("pants_front", "shirt_front", "wetsuit_upper_front", "pants_back", "wetsuit_upper_back", "wetsuit_pants_back")


def write_darts(chains, path):
    with open(path, "w", encoding="utf-8") as file:
        for k, chain in enumerate(chains):
            file.write(f"dart given{k} {' '.join(map(str, chain))}\n")


def designed_darts(surface, curves):
    """By the ids of the surface's points."""
    ids = {surface.GetPoint(k): k for k in range(surface.GetNumberOfPoints())}
    types = curves.GetCellData().GetArray("CurveType")
    return [[ids[curves.GetPoint(point)] for point in chain] for cell, chain in enumerate(polylines_of(curves))
            if types.GetTuple1(cell) == DART]


class Paths:
    """Shortest ways along edges."""

    def __init__(self, surface):
        self.points, self.triangles = points_of(surface), triangles_of(surface)
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        self.size = np.sqrt(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2 / np.pi)
        self.defects = np.full(len(self.points), 2 * np.pi)
        edges = {}
        for triangle in self.triangles:
            for k in range(3):
                i, j, l = np.roll(triangle, -k)
                u, v = self.points[j] - self.points[i], self.points[l] - self.points[i]
                self.defects[i] -= np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v)
                edges[min(i, j), max(i, j)] = edges.get((min(i, j), max(i, j)), 0) + 1
        self.boundary = {v for edge, count in edges.items() if count == 1 for v in edge}
        self.defects[list(self.boundary)] = 0.0
        self.around = [[] for _ in self.points]
        for i, j in edges:
            length = np.linalg.norm(self.points[i] - self.points[j])
            self.around[i].append((length, j))
            self.around[j].append((length, i))

    def ways(self, starts, longest=np.inf):
        """Distance and vertex before, by vertex reached."""
        found, queue = {}, [(0.0, v, v) for v in sorted(starts)]
        heapq.heapify(queue)
        while queue:
            distance, vertex, before = heapq.heappop(queue)
            if vertex not in found and distance <= longest:
                found[vertex] = (distance, before)
                for length, other in self.around[vertex]:
                    heapq.heappush(queue, (distance + length, other, vertex))
        return found

    def darts_to_peaks(self):
        """From the boundary, or an earlier dart, to where most curvature lies beyond its reach."""
        reach = PEAK * self.size
        peaks = {v: abs(sum(self.defects[w] for w in self.ways([v], reach)))
                 for v in range(len(self.points)) if v not in self.boundary}
        starts, chains = set(self.boundary), []
        while len(chains) < PATHS:
            found = self.ways(starts)
            free = [v for v in peaks if found[v][0] > reach]
            if not free:
                break
            chain = [max(free, key=peaks.get)]
            while found[chain[-1]][1] != chain[-1]:
                chain.append(found[chain[-1]][1])
            chains.append(chain[::-1])
            starts.update(chain)
        return chains


def measures(command, *arguments, picture=None):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([command, *arguments, "--quiet", "--output", folder], check=False,
                             capture_output=True, text=True)
        if run.returncode not in (0, 4):
            sys.exit(run.stderr)
        with open(f"{folder}/report.json", encoding="utf-8") as file:
            report = json.load(file)
        if picture:
            subprocess.run([command, "picture", folder, "--quiet", "-o", picture], check=False)
    triangles = sum(piece["triangles"] for piece in report["pieces"])
    mean = {key: sum(piece[key] * piece["triangles"] for piece in report["pieces"]) / triangles
            for key in ("energy_rigid", "E_area")}
    return {**mean, "p95": max(piece["strain_p95"] for piece in report["pieces"]),
            "length": sum(curve["length_3d"] for curve in report["curves"]), "cuts": len(report["curves"]),
            "overlaps": sum(piece["overlaps"] for piece in report["pieces"]), "suggestions": report["suggestions"]}


def measure(command, name, folder):
    """Designed, proposed and the series of the plot: (length / sqrt(area / pi), strain, energy)."""
    surface = DATA / f"{name}.vtp"
    paths = Paths(read(name))
    darts = designed_darts(read(name), read(f"{name}_curves"))
    if not darts:
        return None
    text = folder / "darts.txt"

    def with_darts(chains, *options, drawn=None):
        write_darts(chains, text)
        return measures(command, str(surface), *([str(text)] if chains else []), *options, picture=drawn)

    def picture(what):
        return str(folder / f"{name}_{what}.png") if name in SHOWN and "--write" in sys.argv else None

    def point(run):
        return run["length"] / paths.size, 100 * run["p95"], 1e3 * run["energy_rigid"]

    uncut, designed = with_darts([]), with_darts(darts, drawn=picture("designed"))
    closed = with_darts(darts, "--close-cuts") if designed["overlaps"] else None
    proposed = measures(command, "cut", str(surface), "--max-strain", "0", "--max-length",
                        repr(designed["length"]), "--max-cuts", "10", "--effort", "quick",
                        picture=picture("proposed"))
    steps, length, energy = [point(uncut)], 0.0, uncut["energy_rigid"]
    for k, cut in enumerate(proposed["suggestions"]):
        length += cut["length"]
        following = proposed["suggestions"][k + 1:k + 2]
        if not following or following[0].get("mirror_of") != cut["name"]:
            energy -= cut["gain"]
            steps.append((length / paths.size, 100 * cut["strain_p95_after"], 1e3 * energy))
    peaks = paths.darts_to_peaks()
    runs = [point(with_darts(peaks[:k])) for k in range(1, len(peaks) + 1)]
    longest = 1.5 * designed["length"] / paths.size
    return {"designed": designed, "closed": closed, "proposed": proposed, "size": paths.size,
            "series": [[point(designed)], steps, [point(uncut), *(run for run in runs if run[0] <= longest)]]}


def table_rows(name, found):
    """Beside designed darts; where these overlap, beside them closed as far as they do as well."""
    lines = [row(name, found["designed"], found["proposed"])]
    return lines + ([row("the same, closed", found["closed"], found["proposed"])] if found["closed"] else [])


def row(name, old, new):
    return (f"| {name} | {old['cuts']} / {new['cuts']} | {old['length']:.1f} / {new['length']:.1f} | "
            f"{old['energy_rigid']:.2e} / {new['energy_rigid']:.2e} | {old['E_area']:.4f} / {new['E_area']:.4f} | "
            f"{old['p95']:.4f} / {new['p95']:.4f} | {old['overlaps']} / {new['overlaps']} |")


def write_page(results, folder):
    sys.path.insert(0, str(PAGES))
    import make_pictures  # pylint: disable=import-outside-toplevel
    import svg  # pylint: disable=import-outside-toplevel
    page = PAGES / "suggestions.md"
    table = "\n".join(line for name, found in results.items() for line in table_rows(name, found))
    text = page.read_text(encoding="utf-8")
    page.write_text(re.sub(r"(\| piece of Data .*\n\|[-|]*\n)(?:\|.*\n)+", rf"\1{table}\n", text), encoding="utf-8")
    shown = [results[name]["series"] for name in SHOWN]
    rows = [(what, [[[(point[0], point[k]) for point in series] for series in panel] for panel in shown])
            for k, what in ((1, "strain p95, %"), (2, "energy x 1000"))]
    plot = svg.panels(SHOWN, ("designed darts", "proposed cuts", "shortest paths to peaks"), rows,
                      "length of all cuts / sqrt(area / pi)")
    (PAGES / "images" / "suggestions.svg").write_text(plot, encoding="utf-8")
    pairs = []
    for name in SHOWN:
        images = [make_pictures.read(str(folder / f"{name}_{what}.png")) for what in ("designed", "proposed")]
        pairs.append(make_pictures.appended(
            [make_pictures.scaled(image, 300, image.GetDimensions()[1] * 17 // 100) for image in images], 0))
    height = max(pair.GetDimensions()[1] for pair in pairs)
    same = [make_pictures.padded(pair, height) for pair in pairs]
    lines = [make_pictures.appended(same[k:k + 2], 0) for k in range(0, len(same), 2)]
    make_pictures.write(make_pictures.appended(lines[::-1], 1), str(PAGES / "images" / "suggestions_beside.png"))


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--write"]
    command = arguments[0] if arguments else "wirewarp"
    results = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for piece in arguments[1:] or sorted(path.stem for path in DATA.glob("*.vtp") if "_curves" not in path.stem):
            found = measure(command, piece, folder)
            if found:
                results[piece] = found
                print("\n".join(table_rows(piece, found)), flush=True)
        if "--write" in sys.argv:
            write_page(results, folder)


if __name__ == "__main__":
    main()
