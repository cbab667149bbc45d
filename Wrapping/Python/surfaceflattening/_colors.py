# SPDX-License-Identifier: BSD-3-Clause
"""The colours of pictures."""

import colorsys
from typing import Dict, List

# By the type of a wire, as in the paper.
WIRE_COLORS: Dict[str, str] = {
    "boundary": "#000000", "connector": "#808080", "accessory": "#00991a", "key": "#d90000",
    "dart": "#0033e6", "seam": "#9900bf"}
PLAIN = "#e6e6de"


def blue_to_red(count: int) -> List[str]:
    """Colours in steps of their hue, light enough for black lines on them."""
    result = []
    for step in range(count):
        hue = 2 / 3 * (1 - step / max(count - 1, 1))
        red, green, blue = colorsys.hsv_to_rgb(hue, 0.6, 1.0)
        result.append(f"#{round(255 * red):02x}{round(255 * green):02x}{round(255 * blue):02x}")
    return result


def homogeneity_colors(count: int) -> List[str]:
    """From red at 0.5 to blue at 1, the ideal."""
    return blue_to_red(count)[::-1]


IDEAL = blue_to_red(2)[0]
