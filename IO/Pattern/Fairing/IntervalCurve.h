// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairPlan.h"
#include "Outlines/FairSpan.h"

namespace flattening
{
namespace pattern
{
constexpr double sameBreak = 1e-7; ///< of an interval

/// The smooth curve of an interval, measured along itself.
class IntervalCurve
{
public:
  /// \param spans of the chain
  IntervalCurve(const std::vector<FairSpan>& spans, const PlannedInterval& interval);

  double length() const { return this->Length; }
  /// Where it is divided, as shares of its length. \param fromEnd the shares are those from its end
  std::vector<double> breaks(bool fromEnd) const;
  /// The place along the chain at a share of the length.
  double placeAt(double share) const;

private:
  double Start = 0.0;
  double End = 0.0;
  double Length = 0.0;
  std::vector<FairSpan> Parts;
};
}
}
