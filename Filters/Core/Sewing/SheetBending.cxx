// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SheetBending.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// A triangle beside an edge that is lower than this fraction of it makes no stiffer hinge: slivers
/// beside imprinted curves would else be rods.
constexpr double lowest = 0.05;

/// K of one triangle: by the half-edge's start and end, and the corner opposite.
Eigen::Vector3d slopeWeights(const TriangleFrame& rest, int k)
{
  const Complex opposite = rest.gradient[(k + 2) % 3];
  Eigen::Vector3d weights;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Complex& g = rest.gradient[(k + corner) % 3];
    weights[corner] = 8.0 * rest.area * (g.real() * opposite.real() + g.imag() * opposite.imag());
  }
  return weights;
}
}

SheetBending::SheetBending(
  const SpaceUnknowns& unknowns, const SewnMembrane& sheet, const Indices& twins, double stiffness)
  : Unknowns(unknowns)
{
  this->Hinges.reserve(twins.size() / 2);
  for (Index h = 0; h < static_cast<Index>(twins.size()); ++h)
  {
    const Index twin = twins[h];
    if (twin == none || twin < h)
    {
      continue;
    }
    const Triangle& cell = sheet.triangles()[h / 3];
    const Triangle& other = sheet.triangles()[twin / 3];
    const TriangleFrame& rest = sheet.rest()[h / 3];
    const TriangleFrame& otherRest = sheet.rest()[twin / 3];
    if (!(rest.area > 0.0 && otherRest.area > 0.0))
    {
      continue;
    }
    const Eigen::Vector3d near = slopeWeights(rest, h % 3);
    const Eigen::Vector3d far = slopeWeights(otherRest, twin % 3);
    Hinge hinge;
    hinge.vertices = { cell[h % 3], cell[(h + 1) % 3], cell[(h + 2) % 3], other[(twin + 2) % 3] };
    // The twin runs from the edge's end to its start.
    hinge.weights << near[0] + far[1], near[1] + far[0], near[2], far[2];
    // Opposite weights are length over height; the length squared is 2 A over their ratio.
    const double slimness = std::max({ near[2], far[2], 1.0 / lowest }) * lowest;
    const double length2 = std::max(2.0 * rest.area * near[2], 2.0 * otherRest.area * far[2]);
    const double area = std::max(rest.area + otherRest.area, lowest * length2);
    hinge.weights /= slimness;
    hinge.stiffness = stiffness / area;
    this->Hinges.push_back(hinge);
  }
}

Point3 SheetBending::bend(const Hinge& hinge, const Eigen::VectorXd& x) const
{
  // By differences, since the weights sum to zero.
  const Point3 origin = this->Unknowns.at(hinge.vertices[0], x);
  Point3 sum = Point3::Zero();
  for (int k = 1; k < 4; ++k)
  {
    sum += hinge.weights[k] * (this->Unknowns.at(hinge.vertices[k], x) - origin);
  }
  return sum;
}

double SheetBending::energy(const Eigen::VectorXd& x) const
{
  double sum = 0.0;
  for (const Hinge& hinge : this->Hinges)
  {
    sum += 0.5 * hinge.stiffness * this->bend(hinge, x).squaredNorm();
  }
  return sum;
}

void SheetBending::declare(SpaceMatrix& matrix)
{
  for (Hinge& hinge : this->Hinges)
  {
    const std::array<Index, 12> all = this->Unknowns.of(hinge.vertices);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      hinge.blocks[axis] = { matrix, { all[axis], all[3 + axis], all[6 + axis], all[9 + axis] } };
    }
  }
}

void SheetBending::add(
  const Eigen::VectorXd& x, SpaceMatrix& matrix, Eigen::VectorXd& gradient) const
{
  for (const Hinge& hinge : this->Hinges)
  {
    const Point3 force = hinge.stiffness * this->bend(hinge, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      hinge.blocks[axis].add(matrix,
        [&](int a, int b) { return hinge.stiffness * hinge.weights[a] * hinge.weights[b]; });
      hinge.blocks[axis].scatter(Eigen::Vector4d(force[axis] * hinge.weights), gradient);
    }
  }
}

void SheetBending::addCliques(Triangles& cliques) const
{
  for (const Hinge& hinge : this->Hinges)
  {
    cliques.push_back({ hinge.vertices[2], hinge.vertices[3], hinge.vertices[0] });
  }
}
}
