// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/ClothWeight.h"

#include <cmath>
#include <numeric>

namespace flattening
{
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
