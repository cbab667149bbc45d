# SPDX-License-Identifier: BSD-3-Clause
"""wirewarp batch: many surfaces in one call."""

import os

import command


class Batch(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune()
        self.write("key.txt", self.read("arc.txt").replace("accessory", "key"))
        os.mkdir(self.path("a folder"))
        self.write("a folder/sheet.obj", command.obj(*command.sheet()))

    def batch(self, text, *arguments, code=0):
        """Runs a list of this text into `out`. Gives batch.json and the run."""
        self.write("list.txt", text)
        run = self.run_command("batch", "list.txt", "--output", "out", *arguments, code=code)
        return self.report("out", "batch.json"), run

    def test_each_surface_has_the_result_that_it_has_alone(self):
        report, run = self.batch(
            '# what to flatten\nlune.obj arc.txt # with its arc\n\n"a folder/sheet.obj"\n', "--unit", "m")
        self.assertEqual(run.stderr, "")
        self.assertEqual([row["folder"] for row in report["surfaces"]], ["lune", "sheet"])
        self.assertEqual([row["triangles"] for row in report["surfaces"]], [56, 32])
        for name, *arguments in (("lune", "lune.obj", "arc.txt"), ("sheet", "a folder/sheet.obj")):
            many = self.report("out/" + name)
            flat = self.array(f"out/{name}/flat.vtp", "Points")
            self.run_command(*arguments, "--unit", "m", "--output", "alone", code=0)
            self.assertEqual(flat, self.array("alone/flat.vtp", "Points"))
            one = self.report("alone")
            for key in ("surface", "pieces", "curves", "status"):
                self.assertEqual(many[key], one[key])

    def test_it_says_where_the_time_goes(self):
        report, run = self.batch("lune.obj arc.txt\nlune.obj\n")
        for row in report["surfaces"]:
            seconds = row["seconds"]
            self.assertEqual(sorted(seconds), ["core", "filter", "read", "total", "write"])
            self.assertTrue(all(value > 0 for value in seconds.values()), seconds)
            self.assertAlmostEqual(sum(seconds.values()), 2 * seconds["total"], delta=1e-9)
        together = sum(row["seconds"]["total"] for row in report["surfaces"])
        self.assertGreaterEqual(report["seconds"] * report["workers"], together)
        self.assertAlmostEqual(report["surfaces_per_second"] * report["seconds"], 2, delta=1e-9)
        self.assertIn("2 surfaces", run.stdout)

    def test_equal_names_get_folders_of_their_own(self):
        report, _ = self.batch("lune.obj arc.txt\nlune.obj key.txt\nlune.obj\n")
        self.assertEqual([row["folder"] for row in report["surfaces"]], ["lune", "lune_2", "lune_3"])
        self.assertEqual(self.report("out/lune_2")["curve_files"], ["key.txt"])
        self.assertEqual(self.report("out/lune_3")["curves"], [])

    def test_a_refused_surface_stops_no_other_however_many_run_at_a_time(self):
        text = "lune.obj arc.txt\nlune.obj key.txt\nmissing.obj\nlune.obj\n"
        seen = []
        for threads in ("1", "2", "3", "7"):
            report, run = self.batch(text, "--threads", threads, code=3)
            self.assertEqual([row["exit_code"] for row in report["surfaces"]], [0, 0, 3, 0])
            self.assertEqual(report["surfaces"][2]["status"], "UnreadableInput")
            self.assertIn("error: missing.obj", "\n".join(command.error_lines(run)))
            self.assertEqual(os.listdir(self.path("out/missing")), ["report.json"])
            self.assertEqual(report["workers"], min(4, int(threads)))
            seen.append([(row["folder"], row["status"]) for row in report["surfaces"]])
            seen[-1] += [self.array(f"out/{folder}/flat.vtp", "Points")
                         for folder in ("lune", "lune_2", "lune_3")]
        self.assertEqual(seen, [seen[0]] * 4)

    def test_the_exit_code_is_that_of_the_worst(self):
        broken = ("--paper-method", "--solver", "sequential", "--max-iterations", "1")
        _, run = self.batch("lune.obj arc.txt\n", *broken, code=4)
        self.assertIn("warning: lune: piece 1", command.error_lines(run)[-1])
        self.batch("missing.obj\nlune.obj arc.txt\n", *broken, code=3)
        self.batch("lune.obj arc.txt\nmissing.obj\n", *broken, code=3)

    def test_an_output_that_cannot_be_written_stops_no_other(self):
        os.mkdir(self.path("out"))
        self.write("out/lune", "a file in the way")
        report, _ = self.batch('lune.obj\n"a folder/sheet.obj"\n', code=3)
        self.assertEqual([row["status"] for row in report["surfaces"]], ["UnwritableOutput", "Ok"])

    def test_a_list_without_surfaces_or_with_an_open_quote_is_refused(self):
        for text, word in (("# nothing\n", "no surface"), ('lune.obj "arc.txt\n', "list.txt:1")):
            self.write("list.txt", text)
            self.assert_stderr(word, "batch", "list.txt", "--output", "out")
            self.assertFalse(os.path.exists(self.path("out")))

    def test_no_input_is_replaced_and_no_folder_left(self):
        os.makedirs(self.path("out/lune"))
        for name in ("lune/flat.vtp", "batch.json"):
            self.write("out/" + name, command.xml_polydata(self.points, self.triangles))
            self.write("list.txt", "lune.obj\nout/%s\n" % name)
            self.assert_stderr("out/" + name, "batch", "list.txt", "--output", "out")
            os.remove(self.path("out/" + name))
        self.assertEqual(os.listdir(self.path("out")), ["lune"])
        self.write("flat.vtp", "precious")
        for name in ("..", ".", "out/"):
            self.write("list.txt", "lune.obj\n" + name + "\n")
            self.assert_stderr("list.txt:2", "batch", "list.txt", "--output", "out")
        self.assertIn("flat.vtp", os.listdir(self.folder))

    def test_what_concerns_one_surface_is_bad_usage(self):
        self.write("list.txt", "lune.obj\n")
        for arguments in (("lune.obj",), ("-o", "a.png"), ("picture", "lune.obj"), ("grade",)):
            self.run_command("batch", "list.txt", *arguments, code=2)
        self.assertEqual(self.run_command("batch", "").returncode, 2)

    def test_the_default_folder_takes_the_name_of_the_list(self):
        self.write("list.txt", "lune.obj\n")
        run = self.run_command("batch", "list.txt", "--quiet", "--unit", "m")
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        self.assertEqual(sorted(os.listdir(self.path("list_flat"))), ["batch.json", "lune"])


if __name__ == "__main__":
    command.main()
