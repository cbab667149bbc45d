#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From the OBJ file of a modeller to a pattern to cut: SVG, PDF or DXF at true scale.

Faces are the surface. Line elements (l) are feature curves along its vertices: those of an object or
group called "key ...", "dart ..." or "seam ..." are of that type, all others keep their length only.
"""

import argparse

import surfaceflattening as sf


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help="an .obj file")
    parser.add_argument("pattern", help="the .svg, .pdf or .dxf file to write")
    parser.add_argument("--unit", required=True, choices=("mm", "cm", "m", "inch"),
                        help="unit of length of the .obj file, which does not say it")
    parser.add_argument("--name", default="pattern", help="what is written on the pieces")
    parser.add_argument("--allowance", type=float, default=10.0, help="seam allowance in mm")
    options = parser.parse_args()

    try:
        result = sf.flatten_polydata(*sf.read_surface(options.surface))
        result.write_pattern(options.pattern, unit=options.unit, name=options.name,
                             allowance=options.allowance)
    except (ValueError, OSError) as error:
        parser.exit(1, f"{error}\n")
    print(f"{options.pattern}: {len(result.report['pieces'])} piece(s), {len(result.report['curves'])} curve(s)")


if __name__ == "__main__":
    main()
