#!/usr/bin/python3
"""Write the demonstration pieces: generate.py FOLDER [PIECE...]"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import developables
import pants
import quarter_sphere
import shirt
import shoe
import tshirt
import wetsuit
from output import writePiece


def unrolled(name):
    return lambda: (developables.make()[name], {})


PIECES = {
    "quarter_sphere": quarter_sphere.make,
    "cylinder": unrolled("cylinder"),
    "cone": unrolled("cone"),
    "tangent_developable": unrolled("tangent_developable"),
    "shirt_front": shirt.front,
    "shirt_back": shirt.back,
    "shirt_shoulder": shirt.shoulder,
    "wetsuit_upper_front": wetsuit.upperFront,
    "wetsuit_upper_back": wetsuit.upperBack,
    "wetsuit_pants_front": wetsuit.pantsFront,
    "wetsuit_pants_back": wetsuit.pantsBack,
    "pants_front": pants.front,
    "pants_back": pants.back,
    "shoe_upper": shoe.make,
    "tshirt": tshirt.make,
}


def main(arguments):
    if not arguments or any(name not in PIECES for name in arguments[1:]):
        print(__doc__ + "\nPieces: " + " ".join(PIECES), file=sys.stderr)
        return 2
    os.makedirs(arguments[0], exist_ok=True)
    for name in arguments[1:] or PIECES:
        mesh, sets = PIECES[name]()
        writePiece(mesh, name, arguments[0], sets)
        print(f"{name}: {len(mesh.triangles)} triangles, {len(mesh.curves)} curves")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
