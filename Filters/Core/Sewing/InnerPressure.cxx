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

void InnerPressure::add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
  Eigen::VectorXd& gradient) const
{
  if (this->Pressure == 0.0)
  {
    return;
  }
  for (const Triangle& c : this->Sheet.triangles())
  {
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
      if (curvature == Curvature::Exact)
      {
        // det = p_k . (p_n x p_m): by p_k and p_n it is -[p_m] as a cross matrix.
        matrix.addPair(this->Unknowns.first[c[k]], this->Unknowns.first[c[n]],
          this->Pressure / 6.0 * crossMatrix(p[m]));
      }
    }
  }
}
}
