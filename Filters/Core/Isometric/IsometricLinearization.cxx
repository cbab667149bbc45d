// SPDX-License-Identifier: BSD-3-Clause
// The derivatives of IsometricModel.
#include "Isometric/IsometricModel.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Gradient and Hessian of the direction angle of a vector.
Eigen::Vector2d angleGradient(const Eigen::Vector2d& d)
{
  return Eigen::Vector2d(-d.y(), d.x()) / d.squaredNorm();
}
Eigen::Matrix2d angleHessian(const Eigen::Vector2d& d)
{
  const double r2 = d.squaredNorm();
  const double a = 2.0 * d.x() * d.y() / (r2 * r2);
  const double b = (d.y() * d.y() - d.x() * d.x()) / (r2 * r2);
  Eigen::Matrix2d h;
  h << a, b, b, -a;
  return h;
}
}

Eigen::Matrix<double, 6, 1> IsometricModel::nodeGradient(const Node& node, const Eigen::VectorXd& x)
{
  // theta = pi + phi_in - phi_out (Eq. 3)
  const Eigen::Vector2d gIn = angleGradient(planePoint(x, node.at) - planePoint(x, node.before));
  const Eigen::Vector2d gOut = angleGradient(planePoint(x, node.after) - planePoint(x, node.at));
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << -gIn, gIn + gOut, -gOut;
  return gradient;
}

IsometricModel::NodeGeometry IsometricModel::nodeGeometry(
  const Node& node, const Eigen::VectorXd& x, bool second) const
{
  NodeGeometry geometry;
  geometry.angle = this->nodeAngle(node, x);
  geometry.gradient = nodeGradient(node, x);
  geometry.hessian.setZero();
  if (second)
  {
    const Eigen::Vector2d in = planePoint(x, node.at) - planePoint(x, node.before);
    const Eigen::Vector2d out = planePoint(x, node.after) - planePoint(x, node.at);
    const Eigen::Matrix2d hIn = angleHessian(in);
    const Eigen::Matrix2d hOut = angleHessian(out);
    geometry.hessian.block<2, 2>(0, 0) = hIn;
    geometry.hessian.block<2, 2>(2, 0) = -hIn;
    geometry.hessian.block<2, 2>(0, 2) = -hIn;
    geometry.hessian.block<2, 2>(2, 2) = hIn - hOut;
    geometry.hessian.block<2, 2>(4, 2) = hOut;
    geometry.hessian.block<2, 2>(2, 4) = hOut;
    geometry.hessian.block<2, 2>(4, 4) = -hOut;
  }
  return geometry;
}

void IsometricModel::addAngles(const Eigen::VectorXd& x, bool exact, Eigen::VectorXd& gradient)
{
  for (std::size_t k = 0; k < this->Nodes.size(); ++k)
  {
    const Node& node = this->Nodes[k];
    const NodeGeometry geometry = this->nodeGeometry(node, x, exact);
    const double d = geometry.angle - node.target;
    Eigen::Matrix<double, 6, 6> H =
      2.0 * node.stiffness * (geometry.gradient * geometry.gradient.transpose());
    H += 2.0 * node.stiffness * d * geometry.hessian;
    this->NodeBlocks[k].add(this->Assembler, H);
    this->NodeBlocks[k].scatter(
      Eigen::Matrix<double, 6, 1>(2.0 * node.stiffness * d * geometry.gradient), gradient);
  }
}

/// The constraint's row of the Jacobian. \return the edge
Eigen::Vector2d IsometricModel::takeLengthRow(Index k, const Eigen::VectorXd& x)
{
  const WireEdge& edge = this->Problem.network->edges[this->LengthEdges[k]];
  Eigen::Vector2d d = planePoint(x, edge.to) - planePoint(x, edge.from);
  const Eigen::Vector2d along = d.normalized();
  this->LengthRows[k] << -along.transpose(), along.transpose(), -this->Length[k];
  return d;
}

void IsometricModel::addStretches(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const
{
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    const Index at = this->CoordinateCount + g;
    gradient[at] += this->Problem.groups[g].weight * x[at];
  }
}

void IsometricModel::addLengths(
  const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact)
{
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const Eigen::Vector2d d = this->takeLengthRow(k, x);
    const double length = d.norm();
    const Eigen::Vector2d along = d / length;
    const double lambda = exact ? multipliers[k] : std::max(0.0, multipliers[k]);
    const Eigen::Matrix2d bend =
      lambda / length * (Eigen::Matrix2d::Identity() - along * along.transpose());
    Eigen::Matrix4d H;
    H << bend, -bend, -bend, bend;
    this->LengthBlocks[k].add(this->Assembler, H);
    this->LengthRowBlocks[k].add(this->Assembler, this->LengthRows[k]);
  }
}

void IsometricModel::addLocks(
  const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact)
{
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const NodeGeometry geometry = this->nodeGeometry(this->LockedNodes[k], x, exact);
    const double lambda = multipliers[this->lengthCount() + static_cast<Index>(k)];
    this->LockedBlocks[k].add(
      this->Assembler, Eigen::Matrix<double, 6, 6>(lambda * geometry.hessian));
    this->LockedRows[k] = geometry.gradient.transpose();
    this->LockedRowBlocks[k].add(this->Assembler, this->LockedRows[k]);
  }
}

IsometricModel::Linearization IsometricModel::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, Curvature curvature, double delta, const Execution& execution)
{
  const bool exact = curvature == Curvature::Exact;
  this->Assembler.clear();
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->unknownCount());
  result.constraints = this->constraints(x);
  this->Sheet.add(x, curvature, this->Assembler, result.gradient, execution);
  this->addAngles(x, exact, result.gradient);
  this->addLengths(x, multipliers, exact);
  this->addLocks(x, multipliers, exact);
  for (std::size_t k = 0; k < this->HoldBlocks.size(); ++k)
  {
    this->HoldBlocks[k].add(
      this->Assembler, [&](int, int column) { return this->Hold.weights[k].weight[column]; });
  }
  this->addStretches(x, result.gradient);
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    this->stiffen(g, this->Problem.groups[g].weight);
  }
  for (Index k = 0; k < this->constraintCount(); ++k)
  {
    this->Diagonal.add(this->Assembler, this->unknownCount() + k, -delta);
  }
  this->fixMotion(x);
  return result;
}

std::optional<IsometricModel::Linearization> IsometricModel::differentiate(
  const Eigen::VectorXd& x, const Execution& execution)
{
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->unknownCount());
  result.constraints = this->constraints(x);
  this->Sheet.addGradient(x, result.gradient, execution);
  for (std::size_t k = 0; k < this->Nodes.size(); ++k)
  {
    const Node& node = this->Nodes[k];
    const NodeGeometry geometry = this->nodeGeometry(node, x, false);
    const double torque = 2.0 * node.stiffness * (geometry.angle - node.target);
    this->NodeBlocks[k].scatter(
      Eigen::Matrix<double, 6, 1>(torque * geometry.gradient), result.gradient);
  }
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    this->takeLengthRow(k, x);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    this->LockedRows[k] = nodeGradient(this->LockedNodes[k], x).transpose();
  }
  this->addStretches(x, result.gradient);
  return result;
}

Eigen::VectorXd IsometricModel::transposedJacobianTimes(const Eigen::VectorXd& multipliers) const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(this->unknownCount());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    this->LengthRowBlocks[k].addTransposedTimes(
      this->LengthRows[k], multipliers.segment<1>(k), result);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    this->LockedRowBlocks[k].addTransposedTimes(this->LockedRows[k],
      multipliers.segment<1>(this->lengthCount() + static_cast<Eigen::Index>(k)), result);
  }
  for (const GrainHold::Weight& part : this->Hold.weights)
  {
    result.segment<2>(2 * part.vertex) += multipliers[this->holdRow()] * part.weight;
  }
  return result;
}
}
