// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SymmetryPlane.h"

#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Gauss-Newton converges in fewer where there is a plane.
constexpr int mostPlaneRefinements = 10;
/// About this many vertices are mirrored: enough for a mean.
constexpr Index vertexSamples = 500;
/// Mirrored vertices that are this near, in sqrt(area / pi), are exact but for rounding.
constexpr double exactly = 1e-12;

class Fitting
{
public:
  explicit Fitting(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Locator(mesh)
    , Shape(momentsOf(mesh))
    , Size(std::sqrt(this->Shape.area / pi))
  {
    const Index step = std::max<Index>(1, mesh.vertexCount() / vertexSamples);
    for (Index v = 0; v < mesh.vertexCount(); v += step)
    {
      if (mesh.outgoing(v) != none)
      {
        this->Samples.push_back(v);
      }
    }
  }

  std::optional<SymmetryPlane> run(double tolerance)
  {
    std::vector<Point3> normals{ Point3::UnitX(), Point3::UnitY(), Point3::UnitZ() };
    for (int k = 0; k < 3; ++k)
    {
      normals.emplace_back(this->Shape.axes.col(k));
    }
    std::optional<SymmetryPlane> best;
    for (const Point3& normal : normals)
    {
      const SymmetryPlane plane = this->refined(normal);
      if (plane.error < tolerance && (!best || plane.error < best->error) &&
        !this->liesIn(plane, tolerance))
      {
        best = plane;
      }
    }
    return best;
  }

private:
  /// A surface that is flat in a plane is its image there, whatever its shape.
  bool liesIn(const SymmetryPlane& plane, double tolerance) const
  {
    double sum = 0.0;
    for (Index v : this->Samples)
    {
      sum += std::abs(plane.side(this->Mesh.point(v)));
    }
    return sum < tolerance * this->Size * static_cast<double>(this->Samples.size());
  }

  SymmetryPlane refined(const Point3& normal) const
  {
    std::vector<ClosestPoint> closest;
    SymmetryPlane best = this->measured({ normal, normal.dot(this->Shape.center), 0.0 }, closest);
    SymmetryPlane plane = best;
    for (int step = 0; step < mostPlaneRefinements && best.error > exactly; ++step)
    {
      plane = this->measured(this->step(plane, closest), closest);
      if (plane.error < best.error)
      {
        best = plane;
      }
    }
    return best;
  }

  /// \param closest becomes by sample what is nearest to its image
  SymmetryPlane measured(SymmetryPlane plane, std::vector<ClosestPoint>& closest) const
  {
    plane.error = 0.0;
    closest.clear();
    for (Index v : this->Samples)
    {
      closest.push_back(this->Locator.closest(plane.mirrored(this->Mesh.point(v))));
      plane.error += closest.back().distance;
    }
    plane.error /= static_cast<double>(this->Samples.size()) * this->Size;
    return plane;
  }

  /// Gauss-Newton on the distances of mirrored points from the triangles' planes, over a turn of
  /// the normal about two axes across it and a shift.
  SymmetryPlane step(const SymmetryPlane& plane, const std::vector<ClosestPoint>& closest) const
  {
    const Point3 first = plane.normal.unitOrthogonal();
    const Point3 second = plane.normal.cross(first);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < this->Samples.size(); ++k)
    {
      const Point3& p = this->Mesh.point(this->Samples[k]);
      const Point3 image = plane.mirrored(p);
      const Point3 across = triangleNormal(this->Mesh, closest[k].triangle);
      const double side = plane.side(p);
      const Eigen::Vector3d slope(
        across.dot(-2.0 * (first.dot(p - this->Shape.center) * plane.normal + side * first)),
        across.dot(-2.0 * (second.dot(p - this->Shape.center) * plane.normal + side * second)),
        across.dot(2.0 * plane.normal) * this->Size);
      const double miss = across.dot(image - closest[k].position);
      matrix += slope * slope.transpose();
      right -= miss * slope;
    }
    matrix.diagonal().array() += 1e-12 * matrix.trace();
    const Eigen::Vector3d move = matrix.ldlt().solve(right);
    SymmetryPlane result;
    result.normal = (plane.normal + move[0] * first + move[1] * second).normalized();
    // The turn is about the centre.
    result.offset = plane.offset - plane.normal.dot(this->Shape.center) +
      result.normal.dot(this->Shape.center) + move[2] * this->Size;
    return result;
  }

  const TriangleMesh& Mesh;
  SurfaceLocator Locator;
  SurfaceMoments Shape;
  double Size;
  Indices Samples;
};
}

SurfaceMoments momentsOf(const TriangleMesh& mesh)
{
  SurfaceMoments moments;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const double area = mesh.area(t);
    for (int k = 0; k < 3; ++k)
    {
      // The edges' middles integrate polynomials of degree 2 exactly.
      const Point3 middle =
        0.5 * (mesh.point(mesh.triangle(t)[k]) + mesh.point(mesh.triangle(t)[(k + 1) % 3]));
      moments.center += area / 3.0 * middle;
      second += area / 3.0 * middle * middle.transpose();
    }
    moments.area += area;
  }
  moments.center /= moments.area;
  second = second / moments.area - moments.center * moments.center.transpose();
  moments.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  return moments;
}

SymmetryPlane flattestPlane(const TriangleMesh& mesh)
{
  const SurfaceMoments moments = momentsOf(mesh);
  const Point3 normal = moments.axes.col(0);
  return { normal, normal.dot(moments.center), 0.0 };
}

std::optional<SymmetryPlane> findSymmetryPlane(const TriangleMesh& mesh, double tolerance)
{
  return Fitting(mesh).run(tolerance);
}
}
