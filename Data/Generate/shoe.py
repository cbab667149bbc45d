"""The upper of a slip-on shoe: one piece round a last, open at the heel seam. Unit cm; z to the toe.

A section runs from the ridge, a point (0, z) high over the sole, down to the feather edge (the
sole's outline) as a quarter of an ellipse; sections fan out round toe and heel. Parameters: v along
half the outline from the toe's tip (0) to the heel (1), and the ellipse's angle w from the ridge (0) to
the feather edge (pi / 2).
"""
import numpy as np

from curves import ACCESSORY, KEY, Curve, bezier, line, naturalSpline
from panel import Panel
from torso import buildMirrored

# Feather edge x, z, and the z of the ridge point that belongs to it.
OUTLINE = (
    (0.0, 14.0, 10.2),
    (2.2, 13.2, 9.9),
    (3.9, 11.0, 9.0),
    (4.7, 7.4, 7.0),
    (4.5, 4.2, 4.3),
    (3.8, 0.0, 0.6),
    (3.4, -5.0, -4.2),
    (3.3, -9.0, -7.6),
    (2.4, -12.2, -9.0),
    (0.0, -13.4, -9.4),
)
# Height of the ridge over the sole by z.
RIDGE = (
    (-14.0, 11.6), (-9.0, 11.4), (-4.0, 10.6), (0.0, 9.0), (4.0, 6.7), (7.0, 5.4), (10.2, 4.8), (14.0, 4.6)
)
THROAT, TOP_AT_HEEL = 0.43, 0.92  # v of the throat on the ridge, w of the topline at the heel
HEEL = 0.99  # v of the heel seam: the two sides stay half a centimetre apart
BEND, ROCKER = 0.006, 0.006  # inward bend of the last and curvature of its sole, 1/cm
TRIANGLES = 1500


class Last:
    def __init__(self):
        x, z, ridge = np.array(OUTLINE).T
        # Mirror images of the neighbours make the outline cross the plane x = 0 at right angles.
        xx = np.concatenate([[-x[1]], x, [-x[-2]]])
        zz = np.concatenate([[z[1]], z, [z[-2]]])
        rr = np.concatenate([[ridge[1]], ridge, [ridge[-2]]])
        v = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(xx), np.diff(zz)))])
        v = (v - v[1]) / (v[-2] - v[1])
        self.x, self.z, self.ridge = (naturalSpline(v, value) for value in (xx, zz, rr))
        self.height = naturalSpline(*np.array(RIDGE).T)

    def __call__(self, q):
        v, w = q[:, 0], q[:, 1]
        x, ridge = self.x(v), self.ridge(v)
        z = ridge + (self.z(v) - ridge) * np.sin(w)
        return np.column_stack([x * np.sin(w), self.height(z) * np.cos(w), z])

    def chart(self, q):
        """Seen from above, with the walls folded outwards at their length."""
        v, w = q[:, 0], q[:, 1]
        dx, dz = self.x(v), self.z(v) - self.ridge(v)
        reach = np.hypot(dx, dz)
        node, weight = np.polynomial.legendre.leggauss(12)
        angle = 0.5 * w[:, None] * (node + 1)
        height = self.height(self.z(v))[:, None]
        speed = np.sqrt((reach[:, None] * np.cos(angle)) ** 2 + (height * np.sin(angle)) ** 2)
        length = 0.5 * w * (speed * weight).sum(1)
        return np.column_stack([self.ridge(v) + dz / reach * length, dx / reach * length])


def make():
    last = Last()
    quarter = 0.5 * np.pi
    centre = np.vstack([line((THROAT, 0), (0, 0), 400), line((0, 0), (0, quarter), 400)[1:]])
    outline = [
        Curve("front_centre", KEY, centre),
        Curve("feather", None, line((0, quarter), (HEEL, quarter), 600)),
        Curve("heel", None, line((HEEL, quarter), (HEEL, TOP_AT_HEEL))),
        Curve("topline", None, bezier((HEEL, TOP_AT_HEEL), (0.84, 1.18), (THROAT + 0.02, 0.9), (THROAT, 0))),
    ]
    across = lambda name, v: Curve(name, ACCESSORY, line((v, 0), (v, quarter), 400))
    curves = [across("toe_cap", 0.17), across("ball_girth", 0.30), across("waist", 0.52), across("counter", 0.80)]
    mesh = buildMirrored(Panel(last, outline, curves, TRIANGLES // 2, chart=last.chart), "front_centre")
    z = mesh.points[:, 2].copy()
    mesh.points[:, 0] += BEND * z * z
    mesh.points[:, 1] += ROCKER * (z - 3.0) ** 2
    return mesh, {}
