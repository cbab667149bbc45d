# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of patterns share: the lengths that the files must have, and readers that did not write them."""

import math
import os
import re
import subprocess
from collections import namedtuple
from xml.etree import ElementTree

import ezdxf
import numpy as np

from surfaces import DATA, command, read_file

SVG, INKSCAPE = command.SVG, command.INKSCAPE

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}

# edges: lengths on the surface in millimetres, in the order of the polyline
Wire = namedtuple("Wire", "name kind piece edges")
ACCESSORY, KEY, DART, SEAM, BOUNDARY = 0, 1, 2, 3, -1


class PatternTest(command.CommandTest):
    def content(self, name):
        """Bytes of a file of the folder `out`."""
        with open(self.path("out", name), "rb") as file:
            return file.read()

    def run_command(self, *arguments, **options):
        return super().run_command(*arguments, env=dict(os.environ, SOURCE_DATE_EPOCH="1000000000"), **options)

    def make(self, piece, *options, unit="cm"):
        """Flattens a piece of Data into `out` with the given patterns."""
        return self.run_command("pattern" if "-o" in options else "flatten", *command.data_files(piece), "--unit", unit,
                                "--output", "out", "--quiet", *options, code=(0, 4))

    def svg(self):
        """The root of pattern.svg."""
        return svg_root(self.path("out", "pattern.svg"))

    def dxf(self):
        """The document of pattern.dxf, in which the audit finds nothing, and the blocks of the pieces."""
        document, audit = read_dxf(self.path("out", "pattern.dxf"))
        self.assertEqual(audit, [])
        return document, [document.blocks.get(insert.dxf.name) for insert in document.modelspace().query("INSERT")]

    def notes(self):
        """What report.json says of the pieces of the pattern."""
        return self.report("out")["pattern_notes"]

    def make_raw(self, piece, *options, **more):
        """The same with an edge of the pattern for each edge of the mesh."""
        return self.make(piece, "--smooth", "0", *options, **more)


def bezier_length(control):
    """Length of a cubic Bezier curve, by Gauss's rule on 8 parts."""
    places, weights = np.polynomial.legendre.leggauss(12)
    total = 0.0
    for part in range(8):
        u = ((part + 0.5 + places / 2) / 8)[:, None]
        v = 1 - u
        slope = 3 * (v**2 * (control[1] - control[0]) + 2 * u * v * (control[2] - control[1])
                     + u**2 * (control[3] - control[2]))
        total += float(weights @ np.linalg.norm(slope, axis=1)) / 16
    return total


def bezier_points(control, count):
    """At the ends of equal parts of its parameter."""
    u = np.linspace(0.0, 1.0, count + 1)[:, None]
    v = 1 - u
    return v**3 * control[0] + 3 * u * v**2 * control[1] + 3 * u**2 * v * control[2] + u**3 * control[3]


def wires_in_space(folder, unit):
    """The wires of wires.vtp, measured on the cut surface of cut.vtp."""
    wires = read_file(os.path.join(folder, "wires.vtp"))
    surface = read_file(os.path.join(folder, "cut.vtp"))
    data = wires.GetCellData()
    result = []
    for cell in range(wires.GetNumberOfCells()):
        if data.GetArray("Connector").GetValue(cell):
            continue
        ids = wires.GetCell(cell).GetPointIds()
        places = [surface.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]
        result.append(Wire(*(data.GetAbstractArray(name).GetValue(cell) for name in ("CurveName", "CurveType", "PieceId")),
                           [MILLIMETRES[unit] * math.dist(a, b) for a, b in zip(places, places[1:])]))
    return result


def edge_lengths(points, closed=False):
    ends = points[1:] + points[:1] if closed else points[1:]
    return [math.dist(a, b) for a, b in zip(points, ends)]


def svg_root(path):
    return ElementTree.parse(path).getroot()


def svg_scale(root):
    """Millimetres of a user unit, from width, height and viewBox; both must agree."""
    box = [float(number) for number in root.get("viewBox").split()]
    scales = []
    for attribute, extent in (("width", box[2]), ("height", box[3])):
        number, unit = re.fullmatch(r"([\d.]+)([a-z]+)", root.get(attribute)).groups()
        scales.append(float(number) * MILLIMETRES[unit] / extent)
    assert math.isclose(*scales, rel_tol=1e-12), scales
    return scales[0]


def path_points(element):
    """Points and closedness of a path of straight lines in absolute coordinates."""
    commands = re.findall(r"([A-Za-z])([^A-Za-z]*)", element.get("d"))
    points = []
    closed = False
    for letter, numbers in commands:
        if letter == "Z":
            closed = True
            continue
        assert letter in "ML", letter
        points.append(tuple(float(number) for number in numbers.replace(",", " ").split()))
    return points, closed


def curves_of(element):
    """Bezier curves of a path of M, L, C and Z with absolute coordinates."""
    curves, at, first = [], None, None
    for letter, numbers in re.findall(r"([MLCZ])([^MLCZ]*)", element.get("d")):
        points = np.array([float(word) for word in numbers.replace(",", " ").split()]).reshape(-1, 2)
        if letter == "M":
            at = first = points[0]
        elif letter == "C":
            curves.append(np.array([at, *points]))
            at = points[-1]
        else:
            end = first if letter == "Z" else points[0]
            if np.linalg.norm(end - at) > 0:
                curves.append(np.array([at, at + (end - at) / 3, end - (end - at) / 3, end]))
            at = end
    return curves


def svg_elements(root, kind):
    """(piece, element) of all paths of one class."""
    return [(number, element) for number, group in enumerate(pieces_of(root)) for layer in group.findall(SVG + "g")
            if layer.get("class") == kind for element in layer.findall(SVG + "path")]


def svg_paths(root, kind):
    """(piece, element, points, closed) of all paths of one class, of straight lines."""
    return [(number, element, *path_points(element)) for number, element in svg_elements(root, kind)]


def pieces_of(root):
    return [group for group in root.iter(SVG + "g") if (group.get("id") or "").startswith("piece-")]


def read_dxf(path):
    """The document and what the audit finds in it.

    ezdxf 0.18 forgets the owner of the SEQEND that ends an R12 polyline in a block, and then complains of
    it, in files of its own as well: these are left out.
    """
    document = ezdxf.readfile(path)
    audit = document.audit()
    found = [entry.message for entry in audit.errors + audit.fixes]
    forgotten = re.compile(r"Deleted SEQEND\(#\w+\) entity with invalid owner handle #None\.")
    return document, [message for message in found if not forgotten.fullmatch(message)]


def block_lines(block, *layers):
    """Points and closedness of the polylines of a block on the given layers."""
    return [([(v.dxf.location.x, v.dxf.location.y) for v in line.vertices], line.is_closed)
            for line in block.query("POLYLINE") if line.dxf.layer in layers]


def run_tool(*command):
    return subprocess.run(command, capture_output=True, check=True, timeout=120).stdout


def render(path, resolution, first=1, last=None, gray=True):
    """Pages as (width, height, bytes), one byte a pixel, or three where not gray."""
    limits = ["-f", str(first)] + (["-l", str(last)] if last else [])
    stream = run_tool("pdftoppm", "-r", str(resolution), *(["-gray"] if gray else []), *limits, path)
    pages = []
    at = 0
    while at < len(stream):
        header = re.compile(rb"P[56]\n(\d+) (\d+)\n255\n").match(stream, at)
        width, height = int(header.group(1)), int(header.group(2))
        size = width * height * (1 if gray else 3)
        pages.append((width, height, stream[header.end() : header.end() + size]))
        at = header.end() + size
    return pages


def darkest_columns(page, row):
    """Columns of one row at which a dark line crosses it, as centres weighted by darkness."""
    width, _, pixels = page
    return line_centres([255 - value for value in pixels[row * width : (row + 1) * width]])


def darkest_rows(page, column):
    width, height, pixels = page
    return line_centres([255 - pixels[row * width + column] for row in range(height)])


def line_centres(darkness):
    centres = []
    run = []
    for place, value in enumerate(darkness + [0]):
        if value > 25:
            run.append((place, value))
        elif run:
            weight = sum(value for _, value in run)
            if max(value for _, value in run) > 100:
                centres.append(sum(place * value for place, value in run) / weight)
            run = []
    return centres


def distance_to(point, line):
    """Distance of a point from a closed polyline."""
    least = math.inf
    for (ax, ay), (bx, by) in zip(line, line[1:] + line[:1]):
        square = (bx - ax) ** 2 + (by - ay) ** 2
        along = ((point[0] - ax) * (bx - ax) + (point[1] - ay) * (by - ay)) / square if square else 0
        along = min(1.0, max(0.0, along))
        least = min(least, math.dist(point, (ax + along * (bx - ax), ay + along * (by - ay))))
    return least
