// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Embedding/InteriorSystem.h"
#include "Flattening/FlatteningOptions.h"
#include "Quality/AreaForecast.h"
#include "Surface/FeatureCurve.h"
#include "Wires/KeyCurveLocks.h"
#include "Wires/WireNetwork.h"

namespace flattening
{
/// What every step of a piece's way into the plane reads. It only refers to what it names.
struct PieceContext
{
  const Piece& piece;
  const WireNetwork& network;
  const CutSurface& cut;
  const std::vector<FeatureCurve>& curves;
  const FlatteningOptions& options;
  const Execution& execution;
  /// Factors of the interior that outlive the run; null where none do.
  InteriorSystems* interiors = nullptr;
  /// Whether the plane has room for the piece; null: not asked for.
  const AreaForecast* area = nullptr;

  bool deep() const { return this->area && (this->area->deep() || this->area->tube()); }
};
}
