// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SewnMembrane.h"

#include "Base/ConvexPart.h"
#include "Base/Execution.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
/// Gradient of a corner's hat function in the plane of the rest.
Eigen::Vector2d hatGradient(const TriangleFrame& rest, int k)
{
  return { 2.0 * rest.gradient[k].real(), 2.0 * rest.gradient[k].imag() };
}
}

TriangleFrame restFrame(const std::array<Point2, 3>& corners)
{
  const auto lifted = [](const Point2& p) -> Point3 { return { p.x(), p.y(), 0.0 }; };
  TriangleFrame frame(lifted(corners[0]), lifted(corners[1]), lifted(corners[2]));
  std::array<Complex, 3> images;
  for (int k = 0; k < 3; ++k)
  {
    images[k] = Complex(corners[k].x(), corners[k].y());
  }
  // Where the frame's own x axis lies.
  const Complex axis = frame.alpha(images) + frame.beta(images);
  for (Complex& gradient : frame.gradient)
  {
    gradient *= std::abs(axis) > 0.0 ? axis / std::abs(axis) : Complex(1.0, 0.0);
  }
  return frame;
}

Eigen::Matrix<double, 3, 2> mapIntoSpace(
  const TriangleFrame& rest, const Point3& a, const Point3& b, const Point3& c)
{
  return (b - a) * hatGradient(rest, 1).transpose() + (c - a) * hatGradient(rest, 2).transpose();
}

Eigen::Vector3d metricOf(const Eigen::Matrix<double, 3, 2>& map)
{
  return { map.col(0).squaredNorm(), map.col(1).squaredNorm(), map.col(0).dot(map.col(1)) };
}

std::array<double, 2> stretchesOf(const Eigen::Vector3d& metric)
{
  const double mean = 0.5 * (metric[0] + metric[1]);
  const double radius = std::hypot(0.5 * (metric[0] - metric[1]), metric[2]);
  const double large = std::sqrt(mean + radius);
  const double det = std::sqrt(std::max(0.0, metric[0] * metric[1] - metric[2] * metric[2]));
  return { large, large > 0.0 ? std::min(large, det / large) : 0.0 };
}

SewnMembrane::SewnMembrane(const SpaceUnknowns& unknowns, Triangles triangles, TriangleFrames rest,
  const SheetDensity& density)
  : Unknowns(unknowns)
  , Cells(std::move(triangles))
  , Frames(std::move(rest))
  , Density(density)
{
}

std::vector<double> SewnMembrane::vertexAreas() const
{
  return flattening::vertexAreas(
    this->Cells, this->Unknowns.points.size(), [this](Index t) { return this->Frames[t].area; });
}

Eigen::Matrix<double, 3, 2> SewnMembrane::mapOf(Index t, const Eigen::VectorXd& x) const
{
  const Triangle& c = this->Cells[t];
  return mapIntoSpace(this->Frames[t], this->Unknowns.at(c[0], x), this->Unknowns.at(c[1], x),
    this->Unknowns.at(c[2], x));
}

double SewnMembrane::energy(const Eigen::VectorXd& x, const Execution& execution) const
{
  // Summed in the triangles' order, whatever the threads.
  std::vector<double> density(this->Cells.size());
  execution.forEach(static_cast<Index>(density.size()), [&](Index t) {
    const double area = this->Frames[t].area;
    density[t] = area > 0.0 ? area * this->Density.value(metricOf(this->mapOf(t, x))) : 0.0;
  });
  return std::accumulate(density.begin(), density.end(), 0.0);
}

void SewnMembrane::declare(SpaceMatrix& matrix)
{
  for (const Triangle& c : this->Cells)
  {
    this->Blocks.emplace_back(matrix, this->Unknowns.of(c));
  }
}

/// With hat gradients g_k, dC11 = 2 J1 . dx_k g_k1, dC22 = 2 J2 . dx_k g_k2 and dC12 = J1 . dx_k
/// g_k2 + J2 . dx_k g_k1, where J1 and J2 are the columns of J.
SewnMembrane::Derivatives SewnMembrane::derive(Index t, const Eigen::VectorXd& x, bool convex) const
{
  Derivatives result;
  const double area = this->Frames[t].area;
  if (!(area > 0.0))
  {
    return result;
  }
  const Eigen::Matrix<double, 3, 2> map = this->mapOf(t, x);
  MetricDensity density = this->Density.evaluate(metricOf(map));
  Eigen::Matrix2d stress;
  stress << 2.0 * density.gradient[0], density.gradient[2], density.gradient[2],
    2.0 * density.gradient[1];
  Eigen::Matrix<double, 3, 9> metricDerivative;
  std::array<Eigen::Vector2d, 3> hat;
  for (int k = 0; k < 3; ++k)
  {
    hat[k] = hatGradient(this->Frames[t], k);
    metricDerivative.block<1, 3>(0, 3 * k) = 2.0 * hat[k].x() * map.col(0).transpose();
    metricDerivative.block<1, 3>(1, 3 * k) = 2.0 * hat[k].y() * map.col(1).transpose();
    metricDerivative.block<1, 3>(2, 3 * k) =
      hat[k].y() * map.col(0).transpose() + hat[k].x() * map.col(1).transpose();
  }
  result.gradient = area * (metricDerivative.transpose() * density.gradient);
  if (convex)
  {
    stress = withoutNegativeEigenvalues(stress);
    if (!this->Density.convexInMetric())
    {
      density.hessian = withoutNegativeEigenvalues(density.hessian);
    }
  }
  const Eigen::Matrix<double, 3, 9> half = area * (density.hessian * metricDerivative);
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b <= a; ++b)
    {
      auto block = result.hessian.block<3, 3>(3 * a, 3 * b);
      block = metricDerivative.block<3, 3>(0, 3 * a).transpose() * half.block<3, 3>(0, 3 * b);
      block.diagonal().array() += area * hat[a].dot(stress * hat[b]);
    }
  }
  return result;
}

void SewnMembrane::add(const Eigen::VectorXd& x, Curvature curvature, SpaceMatrix& matrix,
  Eigen::VectorXd& gradient, const Execution& execution) const
{
  const bool convex = curvature == Curvature::Convex;
  computeAndAdd<Derivatives>(
    static_cast<Index>(this->Cells.size()), execution,
    [&](Index t) { return this->derive(t, x, convex); },
    [&](Index t, const Derivatives& derived) {
      this->Blocks[t].add(matrix, derived.hessian);
      this->Blocks[t].scatter(derived.gradient, gradient);
    });
}

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
