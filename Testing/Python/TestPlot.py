# SPDX-License-Identifier: BSD-3-Clause
"""plot() draws pieces, wires and measures with matplotlib; without it a word says what to install."""

import os
import subprocess
import sys
import unittest

os.environ["MPLBACKEND"] = "Agg"

import matplotlib  # noqa: E402  - the backend is chosen first
import numpy as np  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402

from surfaces import command, flattened, quiet  # noqa: E402


class Plot(command.CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.result = flattened("tshirt")

    def tearDown(self):
        pyplot.close("all")

    def wires_of(self, ax):
        return {collection.get_label(): collection for collection in ax.collections
                if isinstance(collection, LineCollection)}

    def test_every_wire_is_drawn_in_its_length_and_the_color_of_its_type(self):
        drawn = self.wires_of(self.result.plot())
        self.assertEqual(set(drawn), {wire.type for wire in self.result.wires})
        for kind, collection in drawn.items():
            lengths = [np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
                       for line in collection.get_segments()]
            np.testing.assert_allclose(
                lengths, [wire.flat_length for wire in self.result.wires if wire.type == kind])
        self.assertEqual(matplotlib.colors.to_hex(drawn["key"].get_color()[0]), "#d90000")

    def test_triangles_are_colored_by_the_array_that_is_named(self):
        for word, name in (("homogeneity", "HomogeneityOfDistortion"), ("area", "AreaRatio"),
                           ("aspect-ratio", "AspectRatio"), ("developability", "Developability")):
            values = self.result.cell_arrays.get(name, self.result.point_arrays.get(name))
            np.testing.assert_array_equal(self.triangles_of(self.result, word).get_array(), values)

    def lightness(self, triangles, values):
        """Relative luminance after ITU-R BT.709."""
        colors = np.array(triangles.to_rgba(values))[:, :3]
        linear = np.where(colors <= 0.04045, colors / 12.92, ((colors + 0.055) / 1.055)**2.4)
        return linear @ (0.2126, 0.7152, 0.0722)

    def triangles_of(self, result, word):
        (triangles,) = [collection for collection in result.plot(word).collections
                        if not isinstance(collection, LineCollection)]
        return triangles

    def test_maps_are_light_where_nothing_is_changed_and_of_both_signs_diverge_from_there(self):
        with quiet():
            result = flattened("shirt_front", material="twill")
        for word, ideal, poor in (("homogeneity", 1.0, 0.5), ("aspect-ratio", 1.0, 0.5), ("stretch", 100.0, 119.9),
                                  ("developability", 0.0, 1e9)):
            triangles = self.triangles_of(result, word)
            values = np.linspace(ideal, min(poor, triangles.get_clim()[1]), 40)
            light = self.lightness(triangles, values)
            self.assertTrue((np.diff(light) <= 1e-6).all(), word)
            self.assertGreater(light[0], 10 * light[-1], word)
        for word, ideal in (("area", 1.0), ("warp", 0.0), ("weft", 0.0), ("shear", 0.0)):
            triangles = self.triangles_of(result, word)
            first, last = triangles.get_clim()
            self.assertAlmostEqual((first + last) / 2, ideal, delta=1e-12, msg=word)
            middle, low, high = triangles.to_rgba([ideal, first, last])
            self.assertLess(np.ptp(middle[:3]), 0.02, word)  # no hue
            self.assertGreater(low[2] - low[0], 0.3, word)
            self.assertGreater(high[0] - high[2], 0.3, word)
            light = self.lightness(triangles, np.linspace(first, last, 41))
            self.assertIn(np.argmax(light), (19, 20, 21), word)

    def test_pieces_are_numbered_and_measured(self):
        texts = [text.get_text() for text in self.result.plot().texts]
        self.assertEqual([text for text in texts if text.isdigit()], ["1", "2", "3", "4"])
        # As the pattern that is cut numbers them.
        self.result.write_pattern(self.path("a.svg"), unit="cm")
        self.assert_words((">piece 1 of 4<", ">piece 4 of 4<"), self.read("a.svg"))
        for piece in self.result.report["pieces"]:
            self.assertTrue(any(f"E_area {piece['E_area']:.4f}" in text for text in texts))
        self.assertEqual(len(self.result.plot(measures=False).texts), 0)

    def test_it_draws_into_given_axes_and_a_file(self):
        figure, (left, right) = pyplot.subplots(1, 2)
        self.assertIs(self.result.plot(ax=right, color_by=None), right)
        self.assertEqual(len(left.collections), 0)
        self.assertEqual(right.get_aspect(), 1.0)
        figure.savefig(self.path("pieces.png"))
        picture = pyplot.imread(self.path("pieces.png"))
        half = picture.shape[1] // 2
        self.assertTrue((picture[:, half:, :3] < 0.95).any())

    def test_words_are_checked(self):
        with self.assertRaisesRegex(ValueError, "color_by is 'beauty'; it must be one of homogeneity"):
            self.result.plot("beauty")

    def test_nothing_else_needs_matplotlib_and_a_word_says_what_to_install(self):
        program = (
            "import sys\n"
            "sys.modules['matplotlib'] = None\n"
            "import surfaceflattening as sf\n"
            "r = sf.flatten([[0,0,0],[1,0,0],[1,1,0],[0,1,0]], [[0,1,2],[0,2,3]])\n"
            "assert '<svg' in r._repr_html_()\n"
            "try:\n"
            "    r.plot()\n"
            "except ImportError as error:\n"
            "    print(error)\n")
        run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertIn("python3-matplotlib", run.stdout)


if __name__ == "__main__":
    unittest.main()
