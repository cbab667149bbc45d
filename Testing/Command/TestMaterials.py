# SPDX-License-Identifier: BSD-3-Clause
import json
import math
import os
import random

import command

TWILL = {"name": "mine", "warp": 2017, "weft": 2035, "shear": 26, "compression": 1,
         "limits": {"warp": [-1, 1], "weft": [-2, 2], "shear": 25}}
KEYS = ["grain_angle", "grain_curve", "one_way", "share_locked", "share_out_of_limit", "share_over_5_percent", "shear_limit",
        "shear_rms", "strain_warp_rms", "strain_weft_rms"]


class Materials(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.write_lune()
        # A knit that has no limits.
        self.write("soft.json", json.dumps({"warp": 34, "weft": 17, "shear": 9, "compression": 0.5}))

    def cloth(self, *arguments, code=0):
        return self.flatten("lune.obj", "arc.txt", *arguments, code=code)["pieces"][0]["cloth"]

    def refused(self, *arguments):
        """The message of a run that is refused for its material."""
        report = self.flatten("lune.obj", "arc.txt", *arguments, code=3)
        self.assertEqual((report["status"], report["pieces"]), ("InvalidOption", []))
        return report["message"]

    def test_threads_and_limits_are_reported(self):
        self.assertIsNone(self.cloth())
        twill = self.cloth("--material", "twill", code=4)
        self.assertEqual(sorted(twill), KEYS)
        self.assertTrue(all(math.isfinite(twill[key]) for key in KEYS if key != "grain_curve"))
        report = self.report("out")
        self.assertEqual((report["material"], report["grain"]), ("twill", []))
        self.assertEqual(report["pieces"][0]["energy_used"], "cloth")
        # What cannot be met is said with the cells, the wire and the ways out.
        self.assertEqual((report["status"], report["id_kind"]), ("BeyondLimits", "cells"))
        out = self.array("out/flat.vtp", "OutOfLimit")
        self.assertEqual(sorted(report["ids"]), [cell for cell, beyond in enumerate(out) if beyond])
        self.assertIn("along the boundary", report["message"])
        self.assertIn("--material", report["message"])

    def test_a_file_is_what_the_name_is(self):
        self.write("mine.json", json.dumps(TWILL))
        self.assertEqual(self.cloth("--material", "mine.json", code=4), self.cloth("--material", "twill", code=4))

    def test_the_grain_follows_a_curve_an_angle_or_the_least_strain(self):
        along = self.cloth("--material", "soft.json", "--grain", "arc:15")
        self.assertEqual(along["grain_curve"], "arc")
        self.assertAlmostEqual(along["grain_angle"], 15.0, 6)
        turned = self.cloth("--material", "soft.json", "--grain=-20")
        self.assertAlmostEqual(turned["grain_angle"], -20.0, 6)
        self.cloth("--material", "soft.json", "--grain", "free")

    def test_a_grain_without_its_curve_is_marked_and_names_those_that_are_there(self):
        missing = self.cloth("--material", "soft.json", "--grain", "hem", code=4)
        self.assertEqual(missing["grain_curve"], "")
        report = self.report("out")
        self.assertEqual(report["status"], "MissingGrain")
        self.assertIn('"hem" is not a curve of the piece', report["message"])
        self.assertIn('with --grain: "arc"', report["message"])
        self.assertIn('"hem"', report["pieces"][0]["message"])
        self.assertNotIn("not an angle", report["message"])
        self.cloth("--material", "soft.json", "--grain", "arc:1o", code=4)
        self.assertIn('"1o" is not an angle', self.report("out")["message"])
        # The piece is what its upright makes of it.
        places = self.array("out/flat.vtp", "Points", "Points")
        self.cloth("--material", "soft.json")
        self.assertEqual(self.array("out/flat.vtp", "Points", "Points"), places)

    def test_materials_without_meaning_are_named_and_nothing_is_flattened(self):
        self.assertIn("one of isotropic, plain, twill", self.refused("--material", "felt"))
        self.assertEqual(os.listdir(self.path("out")), ["report.json"])
        for change, words in (
                *(({"warp": value}, 'has a "warp" that is not a number') for value in ("stiff", None, True, [2000])),
                ({"shear": -1}, "the shear stiffness -1"),
                *(({"weft": value}, "the weft stiffness") for value in (-0.0, 1e300, 1e-300)),
                *(({"shear": value}, "a stiffness too small") for value in (1e-5, 1e12)),
                ({"cross": 1e9}, "the coupling 1e+09"),
                *(({"limits": {"weft": value}}, "strain limits that leave out 0")
                  for value in ([1, 2], [0, 0], [2, -2], [-1e-300, 1e-300])),
                *(({"limits": {"shear": value}}, "a shear limit") for value in (0, -5)),
                ({"limits": {"shear": "5"}}, 'has a "shear" that is not a number'),
                *(({"limits": {"warp": value}}, "are not two numbers") for value in (3, [-1, 1, 2], [-1, None])),
                ({"limits": {"bias": [-1, 1]}}, 'has a member "bias" that means nothing'),
                ({"limits": [-1, 1]}, 'has "limits" that are not an object'),
                *(({"compression": value}, f"the compression ratio {value}") for value in (0, 2)),
                ({"one_way": 1}, "neither true nor false"),
                *(({"name": value}, 'has a "name" that is not text, or is too long') for value in (3, "x" * 5000)),
                ({"bending": 3}, 'has a member "bending" that means nothing')):
            self.write("bad.json", json.dumps({**TWILL, **change}))
            self.assertIn(words, self.refused("--material", "bad.json"), change)
        self.write("bad.json", json.dumps({"warp": 2000, "weft": 2000}))
        self.assertIn('has no "shear"', self.refused("--material", "bad.json"))
        self.assert_stderr("--material", "lune.obj", "--grain", "30", code=2)

    def test_files_that_are_no_material_are_named(self):
        numbers = '"warp": 2000, "weft": 1900, "shear": 25'
        for text, words in (
                *((text, "holds no object") for text in ("[1]", "7", "null", '"twill"')),
                ("", "is not JSON at line 1"), ("{", "is not JSON at line 1"),
                ("{\n" + numbers + "\n,}", "is not JSON at line 3"),
                ('{"warp": 1e999, "weft": 1, "shear": 1}', "has a number that is too large"),
                ("{" + numbers + ', "warp": 1}', 'has "warp" twice'),
                ("{" + numbers + ', "limits": {"shear": 1, "shear": 9}}', 'has "shear" twice'),
                *((text, "is not JSON") for text in (
                    '{"warp": NaN}', '{"warp": Infinity}', "{" + numbers + "} {}", "[" * 100000, '{"a":' * 100000,
                    b"\x00\xff\xfe" * 100, b'{"name": "\xff"}')),
                (" " * 2000000 + "{" + numbers + "}", "has more than a megabyte")):
            self.write("bad.json", text)
            self.assertIn(words, self.refused("--material", "bad.json"), text[:60])
        os.mkdir(self.path("folder"))
        os.mkfifo(self.path("pipe"))
        for name in ("missing.json", "folder", "pipe", "/dev/zero", "x" * 5000, "twill\n"):
            self.assertIn("is neither a material nor a file that can be read", self.refused("--material", name))

    def test_damaged_files_are_materials_or_refused(self):
        random.seed(15)
        whole = json.dumps(TWILL).encode()
        seen = set()
        for _ in range(60):
            text = bytearray(whole)
            for _ in range(random.randint(1, 3)):
                at = random.randrange(len(text))
                text[at:at + random.randint(0, 2)] = random.choice((b"", b"9", b"-", b"e9", b'"', b"{", b"]", b"\xff"))
            self.write("bad.json", bytes(text))
            run = self.run_command("lune.obj", "arc.txt", "--material", "bad.json", "--output", "out")
            report = self.report("out")
            seen.add(report["status"])
            self.assertEqual(run.returncode, {"Ok": 0, "InvalidOption": 3}.get(report["status"], 4), text)
            for piece in report["pieces"]:
                self.assertIsNotNone(piece["cloth"], text)
                self.assertLess(piece["E_len_max"], 1e-9, text)
        self.assertEqual(seen, {"InvalidOption", "BeyondLimits"})

    def test_a_material_may_be_written_with_capitals_unless_a_file_is_called_so(self):
        sewn = []
        for name in ("denim", "Denim", "DENIM"):
            self.run_command("lune.obj", "--unit", "cm", "--material", name, "--output", "out", code=(0, 4))
            sewn.append(self.report("out")["pieces"][0]["cloth"])
        self.assertIsNotNone(sewn[0])
        self.assertEqual(sewn[1:], sewn[:1] * 2)
        self.write("Denim", "no material")
        self.assert_stderr('the material file "Denim"', "lune.obj", "--unit", "cm", "--material", "Denim", "--output", "file")

    def test_the_list_has_every_material_with_its_source(self):
        run = self.run_command("materials")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        for name in ("isotropic", "plain", "twill", "denim", "stretch-woven", "jersey", "rib", "neoprene",
                     "leather", "laminate", "woven-carbon"):
            self.assertEqual(sum(line.startswith(name + " ") for line in run.stdout.splitlines()), 1, name)
            self.assertIn(f"\n  {name}: ", run.stdout)


class Sheets(command.CommandTest):
    def test_the_neutral_layer_of_a_bent_sheet_has_its_width(self):
        """Half of a tube of 100 mm in 36 chords, 200 mm long: a layer that is d within has at each of the 35 bends
        2 d tan(angle / 2) less, the angle being pi / 36."""
        for unit, size in (("mm", 1.0), ("cm", 0.1)):
            self.write("tube.obj", command.obj(*command.grid(36, 4, lambda i, j: tuple(size * x for x in (
                100 * math.cos(math.pi * i / 36), 100 * math.sin(math.pi * i / 36), 50 * j)))))
            for inwards in (0.0, 1.8, -2.0):
                self.flatten("flatten", "tube.obj", "--unit", unit, "--neutral-layer", str(inwards))
                width = 36 * 200 * math.sin(math.pi / 72) - 70 * inwards * math.tan(math.pi / 72)
                around = sum(self.array("out/wires.vtp", "FlatLength"))
                self.assertAlmostEqual(around, 2 * (width + 200) * size, delta=1e-6)


if __name__ == "__main__":
    command.main()
