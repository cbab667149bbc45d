#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From the OBJ file of a modeller to a pattern to cut: SVG, PDF or DXF at true scale.

Faces are the surface. Line elements (l) are feature curves along its vertices: those of an object or
group called "key ...", "dart ..." or "seam ..." are of that type, all others keep their length only.
"""

import argparse
from typing import Dict, List, Tuple

import surfaceflattening as sf

TYPES: Dict[str, sf.CurveType] = {"key": "key", "dart": "dart", "seam": "seam"}


def read_obj(
    path: str
) -> Tuple[List[List[float]], List[Tuple[int, int, int]], List[sf.Curve]]:
    """Points, triangles and curves; positions keep their double precision."""
    points: List[List[float]] = []
    triangles: List[Tuple[int, int, int]] = []
    lines: Dict[str, List[List[int]]] = {}
    group = ""
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words[0] in ("o", "g"):
                group = " ".join(words[1:])
            elif words[0] in ("f", "l"):
                ids = [int(word.split("/")[0]) for word in words[1:]]
                ids = [i - 1 if i > 0 else len(points) + i for i in ids]
                if words[0] == "l":
                    lines.setdefault(group, []).append(ids)
                else:
                    triangles += [(ids[0], a, b) for a, b in zip(ids[1:], ids[2:])]
    curves = []
    for name, parts in lines.items():
        word = name.replace("_", " ").lower().split(" ")[0]
        kind = TYPES.get(word, "accessory")
        for number, ids in enumerate(join(parts)):
            curves.append(sf.Curve(ids, kind, f"{name} {number + 1}" if number else name))
    return points, triangles, curves


def join(parts: List[List[int]]) -> List[List[int]]:
    """Modellers write a line an edge: joins those that follow each other."""
    chains: List[List[int]] = []
    for ids in parts:
        if chains and chains[-1][-1] == ids[0]:
            chains[-1] += ids[1:]
        else:
            chains.append(list(ids))
    return chains


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="an .obj file")
    parser.add_argument("pattern", help="the .svg, .pdf or .dxf file to write")
    parser.add_argument("--unit", required=True, choices=("mm", "cm", "m", "inch"),
                        help="unit of length of the .obj file, which does not say it")
    parser.add_argument("--name", default="pattern", help="what is written on the pieces")
    parser.add_argument("--allowance", type=float, default=10.0, help="seam allowance in mm")
    options = parser.parse_args()

    points, triangles, curves = read_obj(options.surface)
    try:
        result = sf.flatten(points, triangles, curves)
        result.write_pattern(options.pattern, unit=options.unit, name=options.name,
                             allowance=options.allowance)
    except (sf.FlatteningError, ValueError, OSError) as error:
        parser.exit(1, f"{error}\n")
    print(f"{options.pattern}: {len(result.report['pieces'])} piece(s), {len(curves)} curve(s)")


if __name__ == "__main__":
    main()
