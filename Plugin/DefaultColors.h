// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tells ParaView the colours in which it shows HomogeneityOfDistortion, WireKind and what threads
/// do, as long as the user chooses no others, and adds the presets of color_presets.json. ParaView
/// calls it when it loads the plugin.
void setDefaultColors();
