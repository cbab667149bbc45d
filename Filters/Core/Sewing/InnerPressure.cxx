// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/InnerPressure.h"

#include <cmath>

namespace flattening
{
namespace
{
/// Cloth that is stretched to less than this many times its volume has an energy above zero.
constexpr double mostInflated = 4.0;

Eigen::Matrix3d crossMatrix(const Point3& v)
{
  Eigen::Matrix3d cross;
  cross << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return cross;
}
}

InnerPressure::InnerPressure(
  const SpaceUnknowns& unknowns, const SewnMembrane& sheet, double pressure)
  : Unknowns(unknowns)
  , Sheet(sheet)
  , Pressure(pressure)
{
  double designed = 0.0;
  for (const Triangle& c : sheet.triangles())
  {
    designed += unknowns.points[c[0]].dot(unknowns.points[c[1]].cross(unknowns.points[c[2]])) / 6.0;
  }
  this->Offset = mostInflated * std::abs(pressure * designed);
}

double InnerPressure::volume(const Eigen::VectorXd& x) const
{
  double sum = 0.0;
  for (const Triangle& c : this->Sheet.triangles())
  {
    const Point3 a = this->Unknowns.at(c[0], x);
    sum += a.dot(this->Unknowns.at(c[1], x).cross(this->Unknowns.at(c[2], x))) / 6.0;
  }
  return sum;
}

double InnerPressure::energy(const Eigen::VectorXd& x) const
{
  return this->Pressure == 0.0 ? 0.0 : this->Offset - this->Pressure * this->volume(x);
}

void InnerPressure::declare(SymmetricAssembler& assembler)
{
  for (const Triangle& c : this->Sheet.triangles())
  {
    if (this->Pressure == 0.0)
    {
      return;
    }
    std::array<Index, 9> unknowns{};
    for (int k = 0; k < 9; ++k)
    {
      const Index first = this->Unknowns.first[c[k / 3]];
      unknowns[k] = first == none ? none : first + k % 3;
    }
    this->Blocks.emplace_back(assembler, unknowns);
  }
}

void InnerPressure::add(const Eigen::VectorXd& x, Curvature curvature,
  SymmetricAssembler& assembler, Eigen::VectorXd& gradient)
{
  for (std::size_t t = 0; t < this->Blocks.size(); ++t)
  {
    const Triangle& c = this->Sheet.triangles()[t];
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = this->Unknowns.at(c[k], x);
    }
    Eigen::Matrix<double, 9, 1> slope;
    Eigen::Matrix<double, 9, 9> bend = Eigen::Matrix<double, 9, 9>::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const int n = (k + 1) % 3;
      slope.segment<3>(3 * k) = -this->Pressure / 6.0 * p[n].cross(p[(k + 2) % 3]);
      // det = p_k . (p_n x p_m): by p_k and p_n it is -[p_m] as a cross matrix.
      bend.block<3, 3>(3 * k, 3 * n) = this->Pressure / 6.0 * crossMatrix(p[(k + 2) % 3]);
      bend.block<3, 3>(3 * n, 3 * k) = bend.block<3, 3>(3 * k, 3 * n).transpose();
    }
    this->Blocks[t].scatter(slope, gradient);
    if (curvature == Curvature::Exact)
    {
      this->Blocks[t].add(assembler, bend);
    }
  }
}
}
