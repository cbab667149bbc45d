// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tells ParaView the colors and ranges in which it shows HomogeneityOfDistortion, WireKind and
/// what threads do, as long as the user chooses no others, adds the presets of color_presets.json
/// and makes the representation known that keeps the ranges in scripts. ParaView calls it when it
/// loads the plugin.
void setDefaultColors();
