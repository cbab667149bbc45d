// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Base/Execution.h"
#include "Embedding/DistortionEnergy.h"
#include "Sparse/NestedDissection.h"
#include "Sparse/SymmetricAssembler.h"

namespace flattening
{
/// The isometric scheme's problem for one piece, in units of the root of the mean triangle area.
///
/// Unknowns: x and y of every vertex, then the stretch h of each elastic curve. Minimized is
///   sum a_t f(J_t) + w sum (theta_i - alpha_i)^2 + sum weight_g h_g^2 / 2
/// with a_t the area of triangle t over the mean area, f the sheet's energy density and theta_i the
/// planar angle of wire-node i; constraints are the length of each wire edge, |x_a - x_b| = l (1 +
/// h), and the angle of each locked node. Edges of connectors are no constraint here: the triangles
/// beside them hold them, and nodes on them have no angle term.
class IsometricModel
{
public:
  IsometricModel(const Piece& piece, const AngleProblem& problem, const DistortionEnergy& energy,
    double angleWeight);

  Index unknownCount() const { return this->CoordinateCount + this->groupCount(); }
  Index coordinateCount() const { return this->CoordinateCount; }
  Index groupCount() const { return static_cast<Index>(this->Problem.groups.size()); }
  Index constraintCount() const
  {
    return static_cast<Index>(this->LengthEdges.size() + this->LockedNodes.size());
  }
  /// Constraints 0 .. lengthCount() - 1 are lengths, the others locked angles.
  Index lengthCount() const { return static_cast<Index>(this->LengthEdges.size()); }
  double unit() const { return this->Unit; }

  Eigen::VectorXd unknowns(const Points2& positions, const std::vector<double>& stretch) const;
  Points2 positions(const Eigen::VectorXd& x) const;
  std::vector<double> stretches(const Eigen::VectorXd& x) const;

  struct Terms
  {
    double sheet = 0.0;
    double angles = 0.0; ///< with its weight
    double total = 0.0;
  };
  Terms objective(const Eigen::VectorXd& x, const Execution& execution) const;
  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const;

  /// How the Hessian of the Lagrangian is taken.
  enum class Curvature
  {
    Exact,  ///< all terms
    Convex, ///< sheet energy projected, angles by Gauss-Newton, constraints where they are convex
  };

  /// Gradient of the objective, Jacobian of the constraints, and the matrix
  /// [H + tau I, J'; J, -delta I] (lower triangle) at x.
  struct Linearization
  {
    Eigen::VectorXd gradient;
    Eigen::VectorXd constraints;
  };
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution);
  /// Adds to the diagonal of H for all coordinates, after linearize().
  void shift(double tau);
  /// Takes out the rigid motions, after linearize(): holds one vertex, and another one across the
  /// line from the first. Both energy and constraints are invariant, so this chooses among equals.
  void fixMotion(const Eigen::VectorXd& x);
  /// Adds a stiffness to a stretch, after linearize(), so that a right-hand side of this stiffness
  /// times a step makes it take that step.
  void hold(Index group);
  static constexpr double heldStiffness = 1e12;
  /// A good order of elimination for kkt(): vertices by nested dissection at x, each constraint
  /// after its vertices.
  Dissection eliminationOrder(const Eigen::VectorXd& x) const;
  const Eigen::SparseMatrix<double>& kkt() const { return this->Assembler.matrix(); }
  /// J' times a vector, with the Jacobian of the last linearize().
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const;

private:
  struct Node
  {
    Index before; ///< vertices
    Index at;
    Index after;
    double target;
    double weight;
  };
  struct NodeGeometry
  {
    double angle;
    Eigen::Matrix<double, 6, 1> gradient;
    Eigen::Matrix<double, 6, 6> hessian;
  };

  void addNodes();
  void declareEntries();
  std::vector<char> hubsOfWires() const;
  double nodeAngle(const Node& node, const Eigen::VectorXd& x) const;
  NodeGeometry nodeGeometry(const Node& node, const Eigen::VectorXd& x, bool second) const;
  Eigen::Vector4d mapParts(Index t, const Eigen::VectorXd& x) const;
  void addTriangles(const Eigen::VectorXd& x, Curvature curvature, Eigen::VectorXd& gradient,
    const Execution& execution);

  const AngleProblem& Problem;
  Triangles Cells;
  DistortionEnergy Energy;
  double AngleWeight;
  double Unit = 1.0;
  Index CoordinateCount = 0;
  std::vector<TriangleFrame> Frames; ///< in units, so that their mean area is 1
  std::vector<Node> Nodes;           ///< with a term in the objective
  std::vector<Node> LockedNodes;     ///< with a constraint
  Indices LengthEdges;
  std::vector<double> Length; ///< per length constraint, in units
  SymmetricAssembler Assembler;
  Index TriangleEntries = 0;
  Index NodeEntries = 0;
  Index LengthEntries = 0;
  Index LockedEntries = 0;
  Index GroupEntries = 0;
  Index DiagonalEntries = 0;
  Index MotionEntries = 0;
  std::array<Index, 2> FixedVertices{ 0, 1 };
  std::vector<std::array<double, 21>> TriangleValues;
  std::vector<Eigen::Matrix<double, 6, 1>> TriangleGradients;
  std::vector<Eigen::Matrix<double, 5, 1>> LengthRows;
  std::vector<Eigen::Matrix<double, 6, 1>> LockedRows;
};
}
