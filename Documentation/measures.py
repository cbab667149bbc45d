#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of comparison.md, made by the command wirewarp.

    measures.py --check    compares the tables with what the command gives
    measures.py --write    writes them anew

Both check the numbers in its sentences and in those of tutorial.md. The environment
variable WIREWARP names the command; by default it is that of build/.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

from pages import HERE, between_marks, filled, table, unsaid, write

DATA = os.path.normpath(os.path.join(HERE, "..", "Data"))
COMMAND = os.environ.get("WIREWARP", os.path.join(HERE, "..", "build", "bin", "wirewarp"))
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
CURVED = [name for name, what in PIECES.items() if what != "developable"]
# As each method has them: none makes legs of darts alike by itself.
LEGS = ("--dart-legs", "free")
METHODS = {  # and the options that ask for them
    "lscm": ("--scheme", "lscm"),
    "progressive, Laplacian": ("--scheme", "progressive", "--interior", "laplacian", *LEGS),
    "progressive, rigid": ("--scheme", "progressive", "--interior", "arap", *LEGS),
    "global, Laplacian": ("--scheme", "global", "--interior", "laplacian", *LEGS),
    "global, rigid": ("--scheme", "global", "--interior", "arap", *LEGS),
    "isometric": ("--scheme", "isometric", *LEGS),
}
NUMBERS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
           "eleven", "twelve")


def run(*arguments):
    ended = subprocess.run([COMMAND, *arguments, "--quiet"], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 4):  # 4: a warning, which the table shows
        raise RuntimeError(ended.stderr)


def report(folder):
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        return json.load(file)


def flatten_all(method):
    """The report of each surface of Data/ by its name."""
    with tempfile.TemporaryDirectory() as folder:
        names = os.path.join(folder, "list.txt")
        with open(names, "w", encoding="utf-8") as file:
            file.writelines(f'"{DATA}/{name}.vtp" "{DATA}/{name}_curves.vtp"\n' for name in PIECES)
        run("batch", names, "--output", folder, "sew", *METHODS[method], "--once")
        return {name: report(os.path.join(folder, name)) for name in PIECES}


def worst(of):
    """Of the pieces of a surface's report the worst measures, and counts of all."""
    pieces, sewn = of["pieces"], of["resewn"]
    result = {key: max(piece[key] for piece in pieces) for key in ("E_len", "E_len_max", "E_ang", "E_area", "strain_p95")}
    result.update({key: min(piece[key] for piece in pieces) for key in ("E_h", "E_r")})
    result.update({key: sum(piece[key] for piece in pieces) for key in ("triangles", "flipped", "overlaps")})
    result["pieces"] = len(pieces)
    for key, measure in (("sewn_distance", "distance_mean_relative"), ("sewn_strain", "strain_p95")):
        result[key] = max((row[measure] for row in sewn), default=None)
    result["at_rest"] = all(row["converged"] for row in sewn)
    result["released"] = any(piece["status"] == "IncompatibleKeys" for piece in pieces)
    return result


def thousandths(value):
    return f"{1e3 * abs(value):.2f}"


def comparison(measures):
    rows = []
    for name in CURVED:
        for method in METHODS:
            of = measures[method][name]
            rows.append((
                f"`{name}`" if method == next(iter(METHODS)) else "",
                method + (" (key released)" if of["released"] else ""), thousandths(of["E_len"]),
                thousandths(of["E_ang"]), f"{of['E_h']:.3f}", f"{of['E_r']:.3f}",
                f"{abs(of['E_area']):.4f}", f"{of['strain_p95']:.3f}", f"{100 * of['sewn_distance']:.2f}",
                f"{100 * of['sewn_strain']:.2f}", of["flipped"], of["overlaps"]))
    return table(("piece", "method", "E_len x 1e3", "E_ang x 1e3", "E_h", "E_r", "E_area", "strain p95",
                  "sewn distance %", "sewn strain %", "flips", "overlaps"), rows)


def area_shares(measures, method):
    """The isometric scheme's area error as a share of the method's, sorted, on the curved pieces."""
    return sorted(measures["isometric"][name]["E_area"] / measures[method][name]["E_area"] for name in CURVED)


def shares(measures):
    rows = []
    for method in list(METHODS)[:-1]:
        of = area_shares(measures, method)
        rows.append((method, *(f"{value:.2f}" for value in (of[0], statistics.median(of), of[-1]))))
    return table(("method", "least", "median", "greatest"), rows)


def best(measures, key, better):
    """How many curved pieces each method has the best value on."""
    winners = [better(METHODS, key=lambda method: measures[method][name][key]) for name in CURVED]
    return {method: NUMBERS[winners.count(method)] for method in METHODS}


def percent(value):
    return f"{100 * value:.{0 if value >= 0.01 else 1}f}"


def sentences(measures):
    """What the pages must say, a list a page; what does not hold is worded otherwise."""
    isometric, rigid, lscm = (measures[method] for method in ("isometric", "global, rigid", "lscm"))
    all_curved = NUMBERS[len(CURVED)]
    flips = sum(of["flipped"] for of in isometric.values())
    exact = all(of["E_len_max"] < 1e-12 for method in METHODS if method != "lscm"
                for of in measures[method].values())
    lengths = [lscm[name]["E_len"] for name in CURVED]
    more_homogeneous = sum(isometric[name]["E_h"] > lscm[name]["E_h"] for name in CURVED)
    less_homogeneous = [
        f"`{name}` ({isometric[name]['E_h']:.3f} against {rigid[name]['E_h']:.3f})"
        for name in CURVED if round(isometric[name]["E_h"], 3) < round(rigid[name]["E_h"], 3)]
    greater_angles = [f"`{name}`" for name in CURVED if isometric[name]["E_ang"] > rigid[name]["E_ang"]]
    distorted = {method: [f"`{name}`" for name in PIECES if name not in CURVED
                          and max(measures[method][name]["E_ang"], measures[method][name]["E_len"]) > 1e-9]
                 for method in METHODS}
    unrolled = all(bool(names) == method.endswith("Laplacian") for method, names in distorted.items())
    flipped = [f"{of['flipped']} by {method}, on `{name}`" for method in METHODS
               for name, of in measures[method].items() if of["flipped"]]
    median = {method: f"{statistics.median(area_shares(measures, method)):.2f}" for method in METHODS}
    aspect_ratio = best(measures, "E_r", max)
    return {
        "comparison.md": [
            f"by LSCM a wire edge is off by {percent(min(lengths))} to {percent(max(lengths))} % in the mean",
            "exact to rounding" if exact else "not exact",
            f"LSCM is best at, on all {best(measures, 'E_ang', min)['lscm']} curved pieces",
            f"least E_area of all methods on all {best(measures, 'E_area', min)['isometric']}",
            f"and a better E_h than LSCM on all {NUMBERS[more_homogeneous]}",
            f"the isometric scheme is best on {aspect_ratio['isometric']} of the curved pieces, LSCM on "
            f"{aspect_ratio['lscm']}",
            f"E_ang is smaller on all but {' and '.join(greater_angles)}",
            f"to three digits E_h is worse on {' and '.join(less_homogeneous)} alone",
            f"flipped: {'; '.join(flipped)}.",
            f"The Laplacian interior distorts even {' and '.join(sorted(distorted['global, Laplacian']))}."
            + (" All other methods unroll the developable pieces exactly." if unrolled else ""),
            *sewn_sentences(),
            f"On the {all_curved} curved pieces the isometric scheme "
            + ("flips no triangle" if not flips else f"flips {flips} triangles"),
            f"in the median {median['global, Laplacian']} of the area error of the paper's global scheme",
            f"{median['global, rigid']} of that of `--scheme global`",
            f"{median['lscm']} of that of a least squares conformal map",
        ],
        "tutorial.md": tutorial_sentences(),
    }


def sewn_sentences():
    """What comparison.md must say of sewn cloth, by its own table: a figure may differ by a tenth from run to run."""
    rows, name = {}, ""
    for line in between_marks("comparison.md", "measures").splitlines()[2:]:
        cells = [cell.strip() for cell in line.split("|")]
        name = cells[1].strip("`") or name
        rows[name, cells[2].replace(" (key released)", "")] = (float(cells[9]), float(cells[10]))

    def least(which):
        return sum(all(rows[name, "isometric"][which] <= rows[name, method][which] for method in METHODS)
                   for name in CURVED)

    better = sorted({f"`{name}`" for name in CURVED for method in METHODS
                     if all(a < b for a, b in zip(rows[name, method], rows[name, "isometric"]))})
    nearer = sum(rows[name, "lscm"][0] < rows[name, "isometric"][0] for name in CURVED)
    strained = [rows[name, "lscm"][1] for name in CURVED]
    return [
        f"the isometric scheme lies nearest to the design on {NUMBERS[least(0)]} of the twelve curved pieces, and "
        f"is strained least on {NUMBERS[least(1)]}",
        f"nearer and strained less at once on {' and '.join(better)} alone",
        f"LSCM is nearer than it on {NUMBERS[nearer]} of them, with up to {max(strained):.0f} % of strain",
    ]


def tutorial_sentences():
    areas = []
    for curves in ([], [os.path.join(HERE, "tutorial_curves.txt")]):
        with tempfile.TemporaryDirectory() as folder:
            run(f"{DATA}/shirt_front.vtp", *curves, "--scheme", "isometric", "--output", folder)
            areas.append(f"{100 * worst(report(folder))['E_area']:.1f}")
    return [f"{areas[0]} % of the area had to come or go", f"took the area error down to {areas[1]} %"]


def differences(old, new):
    """Cells that differ by more than the last digit may by rounding, or, of cloth that was sewn, by more than
    a tenth: where it buckles, rounding chooses the folds."""
    old_cells, new_cells = (
        [[cell.strip() for cell in line.split("|")] for line in text.splitlines()]
        for text in (old, new))
    if [len(line) for line in old_cells] != [len(line) for line in new_cells]:
        return ["the tables have not the same rows"]
    found = []
    name = ""
    for line, other in zip(old_cells, new_cells):
        name = other[1] or name
        for head, cell, now in zip(new_cells[0], line, other):
            if cell == now:
                continue
            digits = len(now.partition(".")[2])
            try:
                chance = 0.1 * abs(float(now)) if head.startswith("sewn") else 0.0
                same = digits > 0 and abs(float(cell) - float(now)) < 1.5 * 10.0**-digits + chance
            except ValueError:
                same = False
            if not same:
                found.append(f"{name}, {' '.join(line[2:]).strip()}: {cell} is {now} now")
    return found


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true")
    what.add_argument("--write", action="store_true")
    options = parser.parse_args()

    measures = {
        method: {name: worst(of) for name, of in flatten_all(method).items()} for method in METHODS}
    tables = {
        "comparison.md": {"shares": shares(measures), "measures": comparison(measures)},
    }
    found = []
    for page, new in tables.items():
        if options.write:
            write(page, filled(page, new))
            continue
        for mark, text in new.items():
            found += [f"{page}: {fault}" for fault in differences(between_marks(page, mark), text)]
    if found:
        found.append("measures.py --write writes the tables anew")
    for page, wanted in sentences(measures).items():
        found += unsaid(page, wanted)
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    main()
