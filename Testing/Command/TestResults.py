# SPDX-License-Identifier: BSD-3-Clause
import math
import os
import re

import command


class Results(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune()

    def test_report_names_surface_and_times_and_counts_wires(self):
        report = self.flatten("lune.obj", "arc.txt")
        self.assertEqual((report["surface"], report["status"]), ("lune.obj", "Ok"))
        self.assertEqual(sorted(report["seconds"]), ["core", "interior", "quality", "read", "total", "wires", "write"])
        self.assertGreaterEqual(min(report["seconds"].values()), 0)
        # The boundary of 16 edges, the arc of 4 with two sides.
        self.assertEqual([report["pieces"][0][key] for key in (
            "triangles", "vertices", "wire_patches", "wire_nodes", "free_wire_nodes")], [56, 37, 2, 24, 24])

    def test_what_is_skipped_is_in_report_table_and_warning(self):
        self.write("shirt.obj", command.obj(*command.together(
            (self.points, self.triangles), command.TETRAHEDRON,
            (command.torus()[0], command.torus()[1][1:]))))
        run = self.run_command("shirt.obj", "arc.txt", "--skip-closed", "--unit", "inch",
                               "--output", "out", "--table", code=0)
        report = self.report("out")
        self.assertEqual(report["left_out"], [
            {"reason": "ClosedSurface", "cell": 56, "triangles": 4},
            {"reason": "Handle", "cell": 60, "triangles": 71}])
        warning = ("2 of 3 pieces cannot be laid flat and were left out: without boundary those of cells 56, "
                   "with handles those of cells 60")
        self.assertEqual(report["warnings"], [warning])
        self.assertEqual(run.stderr.splitlines()[-1], "wirewarp: warning: " + warning)
        rows = [line.split() for line in run.stdout.splitlines()]
        self.assertIn(("-", "4", "ClosedSurface,"), [(row[0], row[1], row[-3]) for row in rows if len(row) > 3])
        self.write("list.txt", "shirt.obj\n")
        run = self.run_command("batch", "list.txt", "--skip-closed", "--output", "out", code=0)
        self.assertIn("wirewarp: warning: shirt: 2 of 3 pieces", run.stderr)

    def test_no_option_but_those_that_name_a_scheme_changes_it(self):
        for options in ((), ("--no-keys",), ("--interior", "arap"), ("--interior", "laplacian"), ("--solver", "newton"),
                        ("--solver", "sequential"), ("--solver", "sequential", "--scheme", "isometric")):
            with self.subTest(options):
                report = self.flatten("lune.obj", "arc.txt", *options)
                self.assertEqual(report["scheme"], "isometric")
                # Starting elsewhere, the isometric scheme comes to the same shape.
                self.assertEqual(round(report["pieces"][0]["E_h"], 3), 0.810)

    def test_the_papers_method_is_its_global_scheme_with_its_interior(self):
        paper = self.flatten("lune.obj", "arc.txt", "--paper-method")
        self.assertEqual((paper["scheme"], paper["interior"]), ("global", "laplacian"))
        pair = self.flatten("lune.obj", "arc.txt", "--scheme", "global", "--interior", "laplacian")
        self.assertEqual(paper["pieces"], pair["pieces"])
        steps = self.flatten("lune.obj", "arc.txt", "--paper-method", "--solver", "sequential")
        self.assertEqual((steps["scheme"], steps["solver"]), ("global", "sequential"))
        self.assertAlmostEqual(
            steps["pieces"][0]["E_ang"], paper["pieces"][0]["E_ang"], delta=1e-9)

    def test_a_conformal_map_reports_neither_solver_nor_interior(self):
        report = self.flatten("lune.obj", "--scheme", "lscm")
        self.assertEqual((report["solver"], report["interior"]), (None, None))

    def test_files_lie_in_the_folder_and_belong_together(self):
        self.flatten("lune.obj", "arc.txt")
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["cut.vtp", "flat.vtp", "report.json", "wires.vtp"])
        flat, cut = (self.array(f"out/{name}.vtp", "Points") for name in ("flat", "cut"))
        self.assertEqual(len(flat), len(cut))
        self.assertEqual(set(flat[2::3]), {0.0})
        self.assertEqual(len(self.array("out/wires.vtp", "CurveType")), 2)

    def test_default_folder_takes_the_name_of_the_surface(self):
        os.mkdir(self.path("sub"))
        os.replace(self.path("lune.obj"), self.path("sub/lune.obj"))
        run = self.run_command("sub/lune.obj", code=0)
        self.assertIn("lune_flat", run.stdout)
        self.assertIn("flat.vtp", os.listdir(self.path("lune_flat")))

    def test_table_has_a_row_a_piece_and_the_papers_columns(self):
        self.write("sheet.obj", command.obj(*command.sheet()))
        self.write("seam.txt", "seam s 2 7 12 17 22\n")
        lines = self.run_command("sheet.obj", "seam.txt", "--table").stdout.splitlines()
        self.assert_words(("size [mm]", "E_len x1e3", "E_ang x1e3", "E_h", "E_r", "strain p95", "flips", "T_opt", "T_all",
                           "status"), lines[0])
        self.assertEqual([line.split()[0] for line in lines[1:4]], ["1", "2", "all"])
        self.assertEqual([line.split()[1] for line in lines[1:3]], ["16", "16"])
        curve = next(line for line in lines if line.startswith("s "))
        self.assertEqual(curve.split()[1:3], ["1", "1"])

    def test_of_many_pieces_those_that_fit_worst_have_a_line(self):
        heights = [0.02 * (1 + (7 * k) % 24) for k in range(24)]
        parts = [command.dome(4, 4, height) for height in heights]
        self.write("domes.obj", command.obj(*command.together(*(
            ([(x + 3 * k, y, z) for x, y, z in points], triangles) for k, (points, triangles) in enumerate(parts)))))
        lines = self.run_command("domes.obj", "--unit", "cm").stdout.splitlines()
        worst = sorted(range(1, 25), key=lambda piece: -heights[piece - 1])[:20]
        self.assertEqual([int(line.split()[1][:-1]) for line in lines if line.startswith("piece ")], sorted(worst))
        self.assertIn("and 4 more pieces, which fit better; --table lists all", lines)

    def test_quiet_says_nothing(self):
        run = self.run_command("lune.obj", "--quiet", "--unit", "inch")
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))

    def test_broken_promise_is_exit_4_with_everything_written_and_marked(self):
        run = self.run_command("lune.obj", "arc.txt", "--paper-method", "--solver", "sequential", "--max-iterations", "1",
                               "--output", "out", code=4)
        self.assertIn("warning: piece 1", command.error_lines(run)[-1])
        report = self.report("out")
        self.assertEqual(report["exit_code"], 4)
        self.assertEqual(report["pieces"][0]["status"], "NotConverged")
        self.assertEqual(len(self.array("out/flat.vtp", "Points")), 3 * 37)

    def test_what_a_plane_cannot_hold_is_said_with_a_cut(self):
        self.write("ball.obj", command.obj(*command.cap(math.radians(120), 8, 12)))
        run = self.run_command("ball.obj", "--output", "out", code=0)
        piece, = self.report("out")["pieces"]
        self.assertAlmostEqual(piece["E_area"], piece["forecast_area_loss"], delta=0.03)
        self.assertLess(piece["forecast_area_loss_after_cut"], piece["forecast_area_loss"] - 0.1)
        self.assertEqual(piece["forecast_cut_to"], 0)  # the pole, from the boundary
        self.assertGreater(piece["forecast_cut_from"], 12 * 7)
        self.assertIn("a plane cannot hold this piece", piece["verdict"])
        self.assertNotIn(piece["verdict"], run.stdout)
        self.assertIn("wirewarp: warning: piece 1: " + piece["verdict"] + "\n", run.stderr)
        self.assertEqual(self.flatten("lune.obj", "arc.txt")["pieces"][0]["verdict"], "")

    def test_a_tube_is_named_with_the_points_between_which_to_cut_it(self):
        lune = (self.points, self.triangles)
        for count, rings, wider, energy in ((6, 1, 0, ""), (40, 11, 4, "symmetric Dirichlet")):
            tube = command.tube(count, rings, lambda ring: (3 + wider * (1 - ring / rings), 10 * ring / rings))
            self.write("tube.obj", command.obj(*command.together(lune, tube)))
            run = self.run_command("tube.obj", "--unit", "cm", "--output", "out", code=(0, 4))
            self.assertEqual((run.stdout + run.stderr).count("Dirichlet energy was used"), 1 if energy else 0)
            report = self.report("out")
            said = report["pieces"][1]["verdict"]
            self.assertIn(f"wirewarp: warning: piece 2: {said}\n", run.stderr)
            self.assertIn(f"piece 2: {said}", report["warnings"])
            self.assertIn(energy, said)
            start, end = map(int, re.search(
                r"this is a tube with 2 openings, .*: cut it open from point (\d+) to point (\d+), or",
                said).groups())
            self.assertEqual({(p - len(self.points)) // count for p in (start, end)}, {0, rings})


if __name__ == "__main__":
    command.main()
