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

Eigen::Vector2d pointOf(const Eigen::VectorXd& x, Index v)
{
  return x.segment<2>(2 * v);
}
}

IsometricModel::NodeGeometry IsometricModel::nodeGeometry(
  const Node& node, const Eigen::VectorXd& x, bool second) const
{
  // theta = pi + phi_in - phi_out (Eq. 3)
  const Eigen::Vector2d in = pointOf(x, node.at) - pointOf(x, node.before);
  const Eigen::Vector2d out = pointOf(x, node.after) - pointOf(x, node.at);
  const Eigen::Vector2d gIn = angleGradient(in);
  const Eigen::Vector2d gOut = angleGradient(out);
  NodeGeometry geometry;
  geometry.angle = this->nodeAngle(node, x);
  geometry.gradient << -gIn, gIn + gOut, -gOut;
  geometry.hessian.setZero();
  if (second)
  {
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

void IsometricModel::addTriangles(const Eigen::VectorXd& x, Curvature curvature,
  Eigen::VectorXd& gradient, const Execution& execution)
{
  const bool convex = curvature == Curvature::Convex;
  execution.parallelFor(static_cast<Index>(this->Cells.size()), [&](Index begin, Index end) {
    for (Index t = begin; t < end; ++t)
    {
      const DistortionEnergyValue value =
        evaluateDistortionEnergy(this->Energy, this->mapParts(t, x), convex);
      const Eigen::Matrix<double, 4, 6> derivative = mapPartsDerivative(this->Frames[t]);
      this->TriangleGradients[t] = this->Frames[t].area * (derivative.transpose() * value.gradient);
      const Eigen::Matrix<double, 4, 6> half = this->Frames[t].area * (value.hessian * derivative);
      std::array<double, 21>& entries = this->TriangleValues[t];
      int next = 0;
      for (int a = 0; a < 6; ++a)
      {
        for (int b = 0; b <= a; ++b)
        {
          entries[next++] = derivative.col(a).dot(half.col(b));
        }
      }
    }
  });
  Index entry = this->TriangleEntries;
  for (std::size_t t = 0; t < this->Cells.size(); ++t)
  {
    for (double value : this->TriangleValues[t])
    {
      this->Assembler.add(entry++, value);
    }
    for (int k = 0; k < 3; ++k)
    {
      gradient.segment<2>(2 * this->Cells[t][k]) += this->TriangleGradients[t].segment<2>(2 * k);
    }
  }
}

IsometricModel::Linearization IsometricModel::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, Curvature curvature, double delta, const Execution& execution)
{
  const WireNetwork& net = *this->Problem.network;
  const bool exact = curvature == Curvature::Exact;
  this->Assembler.clear();
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->unknownCount());
  result.constraints = this->constraints(x);
  this->addTriangles(x, curvature, result.gradient, execution);

  auto addBlock = [this](Index& entry, const auto& block) {
    for (Eigen::Index a = 0; a < block.rows(); ++a)
    {
      for (Eigen::Index b = 0; b <= a; ++b)
      {
        this->Assembler.add(entry++, block(a, b));
      }
    }
  };
  Index entry = this->NodeEntries;
  for (const Node& node : this->Nodes)
  {
    const NodeGeometry geometry = this->nodeGeometry(node, x, exact);
    const double d = geometry.angle - node.target;
    const Eigen::Matrix<double, 6, 1> g = 2.0 * node.weight * d * geometry.gradient;
    result.gradient.segment<2>(2 * node.before) += g.segment<2>(0);
    result.gradient.segment<2>(2 * node.at) += g.segment<2>(2);
    result.gradient.segment<2>(2 * node.after) += g.segment<2>(4);
    Eigen::Matrix<double, 6, 6> H =
      2.0 * node.weight * (geometry.gradient * geometry.gradient.transpose());
    H += 2.0 * node.weight * d * geometry.hessian;
    addBlock(entry, H);
  }
  entry = this->LengthEntries;
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const WireEdge& edge = net.edges[this->LengthEdges[k]];
    const Eigen::Vector2d d = pointOf(x, edge.to) - pointOf(x, edge.from);
    const double length = d.norm();
    const Eigen::Vector2d along = d / length;
    const double lambda = exact ? multipliers[k] : std::max(0.0, multipliers[k]);
    const Eigen::Matrix2d bend =
      lambda / length * (Eigen::Matrix2d::Identity() - along * along.transpose());
    Eigen::Matrix4d H;
    H << bend, -bend, -bend, bend;
    addBlock(entry, H);
    const Index group = this->Problem.stretchGroup[this->LengthEdges[k]];
    Eigen::Matrix<double, 5, 1>& row = this->LengthRows[k];
    row << -along, along, group == none ? 0.0 : -this->Length[k];
    for (double value : row)
    {
      this->Assembler.add(entry++, value);
    }
  }
  entry = this->LockedEntries;
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const Node& node = this->LockedNodes[k];
    const NodeGeometry geometry = this->nodeGeometry(node, x, exact);
    const double lambda = multipliers[this->lengthCount() + static_cast<Index>(k)];
    addBlock(entry, Eigen::Matrix<double, 6, 6>(lambda * geometry.hessian));
    this->LockedRows[k] = geometry.gradient;
    for (double value : geometry.gradient)
    {
      this->Assembler.add(entry++, value);
    }
  }
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    const double weight = this->Problem.groups[g].weight;
    result.gradient[this->CoordinateCount + g] += weight * x[this->CoordinateCount + g];
    this->Assembler.add(this->GroupEntries + g, weight);
  }
  for (Index k = 0; k < this->constraintCount(); ++k)
  {
    this->Assembler.add(this->DiagonalEntries + this->unknownCount() + k, -delta);
  }
  return result;
}

Eigen::VectorXd IsometricModel::transposedJacobianTimes(const Eigen::VectorXd& multipliers) const
{
  const WireNetwork& net = *this->Problem.network;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(this->unknownCount());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const WireEdge& edge = net.edges[this->LengthEdges[k]];
    const Index group = this->Problem.stretchGroup[this->LengthEdges[k]];
    result.segment<2>(2 * edge.from) += multipliers[k] * this->LengthRows[k].segment<2>(0);
    result.segment<2>(2 * edge.to) += multipliers[k] * this->LengthRows[k].segment<2>(2);
    if (group != none)
    {
      result[this->CoordinateCount + group] += multipliers[k] * this->LengthRows[k][4];
    }
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const Node& node = this->LockedNodes[k];
    const double lambda = multipliers[this->lengthCount() + static_cast<Index>(k)];
    result.segment<2>(2 * node.before) += lambda * this->LockedRows[k].segment<2>(0);
    result.segment<2>(2 * node.at) += lambda * this->LockedRows[k].segment<2>(2);
    result.segment<2>(2 * node.after) += lambda * this->LockedRows[k].segment<2>(4);
  }
  return result;
}
}
