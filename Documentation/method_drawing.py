# SPDX-License-Identifier: BSD-3-Clause
"""The drawing of method.md: a wire-patch on the surface and in the plane, with the symbols of the equations."""

import math

import svg

INK, WIRE, ANGLE, DIRECTION = "#222", svg.COLORS[0], svg.COLORS[1], svg.COLORS[2]
# A wire-patch in the plane, anti-clockwise, and the wire inside that divides it from the next one.
PATCH = [(0, 0), (120, -18), (214, 30), (206, 142), (104, 176), (6, 120)]
NEXT = [(214, 30), (300, 8), (318, 128), (206, 142)]


def bent(x, y):
    """A place of the plane as it is drawn in space: a sheet that bends two ways, seen from the side."""
    height = 60 * math.sin(math.pi * (x + 20) / 360) * math.sin(math.pi * (y + 60) / 300)
    return 0.86 * x + 0.3 * y, 0.62 * y + height


def drawn(points, bend):
    """The sides of a polygon as one path of short lines."""
    path = []
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        path += [(x0 + k / 8 * (x1 - x0), y0 + k / 8 * (y1 - y0)) for k in range(8)]
    return [bent(*p) for p in path] if bend else path


class Panel:
    def __init__(self, canvas, left, bottom, bend):
        self.canvas, self.left, self.bottom, self.bend = canvas, left, bottom, bend

    def place(self, point):
        x, y = bent(*point) if self.bend else point
        return self.left + x, self.bottom - y

    def polygon(self, points, color):
        places = " ".join(f"{self.left + x:.1f},{self.bottom - y:.1f}" for x, y in drawn(points, self.bend))
        self.canvas.add(f'<polygon points="{places}" fill="{color}" stroke="{WIRE}" stroke-width="2"/>')

    def angle(self, before, at, after, words):
        """An arc inside the corner, with its name."""
        x, y = self.place(at)
        ends = []
        for other in (after, before):
            near = [a + 0.15 * (b - a) for a, b in zip(at, other)]
            u, v = (p - q for p, q in zip(self.place(near), (x, y)))
            ends.append((u / math.hypot(u, v), v / math.hypot(u, v)))
        (u0, v0), (u1, v1) = ends
        large = 1 if u0 * v1 - v0 * u1 > 0 else 0
        r = 20
        self.canvas.add(f'<path d="M{x + r * u0:.1f},{y + r * v0:.1f} A{r},{r} 0 {large} 0 {x + r * u1:.1f},{y + r * v1:.1f}" '
                        f'fill="none" stroke="{ANGLE}" stroke-width="1.5"/>')
        middle = (u0 + u1, v0 + v1)
        size = math.hypot(*middle)
        self.canvas.text(x + 34 * middle[0] / size, y + 34 * middle[1] / size + 4, words, "middle", ANGLE)

    def length(self, one, other, words, aside):
        x, y = self.place([(a + b) / 2 for a, b in zip(one, other)])
        self.canvas.text(x + aside[0], y + aside[1], words, "middle", WIRE)

    def nodes(self, points):
        for point in points:
            x, y = self.place(point)
            self.canvas.add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{INK}"/>')


def drawing():
    canvas = svg.Canvas(800, 330)
    for left, bend, title, name in ((30, True, "on the surface", "α"), (440, False, "in the plane", "θ")):
        panel = Panel(canvas, left, 240, bend)
        panel.polygon(NEXT, "#f2f2f2")
        panel.polygon(PATCH, "#e3eef6")
        for k, point in enumerate(PATCH):
            panel.angle(PATCH[k - 1], point, PATCH[(k + 1) % len(PATCH)], f"{name}{'₁₂₃₄₅₆'[k]}")
        panel.nodes(PATCH + NEXT[1:3])
        panel.length(PATCH[0], PATCH[1], "l₁", (0, 18))
        panel.length(PATCH[3], PATCH[4], "l₄", (4, -10))
        panel.length(PATCH[2], PATCH[3], "l₃", (12, 4))
        canvas.text(left + 150, 24, title, "middle", INK)
    x, y = panel.place(PATCH[1])
    canvas.line(x, y, x + 70, y, "#888")
    slope = math.atan2(PATCH[2][1] - PATCH[1][1], PATCH[2][0] - PATCH[1][0])
    canvas.add(f'<path d="M{x + 56:.1f},{y:.1f} A56,56 0 0 0 {x + 56 * math.cos(slope):.1f},{y - 56 * math.sin(slope):.1f}" '
               f'fill="none" stroke="{DIRECTION}" stroke-width="1.5"/>')
    canvas.text(x + 76, y - 10, "φ₂", "start", DIRECTION)
    canvas.text(30, 296, "Lengths l stay. Angles θ are chosen as near to α as a closed loop allows:", color=INK)
    canvas.text(30, 318, "Σ (π − θᵢ) = 2π,   Σ lᵢ cos φᵢ = 0,   Σ lᵢ sin φᵢ = 0,   φᵢ = φᵢ₋₁ + π − θᵢ", color=INK)
    return canvas.document()
