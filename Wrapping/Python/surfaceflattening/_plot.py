# SPDX-License-Identifier: BSD-3-Clause
"""Results drawn with matplotlib, which nothing else needs."""

from typing import TYPE_CHECKING, Any, Optional, get_args

import numpy as np

from ._colors import PLAIN, WIRE_COLORS
from ._errors import ArgumentError
from ._options import word_of
from ._types import Coloring

if TYPE_CHECKING:
    from ._result import Flattening

# Array, whether of points, title, values of the first and the last color, as wirewarp picture has them (of the
# developability the largest value), and the color map: a uniform one, light where nothing is changed, or of values
# to both sides of that a diverging one.
_COLORINGS = {
    "homogeneity": ("HomogeneityOfDistortion", False, "homogeneity (1 is ideal)", 0.5, 1.0, "viridis"),
    "aspect-ratio": ("AspectRatio", False, "aspect ratio (1 is ideal)", 0.5, 1.0, "viridis"),
    "area": ("AreaRatio", False, "area in the plane / on the surface", 0.8, 1.2, "coolwarm"),
    "stretch": ("DominantStretch", False, "largest stretch of warp, weft or bias (%)", 100.0, 120.0, "viridis_r"),
    "warp": ("StrainWarp", False, "strain of the warp (drawn above 0)", -0.05, 0.05, "coolwarm"),
    "weft": ("StrainWeft", False, "strain of the weft (drawn above 0)", -0.05, 0.05, "coolwarm"),
    "shear": ("ShearAngle", False, "shear: trellis angle off the right one (degrees)", -15.0, 15.0, "coolwarm"),
    "developability": ("Developability", True, "developability: angle defect (rad)", 0.0, None, "viridis_r"),
}


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("plot() needs matplotlib; install it, on Debian the package "
                          f"python3-matplotlib ({error})") from None
    return pyplot


def _draw_triangles(result: "Flattening", color_by: Optional[Coloring], ax: Any) -> None:
    from matplotlib import pyplot
    from matplotlib.colors import ListedColormap
    x, y = result.positions.T
    if color_by is None:
        ax.tripcolor(x, y, result.triangles, facecolors=np.zeros(len(result.triangles)),
                     cmap=ListedColormap([PLAIN]))
        return
    name, of_points, title, first, last, colors = _COLORINGS[color_by]
    arrays = result.point_arrays if of_points else result.cell_arrays
    if name not in arrays:
        raise ArgumentError(f"color_by is {color_by!r}, which a result without a material does not have")
    values = arrays[name]
    if last is None:
        last = max(float(values.max(initial=0.0)), 1e-3)
    if color_by == "shear":
        cloth = result.report["pieces"][0]["cloth"]
        last = cloth["shear_limit"] if cloth and cloth["shear_limit"] else last
        first = -last
    steps = pyplot.get_cmap(colors, 8 if color_by == "stretch" else 256)
    options = {"cmap": steps, "vmin": first, "vmax": last}
    if of_points:
        drawn = ax.tripcolor(x, y, result.triangles, values, shading="gouraud", **options)
    else:
        drawn = ax.tripcolor(x, y, result.triangles, facecolors=values, **options)
    ax.figure.colorbar(drawn, ax=ax, label=title, shrink=0.8)


def _draw_wires(result: "Flattening", ax: Any) -> None:
    from matplotlib.collections import LineCollection
    for kind, color in WIRE_COLORS.items():
        lines = [result.positions[wire.vertices] for wire in result.wires if wire.type == kind]
        if lines:
            thin = kind == "connector"
            ax.add_collection(LineCollection(
                lines, colors=color, linewidths=0.6 if thin else 1.4, label=kind,
                linestyles="dotted" if thin else "solid"))
    ax.legend(loc="upper left", bbox_to_anchor=(0.0, -0.02), ncol=6, frameon=False, fontsize="small")


def _write_measures(result: "Flattening", ax: Any) -> None:
    for piece in result.report["pieces"]:
        rows = result.cell_arrays["PieceId"] == piece["piece"]
        corners = result.positions[result.triangles[rows]].reshape(-1, 2)
        ax.annotate(str(piece["piece"] + 1), (corners.min(axis=0) + corners.max(axis=0)) / 2,
                    ha="center", va="center", fontsize="large", fontweight="bold")
    lines = [
        f"piece {piece['piece'] + 1}: {piece['status']}, length error <= {piece['E_len_max']:.1e}, E_ang "
        f"{piece['E_ang']:.4f}, E_h {piece['E_h']:.3f}, E_area {piece['E_area']:.4f}, strain "
        f"{piece['strain_p95']:.4f}" for piece in result.report["pieces"]]
    ax.text(0.0, -0.1, "\n".join(lines), transform=ax.transAxes, va="top", fontsize="small",
            family="monospace")


def plot(result: "Flattening", color_by: Optional[Coloring], ax: Any, measures: bool) -> Any:
    """Draws pieces, wires and measures; the axes."""
    if color_by is not None:
        color_by = word_of(color_by, get_args(Coloring), "color_by")
    pyplot = _pyplot()
    if ax is None:
        _, ax = pyplot.subplots(figsize=(9, 7), layout="constrained")
    _draw_triangles(result, color_by, ax)
    _draw_wires(result, ax)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.set_axis_off()
    if measures:
        _write_measures(result, ax)
    return ax
