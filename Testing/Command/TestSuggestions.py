# SPDX-License-Identifier: BSD-3-Clause
"""wirewarp cut proposes cuts, writes all curves ready for the next run, and says what each gives."""

import math
import os
import signal
import subprocess
import time

import command


class Suggestions(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.points, self.triangles = command.dome()
        self.write("dome.obj", command.obj(self.points, self.triangles))

    def test_its_curves_give_the_next_run_the_same_pieces(self):
        # Cuts are looked for with free legs of darts.
        report = self.flatten("cut", "dome.obj", "--kind", "all", "--max-strain", "0.04", "--dart-legs", "free")
        cuts = report["suggestions"]
        self.assertTrue(cuts)
        self.assertLessEqual(max(piece["strain_p95"] for piece in report["pieces"]), 0.04)
        self.assertEqual(report["status"], "Ok")
        for number, cut in enumerate(cuts, 1):
            self.assertEqual(cut["name"], f"{cut['type']} {number}")
            self.assertGreater(cut["gain"], 0)
            self.assertGreater(cut["gain_predicted"], 0)
            self.assertGreater(cut["length"], 0.1)
        lengths = {curve["name"]: curve["length_3d"] for curve in report["curves"]}
        for cut in cuts:
            self.assertAlmostEqual(lengths[cut["name"]] / cut["length"], 1, delta=1e-9)
        os.rename(self.path("out"), self.path("first"))
        again = self.flatten("dome.obj", os.path.join("first", "curves.vtp"), "--dart-legs", "free")
        self.assertNotIn("curves.vtp", os.listdir(self.path("out")))
        for piece, other in zip(report["pieces"], again["pieces"]):
            self.assertAlmostEqual(piece["strain_p95"] / other["strain_p95"], 1, delta=1e-9)
            self.assertEqual(piece["triangles"], other["triangles"])

    def test_folders_in_the_way_of_files_are_found_before_the_search(self):
        for name in ("flat.vtp", "curves.vtp", "report.json"):
            os.makedirs(self.path("out", name))
            run = self.run_command("cut", "dome.obj", "--unit", "cm", "--output", "out")
            self.assertEqual((run.returncode, run.stdout), (3, ""))
            self.assertRegex(run.stderr, f"^wirewarp: error: .*{name}: cannot be written .a folder of this name")
            self.assertEqual(os.listdir(self.path("out")), [name])
            os.rmdir(self.path("out", name))

    def test_options_of_cloth_and_patterns_are_refused_before_surface_and_search(self):
        for options, said in (
                (["--max-cuts", "2", "--nap"], "an option of wirewarp nest"),
                (["--allowance", "10"], "an option of wirewarp pattern, wirewarp nest"),
                (["-o", "out", "-o", "lay.plt"], "does not write 'lay.plt'; .*wirewarp pattern")):
            with self.subTest(options):
                run = self.run_command("cut", "missing.obj", "--unit", "cm", "--effort", "long", *options)
                self.assertEqual((run.returncode, run.stdout), (2, ""))
                self.assertRegex(run.stderr, said)
        self.assertEqual(os.listdir(self.path(".")), ["dome.obj"])

    def test_nothing_is_cut_that_lies_flat(self):
        self.write("sheet.obj", command.obj(*command.sheet()))
        run = self.run_command("cut", "sheet.obj", "--kind", "all", "--output", "out", code=0)
        self.assertIn("nothing is proposed", run.stdout)
        self.assertEqual(self.report("out")["suggestions"], [])

    def test_what_mirrors_the_surface_is_named(self):
        def hills(x, y, turn):
            out = max(0.0, x - 5 / 7)  # beyond two columns from the edge, where it is flat and turned up
            hill = max(0.0, 1 - ((abs(x) - 0.35) ** 2 + (y - 0.3) ** 2) / 0.12) ** 2
            return x + out * (math.cos(turn) - 1), y, 0.2 * hill + out * math.sin(turn)

        for turn, kind, words in ((0.0, "plane", "mirrored across the plane with normal ("),
                                  (1.0, "axis", "mirrored, by lengths and angles, across the axis from (")):
            self.write("hills.obj", command.obj([hills(x, y, turn) for x, y, _ in self.points], self.triangles))
            run = self.run_command("cut", "hills.obj", "--kind", "darts", "--max-strain", "0", "--max-cuts", "2",
                                   "--output", "out", code=(0, 4))
            self.assertEqual(self.report("out")["suggestions_mirror"]["type"], kind)
            self.assertIn(words, run.stdout)

    def test_weights_say_where_distortion_matters(self):
        middles = [sum(self.points[v][0] for v in t) / 3 for t in self.triangles]
        self.write("dome.vtk", command.legacy(self.points, self.triangles, cell_data="\n".join(
            [f"CELL_DATA {len(middles)}", "SCALARS matters double 1", "LOOKUP_TABLE default",
             *(str(float(x > 0)) for x in middles), ""])))
        options = ("--kind", "darts", "--max-strain", "0", "--max-cuts", "1")
        self.run_command("cut", "dome.vtk", *options, "--weights", "matters", "--output", "out", code=(0, 4))
        self.assertEqual(len(self.report("out")["suggestions"]), 1)
        self.assertGreater(self.array("out/curves.vtp", "Points")[-3], 0.0)  # its tip
        run = self.run_command("cut", "dome.vtk", *options, "--weights", "mattes", "--output", "none", code=3)
        self.assertIn('no cell array of numbers named "mattes"; give one of matters', run.stderr)
        self.assertFalse(os.path.exists(self.path("none/flat.vtp")))

    def test_what_ended_a_search_is_named(self):
        run = self.run_command(
            "cut", "dome.obj", "--kind", "darts", "--max-strain", "0.001", "--max-work", "0.2", "--output", "out")
        self.assertIn("above the bound of 0.1 %, the largest at (", run.stderr)
        self.assertIn("the limit of work ended the search after ", run.stderr)

    def test_lines_cut_nothing_and_tell_what_they_cost(self):
        run = self.run_command("cut", "dome.obj", "--kind", "lines", "--output", "out", code=0)
        report = self.report("out")
        self.assertEqual(len(report["pieces"]), 1)
        lines, left_out = report["suggestions"], report["suggestions_left_out"]
        self.assertEqual([line["name"] for line in lines[:1]], ["centre line 1"])
        self.assertEqual({curve["name"] for curve in report["curves"]}, {line["name"] for line in lines})
        self.assertAlmostEqual(lines[-1]["E_area_after"], report["pieces"][0]["E_area"], 12)
        self.assertTrue(left_out)
        for line in left_out:
            self.assertIn(line["name"], run.stdout.split("left out")[1])
            self.assertTrue(line["gain"] < 0 or not line["sound"])
        os.rename(self.path("out"), self.path("first"))
        self.flatten("dome.obj", os.path.join("first", "curves.vtp"))

    def test_keys_are_priced_by_flattenings_without_them(self):
        run = self.run_command("prices", *command.data_files("pants_front", "_curves_set3"), "--scheme", "global", "-o", "out")
        rows = self.report("out")["key_prices"]
        self.assertEqual([rows[0]["trial"], rows[-1]["trial"]], ["all keys", "no key"])
        self.assertEqual(rows[0]["status"], "IncompatibleKeys")
        self.assertEqual(rows[1]["status"], "Ok")  # what is to blame comes first
        self.assertTrue(rows[1]["trial"].startswith("without "))
        self.assertIsNone(rows[2]["price"])
        for row in rows:
            self.assertIn(row["trial"], run.stdout)
        self.assert_stderr("there is no key curve", "prices", "dome.obj", "--output", "none")

    def test_a_bound_out_of_reach_is_told(self):
        for unit in ("mm", "m"):
            options = ("--kind", "darts", "--max-cuts", "1", "--unit", unit, "--output", "out")
            run = self.run_command("cut", "dome.obj", *options, "--max-strain", "0.001", code=4)
            report = self.report("out")
            self.assertEqual((report["status"], report["exit_code"]), ("BoundMissed", 4))
            strain = max(piece["strain_p95"] for piece in report["pieces"])
            self.assertIn(f"a strain of {100 * strain:.4g} %", run.stderr)
            self.assertEqual([cut["type"] for cut in report["suggestions"]], ["dart"])
            self.assertTrue(any("above the bound of 0.1 %" in text for text in report["warnings"]))
            # One that is missed by less, and the default, are warned of.
            for bound in (("--max-strain", str(0.8 * strain)), ()):
                run = self.run_command("cut", "dome.obj", *options, *bound, code=0)
                self.assertIn("above the bound of", run.stderr)

    def test_a_search_that_is_interrupted_ends_with_the_best_so_far(self):
        self.write("fine.obj", command.obj(*command.dome(40, 40, 0.9)))
        process = subprocess.Popen(
            [command.EXECUTABLE, "cut", "fine.obj", "--kind", "all", "--max-strain", "0", "--max-cuts", "30", "--max-work", "0",
             "-o", "out"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        time.sleep(5)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertIn(process.returncode, (0, 4), errors)
        self.assertIn("the search was interrupted after ", errors)
        report = self.report("out")
        self.assertTrue(report["suggestions"])
        self.assertIn("curves.vtp", os.listdir(self.path("out")))

    def test_options_of_cuts_are_not_for_lines(self):
        for option in (("--max-strain", "0.1"), ("--max-cuts", "3"), ("--max-work", "1")):
            run = self.run_command("cut", "dome.obj", "--kind", "lines", *option, code=2)
            self.assertIn(f"{option[0]} is for --kind darts, seams, all or gores, not for --kind lines", run.stderr)

    def test_bad_usage_is_refused(self):
        for arguments in (["--kind", "pleats"], ["--max-strain", "-1"], ["--max-strain", "nan"], ["--max-cuts", "-1"],
                          ["--prefer", "waist"], ["--max-cuts", "x"], ["--prefer", "waist=-1"], ["--effort", "huge"],
                          ["--effort", "long", "--max-work", "3"]):
            self.run_command("cut", "dome.obj", *arguments, code=2)


if __name__ == "__main__":
    command.main()
