# SPDX-License-Identifier: BSD-3-Clause
import os
import re

import command

COMMANDS = ("make", "check", "cut", "flatten", "pattern", "nest", "grade", "sew", "reshape", "picture", "prices", "batch",
            "materials", "formats")


def listed(text):
    """The options that a help lists, each by its long name."""
    return re.findall(r"^ {1,12}(?:-\w, *)?(--[\w-]+)", text, re.M)


class Usage(command.CommandTest):
    def assert_usage_error(self, *arguments):
        run = self.assert_stderr("--help", *arguments, code=2)
        self.assertEqual(run.stdout, "")
        first = command.error_lines(run)[0]
        self.assertRegex(first, "^wirewarp: error: ")
        return first

    def test_what_is_missing_or_empty_is_named(self):
        for arguments, word in (((), "SURFACE"), (("",), ""), (("a.obj", "--output"), "--output"),
                                (("a.obj", "--output", ""), "--output"), (("a.obj", "--pins", "3", "3"), "--pins")):
            with self.subTest(arguments):
                self.assertIn(word, self.assert_usage_error(*arguments))

    def test_an_option_that_is_nearly_written_is_proposed_and_no_other(self):
        for written, meant in (("--sheme", "--scheme"), ("--materail=denim", "--material"),
                               ("--no-relaese-trials", "--no-release-trials"), ("--fairness", None),
                               ("--Close_Cuts", "--close-cuts"), ("-x", None)):
            with self.subTest(written):
                said = self.assert_usage_error("a.obj", written)
                self.assertEqual(said.partition("; is ")[2], f"{meant} meant?" if meant else "")

    def test_words_of_options_may_have_capital_letters_and_units_other_names(self):
        self.write_lune()
        reports = []
        for scheme, unit, paper in (("global", "inch", "letter"), ("Global", "Inches", "LETTER")):
            self.run_command("pattern", "lune.obj", "--scheme", scheme, "--unit", unit, "--paper", paper, "-o", unit,
                             env={**os.environ, "SOURCE_DATE_EPOCH": "1000000000"}, code=0)
            with open(self.path(f"{unit}/pattern.pdf"), "rb") as file:
                reports.append((self.report(unit)["sizes"], file.read()))
        self.assertEqual(*reports)
        self.assertIn("'ell' is none of mm, cm, m, inch", self.assert_usage_error("a.obj", "--unit", "ell"))

    def test_numbers_out_of_their_range_are_refused(self):
        for option, *values in (
            ("--max-iterations", "0", "1.5", "99999999999999999999"), ("--threads", "-1", "100000"),
            ("--spacing", "nan", "-0.1", "wide"), ("--closure-tolerance", "inf"), ("--relaxation-factor", "2", "0"),
            ("--curve-distance", "1.5"),
        ):
            for value in values:
                with self.subTest(option=option, value=value):
                    self.assertIn(option, self.assert_usage_error("a.obj", option, value))
        for width in ("0", "-3", "nan", "inf", "1e6", "wide"):
            said = self.assert_usage_error("nest", "a.obj", "--unit", "cm", "--roll-width", width)
            self.assertIn(f"--roll-width: '{width}' is not a length in (0, 100000] mm", said)

    def test_options_of_what_is_not_asked_for_are_bad_usage(self):
        message = self.assert_usage_error("pattern", "a.obj", "-o", "a.svg", "--paper", "a3")
        self.assertIn("--paper is for a pattern in PDF (-o FILE.pdf); give that as well, or leave it out", message)

    def test_options_of_version_0_1_name_what_there_is_now(self):
        former = """--suggest --bound --max-cut-length --release-keys --imprint-tolerance --no-split --price-keys --flattenable
            --outside-bias --resew --resew-thickness --resew-iterations --resew-pressure --resew-gravity --resew-once --svg
            --pdf --dxf --plt --garmentcode --walk --piece-name --piece-quantity --curve-allowance --curve-notch
            --double-notches --cut-on-fold --curve-dart-tip --cut-pairs --fair --curve-fair --laser-colors --fabric-width
            --fabric-gap --grade --grade-at --picture --color-by --batch --list-curves --list-materials""".split()
        helps = {name: self.run_command(name, "--help-all").stdout for name in COMMANDS}
        for option in former:
            with self.subTest(option):
                _, is_now, successor = self.assert_usage_error("a.obj", option).partition(f"; {option} is now ")
                self.assertTrue(is_now)
                words = successor.split()
                self.assertNotIn(option, words)
                options = helps[words[1] if words[0] == "wirewarp" else "flatten"] + self.run_command("--help").stdout
                for word in words:
                    if word.startswith("-") and word != "-o":
                        self.assertRegex(options, rf"(?m)^ .*{word}\b")

    def test_a_command_that_is_nearly_written_is_proposed_and_a_file_of_its_name_is_read(self):
        for written, meant in (("flaten", "flatten"), ("Pattren", None), ("piture", "picture"), ("help", "--help")):
            with self.subTest(written):
                run = self.run_command(written, "a.obj")
                self.assertEqual("did you mean wirewarp %s?" % meant in run.stderr, meant is not None, run.stderr)
                self.assertNotEqual(run.returncode, 0)
        self.write("flaten", "not a surface")
        self.assertNotIn("mean", self.run_command("flaten").stderr)

    def test_help_says_what_each_word_of_an_option_does(self):
        said = " ".join(self.run_command("flatten", "--help").stdout.split())
        self.assertRegex(said, r"How the legs of a dart lie: .*straight, or mirrored \(")
        said = " ".join(self.run_command("make", "--help").stdout.split())
        self.assertIn("--max-cuts", said)  # which its messages name

    def test_bad_usage_writes_nothing(self):
        self.write("a.obj", command.obj(*command.sheet()))
        self.assert_usage_error("a.obj", "--output", "out", "--scheme", "nonsense")
        self.assertEqual(os.listdir(self.folder), ["a.obj"])

    def test_help_is_short_and_names_the_commands(self):
        run = self.run_command("--help")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertLessEqual(len(run.stdout.splitlines()), 40)
        self.assertEqual(set(re.findall(r"^  (\w+) {4,}[A-Z]", run.stdout, re.M)), set(COMMANDS))

    def test_help_of_a_command_is_short_and_its_experts_have_the_rest(self):
        for command_ in COMMANDS:
            with self.subTest(command_):
                run = self.run_command(command_, "--help")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertLessEqual(len(run.stdout.splitlines()), 45)
                self.assertNotIn("... ...", run.stdout)
                names = listed(run.stdout)
                self.assertLessEqual(len(names), 20)
                whole = listed(self.run_command(command_, "--help-all").stdout)
                self.assertEqual(len(whole), len(set(whole)))
                self.assertLessEqual(set(names), set(whole))

    def test_formats_tells_inputs_units_and_exit_codes(self):
        run = self.run_command("formats")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assert_words((".vtp", ".obj", ".stl", "TYPE NAME v0 v1", "accessory", "seam", "Units", "report.json"), run.stdout)


if __name__ == "__main__":
    command.main()
