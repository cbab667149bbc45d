# SPDX-License-Identifier: BSD-3-Clause
"""Plots as SVG, without any package: lines on logarithmic axes, panels of lines, and stacked bars."""

import math
from xml.sax.saxutils import escape

# Okabe and Ito's colors, which color-blind readers tell apart.
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
MARGIN = 16
SIZE = 13  # of the words


class Canvas:
    def __init__(self, width, height):
        self.width, self.height, self.items = width, height, []

    def add(self, item):
        self.items.append(item)

    def line(self, x0, y0, x1, y1, color, width=1.0):
        self.add(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" '
                 f'stroke="{color}" stroke-width="{width}"/>')

    def text(self, x, y, words, anchor="start", color="#222", turned=False):
        turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turned else ""
        self.add(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}"{turn}>'
                 f"{escape(words)}</text>")

    def box(self, x, y, width, height, color):
        self.add(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" '
                 f'fill="{color}"/>')

    def document(self):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                f'width="{self.width}" height="{self.height}" font-family="sans-serif" '
                f'font-size="{SIZE}">')
        return "\n".join([head, f'<rect width="{self.width}" height="{self.height}" fill="white"/>',
                          *self.items, "</svg>\n"])


def log_log(series, across, up, label):
    """Series are (name, [(x, y), ...]). Ticks stand at powers of ten; `label` writes those of y."""
    canvas = Canvas(800, 480)
    left, right, top, bottom = 84, 480, MARGIN, 430
    values = [[math.log10(point[k]) for _, points in series for point in points] for k in (0, 1)]
    low = [math.floor(min(v)) for v in values]
    high = [math.ceil(max(v)) for v in values]

    def place(x, y):
        return (left + (math.log10(x) - low[0]) / (high[0] - low[0]) * (right - left),
                bottom - (math.log10(y) - low[1]) / (high[1] - low[1]) * (bottom - top))

    for power in range(low[0], high[0] + 1):
        x, _ = place(10.0**power, 10.0**low[1])
        canvas.line(x, top, x, bottom, "#ddd")
        canvas.text(x, bottom + 18, f"{10**power:,}", "middle")
    for power in range(low[1], high[1] + 1):
        _, y = place(10.0**low[0], 10.0**power)
        canvas.line(left, y, right, y, "#ddd")
        canvas.text(left - 8, y + 4, label(10.0**power), "end")
    canvas.text((left + right) / 2, bottom + 40, across, "middle")
    canvas.text(MARGIN + 4, (top + bottom) / 2, up, "middle", turned=True)
    for k, (name, points) in enumerate(series):
        color = COLORS[k % len(COLORS)]
        places = [place(*point) for point in points]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        canvas.add(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        for x, y in places:
            canvas.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>')
        y = top + 20 + 24 * k
        canvas.line(right + 16, y - 4, right + 40, y - 4, color, 2)
        canvas.text(right + 48, y, name)
    return canvas.document()


def panels(titles, names, rows, across):
    """Small plots, a row of them for each of `rows`, (what is plotted, [series of each panel]); a series is
    a list of (x, y) for each of `names`, a single point a mark. All start at 0; a row has one scale of y."""
    width, height, gap, left, top = 150, 130, 14, 74, 64
    canvas = Canvas(left + (width + gap) * len(titles) + MARGIN, top + (height + gap + 20) * len(rows) + 30)
    for k, name in enumerate(names):
        x = left + 230 * k
        canvas.box(x, MARGIN - 4, 14, 14, COLORS[k])
        canvas.text(x + 20, MARGIN + 8, name)
    most_x = [max(x for _, panel in rows for series in panel[c] for x, _ in series) for c in range(len(titles))]
    for r, (what, panel) in enumerate(rows):
        bottom = top + height + (height + gap + 20) * r
        most = max(y for series in panel for points in series for _, y in points)
        step = 10.0**math.floor(math.log10(most))
        step *= next(f for f in (0.2, 0.5, 1.0, 2.0) if most / (step * f) <= 5)
        canvas.text(MARGIN, bottom - height / 2, what, "middle", turned=True)
        for c, title in enumerate(titles):
            x0 = left + (width + gap) * c

            def place(x, y):
                return x0 + 0.94 * width * x / most_x[c], bottom - 0.94 * height * y / most

            for k in range(math.floor(most / step) + 1):
                _, y = place(0, k * step)
                canvas.line(x0, y, x0 + width, y, "#ddd")
                if c == 0:
                    canvas.text(x0 - 6, y + 4, f"{k * step:g}", "end")
            for x in range(math.floor(most_x[c]) + 1):
                canvas.line(place(x, 0)[0], bottom, place(x, 0)[0], bottom + 4, "#888")
                canvas.text(place(x, 0)[0], bottom + 18, f"{x}", "middle")
            if r == 0:
                canvas.text(x0 + width / 2, bottom - height - 8, title, "middle")
            for k, points in enumerate(panel[c]):
                places = [place(*point) for point in points]
                path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
                canvas.add(f'<polyline points="{path}" fill="none" stroke="{COLORS[k]}" stroke-width="2"/>')
                for x, y in places:
                    size = 5 if len(places) == 1 else 3
                    canvas.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size}" fill="{COLORS[k]}"/>')
    canvas.text(left + (width + gap) * len(titles) / 2, canvas.height - 8, across, "middle")
    return canvas.document()
