// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

#include <memory>

namespace flattening
{
namespace pattern
{
/// The smooth borders of one flattening, which are found once for all of its files.
class FairCache
{
public:
  /// Those of a source, found anew only where it, or what of its options they depend on, is another
  /// one than last time.
  std::shared_ptr<const FairBorders> of(const DrawingSource& all);

private:
  /// What smooth borders depend on.
  struct Cause
  {
    PatternSource source;
    Unit unit = Unit::Centimetre;
    double tolerance = 0.0;
    std::map<std::string, double> toleranceOfCurve;
    bool symmetrize = false;
    std::vector<NotchPlace> notches;
  };
  static bool same(const Cause& cause, const DrawingSource& all);

  Cause Last;
  std::shared_ptr<const FairBorders> Borders;
};

/// The smooth borders of a source, where its options ask for any; they are then what it is drawn
/// with as long as they are kept.
/// \param cache where they may be already, or null
std::shared_ptr<const FairBorders> drawFair(DrawingSource& all, FairCache* cache);
}
}
