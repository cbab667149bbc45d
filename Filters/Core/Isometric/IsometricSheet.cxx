// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricSheet.h"

#include "Base/Execution.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
IsometricSheet::IsometricSheet(const TriangleMesh& mesh, double unit, const SheetEnergy& energy,
  const BoundaryFilling& filling, const RegionWeights& weights)
  : Cells(mesh.triangles())
  , Energy(energy)
{
  this->Frames.reserve(this->Cells.size());
  for (const Triangle& c : this->Cells)
  {
    this->Frames.emplace_back(
      mesh.point(c[0]) / unit, mesh.point(c[1]) / unit, mesh.point(c[2]) / unit);
  }
  const auto inUnits = [unit](const Point2& p) { return Point3(p.x() / unit, p.y() / unit, 0.0); };
  for (std::size_t t = 0; t < filling.shapes.size(); ++t)
  {
    // The stiffness of what is crushed stays that of the others.
    const double area = this->Frames[t].area;
    const auto& [first, second] = filling.shapes[t];
    this->Frames[t] = TriangleFrame(Point3::Zero(), inUnits(first), inUnits(second));
    this->Frames[t].area = std::min(area, this->Frames[t].area);
  }
  for (std::size_t t = 0; t < weights.size(); ++t)
  {
    this->Frames[t].area *= weights[t];
  }
  for (const Triangle& c : filling.triangles)
  {
    const auto rest = [&](std::size_t k) { return inUnits(filling.rest[c[k]]); };
    this->Frames.emplace_back(rest(0), rest(1), rest(2)).area = BoundaryFilling::share;
    this->Cells.push_back(c);
  }
}

Eigen::Vector4d IsometricSheet::mapParts(Index t, const Eigen::VectorXd& x) const
{
  return flattening::mapParts(
    this->Frames[t], this->Cells[t], [&x](Index v) { return x.segment<2>(2 * v); });
}

double IsometricSheet::energy(const Eigen::VectorXd& x, const Execution& execution) const
{
  // Summed in the triangles' order, whatever the threads.
  std::vector<double> density(this->Cells.size());
  execution.forEach(static_cast<Index>(density.size()), [&](Index t) {
    density[t] = this->Frames[t].area * this->Energy.density(this->mapParts(t, x));
  });
  return std::accumulate(density.begin(), density.end(), 0.0);
}

void IsometricSheet::declare(SymmetricAssembler& assembler)
{
  for (std::size_t t = 0; t < this->Cells.size(); ++t)
  {
    const Index first = Block::declare(assembler, this->Cells[t]);
    this->FirstEntry = t == 0 ? first : this->FirstEntry;
  }
}

IsometricSheet::Derivatives IsometricSheet::derivatives(
  Index t, const Eigen::VectorXd& x, bool convex) const
{
  const DistortionEnergyValue value = this->Energy.evaluate(this->mapParts(t, x), convex);
  const Eigen::Matrix<double, 4, 6> derivative = mapPartsDerivative(this->Frames[t]);
  Derivatives result;
  result.gradient = this->Frames[t].area * (derivative.transpose() * value.gradient);
  const Eigen::Matrix<double, 4, 6> half = this->Frames[t].area * (value.hessian * derivative);
  int next = 0;
  for (int a = 0; a < 6; ++a)
  {
    for (int b = 0; b <= a; ++b)
    {
      result.hessian[next++] = derivative.col(a).dot(half.col(b));
    }
  }
  return result;
}

void IsometricSheet::add(const Eigen::VectorXd& x, Curvature curvature,
  SymmetricAssembler& assembler, Eigen::VectorXd& gradient, const Execution& execution) const
{
  const bool convex = curvature == Curvature::Convex;
  computeAndAdd<Derivatives>(
    static_cast<Index>(this->Cells.size()), execution,
    [&](Index t) { return this->derivatives(t, x, convex); },
    [&](Index t, const Derivatives& of) {
      Block::add(assembler, this->FirstEntry + t * Block::entryCount, this->Cells[t],
        [&of](int a, int b) { return of.hessian[a * (a + 1) / 2 + b]; });
      Block::scatter(this->Cells[t], of.gradient, gradient);
    });
}

void IsometricSheet::addGradient(
  const Eigen::VectorXd& x, Eigen::VectorXd& gradient, const Execution& execution) const
{
  using Gradient = Eigen::Matrix<double, 6, 1>;
  computeAndAdd<Gradient>(
    static_cast<Index>(this->Cells.size()), execution,
    [&](Index t) {
      return Gradient(this->Frames[t].area *
        (mapPartsDerivative(this->Frames[t]).transpose() *
          this->Energy.gradient(this->mapParts(t, x))));
    },
    [&](Index t, const Gradient& of) { Block::scatter(this->Cells[t], of, gradient); });
}
}
