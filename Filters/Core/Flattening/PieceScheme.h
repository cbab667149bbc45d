// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/KeyReleasing.h"

namespace flattening
{
/// A piece flattened by a scheme, as its cuts are.
struct FlatWires
{
  WireSolution wires;
  PlacedPiece placed;
  Status status; ///< of the whole way
  double secondsWires = 0.0;
  double secondsInterior = 0.0;
};

/// By the scheme of the options. Keys that clash are released.
FlatWires flattenWires(const PieceContext& context, const CurveRules& rules);

/// The same for wires that are placed already.
FlatWires finishScheme(const PieceContext& context, PlacedWires placed);
}
