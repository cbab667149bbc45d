// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/DirectionsKkt.h"

namespace flattening
{
DirectionsKkt::DirectionsKkt(const DirectionsForm& form)
  : Form(form)
  , Unknowns(form.unknownCount())
  , Assembler(form.unknownCount() + form.constraintCount())
{
  const AngleProblem& problem = form.problem();
  const WireNetwork& net = *problem.network;
  this->Sides.reserve(net.nodeCount());
  for (Index side = 0; side < net.nodeCount(); ++side)
  {
    const Index edge = net.edge[side];
    const Index group = problem.stretchGroup[edge];
    this->Sides.push_back({ form.rotation(net.edge[net.previous[side]]), form.rotation(edge),
      group == none ? none : form.rotationCount() + group, form.unknownCount() + 2 * net.loop[side],
      problem.weight[side], form.signedLength(side), edge });
    this->declare(this->Sides.back());
  }
  // Entries are counted in the order of their declaration.
  for (Index g = form.rotationCount(); g < this->Unknowns; ++g)
  {
    const Index entry = this->Assembler.declare(g, g);
    this->GroupEntries = g == form.rotationCount() ? entry : this->GroupEntries;
  }
  for (Index k = 0; k < this->Unknowns + form.constraintCount(); ++k)
  {
    const Index entry = this->Assembler.declare(k, k);
    this->DiagonalEntries = k == 0 ? entry : this->DiagonalEntries;
  }
  this->Assembler.finish();
}

/// In the order of fill().
void DirectionsKkt::declare(const Side& side)
{
  if (side.in != side.out)
  {
    if (side.in != none)
    {
      this->Assembler.declare(side.in, side.in);
    }
    if (side.out != none)
    {
      this->Assembler.declare(side.out, side.out);
    }
    if (side.in != none && side.out != none)
    {
      this->Assembler.declare(side.in, side.out);
    }
  }
  if (side.out != none)
  {
    this->Assembler.declare(side.out, side.out);
    this->Assembler.declare(side.row, side.out);
    this->Assembler.declare(side.row + 1, side.out);
    if (side.group != none)
    {
      this->Assembler.declare(side.group, side.out);
    }
  }
  if (side.group != none)
  {
    this->Assembler.declare(side.row, side.group);
    this->Assembler.declare(side.row + 1, side.group);
  }
}

void DirectionsKkt::fill(const Eigen::VectorXd& x, const Points2& units,
  const Eigen::VectorXd& multipliers, const std::vector<char>& held, double delta)
{
  this->Assembler.clear();
  this->Held.assign(this->Unknowns, 0);
  std::copy(held.begin(), held.end(), this->Held.begin() + this->Form.rotationCount());
  Index entry = 0;
  const auto add = [&](double value) { this->Assembler.add(entry++, value); };
  for (const Side& side : this->Sides)
  {
    if (side.in != side.out)
    {
      if (side.in != none)
      {
        add(side.weight);
      }
      if (side.out != none)
      {
        add(side.weight);
      }
      if (side.in != none && side.out != none)
      {
        add(-side.weight);
      }
    }
    const Eigen::Vector2d along = side.length * units[side.edge];
    const Eigen::Vector2d stretched = this->Form.stretch(side.edge, x) * along;
    const Eigen::Vector2d lambda = multipliers.segment<2>(side.row - this->Unknowns);
    const bool free = side.group != none && !this->Held[side.group];
    if (side.out != none)
    {
      add(-stretched.dot(lambda));
      add(-stretched.y());
      add(stretched.x());
      if (side.group != none)
      {
        add(free ? lambda.y() * along.x() - lambda.x() * along.y() : 0.0);
      }
    }
    if (side.group != none)
    {
      add(free ? along.x() : 0.0);
      add(free ? along.y() : 0.0);
    }
  }
  for (Index g = 0; g < this->Form.groupCount(); ++g)
  {
    this->Assembler.add(
      this->GroupEntries + g, held[g] ? 1.0 : this->Form.problem().groups[g].weight);
  }
  for (Index c = 0; c < this->Form.constraintCount(); ++c)
  {
    this->Assembler.add(this->DiagonalEntries + this->Unknowns + c, -delta);
  }
}

void DirectionsKkt::shift(double tau)
{
  for (Index k = 0; k < this->Unknowns; ++k)
  {
    this->Assembler.add(this->DiagonalEntries + k, this->Held[k] ? 0.0 : tau);
  }
}

Eigen::VectorXd DirectionsKkt::transposedJacobianTimes(
  const Eigen::VectorXd& x, const Points2& units, const Eigen::VectorXd& vector) const
{
  Eigen::VectorXd product = Eigen::VectorXd::Zero(this->Unknowns);
  for (const Side& side : this->Sides)
  {
    const Eigen::Vector2d along = side.length * units[side.edge];
    const Eigen::Vector2d lambda = vector.segment<2>(side.row - this->Unknowns);
    if (side.out != none)
    {
      product[side.out] +=
        this->Form.stretch(side.edge, x) * (lambda.y() * along.x() - lambda.x() * along.y());
    }
    if (side.group != none)
    {
      product[side.group] += lambda.dot(along);
    }
  }
  return product;
}
}
