// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/DirectionsKkt.h"

#include <cmath>

namespace flattening
{
DirectionsKkt::DirectionsKkt(const DirectionsForm& form)
  : Form(form)
  , Assembler(form.unknownCount() + form.constraintCount())
{
  const AngleProblem& problem = form.problem();
  const WireNetwork& net = *problem.network;
  this->Sides.reserve(net.nodeCount());
  for (Index s = 0; s < net.nodeCount(); ++s)
  {
    const Index edge = net.edge[s];
    const Index group = problem.stretchGroup[edge];
    const Index in = form.rotation(net.edge[net.previous[s]]);
    const Index out = form.rotation(edge);
    const Index stretch = group == none ? none : form.rotationCount() + group;
    const Index row = 2 * net.loop[s];
    // Within a run the angle is fixed.
    const std::array<Index, 2> turning{ in == out ? none : in, in == out ? none : out };
    Side side{ edge, row, problem.weight[s], form.signedLength(s), {}, {}, {} };
    side.angle = { this->Assembler, turning };
    side.bend = { this->Assembler, { out, stretch } };
    side.closes = { this->Assembler, form.unknownCount() + row, { out, stretch } };
    this->Sides.push_back(side);
  }
  this->Diagonal = { this->Assembler, 0, form.unknownCount() + form.constraintCount() };
  this->Assembler.finish();
}

std::vector<double> DirectionsKkt::bounds() const
{
  std::vector<double> tolerance;
  for (const StretchGroup& group : this->Form.problem().groups)
  {
    tolerance.push_back(group.tolerance);
  }
  return tolerance;
}

double DirectionsKkt::objective(const Eigen::VectorXd& x, const Execution&) const
{
  return this->Form.objective(x);
}

Eigen::VectorXd DirectionsKkt::constraints(const Eigen::VectorXd& x) const
{
  return this->Form.closure(x);
}

/// Closures that contradict each other drive the penalty up, and with it what rounding of the merit
/// function means for them.
double DirectionsKkt::constraintRounding(const Eigen::VectorXd&, double merit) const
{
  constexpr double rounding = 1e-13; // of sums of some hundreds of sines and cosines
  return rounding * (1.0 + std::abs(merit));
}

Eigen::Matrix2d DirectionsKkt::closureDerivative(const Side& side) const
{
  const Eigen::Vector2d along = side.length * this->Units[side.edge];
  const double factor = this->Factor[side.edge];
  Eigen::Matrix2d derivative;
  derivative << -factor * along.y(), along.x(), factor * along.x(), along.y();
  return derivative;
}

NewtonKktModel::Linearization DirectionsKkt::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, Curvature, double delta, const Execution&)
{
  this->Units = this->Form.unitVectors(x);
  this->Factor.resize(this->Units.size());
  for (std::size_t e = 0; e < this->Factor.size(); ++e)
  {
    this->Factor[e] = this->Form.stretch(static_cast<Index>(e), x);
  }
  this->Assembler.clear();
  for (const Side& side : this->Sides)
  {
    side.angle.add(
      this->Assembler, [&](int a, int b) { return a == b ? side.weight : -side.weight; });
    const Eigen::Matrix2d derivative = this->closureDerivative(side);
    const Eigen::Vector2d lambda = multipliers.segment<2>(side.row);
    // The second derivatives by rotation and by rotation and stretch; that by stretch is zero.
    const double along = lambda.y() * derivative(0, 1) - lambda.x() * derivative(1, 1);
    const double bend = lambda.y() * derivative(0, 0) - lambda.x() * derivative(1, 0);
    side.bend.add(this->Assembler, [&](int a, int b) {
      return a == 0 ? bend : b == 0 ? along : 0.0;
    });
    side.closes.add(this->Assembler, derivative);
  }
  for (Index g = 0; g < this->Form.groupCount(); ++g)
  {
    this->stiffen(g, this->Form.problem().groups[g].weight);
  }
  for (Index c = 0; c < this->constraintCount(); ++c)
  {
    this->Diagonal.add(this->Assembler, this->unknownCount() + c, -delta);
  }
  return { this->Form.gradient(x), this->Form.closure(x, this->Units) };
}

void DirectionsKkt::shift(double tau)
{
  for (Index k = 0; k < this->unknownCount(); ++k)
  {
    this->Diagonal.add(this->Assembler, k, tau);
  }
}

void DirectionsKkt::stiffen(Index bounded, double stiffness)
{
  this->Diagonal.add(this->Assembler, this->Form.rotationCount() + bounded, stiffness);
}

Eigen::VectorXd DirectionsKkt::transposedJacobianTimes(const Eigen::VectorXd& multipliers) const
{
  Eigen::VectorXd product = Eigen::VectorXd::Zero(this->unknownCount());
  for (const Side& side : this->Sides)
  {
    side.closes.addTransposedTimes(
      this->closureDerivative(side), multipliers.segment<2>(side.row), product);
  }
  return product;
}
}
