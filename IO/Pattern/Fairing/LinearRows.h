// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/StretchCurve.h"

#include <Eigen/SparseCore>

namespace flattening
{
namespace pattern
{
/// Linear conditions of unknown points: a row for each coordinate.
class LinearRows
{
public:
  /// Points stay, of which these are the first unknowns.
  void addHeld(const Points2& points);
  /// Stretches end in the nodes that they are hooked to, and rings are smooth where they close.
  void addHooksAndRings(const std::vector<StretchCurve>& curves);
  /// Curves are mirror images of each other; nodes that stay are so already.
  /// \param curves of all stretches of the network
  void addMirror(const FairNetwork& network, const std::vector<StretchCurve>& curves);

  Eigen::Index size() const { return static_cast<Eigen::Index>(this->Rows.size()); }
  /// Adds all rows from the row 0 on. \param missing what is missing to them
  void add(const Eigen::VectorXd& x, std::vector<Eigen::Triplet<double>>& entries,
    Eigen::VectorXd& missing) const;

private:
  struct Row
  {
    std::vector<std::pair<Eigen::Index, double>> factors; ///< of coordinates
    double value = 0.0;
  };

  void addPoint(const Terms& terms, const Point2& value);

  std::vector<Row> Rows;
};
}
}
