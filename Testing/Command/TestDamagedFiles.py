# SPDX-License-Identifier: BSD-3-Clause
"""Files that end or hang VTK's readers, and files that are none: a message each, and exit code 3."""

import os
import socket
import time

import command


class Damaged(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = command.sheet()
        self.write("good.obj", command.obj(self.points, self.triangles))
        self.legacy = command.legacy(self.points, self.triangles)
        self.xml = command.xml_polydata(self.points, self.triangles)
        words = '<Array type="String" Name="w" NumberOfComponents="1000000" format="ascii">1 0</Array>'
        fields = '<FieldData>%s</FieldData>' % words.replace("NumberOfComponents", "NumberOfTuples")
        self.killing = {
            "words.vtp": self.xml.replace("</Piece>", "<PointData>%s</PointData></Piece>" % words),
            "cells.vtk": self.legacy.replace("\n3 0 1", "\n300000000 0 1", 1),
        }
        self.endless = {
            "fields.vtk": self.legacy + "FIELD f 2000000000\n",
            "words.vtk": self.legacy + "FIELD f 1\nn 1 200000000 string\n",
            "variants.vtk": self.legacy + "FIELD f 1\nn 1 2000000000 variant\n", # over a minute on any machine
            "fields.vtp": self.xml.replace("<PolyData>", "<PolyData>" + fields.replace("000000", "00000000")),
        }

    def refuse(self, *arguments, says=()):
        """Exit 3 with one line, in which these words are."""
        line, = command.error_lines(self.assert_stderr(says, *arguments, "--output", "out"))
        self.assertEqual(os.listdir(self.path("out")), ["report.json"])
        self.assertEqual(self.report("out")["status"], "UnreadableInput")
        return line

    def test_points_that_no_locator_can_be_asked_about_are_refused(self):
        lines = ('<Lines><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>'
                 '<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></Lines>')
        curve = command.xml_polydata([(1.0, 0.0, 0.0), self.points[1], self.points[2]], []).replace(
            "</Points>", "</Points>" + lines).replace("<Piece ", '<Piece NumberOfLines="1" ')
        coordinate = repr(self.points[1][1])
        for number in ("nan", "inf", "1e90", "-1e308"):
            self.write("curve.vtp", curve.replace(coordinate, number, 1))
            self.write("sheet.vtp", self.xml.replace(coordinate, number, 1))
            for arguments in (("good.obj", "curve.vtp"), ("sheet.vtp", "curve.vtp"),
                              ("grade", "S=good.obj", "M=good.obj", "curve.vtp"),
                              ("grade", "S=good.obj", "M=sheet.vtp")):
                with self.subTest(number, arguments=arguments):
                    run = self.run_command(*arguments, "--output", "out", code=(1, 3))
                    self.assertEqual(len(command.error_lines(run)), 1, run.stderr)

    def test_points_of_more_components_than_memory_holds(self):
        for count in ("300000000", "-1"):  # -1: as many as a container could never hold
            text = self.xml.replace('NumberOfComponents="3"', f'NumberOfComponents="{count}"')
            with self.subTest(count):
                self.refuse(self.write("wide.vtp", text), says=("wide.vtp", "memory"))

    def test_a_reader_that_dies_or_does_not_end_is_a_message_for_surfaces_and_curves(self):
        for files, befores, words, least in ((self.killing, ((), ("good.obj",)), "VTK's reader ended by signal 11", 2),
                                             (self.endless, ((),), "came to no end within", 1)):
            lines = [self.refuse(*before, self.write(name, text), says=name)
                     for name, text in files.items() for before in befores]
            self.assertGreaterEqual(sum(words in line for line in lines), least, lines)

    def test_in_a_batch_only_the_damaged_surfaces_are_refused(self):
        names = [self.write(name, text) for name, text in self.killing.items()]
        self.write("fine.vtp", self.xml)
        self.write("list.txt", "\n".join(["fine.vtp", *names, "good.obj " + names[0], "fine.vtp"]) + "\n")
        self.run_command("batch", "list.txt", "--output", "out", "--threads", "1", code=3)
        statuses = [row["status"] for row in self.report("out", "batch.json")["surfaces"]]
        self.assertEqual(statuses, ["Ok", *["UnreadableInput"] * (len(names) + 1), "Ok"])

    def test_what_is_no_file_is_refused_at_once_by_its_kind(self):
        os.mkfifo(self.path("pipe.vtp"))
        os.mkfifo(self.path("pipe.obj"))
        os.symlink("/dev/zero", self.path("zero.ply"))
        os.symlink("/dev/tty", self.path("terminal.txt"))
        os.mkdir(self.path("folder.txt"))
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(os.path.relpath(self.path("socket.stl")))
            for arguments, word in (
                (("pipe.vtp",), "pipe"), (("pipe.obj",), "pipe"), (("good.obj", "pipe.vtp"), "pipe"),
                (("zero.ply",), "device"), (("good.obj", "terminal.txt"), "device"),
                (("socket.stl",), "socket"), (("good.obj", "folder.txt"), "folder"),
            ):
                with self.subTest(arguments):
                    start = time.monotonic()
                    self.refuse(*arguments, says=(arguments[-1], word))
                    self.assertLess(time.monotonic() - start, 20)
        for name, word in (("pipe.obj", "pipe"), ("zero.ply", "device"), ("folder.txt", "folder")):
            self.assert_stderr(word, "batch", name, "--output", "out")

    def test_a_file_larger_than_can_be_flattened_is_refused_before_it_is_read(self):
        for name in ("a.obj", "a.vtk", "a.vtp", "a.ply", "a.stl"):
            with self.subTest(name):
                with open(self.path(name), "wb") as file:
                    file.write(b"# vtk DataFile Version 3.0\n")
                    file.truncate(20 * 10**9)
                start = time.monotonic()
                self.refuse(name, says=(name, "20 GB", "4 GB"))
                self.assertLess(time.monotonic() - start, 20)
                os.remove(self.path(name))

    def test_names_with_control_characters_reach_no_terminal(self):
        escape = "\x1b[31m\x9b"
        self.write("names.txt", f"accessory a{escape} 10 11 12 13 14\n")
        self.write("names.vtk", command.legacy_curves(self.points, [(1, "a%1b[31m%00%0ab", [10, 11, 12, 13, 14])]))
        for name in ("names.txt", "names.vtk"):
            for arguments in (("--table",), ("--tolerance", "none=0.1"), ("--max-iterations", "1"), ("--no-split-triangles",)):
                with self.subTest(name=name, arguments=arguments):
                    run = self.run_command("good.obj", name, *arguments, "--output", "out")
                    text = run.stdout + run.stderr
                    self.assertRegex(text, "^[\n -~]+$")
                    self.assertIn(run.returncode, (0, 3, 4))
                    if arguments == ("--table",):
                        self.assertIn("a?[31m", text)
        self.write("bad.txt", f"accessory a{escape} 10 99\nbogus\x1b[31m b 1 2\n")
        for arguments in (("good.obj", "bad.txt"), ("a\x1b[31m.obj",)):
            self.assertNotIn("\x1b", self.run_command(*arguments, "--output", "out", code=3).stderr)


if __name__ == "__main__":
    command.main()
