# SPDX-License-Identifier: BSD-3-Clause
"""flatten() from arrays gives what the C++ program wirewarp gives from files."""

import unittest

from surfaces import command, flattened, quiet

# Options, and the words of the command for them.
OPTIONS = (
    ({"scheme": "progressive", "interior": "laplacian"}, "--scheme progressive --interior laplacian"),
    ({"scheme": "lscm"}, "--scheme lscm"),
    ({"max_iterations": 2, "scheme": "global"}, "--max-iterations 2 --scheme global"),
    ({"solver": "sequential"}, "--solver sequential"),
    ({"interior": "laplacian"}, "--interior laplacian"),
    ({"paper_method": True}, "--paper-method"),
    ({"release_keys": True, "release_trials": False}, "--no-keys --no-release-trials"),
    ({"energy": "dirichlet"}, "--energy dirichlet"),
    ({"boundary": "free"}, "--boundary free"),
    ({"boundary": "free", "energy": "rigid", "area_bias": 0.5}, "--boundary free --energy rigid --area-bias 0.5"),
    ({"area_bias": 0.5, "angle_weight": 20.0}, "--area-bias 0.5 --angle-weight 20"),
    ({"isometric_iterations": 2}, "--isometric-iterations 2"),
    ({"isometric_tolerance": 1.0}, "--isometric-tolerance 1"),
    ({"scheme": "global", "rigid_iterations": 2}, "--scheme global --rigid-iterations 2"),
    ({"scheme": "global", "rigid_tolerance": 1e-2}, "--scheme global --rigid-tolerance 1e-2"),
    ({"scheme": "global", "interior": "relaxation", "relaxation_factor": 1.2, "relaxation_movement": 1e-3,
      "relaxation_min_iterations": 3, "relaxation_max_iterations": 30},
     "--scheme global --interior relaxation --relaxation-factor 1.2 --relaxation-movement 1e-3 "
     "--relaxation-min-iterations 3 --relaxation-max-iterations 30"),
    ({"closure_tolerance": 1e-2, "optimality_tolerance": 1e-1, "scheme": "global"},
     "--closure-tolerance 1e-2 --optimality-tolerance 1e-1 --scheme global"),
    ({"tolerance": {"waist_dart": 0.04}}, "--tolerance waist_dart=0.04"),
    ({"scheme": "lscm", "pins": (3, 40)}, "--scheme lscm --pins 3 40"),
    ({"arrange": False}, "--no-arrange"),
    ({"dart_legs": "free"}, "--dart-legs free"),
    ({"dart_legs": "straight"}, "--dart-legs straight"),
    ({"material": "twill", "grain": 30.0}, "--material twill --grain 30"),
    ({"material": "jersey", "grain": ["none_such", "grainline:45"], "release_keys": True},
     "--material jersey --grain none_such --grain grainline:45 --no-keys"),
    ({"material": "isotropic", "grain": "free", "scheme": "global"},
     "--material isotropic --grain free --scheme global"),
    ({"spacing": 0.5, "split_triangles": False}, "--spacing 0.5 --no-split-triangles"),
    ({"max_length_error": 1e-18}, "--max-length-error 1e-18"),
    ({"imprint_tolerance": 1e-3, "snap_tolerance": 0.1}, "--curve-distance 1e-3 --snap-tolerance 0.1"),
)
REFUSED = (
    ({"paper_method": True, "scheme": "global"}, "--paper-method --scheme global"),
    ({"paper_method": True, "interior": "arap"}, "--paper-method --interior arap"),
    ({"scheme": "lscm", "solver": "newton"}, "--scheme lscm --solver newton"),
    ({"scheme": "lscm", "tolerance": {"waist_dart": 0.1}}, "--scheme lscm --tolerance waist_dart=0.1"),
    ({"energy": "dirichlet", "area_bias": 0.0}, "--energy dirichlet --area-bias 0"),
    ({"boundary": "free", "area_bias": 0.5}, "--boundary free --area-bias 0.5"),
    ({"boundary": "free", "scheme": "global"}, "--boundary free --scheme global"),
    ({"boundary": "free", "dart_legs": "free"}, "--boundary free --dart-legs free"),
    ({"boundary": "free", "tolerance": {"waist_dart": 0.1}}, "--boundary free --tolerance waist_dart=0.1"),
    ({"scheme": "global", "isometric_iterations": 100}, "--scheme global --isometric-iterations 100"),
    ({"interior": "laplacian", "rigid_iterations": 9}, "--interior laplacian --rigid-iterations 9"),
    ({"relaxation_factor": 1.5}, "--relaxation-factor 1.5"),
    ({"scheme": "progressive", "release_trials": False}, "--scheme progressive --no-release-trials"),
    ({"arrange": False, "spacing": 0.05}, "--no-arrange --spacing 0.05"),
    ({"pins": (3, 40)}, "--pins 3 40"),
    ({"grain": 30.0}, "--grain 30"),
    ({"material": "twill", "energy": "rigid"}, "--material twill --energy rigid"),
    ({"interior": "relaxation", "relaxation_factor": 2.5}, "--interior relaxation --relaxation-factor 2.5"),
    ({"tolerance": {"waist_dart": 1.0}}, "--tolerance waist_dart=1"),
    ({"tolerance": {"no_such": 0.1}}, "--tolerance no_such=0.1"),
    ({"max_iterations": 0}, "--max-iterations 0"),
    ({"spacing": -1.0}, "--spacing=-1"),
)


class SameNumbers(command.CommandTest):
    def run_pants(self, words, code):
        return self.run_command(*command.data_files("pants_front"), "--unit", "cm", *words.split(), "--quiet", "-o", "out",
                                code=code)

    def compare(self, mine, theirs, where):
        if isinstance(mine, dict):
            self.assertEqual(set(mine), set(theirs), where)
            for key in mine:
                self.compare(mine[key], theirs[key], f"{where}.{key}")
        elif isinstance(mine, list):
            self.assertEqual(len(mine), len(theirs), where)
            for row, (one, other) in enumerate(zip(mine, theirs)):
                self.compare(one, other, f"{where}[{row}]")
        elif isinstance(mine, float):
            self.assertAlmostEqual(mine, theirs, delta=1e-9 * max(1.0, abs(theirs)), msg=where)
        else:
            self.assertEqual(mine, theirs, where)

    @quiet()
    def test_they_give_the_same_report_and_each_changes_something(self):
        plain = flattened("pants_front")
        for options, words in OPTIONS:
            with self.subTest(options=options):
                mine = flattened("pants_front", **options)
                self.run_pants(words, (0, 4))
                theirs = self.report("out")
                self.assertEqual(mine.report["status"], theirs["status"])
                self.compare(mine.report["pieces"], [
                    {**piece, "message": own["message"]}
                    for piece, own in zip(theirs["pieces"], mine.report["pieces"])], "pieces")
                self.compare(mine.report["curves"], theirs["curves"], "curves")
                if not {"split_triangles", "imprint_tolerance", "release_keys"} & set(options):
                    self.assertFalse(mine == plain)

    def test_they_are_refused_for_the_same(self):
        for options, words in REFUSED:
            with self.subTest(options=options):
                self.assert_raises(ValueError, "", flattened, "pants_front", **options)
                self.run_pants(words, (2, 3))


if __name__ == "__main__":
    unittest.main()
