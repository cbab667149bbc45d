// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StretchCurve.h"

#include <Eigen/SparseCore>

namespace flattening
{
namespace pattern
{
/// The condition that a part of a curve has a length, with its derivatives by the unknowns.
class CurveLength
{
public:
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// \param from along the stretch \param to where the part ends \param wanted its length
  CurveLength(const StretchCurve& curve, double from, double to, double wanted);

  double wanted() const { return this->Wanted; }
  /// Adds its derivative as a row. \return what is missing to the length
  double addRow(Eigen::Index row, const Eigen::VectorXd& x, Entries& entries) const;
  /// Adds its second derivative, times a tension. Entries are the same whatever that is.
  void addTension(double tension, const Eigen::VectorXd& x, Entries& entries) const;

private:
  double Wanted;
  std::vector<std::pair<Terms, double>> Slopes; ///< at the places of its integral, with weights
};
}
}
