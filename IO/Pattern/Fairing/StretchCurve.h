// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/CubicBasis.h"
#include "Fairing/FairNetwork.h"

namespace flattening
{
namespace pattern
{
/// A linear combination of unknown points.
struct Term
{
  Eigen::Index unknown = 0;
  double factor = 0.0;
};
using Terms = std::vector<Term>;

Point2 sum(const Terms& terms, const Eigen::VectorXd& x);

enum class Derivative
{
  Place,
  Slope,
  Bend,
};

/// A stretch as a curve of unknown points: its nodes, and the coefficients between them.
class StretchCurve
{
public:
  /// The stretch stays the caller's.
  /// \param next the first unknown that is free; those taken are counted
  StretchCurve(const FairStretch& stretch, Eigen::Index& next);

  const FairStretch& stretch() const { return this->Stretch; }
  const CubicBasis& basis() const { return this->Basis; }
  /// The unknown points that it depends on, from its first node to its last.
  std::vector<Eigen::Index> unknowns() const;
  Terms at(double t, Derivative derivative) const;
  std::vector<FairSpan> spans(const Eigen::VectorXd& x) const;
  /// Of the points across the curve, along which they may slide, between those of its ends.
  std::vector<double> deviation(
    const Points2& nodes, const Eigen::VectorXd& x, std::vector<double>& nearest) const;

private:
  const FairStretch& Stretch;
  CubicBasis Basis;
  Eigen::Index First = 0;
};
}
}
