// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SewingLoads.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
/// Beyond it a step inwards is far below what can be seen, and the system badly conditioned.
constexpr double hardest = 1e4;

double stiffnessAgainstInwards(double stiffness, double bias)
{
  return bias < 1.0 ? std::min(hardest, stiffness * bias / (1.0 - bias)) : hardest;
}
}

DesignAnchor::DesignAnchor(const SpaceUnknowns& unknowns, const SewnMembrane& sheet,
  double stiffness, double outsideBias, const Points3& outwards)
{
  if (!(stiffness > 0.0))
  {
    return;
  }
  const std::vector<double> areas = sheet.vertexAreas();
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  const bool biased = outsideBias > 0.0;
  const double againstInwards = stiffnessAgainstInwards(stiffness, outsideBias);
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    if (unknowns.first[v] != none && areas[v] > 0.0)
    {
      const double share = areas[v] / sum;
      this->Springs.push_back(
        { unknowns.first[v], unknowns.points[v], biased ? outwards[v] : Point3::Zero(),
          stiffness * share, biased ? againstInwards * share : 0.0 });
    }
  }
}

double DesignAnchor::inwards(const Spring& spring, const Point3& moved)
{
  return std::min(0.0, spring.outwards.dot(moved));
}

double DesignAnchor::energy(const Eigen::VectorXd& x) const
{
  double sum = 0.0;
  for (const Spring& spring : this->Springs)
  {
    const Point3 moved = x.segment<3>(spring.first) - spring.design;
    const double in = inwards(spring, moved);
    sum += spring.stiffness * moved.squaredNorm() + spring.againstInwards * in * in;
  }
  return sum;
}

void DesignAnchor::add(
  const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const
{
  for (const Spring& spring : this->Springs)
  {
    const Point3 moved = x.segment<3>(spring.first) - spring.design;
    const double in = inwards(spring, moved);
    const Point3& out = spring.outwards;
    gradient.segment<3>(spring.first) +=
      2.0 * spring.stiffness * moved + 2.0 * spring.againstInwards * in * out;
    const double across = in < 0.0 ? 2.0 * spring.againstInwards : 0.0;
    matrix.addOwn(spring.first,
      2.0 * spring.stiffness * Eigen::Matrix3d::Identity() + across * out * out.transpose());
  }
}

namespace
{
/// Cloth that is stretched to less than this many times its volume has an energy above zero.
constexpr double maxInflated = 4.0;

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
  this->Offset = maxInflated * std::abs(pressure * designed);
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

void InnerPressure::declare(SpaceMatrix& matrix)
{
  for (std::size_t t = 0; this->Pressure != 0.0 && t < this->Sheet.triangles().size(); ++t)
  {
    this->Blocks.emplace_back(matrix, this->Unknowns.of(this->Sheet.triangles()[t]));
  }
}

void InnerPressure::add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
  Eigen::VectorXd& gradient) const
{
  for (std::size_t t = 0; t < this->Blocks.size(); ++t)
  {
    const Triangle& c = this->Sheet.triangles()[t];
    Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero();
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = this->Unknowns.at(c[k], x);
    }
    for (int k = 0; k < 3; ++k)
    {
      const int n = (k + 1) % 3;
      const int m = (k + 2) % 3;
      this->Unknowns.scatter(c[k], -this->Pressure / 6.0 * p[n].cross(p[m]), gradient);
      // det = p_k . (p_n x p_m): by p_k and p_n it is -[p_m] as a cross matrix.
      hessian.block<3, 3>(3 * k, 3 * n) = this->Pressure / 6.0 * crossMatrix(p[m]);
      hessian.block<3, 3>(3 * n, 3 * k) = hessian.block<3, 3>(3 * k, 3 * n).transpose();
    }
    if (curvature == Curvature::Exact)
    {
      this->Blocks[t].add(matrix, hessian);
    }
  }
}

ClothWeight::ClothWeight(
  const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const Point3& force)
  : Unknowns(unknowns)
  , Force(force)
  , Area(sheet.vertexAreas())
{
  // Cloth that sinks by less than its size has an energy above zero.
  const double area = std::accumulate(this->Area.begin(), this->Area.end(), 0.0);
  this->Offset = force.norm() * area * std::sqrt(area);
}

double ClothWeight::energy(const Eigen::VectorXd& x) const
{
  double sum = this->Offset;
  for (std::size_t v = 0; v < this->Area.size(); ++v)
  {
    const auto vertex = static_cast<Index>(v);
    sum -= this->Area[v] * this->Force.dot(this->Unknowns.at(vertex, x) - this->Unknowns.points[v]);
  }
  return sum;
}

void ClothWeight::add(Eigen::VectorXd& gradient) const
{
  for (std::size_t v = 0; v < this->Area.size(); ++v)
  {
    if (this->Unknowns.first[v] != none)
    {
      gradient.segment<3>(this->Unknowns.first[v]) -= this->Area[v] * this->Force;
    }
  }
}
}
