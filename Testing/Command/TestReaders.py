# SPDX-License-Identifier: BSD-3-Clause
import base64
import itertools
import json
import struct

import command


class Readers(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune()

    def measures(self, *files):
        piece = self.flatten(*files)["pieces"][0]
        return [piece[key] for key in ("triangles", "vertices", "wire_patches", "objective", "E_ang")]

    def coordinates(self):
        return [x for point in self.points for x in point]

    def test_every_format_that_holds_doubles_gives_them_to_the_last_bit(self):
        files = {
            "a.obj": command.obj(self.points, self.triangles),
            "a.vtk": command.legacy(self.points, self.triangles),
            "a.vtp": command.xml_polydata(self.points, self.triangles),
            "ascii.ply": command.ply(self.points, self.triangles, ""),
            "little.ply": command.ply(self.points, self.triangles, "<"),
            "big.PLY": command.ply(self.points, self.triangles, ">"),
        }
        for name, content in files.items():
            with self.subTest(name):
                self.flatten(self.write(name, content))
                self.assertEqual(self.array("out/cut.vtp", "Points"), self.coordinates())

    def test_stl_is_read_in_its_single_precision_with_corners_joined(self):
        self.write("a.stl", command.stl(self.points, self.triangles))
        wanted = self.measures("lune.obj")
        found = self.measures("a.stl")
        self.assertEqual(found[:3], wanted[:3])
        self.assertAlmostEqual(found[4], wanted[4], delta=1e-6)
        self.assertNotEqual(found[4], wanted[4])

    def test_off_is_read_with_what_stands_around_its_numbers(self):
        def off(head, point="%r %r %r\n", face="3 %d %d %d\n"):
            return (head + "".join(point % p for p in self.points)
                    + "".join(face % t for t in self.triangles))

        counts = "%d %d 0\n" % (len(self.points), len(self.triangles))
        # A vertex and a face end with a line, whatever it holds beside coordinates and ids.
        for head, point, face in (
                ("OFF " + counts, "%r %r %r\n", "3 %d %d %d\n"),
                ("COFF\n# from a scanner\n\n" + counts, "%r %r %r 255 0 0 255\n", "3 %d %d %d 0.5 0.5 0.5\r\n"),
                ("OFF\n%d %d\n" % (len(self.points), len(self.triangles)), "%r %r %r 9 9 9\n", "3 %d %d %d\n"),
                ("\ufeffOFF" + counts, "\n%r %r %r # first\n", "3 %d # one\n\n %d\t%d 255 0 0 # red\n"),
                ("STCNOFF " + counts, "%r %r %r 0 0 1 .5 .5 .5 1 0 0\n", "3 %d %d %d\n"),
                ("COFF\n" + counts, "%r %r %r 255 0 0\n", "3 %d %d %d\r\n")):
            with self.subTest(head=head, point=point, face=face):
                self.write("a.off", off(head, point, face))
                self.flatten("a.off")
                self.assertEqual(self.array("out/cut.vtp", "Points"), self.coordinates())
                self.assertEqual(self.array("out/cut.vtp", "connectivity", "Polys"),
                                 [v for triangle in self.triangles for v in triangle])
        for text, words in ((off("OFF\n" + counts)[:-40], ":"), (off("OFF\n1 2\n3"), "a.off:"),
                            ("OFF BINARY\n", "as text (ASCII)"), ("STCNOFF  BINARY\n8\0", "as text (ASCII)"),
                            (off("4OFF\n" + counts), "three coordinates"), (off("nOFF\n3 " + counts), "'nOFF'"),
                            (off("OFFSET\n" + counts), "'OFFSET'"), (off(counts), "is not OFF"),
                            ("OFF\n-1 2 0\n", "'-1' is not a count"), ("OFF\n", "truncated"),
                            (off("OFF\n" + counts, face="3\n%d\n%d 1%d\n"), "vertex id"),
                            (off("OFF\n" + counts, face="3 %d %d 1%d\n"), "vertex id")):
            self.assert_stderr(words, self.write("a.off", text), "--output", "out")

    def gltf(self, matrix=None, cut_at=None):
        """The surface as glTF, whose points are doubled along the meridian of index `cut_at`."""
        points, triangles = list(self.points), self.triangles
        if cut_at is not None:
            column = {1 + 5 * j + cut_at: len(points) + j for j in range(7)}
            column.update({0: len(points) + 7, 36: len(points) + 8})
            points += [points[v] for v in column]
            right = {t for t in triangles if any(1 <= v < 36 and (v - 1) % 5 > cut_at for v in t)}
            triangles = [tuple(column.get(v, v) if t in right else v for v in t) for t in triangles]
        data = b"".join(struct.pack("<3f", *point) for point in points)
        size = len(data)
        data += b"".join(struct.pack("<3I", *t) for t in triangles)
        bounds = [[f(p[k] for p in points) for k in range(3)] for f in (min, max)]
        return {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, **({"matrix": matrix} if matrix else {})}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                 "min": bounds[0], "max": bounds[1]},
                {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": size},
                            {"buffer": 0, "byteOffset": size, "byteLength": len(data) - size}],
            "buffers": [{"byteLength": len(data)}]}, data

    def write_gltf(self, name, scene, data):
        if name.endswith(".gltf"):
            uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
            scene["buffers"][0]["uri"] = uri
            return self.write(name, json.dumps(scene))
        text = json.dumps(scene).encode()
        text += b" " * (-len(text) % 4)
        data += bytes(-len(data) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
        return self.write(name, b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)

    def test_gltf_is_read_in_metres_and_its_texture_seams_are_joined(self):
        wanted = self.measures("lune.obj")
        for name in ("a.gltf", "a.glb"):
            self.write_gltf(name, *self.gltf())
            found = self.measures(name)
            self.assertEqual(found[:3], wanted[:3], name)
            self.assertAlmostEqual(found[4], wanted[4], delta=1e-6)
            report = self.report("out")
            self.assertEqual((report["unit"], report["unit_stated"], report["warnings"]), ("m", True, []))
        # A node's matrix, by columns: half the size, moved.
        self.write_gltf("a.glb", *self.gltf([0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 7, 8, 9, 1]))
        half = self.flatten("a.glb")["sizes"][0]
        whole = self.flatten("lune.obj", "--unit", "m")["sizes"][0]
        self.assertAlmostEqual(2 * half["width_mm"], whole["width_mm"], delta=0.01)
        self.write_gltf("a.glb", *self.gltf(cut_at=2))
        found = self.measures("a.glb")
        self.assertEqual(found[:3], wanted[:3])
        self.assertEqual(self.report("out")["warnings"],
                         ["9 points are joined with one that it lies on, as the format of the file doubles points"])

    def test_gltf_with_compressed_meshes_is_refused_by_the_name_of_the_extension(self):
        scene, data = self.gltf()
        for extension in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"):
            for name in ("a.gltf", "a.glb"):
                names = ["KHR_materials_unlit", extension]
                path = self.write_gltf(name, {**scene, "extensionsUsed": names, "extensionsRequired": names}, data)
                self.assert_stderr(f"by the extension {extension}, which is not read", path, "--output", "out")

    def test_what_is_no_gltf_is_refused(self):
        scene, data = self.gltf()
        for name, content in (("a.gltf", b"{}"), ("a.glb", b"glTF" + bytes(20)), ("a.gltf", b"v 0 0 0"),
                              ("a.gltf", json.dumps({**scene, "meshes": []}).encode())):
            self.assert_stderr(name, self.write(name, content), "--output", "out")
        self.assert_stderr("save the surface as .obj", self.write("a.3mf", b"PK"))

    def test_strips_of_a_ply_are_triangles_all_of_one_side(self):
        points, _ = command.sheet(2, 2)
        # Two strips, of which the second is two that corners twice over join.
        strip = [0, 1, 3, 4, 6, 7, -1, 1, 2, 4, 5, 5, 4, 4, 5, 7, 8, -1, 0, 1]
        triangles = [(0, 1, 3), (3, 1, 4), (3, 4, 6), (6, 4, 7), (1, 2, 4), (4, 2, 5),
                     (4, 5, 7), (7, 5, 8)]
        self.write("plain.obj", command.obj(points, triangles))
        self.write("strips.ply", command.ply_strips(points, [strip], ""))
        self.write("lists.ply", command.ply_strips(points, [strip[:6], strip[7:17]], "<"))
        self.flatten("plain.obj")
        wanted = self.array("out/cut.vtp", "connectivity", "Polys")
        self.assertEqual(len(wanted), 3 * len(triangles))
        for name in ("strips.ply", "lists.ply"):
            self.flatten(name)
            self.assertEqual(self.array("out/cut.vtp", "connectivity", "Polys"), wanted)
        self.assert_stderr("strip 0", self.write("bad.ply", command.ply_strips(points, [[0, 1, -2]], "")), "--output", "out")

    def test_what_stands_around_coordinates_and_corners_of_an_obj_changes_nothing(self):
        number, count = itertools.count(1), len(self.points)
        seams = "".join("v %r %r %r\n" % point for point in self.points)
        for triangle in self.triangles:
            seams += "vt 0.5 0.5\n" * 3 + "vn 0 0 1\n"
            seams += "f " + " ".join("%d/%d/1" % (v + 1, next(number)) for v in triangle) + "\n"
        # Backward ids, normals, colors, continued lines and line ends of Windows.
        odd = "# comment\r\nmtllib x.mtl\r\no piece\r\n"
        odd += "".join("v %r %r %r 0.1 0.2 0.3\r\n" % point for point in self.points)
        odd += "".join("f %d//1 \\\r\n %d//1 %d//1\r\n" % (a - count, b - count, c - count) for a, b, c in self.triangles)
        self.write("marked.txt", "\ufeff" + self.read("arc.txt"))
        wanted = self.measures("lune.obj", "arc.txt")
        for text, curves in ((seams, "arc.txt"), (odd, "arc.txt"), ("\ufeff" + self.read("lune.obj"), "marked.txt")):
            self.assertEqual(self.measures(self.write("other.obj", text), curves), wanted, text[:40])

    def test_arrays_whose_name_is_empty_stay_behind(self):
        count, cells = len(self.points), len(self.triangles)
        for kind, rows in (("POINT_DATA", count), ("CELL_DATA", cells)):
            with self.subTest(kind):
                self.write("a.vtk", command.legacy(self.points, self.triangles) + (
                    "\n%s %d\nFIELD FieldData 2\n%%00 1 %d int\n%s\nkept 1 %d int\n%s\n" % (
                        kind, rows, rows, "1 " * rows, rows, "2 " * rows)))
                self.flatten("a.vtk")
                self.assertEqual(self.array("out/cut.vtp", "Points"), self.coordinates())
                self.assertEqual(set(self.array("out/cut.vtp", "kept")), {2})

    def test_text_curves_and_polydata_curves_give_the_same_result(self):
        self.write("keys.txt", "key arc %s # the middle\n" % " ".join(map(str, self.arc)))
        self.write("keys.vtk", command.legacy_curves(self.points, [(1, "arc", self.arc)]))
        results = []
        for curves in ("keys.txt", "keys.vtk"):
            report = self.flatten("lune.obj", curves)
            results.append((report["pieces"], report["curves"], self.array("out/flat.vtp", "Points")))
        self.assertEqual(results[0], results[1])
        self.assertEqual([(c["name"], c["type"]) for c in results[0][1]], [("arc", "key")])


if __name__ == "__main__":
    command.main()
