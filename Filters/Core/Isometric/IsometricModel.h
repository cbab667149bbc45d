// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Base/Execution.h"
#include "Isometric/IsometricSheet.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/SymmetricAssembler.h"

namespace flattening
{
/// A wire-node as a hinge between its two edges.
struct WireHinge
{
  double length = 0.0;          ///< mean of the two edges
  double angle = 0.0;           ///< on the surface
  bool sheetOnBothSides = true; ///< of both edges
};

/// How stiff the wires of a piece are against bending.
///
/// A wire keeps its length, so the sheet that would shorten it presses on it, and what is pressed
/// buckles. The sheet holds it: a wire of bending energy B (kappa - kappa_0)^2 per length on a
/// sheet of modulus E wrinkles at the least force N where N q^2 = 2 B q^4 + c q has a solution, c
/// about 2 E / 3 at an edge of the sheet and twice that inside, so at B = (N / 2.4)^3 / c^2. So B
/// grows with the cube of the pressing force, from a small least value on; wires in tension keep
/// that. Forces belong to the surface and B to the length, not to the mesh: a hinge of length l
/// costs B / l times the square of its angle's change, and a finer mesh of the same surface gives
/// the same shape.
///
/// Energies and lengths are those of IsometricModel.
class WireStiffness
{
public:
  /// \param weight of all terms. \param sheetArea of the piece. \param sheetModulus over that of
  /// the rigid energy.
  WireStiffness(double weight, double sheetArea, double sheetModulus);

  /// Where forces are not known yet.
  double unknownForce(const WireHinge& hinge) const;
  /// Under a force that presses (positive) or draws.
  double underForce(const WireHinge& hinge, double force) const;

private:
  double ofBending(const WireHinge& hinge, double bending) const;

  double Weight;
  double Area;
  double Modulus;
};

/// Where a vertex lies, of the isometric scheme's unknowns.
inline Eigen::Vector2d planePoint(const Eigen::VectorXd& x, Index v)
{
  return x.segment<2>(2 * v);
}

/// A nested dissection of a piece's vertices where they lie, for
/// IsometricModel::eliminationOrder().
/// \param cells those of the piece and of its filling
Dissection dissectVertices(Triangles cells, const WireNetwork& network, const Points2& positions);

/// The isometric scheme's problem for one piece, in units of the root of the mean triangle area.
///
/// Unknowns: x and y of every vertex, then the stretch h of each elastic curve. Minimized is
///   sum w_t a_t f(J_t) + sum k_i (theta_i - alpha_i)^2 + sum weight_g h_g^2 / 2
/// with w_t and a_t the weight of triangle t and its area over the mean area, f the sheet's energy
/// density, theta_i the planar angle of wire-node i and k_i its stiffness, the same for all forces
/// until switchToFinalObjective() gets them; constraints are the length of each wire edge, |x_a -
/// x_b| = l (1 + h), the angle of each locked node, and the hold. Edges of connectors and of a free
/// boundary are no constraint: the triangles beside them hold them, and nodes on them have no angle
/// term.
class IsometricModel : public NewtonKktModel
{
public:
  /// \param hold of a sheet that does not turn freely; without one it turns as its energy asks.
  /// \param weights by triangle, for the sheet's energy; empty: 1
  IsometricModel(const Piece& piece, const AngleProblem& problem, const SheetEnergy& energy,
    double bendingWeight, const GrainHold& hold = {}, const BoundaryFilling& filling = {},
    const RegionWeights& weights = {});

  Index unknownCount() const override { return this->CoordinateCount + this->groupCount(); }
  Index coordinateCount() const { return this->CoordinateCount; }
  Index groupCount() const { return static_cast<Index>(this->Problem.groups.size()); }
  Index constraintCount() const override { return this->holdRow() + (this->Hold.holds() ? 1 : 0); }
  std::vector<double> bounds() const override { return stretchBounds(this->Problem); }
  /// Constraints 0 .. lengthCount() - 1 are lengths, the others locked angles, the last the hold.
  Index lengthCount() const { return static_cast<Index>(this->LengthEdges.size()); }

  Eigen::VectorXd unknowns(const Points2& positions, const std::vector<double>& stretch) const;
  Points2 positions(const Eigen::VectorXd& x) const;
  std::vector<double> stretches(const Eigen::VectorXd& x) const;

  struct Terms
  {
    double sheet = 0.0;
    double angles = 0.0; ///< with their stiffness
    double total = 0.0;
  };
  Terms terms(const Eigen::VectorXd& x, const Execution& execution) const;
  double objective(const Eigen::VectorXd& x, const Execution& execution) const override
  {
    return this->terms(x, execution).total;
  }
  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const override;
  /// Takes the multipliers of lengths for the forces in the wires, and makes these as stiff as they
  /// ask for.
  bool switchToFinalObjective(const Eigen::VectorXd& multipliers) override;
  /// Lets all wires keep the stiffness that they have.
  void keepStiffness() { this->KeepsStiffness = true; }
  /// Per wire-node k_i; 0 for nodes without a term.
  std::vector<double> stiffness() const;
  double constraintRounding(const Eigen::VectorXd& x, double merit) const override;
  double gradientScale(double objective) const override;
  double gradientRounding(const Eigen::VectorXd& x) const override;

  /// Convex: sheet energy projected, angles by Gauss-Newton, constraints where they are convex. The
  /// rigid motions, of which neither energy nor constraints know, are taken out: one vertex is
  /// held, and another one across the line from the first; of a cloth, which knows of turns, the
  /// first alone.
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution) override;
  std::optional<Linearization> differentiate(
    const Eigen::VectorXd& x, const Execution& execution) override;
  const std::array<Index, 2>& fixedVertices() const { return this->FixedVertices; }
  bool hasConvexPart() const override { return true; }
  /// Of all coordinates.
  void shift(double tau) override;
  void stiffen(Index bounded, double stiffness) override;
  /// A good order of elimination for kkt(): vertices as dissected, each constraint after its
  /// vertices.
  Dissection eliminationOrder(const Dissection& dissection) const;
  const SparseMatrix& kkt() const override { return this->Assembler.matrix(); }
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const override;

private:
  struct Node
  {
    Index before; ///< vertices
    Index at;
    Index after;
    double target;
    Index node;                   ///< of the network
    std::array<Index, 2> lengths; ///< constraints, of both edges
    WireHinge hinge;
    double stiffness;
  };
  struct NodeGeometry
  {
    double angle;
    Eigen::Matrix<double, 6, 1> gradient;
    Eigen::Matrix<double, 6, 6> hessian;
  };

  void addNodes();
  Node makeNode(Index node, const Indices& lengthOfEdge) const;
  void declareEntries();
  std::vector<char> hubsOfWires() const;
  static double nodeAngle(const Node& node, const Eigen::VectorXd& x);
  static Eigen::Matrix<double, 6, 1> nodeGradient(const Node& node, const Eigen::VectorXd& x);
  static NodeGeometry nodeGeometry(const Node& node, const Eigen::VectorXd& x, bool second);
  void addAngles(const Eigen::VectorXd& x, bool exact, Eigen::VectorXd& gradient);
  void addStretches(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
  Eigen::Vector2d takeLengthRow(Index k, const Eigen::VectorXd& x);
  void addLengths(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact);
  void addLocks(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact);
  void fixMotion(const Eigen::VectorXd& x);
  Index holdRow() const
  {
    return static_cast<Index>(this->LengthEdges.size() + this->LockedNodes.size());
  }

  const AngleProblem& Problem;
  double Unit;
  IsometricSheet Sheet;
  GrainHold Hold;
  WireStiffness Stiffness;
  bool Settled = false;
  Index CoordinateCount = 0;
  std::vector<Node> Nodes;       ///< with a term in the objective
  std::vector<Node> LockedNodes; ///< with a constraint
  Indices LengthEdges;
  std::vector<double> Length; ///< per length constraint, in units
  SymmetricAssembler Assembler;
  std::vector<SymmetricBlock<6>> NodeBlocks;
  std::vector<SymmetricBlock<4>> LengthBlocks;      ///< of both ends
  std::vector<JacobianBlock<1, 5>> LengthRowBlocks; ///< by both ends and the stretch
  std::vector<SymmetricBlock<6>> LockedBlocks;
  std::vector<JacobianBlock<1, 6>> LockedRowBlocks;
  std::vector<JacobianBlock<1, 2>> HoldBlocks; ///< by weight
  DiagonalBlock Diagonal;
  SymmetricBlock<2> FarVertexBlock;
  std::array<Index, 2> FixedVertices{ 0, 1 };
  bool KeepsStiffness = false;
  std::vector<Eigen::Matrix<double, 1, 5>> LengthRows;
  std::vector<Eigen::Matrix<double, 1, 6>> LockedRows;
};
}
