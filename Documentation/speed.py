#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables and pictures of speed.md, made from speed.json, which Testing/Benchmark/run.py writes.

    speed.py --write    makes them anew
    speed.py --check    compares them with what would be made

Both check the numbers in its own sentences.
"""

import json
import math
import os
import sys

import svg
from pages import HERE, filled, table, unsaid

METHODS = {  # and what they are called here
    "CGAL LSCM": "CGAL LSCM",
    "CGAL ARAP": "CGAL ARAP",
    "BFF": "geometry-central BFF",
    "laplacian": "global, Laplacian interior",
    "rigid": "global, rigid interior",
    "isometric": "isometric",
}
PEERS = ("CGAL LSCM", "CGAL ARAP", "BFF")


def exponent(points):
    """Of the power of x that fits y best: the slope through the logarithms, by least squares."""
    x, y = ([math.log(point[k]) for point in points] for k in (0, 1))
    mean = [sum(v) / len(points) for v in (x, y)]
    return (sum((a - mean[0]) * (b - mean[1]) for a, b in zip(x, y)) /
            sum((a - mean[0])**2 for a in x))


def short(value):
    """Three digits."""
    digits = max(0, 2 - math.floor(math.log10(value))) if value > 0 else 0
    return f"{value:,.{digits}f}"


class Sizes:
    """The whole way, per method, number of threads and triangles."""

    def __init__(self, flattening):
        self.rows = flattening["rows"]
        self.sizes = sorted({row["triangles"] for row in self.rows})
        # Peers know one thread only.
        self.threads = max(row["threads"] for row in self.rows)

    def row(self, method, triangles, threads=None):
        threads = 1 if method in PEERS else threads or self.threads
        found = [row for row in self.rows if
                 (row["method"], row["triangles"], row["threads"]) == (method, triangles, threads)]
        return found[0] if found else None

    def points(self, method):
        """Triangles and processor seconds of one thread."""
        rows = [self.row(method, size, 1) for size in self.sizes]
        return [(row["triangles"], row["processor_seconds"]) for row in rows
                if row and "processor_seconds" in row]

    def ratio(self, row, peer, key="seconds"):
        other = self.row(peer, row["triangles"])
        if not other or key not in other or row["method"] in PEERS:
            return ""
        ratio = other[key] / row[key]
        return f"1/{short(ratio)}" if ratio >= 1.0 else short(1.0 / ratio)

    def table(self):
        lines = []
        for size in self.sizes:
            for method, name in METHODS.items():
                row, one = self.row(method, size), self.row(method, size, 1)
                if row:
                    ours = method not in PEERS
                    processor = one and one.get("processor_seconds")
                    lines.append((
                        f"{size:,}", name, short(1e3 * row["seconds"]),
                        self.ratio(row, "CGAL LSCM"), self.ratio(row, "CGAL ARAP"), self.ratio(row, "BFF"),
                        short(1e3 * processor) if processor else "",
                        self.ratio(one, "CGAL LSCM", "processor_seconds") if processor else "",
                        short(1e3 * row["seconds_wires"]) if ours else "",
                        *((f"{row['bytes_a_triangle']:,.0f}", f"{row['E_len']:.1e}",
                           f"{row['E_ang']:.4f}", f"{row['E_h']:.3f}", row["flips"])
                          if "E_ang" in row else ("", "", "", "", ""))))
        return table(("triangles", "method", "ms", "of CGAL LSCM", "of CGAL ARAP", "of BFF",
                      "processor, ms", "of CGAL LSCM's", "its wires, ms", "bytes a triangle", "E_len", "E_ang", "E_h", "flips"), lines)

    def parallel(self):
        lines = []
        for method, name in METHODS.items():
            for size in self.sizes[-2:]:
                one, more = self.row(method, size, 1), self.row(method, size)
                if method not in PEERS and one and more and one is not more:
                    gain = one["seconds"] / more["seconds"]
                    lines.append((name, f"{size:,}", short(1e3 * one["seconds"]),
                                  short(1e3 * more["seconds"]), f"{gain:.2f}",
                                  f"{gain / self.threads:.0%}"))
        return table(("method", "triangles", "1 thread, ms", f"{self.threads} threads, ms", "gain",
                      "efficiency"), lines)

    def picture(self):
        series = []
        for method, name in METHODS.items():
            points = self.points(method)
            if len(points) > 1:
                series.append((f"{name}: n^{exponent(points):.2f}", points))
        return svg.log_log(series, "triangles n", "processor seconds of one thread", lambda value: f"{value:g}")


def solver_table(rows):
    """Of the largest size."""
    largest = max(row["triangles"] for row in rows)
    return table(("system", "triangles", "unknowns", "solver", "order and structure, ms", "factor, ms", "solve, ms",
                  "entries of the factor", "residual"),
                 [(row["system"], f"{row['triangles']:,}", f"{row['unknowns']:,}", row["method"],
                   *(short(1e3 * row[f"seconds_{part}"]) for part in ("analyze", "factor", "solve")),
                   f"{row['entries']:,.0f}" if row["entries"] else "", f"{row['residual']:.0e}")
                  for row in rows if row["triangles"] == largest])


def made(numbers):
    """Tables by their marks, pictures by their names."""
    sizes = Sizes(numbers["flattening"])
    return ({
        "sizes": sizes.table(),
        "threads": sizes.parallel(),
        "solvers": solver_table(numbers["solvers"]),
    }, {
        "speed.svg": sizes.picture(),
    })


def sentences(numbers):
    """What speed.md must say."""
    sizes = Sizes(numbers["flattening"])
    triangles = sizes.sizes[1]
    rigid, isometric, peer = (
        sizes.row(method, triangles)["seconds"] for method in ("rigid", "isometric", "CGAL LSCM"))
    machine = numbers["machine"]
    command = {row["scheme"]: row for row in numbers["waiting"]}
    if {row["triangles"] for row in command.values()} != {triangles}:
        raise ValueError("the command was not run on the trouser leg of the second size")
    return [f"a trouser leg of {triangles:,} triangles the command takes "
            f"{command['isometric']['cpu_seconds']:.1f} s of processor time by default and "
            f"{command['global']['cpu_seconds']:.1f} s by `--scheme global`",
            f"takes {isometric:.1f} s and {1e3 * rigid:.0f} ms on two threads",
            f"knows one thread, {peer:.1f} s",
            f"measured on {machine['cores']} cores of an {machine['processor']}"]


def main():
    if sys.argv[1:] not in (["--write"], ["--check"]):
        sys.exit(__doc__)
    with open(os.path.join(HERE, "speed.json"), encoding="utf-8") as file:
        numbers = json.load(file)
    tables, files = made(numbers)
    files = {os.path.join("images", name): text for name, text in files.items()}
    files["speed.md"] = filled("speed.md", tables)
    old = unsaid("speed.md", sentences(numbers))
    for name, text in files.items():
        path = os.path.join(HERE, name)
        if sys.argv[1] == "--write":
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        elif not os.path.exists(path) or open(path, encoding="utf-8").read() != text:
            old.append(f"{name} is not what speed.json gives; speed.py --write makes it anew")
    if old:
        sys.exit("\n".join(old))


if __name__ == "__main__":
    main()
