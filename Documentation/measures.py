#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of gallery.md and comparison.md, made by the command wirewarp.

    measures.py --check    compares the tables with what the command gives
    measures.py --write    writes them anew

The environment variable WIREWARP names the command; by default it is that of build/.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "..", "Data")
COMMAND = os.environ.get("WIREWARP", os.path.join(HERE, "..", "build", "bin", "wirewarp"))
BEGIN, END = "<!-- measures -->\n", "<!-- /measures -->\n"
METHODS = ("lscm", "progressive", "global", "isometric")
PIECES = {  # and what they are
    "quarter_sphere": "90 degree lune of a sphere",
    "shirt_front": "loose shirt, front",
    "shirt_back": "loose shirt, back",
    "shirt_shoulder": "loose shirt, yoke",
    "pants_front": "left leg, front",
    "pants_back": "left leg, back",
    "wetsuit_upper_front": "tight upper body, front",
    "wetsuit_upper_back": "tight upper body, back",
    "wetsuit_pants_front": "tight pants, front",
    "wetsuit_pants_back": "tight pants, back",
    "shoe_upper": "upper of a slip-on shoe",
    "tshirt": "whole T-shirt, cut at its seams",
    "cylinder": "developable",
    "cone": "developable",
    "tangent_developable": "developable",
}
COMPARED = tuple(PIECES)[:11]


def measure(name, method):
    """The report's rows, one a piece."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [COMMAND, f"{DATA}/{name}.vtp", f"{DATA}/{name}_curves.vtp", "--scheme", method,
             "--quiet", "--output", folder], capture_output=True, text=True, check=False)
        if run.returncode not in (0, 4):  # 4: a broken promise, which the table shows
            raise RuntimeError(run.stderr)
        with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
            return json.load(file)["pieces"]


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def thousandths(value):
    return f"{1e3 * abs(value):.2f}"


def gallery():
    text = row(("piece", "what", "triangles", "pieces", "E_ang x 1e3", "E_h", "E_area", "overlaps"))
    text += row(["---"] * 8)
    for name, what in PIECES.items():
        pieces = measure(name, "isometric")
        text += row((
            f"`{name}`", what, str(sum(piece["triangles"] for piece in pieces)), str(len(pieces)),
            thousandths(max(piece["E_ang"] for piece in pieces)),
            f"{min(piece['E_h'] for piece in pieces):.3f}",
            f"{abs(max(piece['E_area'] for piece in pieces)):.4f}",
            str(sum(piece["overlaps"] for piece in pieces))))
    return text


def comparison():
    text = row(("piece", "method", "E_len x 1e3", "E_ang x 1e3", "E_h", "E_r", "E_area", "flips",
                "overlaps"))
    text += row(["---"] * 9)
    for name in COMPARED:
        for method in METHODS:
            piece, = measure(name, method)
            text += row((
                f"`{name}`" if method == METHODS[0] else "", method, thousandths(piece["E_len"]),
                thousandths(piece["E_ang"]), f"{piece['E_h']:.3f}", f"{piece['E_r']:.3f}",
                f"{piece['E_area']:.4f}", str(piece["flipped"]), str(piece["overlaps"])))
    return text


def differences(old, new):
    """Cells that differ by more than the last digit may by rounding."""
    old_cells, new_cells = (
        [[cell.strip() for cell in line.split("|")] for line in text.splitlines()]
        for text in (old, new))
    if [len(line) for line in old_cells] != [len(line) for line in new_cells]:
        return ["the tables have not the same rows"]
    found = []
    for line, other in zip(old_cells, new_cells):
        for cell, now in zip(line, other):
            if cell == now:
                continue
            digits = len(now.partition(".")[2])
            try:
                same = digits > 0 and abs(float(cell) - float(now)) < 1.5 * 10.0**-digits
            except ValueError:
                same = False
            if not same:
                found.append(f"{' '.join(line).strip()}: {cell} is {now} now")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true")
    what.add_argument("--write", action="store_true")
    options = parser.parse_args()

    found = []
    for page, table in (("gallery.md", gallery), ("comparison.md", comparison)):
        path = os.path.join(HERE, page)
        with open(path, encoding="utf-8") as file:
            before, rest = file.read().split(BEGIN)
        old, after = rest.split(END)
        new = table()
        if options.check:
            found += [f"{page}: {text}" for text in differences(old, new)]
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(before + BEGIN + new + END + after)
    if found:
        sys.exit("\n".join(found + ["measures.py --write writes the tables anew"]))


if __name__ == "__main__":
    main()
