# SPDX-License-Identifier: BSD-3-Clause
"""Results as notebooks show them: the flat pieces as SVG, and a table of their measures."""

from html import escape
from typing import TYPE_CHECKING, Any, List, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._colors import HOMOGENEITY_COLORS, PLAIN, WIRE_COLORS

if TYPE_CHECKING:
    from ._result import Flattening
    from ._suggestion import Suggestion

_WIDTH, _HEIGHT = 640.0, 400.0
# Beyond, a notebook would carry megabytes: the pieces are drawn in one color.
_MOST_COLORED = 6000
_COLUMNS: Tuple[Tuple[str, str, str], ...] = (
    ("status", "status", ""), ("triangles", "triangles", "d"),
    ("E_len_max", "largest length error", ".1e"), ("E_ang", "E_ang", ".4f"), ("E_h", "E_h", ".3f"),
    ("E_area", "E_area", ".4f"), ("strain_p95", "strain, 95 % below", ".4f"))
# Of what is proposed.
_CUT_COLUMNS: Tuple[Tuple[str, str, str], ...] = (
    ("length", "length", ".6g"), ("opening", "opening", ".4g"), ("gain", "gain", ".3g"),
    ("strain_before", "strain before", ".4f"), ("strain_after", "after", ".4f"),
    ("E_area_before", "E_area before", ".4f"), ("E_area_after", "after", ".4f"))


def _on_screen(positions: NDArray[np.float64]) -> Tuple[NDArray[np.float64], float, float]:
    """Positions in a picture with y downwards, its width and height."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    extent = high - low
    scale = min(_WIDTH / max(extent[0], 1e-300), _HEIGHT / max(extent[1], 1e-300))
    placed = (positions - low) * scale
    placed[:, 1] = extent[1] * scale - placed[:, 1]
    return placed, float(extent[0] * scale), float(extent[1] * scale)


def _path(points: NDArray[np.float64], close: bool) -> str:
    steps = "L".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f"M{steps}Z" if close else f"M{steps}"


def _triangles(result: "Flattening", placed: NDArray[np.float64]) -> List[str]:
    colored = len(result.triangles) <= _MOST_COLORED
    values = result.cell_arrays.get("HomogeneityOfDistortion")
    if values is None or not colored:
        groups: Any = [(PLAIN, np.arange(len(result.triangles)))]
    else:
        last = len(HOMOGENEITY_COLORS) - 1
        steps = np.clip(np.round((values - 0.5) / 0.5 * last), 0, last).astype(int)
        groups = [(color, np.flatnonzero(steps == step)) for step, color in enumerate(HOMOGENEITY_COLORS)]
    lines = []
    for color, rows in groups:
        if len(rows):
            outline = "".join(_path(placed[corners], True) for corners in result.triangles[rows])
            lines.append(f'<path d="{outline}" fill="{color}" stroke="{color}" stroke-width="0.5"/>')
    return lines


def _numbers(result: "Flattening", placed: NDArray[np.float64]) -> List[str]:
    """The number of each piece, by which it is found in the table and on the pattern; they count from 1."""
    texts = []
    for piece in result.report["pieces"]:
        rows = result.cell_arrays["PieceId"] == piece["piece"]
        corners = placed[result.triangles[rows]].reshape(-1, 2)
        x, y = (corners.min(axis=0) + corners.max(axis=0)) / 2
        texts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-family="sans-serif" font-size="14" '
                     f'font-weight="bold" text-anchor="middle" dominant-baseline="central">'
                     f'{piece["piece"] + 1}</text>')
    return texts


def _svg(result: "Flattening") -> str:
    placed, width, height = _on_screen(result.positions)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 8:.0f}" '
             f'height="{height + 8:.0f}" viewBox="-4 -4 {width + 8:.1f} {height + 8:.1f}">']
    lines += _triangles(result, placed)
    for wire in result.wires:
        stroke = 'stroke-width="0.7" stroke-dasharray="2"' if wire.type == "connector" else 'stroke-width="1.5"'
        lines.append(f'<path d="{_path(placed[wire.vertices], False)}" fill="none" '
                     f'stroke="{WIRE_COLORS[wire.type]}" {stroke}>'
                     f"<title>{escape(wire.name)} ({wire.type})</title></path>")
    return "".join([*lines, *_numbers(result, placed), "</svg>"])


def _rows(titles: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    head = "".join(f"<th>{title}</th>" for title in titles)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _table(result: "Flattening") -> str:
    pieces: Any = result.report["pieces"]
    return _rows(["piece", *(title for _, title, _ in _COLUMNS)], [
        [str(piece["piece"] + 1), *(format(piece[key], form) for key, _, form in _COLUMNS)]
        for piece in pieces])


def to_html(result: "Flattening") -> str:
    """A picture and a table; where triangles are colored, yellow is ideal and dark half the area."""
    legend = (f'Triangles: <span style="background:{HOMOGENEITY_COLORS[-1]}">yellow</span>, the area kept, to '
              f'<span style="color:{HOMOGENEITY_COLORS[0]}">dark</span>, half or twice of it. ' if len(result.triangles) <= _MOST_COLORED else "")
    kinds = sorted({wire.type for wire in result.wires})
    legend += "Wires: " + ", ".join(
        f'<span style="color:{WIRE_COLORS[kind]}">{kind}</span>' for kind in kinds) + "."
    message = result.report["message"]
    said = f"<p><b>{escape(result.report['status'])}</b>: {escape(message)}</p>" if message else ""
    return f"<div>{_svg(result)}<p>{legend}</p>{said}{_table(result)}</div>"


def suggestion_to_html(suggestion: "Suggestion") -> str:
    """A table of what is proposed, and the flat pieces."""
    met = "The bound is met." if suggestion.bound_met else "The bound is not met."
    table = _rows(["name", "type", *(title for _, title, _ in _CUT_COLUMNS)], [
        [cut.curve.name, cut.curve.type,
         *("-" if np.isnan(getattr(cut, key)) else format(getattr(cut, key), form) for key, _, form in _CUT_COLUMNS)]
        for cut in suggestion.cuts]) if suggestion.cuts else "<p>Nothing is proposed.</p>"
    return f"<div>{table}<p>{met}</p>{to_html(suggestion.flattening)}</div>"
