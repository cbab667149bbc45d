// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <Eigen/Core>

#include <algorithm>

namespace flattening
{
/// Share of the decrease which the slope promises that a step must bring (Armijo's rule).
constexpr double sufficientDecrease = 1e-4;

inline double largest(const Eigen::VectorXd& v)
{
  return v.size() ? v.cwiseAbs().maxCoeff() : 0.0;
}

/// Objective plus the sum of penalty_i |c_i|, which a step of sequential quadratic programming
/// lowers: exact where each penalty is above its constraint's multiplier.
class MeritFunction
{
public:
  /// \param margin of a penalty over its multiplier; it keeps the function exact while multipliers
  /// change, and shortens steps. \param share least penalty over the largest.
  MeritFunction(Index constraints, double margin, double share)
    : Penalties(Eigen::VectorXd::Zero(constraints))
    , Margin(margin)
    , Share(share)
  {
  }

  /// Penalties only grow, so that steps get on by one measure.
  void raise(const Eigen::VectorXd& multipliers)
  {
    const Eigen::VectorXd asked = this->Margin * multipliers.cwiseAbs();
    const double least = this->Share * (asked.size() ? asked.maxCoeff() : 0.0);
    this->Penalties =
      this->Penalties.cwiseMax((asked.array().max(least) + smallestPenalty).matrix());
  }
  void forget() { this->Penalties.setZero(); }

  double violation(const Eigen::VectorXd& constraints) const
  {
    return constraints.cwiseAbs().dot(this->Penalties);
  }
  double largestPenalty() const
  {
    return this->Penalties.size() ? this->Penalties.maxCoeff() : 0.0;
  }

private:
  /// Where no multiplier asks for one.
  static constexpr double smallestPenalty = 1e-3;

  Eigen::VectorXd Penalties;
  double Margin;
  double Share;
};
}
