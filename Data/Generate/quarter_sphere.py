"""The quarter-sphere: a 90 degree lune of the unit sphere, 4 longitude by 8 latitude steps."""
import numpy as np

from curves import ACCESSORY
from panel import Mesh, NamedCurve

LONGITUDES, LATITUDES = 4, 8


def vertex(i, j):
    """Id of longitude i, latitude j; the poles are the first and the last vertex."""
    if j == 0:
        return 0
    if j == LATITUDES:
        return 1 + (LATITUDES - 1) * (LONGITUDES + 1)
    return 1 + (j - 1) * (LONGITUDES + 1) + i


def make():
    points = [(-1.0, 0.0, 0.0)]
    for j in range(1, LATITUDES):
        beta = np.pi * (j / LATITUDES - 0.5)
        for i in range(LONGITUDES + 1):
            gamma = 0.5 * np.pi * i / LONGITUDES
            p = np.array([np.sin(beta), np.cos(beta) * np.sin(gamma), np.cos(beta) * np.cos(gamma)])
            p[np.abs(p) < 1e-15] = 0.0
            points.append(tuple(p))
    points.append((1.0, 0.0, 0.0))
    triangles = []
    for i in range(LONGITUDES):
        for j in range(LATITUDES):
            if j < LATITUDES - 1:
                triangles.append((vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)))
            if j > 0:
                triangles.append((vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)))
    half = LATITUDES // 2
    across = NamedCurve("cross_arc", ACCESSORY, [vertex(i, half) for i in range(LONGITUDES + 1)])
    along = NamedCurve(
        "long_arc", ACCESSORY, [vertex(LONGITUDES // 2, j) for j in range(LATITUDES + 1)]
    )
    mesh = Mesh(np.array(points), np.array(triangles), [across])
    return mesh, {"two": [across, along]}
