// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricSheet.h"

#include "Base/Execution.h"

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
  for (std::size_t t = 0; t < weights.size(); ++t)
  {
    this->Frames[t].area *= weights[t];
  }
  for (const Triangle& c : filling.triangles)
  {
    const auto rest = [&](std::size_t k) {
      const Point2 p = filling.rest[c[k]] / unit;
      return Point3(p.x(), p.y(), 0.0);
    };
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
