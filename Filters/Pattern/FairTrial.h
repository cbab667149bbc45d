// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FairNetwork.h"

namespace flattening
{
namespace pattern
{
/// Joins the cubic curves of the spline of one stretch, between nodes that stay where they are.
class FairTrial
{
public:
  /// \param network of which it is one of the stretches \param nodes where they are
  /// \param tolerances of its points, those of its ends among them
  FairTrial(const FairNetwork& network, std::size_t stretch, const Points2& nodes,
    std::vector<double> tolerances, double wave);

  /// Takes away each break without which the tolerances are kept as well, and puts one in the
  /// middle of two. \return whether any was
  bool join(std::size_t leastSpans);

  const std::vector<double>& breaks() const { return this->stretch().breaks; }
  /// Of all points.
  const std::vector<double>& weights() const { return this->Weights; }

private:
  const FairStretch& stretch() const { return this->One.stretches.front(); }
  FairStretch& stretch() { return this->One.stretches.front(); }
  /// Whether there is a spline with the breaks as they are that keeps the tolerances.
  bool fits();
  bool take(const std::vector<double>& breaks);

  FairNetwork One;
  std::vector<double> Tolerances;
  double Wave;
  std::vector<double> Weights;
  int Left; ///< solutions that may still be tried
};
}
}
