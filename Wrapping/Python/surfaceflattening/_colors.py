# SPDX-License-Identifier: BSD-3-Clause
"""The colors of pictures."""

from typing import Dict

# By the type of a wire, as in the paper.
WIRE_COLORS: Dict[str, str] = {
    "boundary": "#000000", "connector": "#808080", "accessory": "#00991a", "key": "#d90000",
    "dart": "#0033e6", "seam": "#9900bf"}
PLAIN = "#e6e6de"
# Viridis, whose lightness rises evenly: from dark at a homogeneity of 0.5 to light at 1, the ideal.
HOMOGENEITY_COLORS = (
    "#440154", "#482173", "#433e85", "#38588c", "#2d708e", "#25858e", "#1e9b8a", "#2ab07f", "#52c569", "#86d549",
    "#c2df23", "#fde725")
