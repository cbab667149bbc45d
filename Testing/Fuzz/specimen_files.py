# SPDX-License-Identifier: BSD-3-Clause
"""Small sound files of every format that the command reads, for mutated_files.py to damage."""

import base64
import struct
import zlib

import command

POINTS, TRIANGLES = command.sheet(2, 2)
STRIP = [0, 3, 1, 4, 2, 5, -1, 3, 6, 4, 7, 5, 8]
CURVES = [(0, "a", [3, 4, 5]), (1, "b", [1, 4, 7])]


def legacy_binary():
    """Version 3, big-endian, with arrays."""
    text = b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS 9 double\n"
    text += b"".join(struct.pack(">3d", *point) for point in POINTS)
    text += b"\nPOLYGONS 8 32\n" + b"".join(struct.pack(">4i", 3, *t) for t in TRIANGLES)
    text += b"\nPOINT_DATA 9\nSCALARS heat float 1\nLOOKUP_TABLE default\n" + struct.pack(">9f", *range(9))
    return text + b"\nFIELD FieldData 1\nload 2 9 int\n" + struct.pack(">18i", *range(18)) + b"\n"


def legacy_offsets():
    """Version 5.1, ASCII."""
    text = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 9 float\n"
    text += " ".join("%g %g %g" % point for point in POINTS)
    text += "\nPOLYGONS 9 24\nOFFSETS vtktypeint64\n" + " ".join(str(3 * k) for k in range(9))
    text += "\nCONNECTIVITY vtktypeint64\n" + " ".join("%d %d %d" % t for t in TRIANGLES)
    text += "\nMETADATA\nINFORMATION 0\n\nCELL_DATA 8\nNORMALS n double\n" + "0 0 1\n" * 8
    text += "POINT_DATA 9\nFIELD FieldData 1\nword 1 9 string\n" + "w%20x\n" * 9
    return text.encode()


def legacy_curves():
    text = command.legacy_curves(POINTS, CURVES).replace("FieldData 2", "FieldData 3")
    return (text + "LengthTolerance 1 2 double\n0 0.01\n").encode()


def xml(form, content, head=""):
    """XML polydata with points, triangles and arrays; `content` makes what follows the attributes of an array's element of
    its values and of these as bytes."""
    def array(kind, code, values, attributes):
        data = struct.pack("<%d%s" % (len(values), code), *values)
        return ('<DataArray type="%s" %s format="%s"' % (kind, attributes, form)).encode() + content(values, data)

    flat = [x for point in POINTS for x in point]
    ids = [v for triangle in TRIANGLES for v in triangle]
    return (
        ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
         'header_type="UInt32"%s>\n<PolyData>\n<Piece NumberOfPoints="9" NumberOfPolys="8">\n' % head).encode()
        + b'<PointData Scalars="heat">\n' + array("Float32", "f", range(9), 'Name="heat"') + b"</PointData>\n"
        + b"<Points>\n" + array("Float64", "d", flat, 'NumberOfComponents="3"') + b"</Points>\n<Polys>\n"
        + array("Int64", "q", ids, 'Name="connectivity"')
        + array("Int64", "q", [3 * k + 3 for k in range(8)], 'Name="offsets"')
        + b"</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n"
    )


def within(data):
    """In the element of an array."""
    return b">" + data + b"</DataArray>\n"


def with_size(data):
    return struct.pack("<I", len(data)) + data


def zipped(_, data):
    packed = zlib.compress(data)
    return within(base64.b64encode(struct.pack("<4I", 1, len(data), len(data), len(packed))) + base64.b64encode(packed))


def xml_appended(encoding):
    blocks = []

    def content(_, data):
        place = sum(map(len, blocks))
        blocks.append(with_size(data) if encoding == "raw" else base64.b64encode(with_size(data)))
        return b' offset="%d"/>\n' % place

    text, end = xml("appended", content), b"</VTKFile>\n"
    return (text.removesuffix(end) + b'<AppendedData encoding="%s">\n_' % encoding.encode() + b"".join(blocks)
            + b"\n</AppendedData>\n" + end)


def xml_curves():
    """Polylines with types and names."""
    values = " ".join("%r %r %r" % point for point in POINTS)
    names = " ".join(" ".join(str(ord(c)) for c in name) + " 0" for _, name, _ in CURVES)
    return (
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>\n'
        '<Piece NumberOfPoints="9" NumberOfLines="2">\n<Points>'
        '<DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points>\n<Lines>'
        '<DataArray type="Int64" Name="connectivity" format="ascii">3 4 5 1 4 7</DataArray>\n'
        '<DataArray type="Int64" Name="offsets" format="ascii">3 6</DataArray></Lines>\n<CellData>'
        '<DataArray type="Int32" Name="CurveType" format="ascii">0 1</DataArray>\n'
        '<Array type="String" Name="CurveName" NumberOfTuples="2" format="ascii">%s</Array></CellData>\n'
        "</Piece></PolyData></VTKFile>\n" % (values, names)
    ).encode()


def stl_text():
    facets = "".join(
        "facet normal 0 0 1\nouter loop\n" + "".join("vertex %g %g %g\n" % POINTS[v] for v in triangle)
        + "endloop\nendfacet\n" for triangle in TRIANGLES)
    return ("solid x\n" + facets + "endsolid x\n").encode()


def obj():
    text = command.obj(POINTS, TRIANGLES).replace("f ", "vt 0 1\nvn 0 0 1\nf ", 1)
    return (text + "l 4 5 6\n# end\n").encode()


# The name says what becomes of the file: a surface, curves of a sound surface, or a list of surfaces.
CHAIN = (3, 4, 5)


def obj_curves():
    text = "o dart left\n" + "".join("v {} {} {}\n".format(*POINTS[k]) for k in CHAIN) + "l 1 2\nl 2 -1\n"
    return text.encode()


def csv_curves():
    rows = "".join("key;a;{};{};{}\n".format(*POINTS[k]) for k in CHAIN)
    return ("Type;Name;x;y;z\n" + rows).encode()


def dxf_curves():
    def entity(kind, *groups):
        return "".join(f"{code}\n{value}\n" for code, value in ((0, kind), *groups))

    def place(k, code=10):
        return tuple((code + 10 * i, POINTS[k][i]) for i in range(3))

    text = entity("SECTION", (2, "ENTITIES"))
    text += entity("LINE", (8, "key a"), *place(CHAIN[0]), *place(CHAIN[1], 11))
    text += entity("POLYLINE", (8, "b"), (66, 1), (70, 8))
    text += "".join(entity("VERTEX", (8, "b"), *place(k), (70, 32)) for k in CHAIN[1:])
    text += entity("SEQEND")
    text += entity("SPLINE", (5, "2F"), (8, "c"), (71, 2), *((40, k // 3) for k in range(6)),
                   *(group for k in (1, 4, 7) for group in place(k)))
    text += entity("ENDSEC") + entity("EOF")
    return text.encode()


SPECIMENS = {
    "ascii.vtp": xml("ascii", lambda values, _: within(" ".join(map(repr, values)).encode())),
    "binary.vtp": xml("binary", lambda _, data: within(base64.b64encode(with_size(data)))),
    "zipped.vtp": xml("binary", zipped, ' compressor="vtkZLibDataCompressor"'),
    "raw.vtp": xml_appended("raw"),
    "base64.vtp": xml_appended("base64"),
    "plain.vtk": command.legacy(POINTS, TRIANGLES, cell_data="CELL_DATA 8\nSCALARS s int\nLOOKUP_TABLE d\n"
                                + "1\n" * 8 + "LOOKUP_TABLE d 1\n0 0 0 1\n").encode(),
    "binary.vtk": legacy_binary(),
    "offsets.vtk": legacy_offsets(),
    "text.stl": stl_text(),
    "binary.stl": command.stl(POINTS, TRIANGLES),
    "surface.obj": obj(),
    "text.ply": command.ply(POINTS, TRIANGLES, "").encode(),
    "little.ply": command.ply(POINTS, TRIANGLES, "<"),
    "big.ply": command.ply(POINTS, TRIANGLES, ">"),
    "strips.ply": command.ply_strips(POINTS, [STRIP], "").encode(),
    "curves.vtk": legacy_curves(),
    "curves.vtp": xml_curves(),
    "curves.obj": obj_curves(),
    "curves.csv": csv_curves(),
    "curves.dxf": dxf_curves(),
    "curves.txt": b"# two\naccessory a 3 4 5\nkey b 1 \\\n4 7 # up\n",
    "list.txt": b'# surfaces\nsound.obj curves.txt\n"a folder/sound.obj" # again\n\nsound.obj\n',
}
