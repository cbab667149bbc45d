# SPDX-License-Identifier: BSD-3-Clause
import os
import resource
import shutil
import struct
import subprocess
import unittest

import command


class Refusals(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = command.sheet()
        self.write("good.obj", command.obj(self.points, self.triangles))

    def refuse(self, *arguments, says=(), status=None):
        """Exit 3, one message in plain words, and a report that tells it."""
        run = self.assert_stderr(says, *arguments, "--output", "out")
        self.assertEqual(os.listdir(self.path("out")), ["report.json"])
        report = self.report("out")
        self.assertEqual((report["exit_code"], report["pieces"], report["curves"]), (3, [], []))
        self.assertEqual((run.stdout, run.stderr), ("", f"wirewarp: error: {report['message']}\n"))
        self.assertEqual(report["status"], status or report["status"])

    def test_outputs_that_a_command_does_not_write(self):
        for name, output, says in (("check", "k.stl", ".obj, .vtp"), ("check", "folder", ".obj, .vtp"),
                                   ("pattern", "shirt.pfd", ".pdf"), ("flatten", "flat.text", "a folder")):
            with self.subTest(name, output=output):
                self.assert_stderr(("does not write '%s'; it writes " % output, says), name, "good.obj", "--unit", "cm",
                                   "--output", output, code=(2, 3))
                self.assertFalse(os.path.exists(self.path(output)))

    def test_a_check_exits_alike_where_it_says_nothing(self):
        self.write("ring.obj", command.obj(*command.torus()))
        for surface, code in (("ring.obj", 4), ("good.obj", 0)):
            for quiet in ((), ("--quiet",)):
                run = self.run_command("check", surface, "--unit", "cm", *quiet)
                self.assertEqual((run.returncode, not run.stdout), (code, bool(quiet)))

    def test_points_that_are_not_finite_are_named_by_their_lines(self):
        self.write("unused.obj", command.obj([*self.points, (float("inf"), 0.0, 0.0)], self.triangles))
        self.run_command("check", "unused.obj", "--unit", "cm", code=0)
        self.points[3] = (float("nan"), 0.0, 0.0)
        self.write("nan.obj", "# a comment\n" + command.obj(self.points, self.triangles))
        self.assert_stderr("nan.obj:5: a coordinate is not a finite number", "check", "nan.obj")

    def test_other_formats_name_the_line_or_the_facet(self):
        ply = ("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n{}0 0 1\n3 0 1 {}\n")
        off = "OFF\n5 1 0\n{}0 0 1\n3 0 1 {}\n"
        points = "0 0 0\n1 0 0\nnan 1 0\n1 1 0\n"
        stl = "solid a\nfacet\nvertex 0 0 0\nvertex inf 0 0\nvertex 0 1 0\nendfacet\nendsolid\n"
        binary = b"\0" * 80 + struct.pack("<I12fH", 1, *(0.0,) * 5, float("nan"), *(0.0,) * 6, 0)
        for name, text, place in (("a.ply", ply.format(points, 2), ":12: "), ("a.off", off.format(points, 2), ":5: "),
                                  ("a.stl", stl, ":4: "), ("b.stl", binary, "facet 0 ")):
            self.assert_stderr((place, "not a finite number"), "check", self.write(name, text))
        for name, text in (("u.ply", ply.format(points, 3)), ("u.off", off.format(points, 3))):
            self.run_command("check", self.write(name, text), "--unit", "cm", code=0)

    def test_strains_are_said_in_few_figures(self):
        """A plane has none but that of rounding."""
        self.write("plane.obj", command.obj(*command.grid(4, 4, lambda i, j: (i / 7, j / 7, 0.3))))
        run = self.run_command("flatten", "plane.obj", "--unit", "cm")
        self.assertIn("fits, strain under 0.1 %", run.stdout)

    def test_a_result_in_another_unit_than_it_was_made_in(self):
        self.run_command("flatten", "good.obj", "--unit", "cm", "--output", "flat")
        self.assert_stderr("is in cm", "pattern", "flat", "--unit", "mm", "--output", "flat.svg")
        self.assertFalse(os.path.exists(self.path("flat.svg")))
        self.run_command("pattern", "flat", "--unit", "cm", "--output", "flat.svg", code=0)

    def test_files_that_are_not_there_or_cannot_be_read(self):
        os.mkdir(self.path("folder.vtp"))
        os.mkdir(self.path("pieces"))
        whole = command.xml_polydata(self.points, self.triangles)
        for name, content in (
                ("a.step", "x"), ("plain", "x"), ("curves.stl", "solid x"),
                ("grid.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 0 double\n"),
                ("words.vtp", whole.replace("Float64", "Vloat64")),
                ("many.vtp", whole.replace('NumberOfPoints="%d"' % len(self.points), 'NumberOfPoints="%d"' % 10**15)),
                *(("empty" + ending, "") for ending in (".obj", ".vtk", ".vtp", ".ply", ".stl"))):
            self.write(name, content)
        for arguments, says in (
                (["absent.obj"], ["no such file"]), (["good.obj", "absent.txt"], ["no such file"]),
                (["folder.vtp"], ["folder"]), (["pieces"], ["this is a folder"]),
                (["a.step"], [".vtp", ".obj", ".stl"]), (["plain"], [".vtp"]),
                (["good.obj", "curves.stl"], [".csv", "not from '.stl'"]), (["grid.vtk"], ["polydata"]),
                (["words.vtp"], ["Vloat64"]), (["many.vtp"], []),
                *(([f"empty{ending}"], ["empty"]) for ending in (".obj", ".vtk", ".vtp", ".ply", ".stl"))):
            with self.subTest(arguments):
                self.refuse(*arguments, says=(arguments[-1], *says), status="UnreadableInput")

    def test_files_of_another_kind_than_their_name_says_and_every_truncation(self):
        text = command.obj(self.points, self.triangles)
        files = {
            "a.vtk": command.legacy(self.points, self.triangles).encode(),
            "a.vtp": command.xml_polydata(self.points, self.triangles).encode(),
            "ascii.ply": command.ply(self.points, self.triangles, "").encode(),
            "binary.ply": command.ply(self.points, self.triangles, "<"),
            "a.stl": command.stl(self.points, self.triangles),
        }
        for name, content in files.items():
            parts = [content[: int(part * len(content))] for part in (0.03, 0.2, 0.5, 0.8, 0.97)]
            for wrong in (text, *parts):
                with self.subTest(name=name, size=len(wrong)):
                    self.refuse(self.write(name, wrong), says=(name,))
        self.refuse(self.write("a.obj", b"\0\1\2\3" * 100), says=("a.obj",))

    def test_obj_tells_the_line_of_a_defect(self):
        for text, line, says in (
            ("v 0 0 0\nv 1 0\n", 2, "three coordinates"),
            ("v 0 0 0\nv 1 x 0\n", 2, "'x'"),
            ("v 0 0 0\nv 1 0 0\n\nf 1 2\n", 4, "three vertices"),
            ("v 0 0 0\nv 1 0 0\nf 1 2 9\n", 3, "9 is out of range"),
            ("v 0 0 0\nv 1 0 0\nf 1 2 0\n", 3, "0 is out of range"),
            ("v 0 0 0\nv 1 0 0\nf 1 2 -3\n", 3, "-3 is out of range"),
            ("v 0 0 0\nv 1 0 0\nf 1 2 a/1\n", 3, "'a/1'"),
        ):
            with self.subTest(text):
                self.refuse(self.write("bad.obj", text), says=("bad.obj:%d:" % line, says))

    def test_cell_ids_out_of_range_are_refused_in_every_format(self):
        triangles = [*self.triangles, (0, 1, 999)]
        for name, content in (("a.vtk", command.legacy(self.points, triangles)),
                              ("a.vtp", command.xml_polydata(self.points, triangles)),
                              ("a.ply", command.ply(self.points, triangles, "<"))):
            self.refuse(self.write(name, content), says=(name, "999"))

    def test_curve_text_tells_file_line_and_way_out(self):
        for text, line, *says in (
                ("accessory a 0 1\nbogus b 1 2\n", 2, "'bogus'", "accessory, key, straight, dart"), ("key\n", 1, "no name"),
                ("# c\n\nkey k 0 25\n", 3, "25", "out of range", "'k'"), ("key k -1 0\n", 1, "-1", "out of range"),
                ("key k 0 1.5\n", 1, "'1.5'"), ("key k 0 1 2x\n", 1, "'2x'"), ("key k 0\n", 1, "'k'", "two vertices")):
            self.refuse("good.obj", self.write("curves.txt", text), says=(f"curves.txt:{line}:", *says))

    def test_a_defect_of_a_curve_is_blamed_on_the_file_of_the_curve(self):
        self.write("fine.vtk", command.legacy_curves(self.points, [(0, "fine", [6, 7, 8])]))
        loose = [*self.points]
        loose[12] = (3.0, 3.0, 3.0)
        for points, curve in ((self.points, (7, "odd", [11, 12, 13])), (loose, (0, "loose", [11, 12, 13])),
                              (self.points, (0, "point", [11, 11, 11]))):
            with self.subTest(curve[1]):
                self.write("bad.vtk", command.legacy_curves(points, [curve]))
                self.refuse("good.obj", "fine.vtk", "bad.vtk", says="error: bad.vtk: ")
        self.write("own.vtk", command.legacy(self.points, self.triangles, [[11, 11, 11]]))
        self.refuse("own.vtk", "fine.vtk", says="error: own.vtk: ", status="CurveTooShort")

    def test_curves_file_without_polyline(self):
        self.write("curves.vtk", command.legacy(self.points))
        self.refuse("good.obj", "curves.vtk", says=("curves.vtk", "no polyline"))

    def test_a_file_in_the_way_of_the_output_folder(self):
        self.write("out", "precious")
        for folder in ("out", "out/below"):
            self.assert_stderr("output folder", "good.obj", "--output", folder)
        self.assertEqual(self.read("out"), "precious")

    def test_no_file_is_in_place_where_another_cannot_be(self):
        for name in ("flat.vtp", "report.json"):
            os.makedirs(self.path("out", name, "inner"))
            self.write("out/pattern.svg", "of an earlier run")
            self.assert_stderr(name, "good.obj", "--output", "out")
            self.assertEqual(sorted(os.listdir(self.path("out"))), sorted((name, "pattern.svg")))
            shutil.rmtree(self.path("out"))

    def test_a_program_without_its_reader_says_what_is_missing(self):
        shutil.copy(command.EXECUTABLE, self.path("alone"))
        self.write("good.vtp", command.xml_polydata(self.points, self.triangles))
        for name, code in (("good.vtp", 3), ("good.obj", 0)):
            run = subprocess.run([self.path("alone"), name, "--output", "out"], cwd=self.folder, capture_output=True,
                                 text=True, timeout=120, check=False)
            self.assertEqual(run.returncode, code, run.stderr)
            if code:
                self.assertIn("wirewarp-read is not there; install it", run.stderr)

    def test_a_limit_of_open_files_is_named(self):
        def limit_files(most):
            resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))

        self.write("good.vtp", command.xml_polydata(self.points, self.triangles))
        for name in ("good.vtp", "good.obj"):
            refused = 0
            for most in range(5, 12):
                with self.subTest(name=name, most=most):
                    run = self.run_command(name, "--output", "out", preexec_fn=lambda most=most: limit_files(most))
                    if run.returncode == 127:
                        continue  # the libraries alone want more
                    self.assertNotIn("memory", run.stderr)
                    self.assertNotIn("damaged", run.stderr)
                    if run.returncode != 0:
                        refused += 1
                        self.assertIn("Too many open files", run.stderr)
                        self.assertIn("ulimit -n", run.stderr)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertGreater(refused, 0 if name == "good.vtp" else -1)

    @unittest.skipUnless(os.geteuid() == 0, "another user, who runs nothing else, is needed to count processes")
    def test_it_runs_with_the_threads_that_a_limit_leaves(self):
        def limit_processes(most):
            os.setgroups([])
            os.setgid(64999)
            os.setuid(64999)
            resource.setrlimit(resource.RLIMIT_NPROC, (most, most))

        os.chmod(self.folder, 0o777)
        self.write("wave.obj", command.obj(
            [(x, y, 0.01 * x * y) for y in range(61) for x in range(61)], command.sheet(60, 60)[1]))

        def run_limited(most):
            return self.run_command("wave.obj", "--unit", "mm", "--output", f"out{most}",
                                    env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
                                    preexec_fn=lambda: limit_processes(most))

        try:
            run = run_limited(64)
        except PermissionError:
            self.skipTest("the other user cannot read the program")
        if run.returncode == 127:
            self.skipTest("the other user cannot read the libraries")
        self.assertEqual(run.returncode, 0, run.stderr)
        for most in (1, 2, 3):
            with self.subTest(most=most):
                run = run_limited(most)
                self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_full_disk_leaves_no_part_of_a_file(self):
        def limit_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1500, 1500))

        before = self.flatten("good.obj")
        files = os.listdir(self.path("out"))
        # The command starts with the default action of SIGXFSZ, which would end it.
        run = self.run_command("good.obj", "--output", "out", preexec_fn=limit_files, code=3)
        self.assertIn("flat.vtp", command.error_lines(run)[0])
        self.assertEqual(os.listdir(self.path("out")), files)
        self.assertEqual(self.report("out"), before)

    def test_a_table_that_cannot_be_printed_is_no_success(self):
        self.write("list.txt", "good.obj\n")
        for arguments in (("good.obj",), ("batch", "list.txt"), ("--help",), ("--version",)):
            with self.subTest(arguments), open("/dev/full", "w", encoding="utf-8") as full:
                run = subprocess.run([command.EXECUTABLE, *arguments], cwd=self.folder, stdout=full, stderr=subprocess.PIPE,
                                     text=True, timeout=120, check=False)
                self.assertEqual(run.returncode, 3, run.stderr)
                self.assert_words(("standard output", "--quiet"), command.error_lines(run)[-1])

    def test_an_input_is_neither_replaced_nor_removed(self):
        os.mkdir(self.path("out"))
        whole = command.xml_polydata(self.points, self.triangles)
        os.symlink("out", self.path("link"))
        for name, content in (
            ("flat.vtp", whole), ("cut.vtp", whole[:300]), ("report.json", "key k 0 1\n"),
            ("pattern.svg", "key k 0 1\n"),
        ):
            arguments = ("out/" + name,) if name.endswith(".vtp") else ("good.obj", "out/" + name)
            for folder in ("out", "link"):
                with self.subTest(name=name, folder=folder):
                    self.write("out/" + name, content)
                    self.assert_stderr((folder + "/" + name, "--output"), *arguments, "--output", folder)
                    self.assertEqual(os.listdir(self.path("out")), [name])
                    self.assertEqual(self.read("out/" + name), content)
            os.remove(self.path("out/" + name))

    def test_a_default_folder_is_not_made_for_a_refusal(self):
        run = self.run_command("absent.obj", "--quiet", code=3)
        self.assertEqual(len(command.error_lines(run)), 1)
        self.assertEqual(os.listdir(self.folder), ["good.obj"])

    def test_names_of_any_bytes_keep_the_report_readable(self):
        self.run_command(b"caf\xe9.obj", "--output", "out", "--quiet", errors="replace", code=3)
        self.assertTrue(self.report("out")["message"])


if __name__ == "__main__":
    command.main()
