// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/SymmetricAssembler.h"

namespace flattening
{
/// The angle problem with one direction psi per wire edge as unknown, instead of one angle per
/// node.
///
/// The other side of an edge runs in direction psi + pi, so that every angle is
/// theta = c + psi_in - psi_out with a constant c, a multiple of pi, and all turning and 2 pi
/// constraints hold by construction; only two closures a loop remain. Locked angles tie directions
/// to each other: edges fall into rigid runs with one rotation each. Elastic edges add a stretch h
/// per group. One run stays fixed, since a rotation of the whole changes nothing.
///
/// Unknowns x: the rotations of all runs but the fixed one, then the stretches. Constraints: x and
/// y closure of each loop, in units of the mean wire edge.
class DirectionsForm
{
public:
  explicit DirectionsForm(const AngleProblem& problem);

  Index unknownCount() const { return this->Rotations + this->groupCount(); }
  Index rotationCount() const { return this->Rotations; }
  /// How many of the first rotations are those of single edges along wires, in an order in which
  /// each leaves one neighbor only where it is eliminated.
  Index rotationsAlongWires() const { return this->RotationsAlong; }
  Index groupCount() const { return static_cast<Index>(this->Problem->groups.size()); }
  Index constraintCount() const { return 2 * this->Problem->network->loopCount(); }
  const AngleProblem& problem() const { return *this->Problem; }
  /// The unknown rotation of an edge; none where it stays fixed.
  Index rotation(Index edge) const { return this->UnknownOfEdge[edge]; }
  /// Length of a side in units, negative where it runs back along its edge.
  double signedLength(Index side) const;
  /// Factor 1 + h of an edge's length.
  double stretch(Index edge, const Eigen::VectorXd& x) const
  {
    const Index group = this->Problem->stretchGroup[edge];
    return group == none ? 1.0 : 1.0 + x[this->Rotations + group];
  }
  /// Unit of length of the constraints.
  double unit() const { return this->Unit; }
  /// Nodes where locked angles contradict each other around a loop or a vertex; empty where they
  /// agree.
  const Indices& contradictions() const { return this->Contradictions; }

  /// Unknowns that come nearest to the given angles.
  Eigen::VectorXd unknowns(const std::vector<double>& theta) const;
  /// The angles nearest to the surface angles that meet the turning and 2 pi constraints.
  const std::vector<double>& projectedAngles() const { return this->Projected; }

  std::vector<double> angles(const Eigen::VectorXd& x) const;
  /// Per side.
  std::vector<double> directions(const Eigen::VectorXd& x) const;
  std::vector<double> lengths(const Eigen::VectorXd& x) const;
  std::vector<double> stretches(const Eigen::VectorXd& x) const;

  double objective(const Eigen::VectorXd& x) const;
  Eigen::VectorXd gradient(const Eigen::VectorXd& x) const;
  /// Cosine and sine of each wire edge's direction.
  Points2 unitVectors(const Eigen::VectorXd& x) const;
  Eigen::VectorXd closure(const Eigen::VectorXd& x, const Points2& units) const;
  Eigen::VectorXd closure(const Eigen::VectorXd& x) const
  {
    return this->closure(x, this->unitVectors(x));
  }

  /// Lengths to close with, where they differ from the problem's (the homotopy); per wire edge.
  void setLengths(const std::vector<double>& length);

private:
  void projectAngles();
  void fixBranches(const std::vector<double>& psi);
  void formRuns(const std::vector<double>& psi);
  double direction(Index edge, const Eigen::VectorXd& x) const
  {
    const Index unknown = this->UnknownOfEdge[edge];
    return this->Offset[edge] + (unknown == none ? 0.0 : x[unknown]);
  }

  const AngleProblem* Problem;
  std::vector<double> Projected;
  std::vector<double> Branch; ///< c, per node
  std::vector<double> Offset; ///< per edge, its direction within its run
  Indices UnknownOfEdge;      ///< none for the fixed run
  Index Rotations = 0;
  Index RotationsAlong = 0;
  Indices Contradictions;
  std::vector<double> Length; ///< per edge, in units
  double Unit = 1.0;
};

/// The directions form as Newton's method wants it. The stretches are the bounded unknowns.
class DirectionsKkt : public NewtonKktModel
{
public:
  /// Only refers to the form.
  explicit DirectionsKkt(const DirectionsForm& form);

  Index unknownCount() const override { return this->Form.unknownCount(); }
  Index constraintCount() const override { return this->Form.constraintCount(); }
  std::vector<double> bounds() const override { return stretchBounds(this->Form.problem()); }
  double objective(const Eigen::VectorXd& x, const Execution& execution = {}) const override;
  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const override;
  double constraintRounding(const Eigen::VectorXd& x, double merit) const override;
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
    Curvature curvature, double delta, const Execution& execution = {}) override;
  void shift(double tau) override;
  void stiffen(Index bounded, double stiffness) override;
  const SparseMatrix& kkt() const override { return this->Assembler.matrix(); }
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const override;

private:
  /// Numbers and entries that a side brings.
  struct Side
  {
    Index edge;
    Index row; ///< of the first closure of its loop, counted from 0
    double weight;
    double length;              ///< in units, negative where the side runs back along its edge
    SymmetricBlock<2> angle;    ///< of the rotations of the edges before and after the node
    SymmetricBlock<2> bend;     ///< of rotation and stretch of the edge
    JacobianBlock<2, 2> closes; ///< derivative of the loop's closures by these two
  };
  /// Derivative of closures by rotation and stretch, with the Jacobian of the last linearize().
  Eigen::Matrix2d closureDerivative(const Side& side) const;

  const DirectionsForm& Form;
  std::vector<Side> Sides;
  SymmetricAssembler Assembler;
  DiagonalBlock Diagonal;
  Points2 Units;              ///< directions of the wire edges at the last linearize()
  std::vector<double> Factor; ///< 1 + stretch per wire edge there
};
}
