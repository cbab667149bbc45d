// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/KeyCurveLocks.h"

#include <Eigen/SparseCore>
#include <cmath>

namespace flattening
{
/// Wire edges that stretch together by an unknown factor 1 + h.
struct StretchGroup
{
  double tolerance = 0.0; ///< |h| stays within it
  double weight = 1.0;    ///< of h^2 / 2 in the objective
};

/// A flattening from elsewhere to start from: closed loops of other lengths.
struct AngleStart
{
  std::vector<double> theta;  ///< per node
  std::vector<double> length; ///< per wire edge
};

/// The constrained optimization of Eq. 13 (of Eq. 2 where the network is a single wire-patch):
/// least change of the angles of all free wire-nodes, under the turning of each loop (2 pi), the
/// closure of each loop, and the sum of 2 pi around each interior vertex.
struct AngleProblem
{
  const WireNetwork* network = nullptr;
  std::vector<double> target; ///< per node: alpha of the paper
  std::vector<double> weight; ///< per node, in the objective; 0 around holes
  NodeLocks locks;
  std::vector<double> length; ///< per wire edge: the length to close with
  std::vector<char> held;     ///< per wire edge: the isometric scheme keeps its length
  Indices stretchGroup;       ///< per wire edge; none where the length is rigid
  std::vector<StretchGroup> groups;
};

/// The problem of a network: targets are the surface angles, lengths those on the surface.
AngleProblem makeAngleProblem(const WireNetwork& network, NodeLocks locks);

/// The angle to the left of a path in the plane, in (0, 2 pi].
double interiorAngle(const Point2& before, const Point2& at, const Point2& after);

/// The angle and whole turns that come nearest to a target.
inline double nearestBranch(double angle, double target)
{
  return angle + 2.0 * pi * std::round((target - angle) / (2.0 * pi));
}

/// The planar angle of each node where the wires' vertices lie, on the branch next to its target. A
/// wire that ends in a patch has its full turn there. \param positions per piece vertex
std::vector<double> planarAngles(const AngleProblem& problem, const Points2& positions);

/// Per stretch group how far its stretch may go.
std::vector<double> stretchBounds(const AngleProblem& problem);

/// Length of each wire edge with these stretches of elastic curves and connectors.
std::vector<double> stretchedLengths(
  const AngleProblem& problem, const std::vector<double>& stretch);

/// 1/2 sum w (theta - alpha)^2 over the free nodes (Eq. 13).
double angleObjective(const AngleProblem& problem, const std::vector<double>& theta);

/// Direction phi of each side by Eq. 3, each loop on its own with phi = pi - theta at its first
/// node.
std::vector<double> sideDirections(const WireNetwork& network, const std::vector<double>& theta);

/// Direction of each wire edge by Eq. 3, from the first side on over all loops and across edges;
/// one frame for all where the angles meet the turning and 2 pi constraints.
std::vector<double> edgeDirections(const WireNetwork& network, const std::vector<double>& theta);

/// Rows: the turning of each loop, x and y closure of each loop, then the sum at each interior
/// vertex that has a free node (the order of Eq. 15). Columns: the free nodes.
class AngleConstraints
{
public:
  explicit AngleConstraints(const AngleProblem& problem);

  Index rowCount() const { return this->Rows; }
  Index freeCount() const { return static_cast<Index>(this->FreeNodes.size()); }
  const Indices& freeNodes() const { return this->FreeNodes; }

  /// Values of the constraints, zero where they hold (the negative of Eqs. 21 and 22).
  Eigen::VectorXd residual(const std::vector<double>& theta) const;
  /// Their derivative by the free angles, H of Eqs. 16 to 19.
  Eigen::SparseMatrix<double> jacobian(const std::vector<double>& theta) const;

private:
  const AngleProblem* Problem;
  Indices FreeNodes;
  Indices ColumnOfNode;
  Indices VertexRow; ///< per host vertex, else none
  Index Rows = 0;
};

/// Ranks of elements of which some come first, each part in its order.
struct RankedFirst
{
  Indices rank;
  Index first = 0; ///< how many come first
};

template <class ComesFirst>
RankedFirst rankFirst(std::size_t count, const ComesFirst& comesFirst)
{
  RankedFirst ranked{ Indices(count) };
  Index next = 0;
  for (const bool first : { true, false })
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      if (comesFirst(k) == first)
      {
        ranked.rank[k] = next++;
      }
    }
    ranked.first = first ? next : ranked.first;
  }
  return ranked;
}

/// Largest distance by which a loop misses its start when its sides are laid one after the other.
/// \param length per wire edge.
double closureResidual(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length);

/// Sum of the lengths of the outer boundary, the measure of closure residuals.
double perimeter(const AngleProblem& problem);

/// The angle problem of a piece's wires as every scheme, trial and piece of advice poses it: key
/// curves locked but for the released ones, elastic curves and connectors with their stretches; of
/// a free boundary neither lengths nor angles count.
AngleProblem makeWireProblem(const WireNetwork& network, const Piece& piece, const CutSurface& cut,
  const std::vector<FeatureCurve>& curves, const CurveRules& rules = {});
}
