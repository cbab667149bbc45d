"""The torso as one smooth sheet that runs from the front hem over the shoulders to the back hem.

Chart coordinates (s, t): t follows the centre line, 0 on top of the shoulders, negative in front;
s is the length along the section from the centre line, positive to the wearer's left. Unit cm; x
to the left, y up, z to the front. A section is half an ellipse: half width a, from the side's z to
the centre line's z.
"""
from dataclasses import dataclass

import numpy as np

from curves import line, naturalSpline
from panel import build, mirrored


@dataclass(frozen=True)
class Bulge:
    """A pair of swellings at x = +-s and height y; negative depth swells the back."""

    s: float
    y: float
    depth: float
    widthS: float
    widthT: float


@dataclass(frozen=True)
class TorsoShape:
    """rows: y, z of the front's centre line, z of the back's, half width, z of the side; upwards,
    the last is the top. drop: fall of the shoulder from the neck outwards, and its reach in t."""

    rows: tuple
    bulges: tuple
    drop: float = 0.27
    reach: float = 12.0


GAUSS_X, GAUSS_W = np.polynomial.legendre.leggauss(12)


class Torso:
    def __init__(self, shape):
        self.shape = shape
        y, front, back, a, side = np.array(shape.rows).T
        # Front and back share one t for a height, so that their side seams are the same curve.
        step = 0.5 * (np.hypot(np.diff(y), np.diff(front)) + np.hypot(np.diff(y), np.diff(back)))
        t = np.concatenate([[0.0], np.cumsum(step)]) - step.sum()
        t = np.concatenate([t, -t[-2::-1]])
        wrap = lambda v: np.concatenate([v, v[-2::-1]])
        self.y, self.centre = naturalSpline(t, wrap(y)), naturalSpline(
            t, np.concatenate([front, back[-2::-1]])
        )
        self.a, self.side = naturalSpline(t, wrap(a)), naturalSpline(t, wrap(side))
        self.table = np.linspace(t[0], t[-1], 4001)
        self.heights = self.y(self.table)

    def front(self, y):
        """t of the front's centre line at height y."""
        lower = self.table < 0
        return float(np.interp(y, self.heights[lower], self.table[lower]))

    def back(self, y):
        upper = self.table > 0
        return float(np.interp(y, self.heights[upper][::-1], self.table[upper][::-1]))

    def arc(self, phi, a, b):
        """Length of the ellipse (a sin, b cos) from 0 to phi, by Gauss-Legendre."""
        angle = 0.5 * phi[:, None] * (GAUSS_X + 1)
        speed = np.sqrt((a[:, None] * np.cos(angle)) ** 2 + (b[:, None] * np.sin(angle)) ** 2)
        return 0.5 * phi * (speed * GAUSS_W).sum(1)

    def sideSeam(self, t):
        """Chart points of the side at the given t."""
        t = np.asarray(t, float)
        a, b = self.a(t), np.abs(self.centre(t) - self.side(t))
        return np.column_stack([self.arc(np.full_like(t, 0.5 * np.pi), a, b), t])

    def __call__(self, q):
        s, t = q[:, 0], q[:, 1]
        a, depth = self.a(t), self.centre(t) - self.side(t)
        b = np.abs(depth)
        phi = s / a
        for _ in range(30):
            speed = np.sqrt((a * np.cos(phi)) ** 2 + (b * np.sin(phi)) ** 2)
            step = np.clip((s - self.arc(phi, a, b)) / np.maximum(speed, 0.3 * a), -0.3, 0.3)
            phi = phi + step
            if np.abs(step).max() < 1e-14:
                break
        x = a * np.sin(phi)
        z = self.side(t) + depth * np.cos(phi)
        y = self.y(t) - self.shape.drop * x * x / (np.abs(x) + 6) * np.exp(-((t / self.shape.reach) ** 2))
        for bulge in self.shape.bulges:
            t0 = self.front(bulge.y) if bulge.depth > 0 else self.back(bulge.y)
            for sign in (1.0, -1.0):
                d2 = ((s - sign * bulge.s) / bulge.widthS) ** 2 + ((t - t0) / bulge.widthT) ** 2
                swell = bulge.depth * np.exp(-0.5 * d2) * np.cos(phi)  # nothing at the side
                z = z + swell
                x = x + 0.35 * sign * np.abs(swell)
        return np.column_stack([x, y, z])


def through(points, count=200):
    """A smooth curve through chart points whose t is monotone."""
    s, t = np.array(points).T
    order = np.argsort(t)
    spline = naturalSpline(t[order], s[order])
    tt = np.linspace(t[0], t[-1], count)
    return np.column_stack([spline(tt), tt])


def level(t, s0=0.0, s1=45.0):
    """A girth: constant t, from the centre line to beyond the side."""
    return line((s0, t), (s1, t), 400)


def buildMirrored(panel, centreName):
    """Build the half s >= 0 and mirror it; the curve of that name is the centre line."""
    mesh, _ = build(panel)
    centre = next(c.vertices for c in mesh.curves if c.name == centreName)
    return mirrored(mesh, centre)
