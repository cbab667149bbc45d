// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/KeyReleasing.h"

namespace flattening
{
/// The isometric scheme from where FlatteningOptions::start has the piece. No value where there is
/// no such start, where anything but lengths holds the wires (key or elastic curves, connectors, a
/// cloth), and where start or solution fold a triangle or it comes to no minimum.
std::optional<PlacedWires> warpFromGivenStart(const PieceContext& context, const CurveRules& rules);
}
