# SPDX-License-Identifier: BSD-3-Clause
"""The PDF as poppler sees it: page sizes, texts, and distances counted in pixels."""

import re
import unittest

import pattern_files as pattern

# 254 dots an inch are 10 pixels a millimetre.
RESOLUTION = 254
PAPERS = {"A4": (210.0, 297.0), "letter": (215.9, 279.4), "A0": (841.0, 1189.0)}
OVERLAP = 10.0
MARGIN = 10.0


def page_sizes(path):
    text = pattern.run_tool("pdfinfo", "-f", "1", "-l", "1000", path).decode()
    sizes = re.findall(r"Page +\d+ size: +([\d.]+) x ([\d.]+) pts", text)
    return [(float(w) * 25.4 / 72.0, float(h) * 25.4 / 72.0) for w, h in sizes]


def page_texts(path):
    return pattern.run_tool("pdftotext", "-layout", path, "-").decode().split("\f")[:-1]


def word_boxes(path):
    return pattern.run_tool("pdftotext", "-bbox", path, "-").decode()


class Pages(pattern.PatternTest):
    def test_the_test_rectangle_measures_100_by_50_mm_on_every_paper(self):
        for paper in ("A4", "letter", "A0", "sheet"):
            with self.subTest(paper):
                self.make("quarter_sphere", "-o", "out/pattern.pdf", "--paper", paper)
                page = pattern.render(self.path("out", "pattern.pdf"), RESOLUTION, 1, 1)[0]
                # Scan where the rectangle must be: its inside is crossed away from its texts.
                left = self.first_line(page)
                columns = pattern.darkest_columns(page, left[1] + 60)
                self.assertAlmostEqual(columns[1] - columns[0], 1000.0, delta=1.0)
                rows = pattern.darkest_rows(page, left[0] + 40)
                self.assertAlmostEqual(rows[1] - rows[0], 500.0, delta=1.0)

    def first_line(self, page):
        """Upper left corner of the rectangle: the first dark pixel of the legend's height."""
        width, height, pixels = page
        for row in range(int(10 * MARGIN) - 5, height):
            line = pixels[row * width : (row + 1) * width]
            dark = [column for column, value in enumerate(line) if value < 100]
            if len(dark) > 900:
                return dark[0], row
        raise AssertionError("there is no rectangle")

    def test_pages_have_the_size_of_their_paper_and_lie_one_way(self):
        for paper, (width, height) in PAPERS.items():
            with self.subTest(paper):
                self.make("shirt_front", "-o", "out/pattern.pdf", "--paper", paper)
                sizes = page_sizes(self.path("out", "pattern.pdf"))
                self.assertEqual(len(set(sizes)), 1)
                self.assertEqual(sorted(round(size, 1) for size in sizes[0]), [width, height])

    def test_pages_bear_rows_columns_count_and_neighbours(self):
        self.make("shirt_front", "-o", "out/pattern.pdf", "--name", "front", "--size", "38", "--quantity", "2")
        texts = page_texts(self.path("out", "pattern.pdf"))
        names = []
        for number, text in enumerate(texts, 1):
            row, column = re.search(
                rf"row ([A-Z]+), column (\d+), page {number} of {len(texts)}\b", text).groups()
            self.assertIn(f"{row}{column}", text.split())
            names.append((ord(row) - ord("A"), int(column) - 1))
        self.assertGreater(len(names), 4)
        self.assertEqual(names, sorted(set(names)))
        for (row, column), text in zip(names, texts):
            for other in ((row + 1, column), (row - 1, column), (row, column + 1)):
                said = f"to {chr(ord('A') + other[0])}{other[1] + 1}"
                self.assertEqual(said in re.sub(r"\s+", " ", text), other in names, (row, column))
        everything = " ".join(texts)
        self.assert_words(("100 mm x 50 mm", "Scale 1:1", "Unit of the surface: cm", "size 38", "cut 2", "piece 1 of 1", "A4"),
                          everything)

    def test_joined_pages_give_the_same_drawing_as_one_large_page(self):
        """Lays the pages on each other as their labels say and compares pixel by pixel."""
        self.make("shirt_front", "-o", "out/pattern.pdf")
        path = self.path("out", "pattern.pdf")
        texts = page_texts(path)
        resolution = 50.8  # 2 pixels a millimetre
        pages = pattern.render(path, resolution, gray=False)
        width, height = page_sizes(path)[0]
        step = (width - 2 * MARGIN - OVERLAP, height - 2 * MARGIN - OVERLAP)
        ink = set()
        shared = 0
        for text, page in zip(texts, pages):
            row, column = re.search(r"row ([A-Z]+), column (\d+)", text).groups()
            left, top = (round(2 * (place * size - MARGIN)) for place, size in zip((int(column) - 1, ord(row) - ord("A")), step))
            mine = {(x + left, y + top) for x, y in self.dark_pixels(page, with_mixed=True)}
            shared += len(mine & ink)
            ink |= mine
        self.assertGreater(shared, 100)  # the bands that pages share show the same lines

        self.make("shirt_front", "-o", "out/pattern.pdf", "--paper", "sheet")
        (sheet,) = pattern.render(path, resolution, gray=False)
        whole = set(self.dark_pixels(sheet))
        # Both drawings have one piece below a legend; its lower half a metre is compared.
        joined_corner = self.lower_left(ink)
        whole_corner = self.lower_left(whole)
        shift = (whole_corner[0] - joined_corner[0], whole_corner[1] - joined_corner[1])
        moved = {(x + shift[0], y + shift[1]) for x, y in ink}
        # Texts move onto whole pages.
        words = [[resolution / 72 * float(side) for side in box] for box in re.findall(
            r'xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)"', word_boxes(path))]
        piece = {(x, y) for x, y in whole if y > whole_corner[1] - 1000
                 and not any(a - 2 < x < c + 2 and b - 2 < y < d + 2 for a, b, c, d in words)}
        missing = [p for p in piece if not self.near(p, moved)]
        self.assertGreater(len(piece), 3000)
        self.assertLess(len(missing), 0.01 * len(piece))

    def test_each_layer_can_be_hidden_and_together_they_are_the_drawing(self):
        self.make("tshirt", "-o", "out/pattern.pdf", "-o", "out/pattern.svg", "--paper", "sheet")
        path = self.path("out", "pattern.pdf")
        content = self.content("pattern.pdf")
        groups = dict(re.findall(rb"(?s)\n(\d+) 0 obj\n<< /Name \(([^)]*)\) /Type /OCG >>", content))
        roles = {element.get(pattern.INKSCAPE + "label") for element in self.svg().iter() if element.get("class")}
        self.assertEqual({name.decode() for name in groups.values()}, roles | {"page marks"})
        ((shown, listed),) = re.findall(rb"(/ON \[ ([^]]*))\]", content)
        self.assertEqual(re.findall(rb"(\d+) 0 R", listed), sorted(groups, key=int))

        def without(numbers):
            """The ink where some layers are hidden; no byte of the file moves."""
            hidden = b"".join(b"%s 0 R " % number for number in numbers)
            with open(path, "wb") as file:
                file.write(content.replace(shown, (b"/OFF[ " + hidden).ljust(len(shown))))
            ((_, _, pixels),) = pattern.render(path, 50.8)
            return {at for at, value in enumerate(pixels) if value < 255}

        whole = without([])
        self.assertEqual(without(groups), set())
        together = set()
        for number, name in groups.items():
            alone = without(set(groups) - {number})
            self.assertGreater(len(alone), 20, name)
            self.assertLess(len(alone), 0.7 * len(whole), name)
            together |= alone
        self.assertEqual(together, whole)

    def dark_pixels(self, page, with_mixed=False):
        """Pixels of black lines; crosses and trim lines are colored, frames grey."""
        width, height, pixels = page
        margin = round(2 * MARGIN) + 1  # labels stand in the margin
        for y in range(margin, height - margin):
            for x in range(margin, width - margin):
                at = 3 * (y * width + x)
                pixel = pixels[at : at + 3]
                # A thin line on two pixels darkens each by a quarter.
                dark = max(pixel) < 200 and max(pixel) - min(pixel) < 40
                # Black half a pixel beside the red of a key curve.
                mixed = min(pixel) < 150 and pixel[0] == max(pixel) and pixel[0] < 230
                if dark or (with_mixed and mixed):
                    yield x, y

    def lower_left(self, pixels):
        bottom = max(y for _, y in pixels)
        return min(x for x, y in pixels if y > bottom - 1000), bottom

    def near(self, pixel, others):
        x, y = pixel
        return any((x + i, y + j) in others for i in range(-2, 3) for j in range(-2, 3))

    def test_a_small_pattern_is_one_page_without_joints(self):
        self.make("quarter_sphere", "-o", "out/pattern.pdf")
        path = self.path("out", "pattern.pdf")
        (text,) = page_texts(path)
        self.assertNotIn("row", text)
        self.assertNotIn("to A2", text)


if __name__ == "__main__":
    unittest.main()
