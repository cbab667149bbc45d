# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command share: running it, surfaces to feed it, reading what it writes."""

import csv
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

EXECUTABLE = os.environ.get("WIREWARP")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(SOURCE, "Data")
SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def data_files(name, curves="_curves"):
    """Paths of a piece of Data/ and of its curves."""
    return os.path.join(DATA, name + ".vtp"), os.path.join(DATA, name + curves + ".vtp")


class WordsTest(unittest.TestCase):
    def assert_words(self, words, text):
        """One text, or each of several, is part of another."""
        for word in (words,) if isinstance(words, str) else words:
            self.assertIn(word, text)

    def assert_raises(self, kind, words, call, *arguments, **options):
        """The exception, whose text holds these words."""
        with self.assertRaises(kind) as caught:
            call(*arguments, **options)
        self.assert_words(words, str(caught.exception))
        return caught.exception


class CommandTest(WordsTest):
    """Each test runs in a folder of its own."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="wirewarp test ")
        self.folder = self._folder.name
        self.addCleanup(self._folder.cleanup)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
        return name

    def read(self, *names):
        with open(self.path(*names), encoding="utf-8", newline="") as file:
            return file.read()

    def table(self, *names):
        """The rows of a CSV file as dictionaries."""
        return list(csv.DictReader(self.read(*names).splitlines()))

    def run_command(self, *arguments, code=None, **options):
        """Runs wirewarp in the test's folder, to this exit code or one of these."""
        run = subprocess.run([EXECUTABLE, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=300,
                             check=False, **options)
        if code is not None:
            self.assertIn(run.returncode, code if isinstance(code, tuple) else (code,), run.stdout + run.stderr)
        return run

    def assert_stderr(self, words, *arguments, code=3):
        """Runs wirewarp to this exit code; these words are on stderr."""
        run = self.run_command(*arguments, code=code)
        self.assert_words(words, "\n".join(error_lines(run)))
        return run

    def flatten(self, *arguments, code=0):
        """Runs wirewarp into the folder `out` and gives its report."""
        self.run_command(*arguments, "--output", "out", code=code)
        return self.report("out")

    def report(self, folder, name="report.json"):
        return read_json(self.path(folder, name))

    def array(self, file, name, within="Piece"):
        return read_array(self.path(file), name, within)

    def write_lune(self, scale=1.0):
        """The quarter-sphere as lune.obj, and its arc as the accessory curve of arc.txt."""
        self.points, self.triangles, self.arc = quarter_sphere()
        self.write("lune.obj", obj([tuple(scale * x for x in point) for point in self.points], self.triangles))
        self.write("arc.txt", "accessory arc " + " ".join(map(str, self.arc)) + "\n")


def read_json(path):
    """A file that holds numbers alone: neither NaN nor infinity."""
    def refuse_constant(name):
        raise AssertionError(f"a number in {path} is {name}")

    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_constant=refuse_constant)


def main():
    """Runs the tests of the calling file."""
    unittest.main(argv=[sys.argv[0]], verbosity=2)


# Surfaces ---------------------------------------------------------------------------------------


def quarter_sphere():
    """The paper's quarter-sphere (Fig. 11): points, triangles, and the arc half-way between the poles."""

    def point(longitude, latitude):
        a, b = math.pi / 8 * longitude, math.pi / 8 * latitude
        return (math.sin(b) * math.cos(a), math.sin(b) * math.sin(a), math.cos(b))

    def vertex(i, j):
        return 0 if j == 0 else 36 if j == 8 else 5 * j - 4 + i

    triangles = []
    for i in range(4):
        for j in range(8):
            a, b, c, d = vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)
            triangles += [t for t in ((a, b, c), (a, c, d)) if len(set(t)) == 3]
    points = [point(0, 0)] + [point(i, j) for j in range(1, 8) for i in range(5)] + [point(0, 8)]
    return points, triangles, [vertex(i, 4) for i in range(5)]


def grid(columns, rows, place, closed=False, other=lambda i, j: False):
    """Squares between the points place(i, j), which are vertices by grid_ids(), or a tube where it is closed, split into
    triangles by one diagonal, or the other one."""
    wide = columns if closed else columns + 1
    points = [place(i, j) for j in range(rows + 1) for i in range(wide)]
    triangles = []
    for j in range(rows):
        for i in range(columns):
            a, b = j * wide + i, j * wide + (i + 1) % wide
            c, d = b + wide, a + wide
            triangles += [(a, b, d), (b, c, d)] if other(i, j) else [(a, b, c), (a, c, d)]
    return points, triangles


def grid_ids(columns):
    """The vertex (i, j) of a grid, as a function."""
    return lambda i, j: j * (columns + 1) + i


def tube(columns, rows, ring, deep=1.0):
    """A tube about the z axis, whose ring j has the radius and the height of ring(j); along y that radius is `deep` times
    as large."""
    def place(i, j):
        turn, (radius, height) = 2 * math.pi * i / columns, ring(j)
        return radius * math.cos(turn), deep * radius * math.sin(turn), height
    return grid(columns, rows, place, closed=True)


def sheet(columns=4, rows=4):
    """A sheet of squares over a cylinder of radius 1."""
    return grid(columns, rows, lambda i, j: (math.cos(0.3 * i), math.sin(0.3 * i), 0.25 * j))


def dome(columns=14, rows=14, height=0.5, other=lambda i, j: (i + j) % 2 == 0):
    """A dome over the square from -1 to 1; by default its own mirror image, triangles and all."""
    def place(i, j):
        x, y = 2 * i / columns - 1, 2 * j / rows - 1
        return x, y, height * (1 - x * x) * (1 - y * y)
    return grid(columns, rows, place, other=other)


def hill(height):
    """A bump over a square of 6 x 6."""
    return grid(6, 6, lambda i, j: (i, j, height * i * (6 - i) * j * (6 - j) / 9))


def cap(angle, rings, count, size=1.0):
    """The sphere about its pole, which is vertex 0, down to an angle."""
    points, triangles = tube(count, rings - 1, lambda j: (
        size * math.sin(angle * (j + 1) / rings), size * math.cos(angle * (j + 1) / rings)))
    return [(0.0, 0.0, size), *points], [(0, 1 + k, 1 + (k + 1) % count) for k in range(count)] + [
        (a + 1, c + 1, b + 1) for a, b, c in triangles]


def ring(count=24):
    """A flat ring of radii 1 and 3."""
    return tube(count, 2, lambda j: (1 + j, 0.0))


TETRAHEDRON = ([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def together(*surfaces):
    """Surfaces as one, each of points and triangles, their triangles in this order."""
    points, triangles = [], []
    for part_points, part_triangles in surfaces:
        triangles += [tuple(v + len(points) for v in t) for t in part_triangles]
        points += part_points
    return points, triangles


def torus(count=6):
    """A closed surface with one handle."""
    points, triangles = tube(count, count, lambda j: (
        3 + math.cos(2 * math.pi * j / count), math.sin(2 * math.pi * j / count)))
    return points[:count * count], [tuple(v % (count * count) for v in t) for t in triangles]


def obj(points, triangles):
    lines = ["v %r %r %r" % tuple(point) for point in points]
    lines += ["f " + " ".join(str(v + 1) for v in triangle) for triangle in triangles]
    return "\n".join(lines) + "\n"


def legacy(points, polygons=(), polylines=(), cell_data=""):
    """Legacy polydata, ASCII, double."""
    text = "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET POLYDATA\nPOINTS %d double\n" % len(points)
    text += "".join("%r %r %r\n" % tuple(point) for point in points)
    for keyword, cells in (("LINES", polylines), ("POLYGONS", polygons)):
        if cells:
            text += "%s %d %d\n" % (keyword, len(cells), sum(len(cell) + 1 for cell in cells))
            text += "".join(" ".join(map(str, [len(cell), *cell])) + "\n" for cell in cells)
    return text + cell_data


def legacy_curves(points, curves):
    """Curves as (type, name, vertices) in legacy polydata."""
    data = "CELL_DATA %d\nFIELD FieldData 2\nCurveType 1 %d int\n" % (len(curves), len(curves))
    data += " ".join(str(curve[0]) for curve in curves) + "\n"
    data += "CurveName 1 %d string\n" % len(curves)
    data += "".join(curve[1] + "\n" for curve in curves)
    return legacy(points, polylines=[curve[2] for curve in curves], cell_data=data)


def xml_polydata(points, triangles):
    """XML polydata, ASCII, double."""
    count = len(triangles)
    return (
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
        '<Piece NumberOfPoints="%d" NumberOfPolys="%d">' % (len(points), count)
        + '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
        + " ".join("%r %r %r" % tuple(point) for point in points)
        + '</DataArray></Points><Polys><DataArray type="Int64" Name="connectivity" format="ascii">'
        + " ".join("%d %d %d" % tuple(triangle) for triangle in triangles)
        + '</DataArray><DataArray type="Int64" Name="offsets" format="ascii">'
        + " ".join(str(3 * k + 3) for k in range(count))
        + "</DataArray></Polys></Piece></PolyData></VTKFile>\n"
    )


def ply(points, triangles, order):
    """PLY with doubles; `order` is '<', '>' or '' for ASCII."""
    name = {"<": "binary_little_endian", ">": "binary_big_endian", "": "ascii"}[order]
    head = (
        "ply\nformat %s 1.0\nelement vertex %d\n" % (name, len(points))
        + "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
        + "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % len(triangles)
    )
    if not order:
        lines = ["%r %r %r 7" % tuple(point) for point in points]
        lines += ["3 %d %d %d" % tuple(triangle) for triangle in triangles]
        return head + "\n".join(lines) + "\n"
    data = b"".join(struct.pack(order + "dddB", *point, 7) for point in points)
    data += b"".join(struct.pack(order + "Biii", 3, *triangle) for triangle in triangles)
    return head.encode() + data


def ply_strips(points, strips, order):
    """PLY with triangle strips; `order` as in ply()."""
    head, _ = ply(points, [], "").split("element face")
    head = head.replace("ascii", "binary_little_endian") if order else head
    head += "element tristrips %d\nproperty list int int vertex_indices\nend_header\n" % len(strips)
    lists = [[len(strip), *strip] for strip in strips]
    if not order:
        lines = ["%r %r %r 7" % tuple(point) for point in points] + [" ".join(map(str, row)) for row in lists]
        return head + "\n".join(lines) + "\n"
    data = b"".join(struct.pack(order + "dddB", *point, 7) for point in points)
    return head.encode() + data + b"".join(struct.pack("%s%di" % (order, len(row)), *row) for row in lists)


def stl(points, triangles):
    """Binary STL, single precision."""
    data = b"binary".ljust(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        corners = [x for vertex in triangle for x in points[vertex]]
        data += struct.pack("<12fH", 0.0, 0.0, 0.0, *corners, 0)
    return data


# Results ----------------------------------------------------------------------------------------

def read_array(path, name, within="Piece"):
    """Values of an array of a file of VTK in a list; points are called Points, corners of cells within Lines or Polys
    connectivity and offsets."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if within in ("Lines", "Polys"):
        cells = getattr(data, "Get" + within)()
        array = cells.GetConnectivityArray() if name == "connectivity" else cells.GetOffsetsArray()
        return vtk_to_numpy(array).tolist()[0 if name == "connectivity" else 1:]
    array = data.GetPoints().GetData() if name == "Points" else (
        data.GetPointData().GetArray(name) or data.GetCellData().GetArray(name))
    if not array:
        raise KeyError(name)
    return vtk_to_numpy(array).ravel().tolist()


def nest_layers(path):
    """Names and points of the lines of each size of a nest in SVG, by the names of the sizes."""
    return {group.get("data-size"): [
        (path.get("data-curve"), [tuple(map(float, pair.split(","))) for pair in path.get("d")[1:].split(" L")])
        for path in group.findall(SVG + "path")] for group in ElementTree.parse(path).getroot().findall(SVG + "g")}


def read_png(path):
    """The pixels of a picture as rows of three numbers from 0 to 255."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).astype(int).reshape(height, width, -1)[:, :, :3]


def error_lines(run):
    """What the command complained of; every line of stderr must be its own."""
    lines = run.stderr.splitlines()
    foreign = [line for line in lines if not re.match(r"wirewarp: |Try 'wirewarp", line)]
    if foreign:
        raise AssertionError("stderr holds lines of others: %r" % foreign)
    return lines
