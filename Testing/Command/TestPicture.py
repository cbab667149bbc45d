# SPDX-License-Identifier: BSD-3-Clause
"""wirewarp picture: what it shows, and what happens where nothing can be drawn."""

import os
import shutil

from vtkmodules.vtkCommonCore import vtkVersion

import command

SURFACE, CURVES = command.data_files("shirt_front")
WIRES = {"boundary": (0, 0, 0), "accessory": (0, 153, 26), "key": (217, 0, 0), "dart": (0, 51, 230)}


def count(pixels, color):
    return int((abs(pixels - color).max(axis=2) <= 2).sum())


class Picture(command.CommandTest):
    def draw(self, name, *arguments, source=(SURFACE, CURVES)):
        run = self.run_command("picture", *source, "--unit", "cm", "-o", name, *arguments, code=0)
        self.assertEqual(run.stderr, "")
        return command.read_png(self.path(name))

    def test_it_shows_the_wires_in_their_colors_in_space_and_in_the_plane(self):
        pixels = self.draw("shirt.png")
        middle = pixels.shape[1] // 2
        for name, color in WIRES.items():
            for side in (pixels[200:, :middle], pixels[200:, middle:]):
                self.assertGreater(count(side, color), 200, name)

    def test_each_coloring_gives_another_picture(self):
        names = ("strain", "developability", "homogeneity", "aspect-ratio", "area")
        pictures = [self.draw(name + ".png", "--color", name) for name in names]
        for k, picture in enumerate(pictures):
            for other in pictures[:k]:
                self.assertGreater((picture != other).any(axis=2).mean(), 0.1)

    def test_the_strain_is_shown_by_default_and_the_range_may_be_chosen(self):
        default, strain, same, wide = (
            self.draw(f"{k}.png", *words) for k, words in enumerate((
                (), ("--color", "strain"), ("--color-range", "0", "50", "--color", "strain"), ("--range", "0", "1e3"))))
        self.assertTrue((default == strain).all())
        for other in (same, wide):
            self.assertGreater((other != strain).any(axis=2).mean(), 0.1)
        self.assert_stderr("--color-range", "picture", SURFACE, "-o", "a.png", "--color-range", "2", "1", code=2)

    def test_its_size_may_be_chosen(self):
        self.assertEqual(self.draw("shirt.png", "--size", "800", "500").shape, (500, 800, 3))

    def test_bodies_are_seen_from_the_side_and_above(self):
        """A closed box has no direction that most of it faces; the bottom of a cup is not what shows it."""
        for up in "yz":
            points, triangles = command.tube(16, 8, lambda j: (1, j))
            triangles += [(0, i + 1, i) for i in range(1, 15)]
            if up == "y":
                points = [(x, z, -y) for x, y, z in points]
            self.write("cup.obj", command.obj(points, triangles))
            self.run_command("make", "cup.obj", "--unit", "cm", "-o", "cup", "-o", "cup.svg")
            for words in ((), ("--size", "400", "400")):
                pixels = self.draw("cup.png", "--color", "area", *words, source=["cup"])
                drawn = (pixels[160:-60] != 255).any(axis=2)  # from below
                wide = drawn.any(axis=0)
                first = wide.argmax()
                columns = wide[first:].argmin()  # up to the flat pieces
                rows = drawn[:, first:first + columns].any(axis=1).sum()
                self.assertGreater(rows, 2 * columns)  # it is 8 high and 2 wide

    def test_its_folder_is_made_and_nothing_else_is_left_there(self):
        self.draw(os.path.join("a folder", "shirt.PNG"))
        self.assertEqual(os.listdir(self.path("a folder")), ["shirt.PNG"])

    def test_without_an_x_server_it_is_drawn_otherwise_or_refused_before_anything_is_written(self):
        for display in (None, "", ":65000"):
            environment = {**os.environ, "DISPLAY": display or ""}
            if display is None:
                del environment["DISPLAY"]
            run = self.run_command("picture", SURFACE, "-o", "out", "-o", "a.png", env=environment)
            if run.returncode == 0:  # VTK 9.4 and later draw by EGL or OSMesa then
                self.assertGreaterEqual((vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()), (9, 4))
                self.assertGreater(os.path.getsize(self.path("a.png")), 1000)
                shutil.rmtree(self.path("out"))
                os.remove(self.path("a.png"))
                continue
            self.assertEqual(run.returncode, 3, run.stderr)
            line, = command.error_lines(run)
            self.assert_words(("X server", "xvfb-run"), line)
            self.assertEqual(os.listdir(self.folder), [])

    def test_a_folder_that_cannot_be_written_to_is_refused(self):
        self.write("file", "in the way")
        self.assert_stderr("cannot make", "picture", SURFACE, "-o", "out", "-o", os.path.join("file", "a.png"))
        self.assertFalse(os.path.exists(self.path("out/flat.vtp")))

    def test_a_folder_in_its_place_is_refused_before_anything_is_written(self):
        os.mkdir(self.path("a.png"))
        self.assert_stderr("--output", "picture", SURFACE, "-o", "out", "-o", "a.png")
        self.assertEqual(os.listdir(self.folder), ["a.png"])

    def test_the_sewn_surface_is_drawn_over_its_design_by_its_distance(self):
        self.assertEqual(self.run_command("sew", SURFACE, CURVES, "--once", "-o", "out").returncode, 0)
        plain, sewn = (self.draw(color + ".png", "--color", color, source=["out"]) for color in ("area", "distance"))
        middle = plain.shape[1] // 2
        changed = (plain[200:] != sewn[200:]).any(axis=2)
        for side in (changed[:, :middle], changed[:, middle:]):
            self.assertGreater(side.mean(), 0.1)

    def test_colorings_need_what_they_show(self):
        for coloring, remedy in (("distance", "wirewarp sew"), ("stretch", "--material"), ("shear", "--material")):
            self.assert_stderr(remedy, "picture", SURFACE, "-o", "a.png", "--color", coloring)
            self.assertEqual(os.listdir(self.folder), [])

    def test_other_endings_and_colorings_are_bad_usage(self):
        for arguments in (("-o", "a.pdf"), ("-o", "a.png", "--color", "taste")):
            self.assert_stderr(arguments[-1], "picture", SURFACE, *arguments, code=2)


if __name__ == "__main__":
    command.main()
