// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Darts.h"
#include "Notches.h"
#include "Pattern.h"
#include "PlaneGeometry.h"

namespace flattening
{
namespace pattern
{
/// What the drawing of each piece needs to know of the whole flattening.
struct DrawingSource
{
  const PatternSource& source;
  const PatternOptions& options;
  PieceLoops loops;
  SewnPartners partners;
  WireOfEdge wires;
  std::vector<NotchPlace> notches;

  double scale() const { return millimetresPer(this->options.unit); }
  Point2 at(Index point) const { return this->scale() * this->source.positions[point]; }
};
}
}
