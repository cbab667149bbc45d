// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/StretchCurve.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

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
  /// What lies in one span of the curve, so that all its places have the same unknowns.
  struct Part
  {
    Terms unknowns;                             ///< of the first place
    std::vector<std::array<double, 4>> factors; ///< of the slopes at the places of its integral
    std::vector<double> weights;

    Point2 slope(std::size_t place, const Eigen::VectorXd& x) const;
  };

  double Wanted;
  std::vector<Part> Parts;
};
}
}
