// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SymmetryPlane.h"

#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>

namespace flattening
{
namespace
{
/// Gauss-Newton converges in fewer where there is a plane.
constexpr int maxPlaneRefinements = 10;
/// About this many vertices are mirrored: enough for a mean.
constexpr Index vertexSamples = 500;
/// Mirrored vertices that are this near, in sqrt(area / pi), are exact but for rounding.
constexpr double exactly = 1e-12;

/// Of the squared length of a curve, that of its width below which it tells no plane.
constexpr double straight = 1e-4;

/// The normal and the offset of a plane; empty where the text is none.
std::vector<double> numbersOfPlane(const std::string& text)
{
  std::string rest = text;
  std::vector<double> numbers;
  const std::size_t axis = text.empty() ? std::string::npos : std::string("xyz").find(text[0]);
  if (axis != std::string::npos)
  {
    numbers.assign(3, 0.0);
    numbers[axis] = 1.0;
    rest = text.size() == 1 ? "=0" : text.substr(1);
    if (rest[0] != '=')
    {
      return {};
    }
    rest.erase(0, 1);
  }
  for (std::istringstream stream(rest); numbers.size() < 5 && stream.good();)
  {
    stream.imbue(std::locale::classic());
    double number = 0.0;
    char comma = ',';
    stream >> number;
    if (stream.fail() || (!(stream >> comma).eof() && comma != ','))
    {
      return {};
    }
    numbers.push_back(number);
  }
  return numbers.size() == 4 ? numbers : std::vector<double>();
}

SymmetryPlane planeOf(const Polyline& curve, const TriangleMesh& mesh)
{
  Point3 center = Point3::Zero();
  for (const Point3& point : curve.points)
  {
    center += point / static_cast<double>(curve.points.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point3& point : curve.points)
  {
    spread += (point - center) * (point - center).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  SymmetryPlane plane;
  plane.normal = axes.eigenvectors().col(0);
  if (axes.eigenvalues()[1] < straight * axes.eigenvalues()[2])
  {
    const SurfaceLocator locator(mesh);
    Point3 normal = Point3::Zero();
    for (const Point3& point : curve.points)
    {
      normal += triangleNormal(mesh, locator.closest(point).triangle);
    }
    const Point3 across = normal.cross(axes.eigenvectors().col(2));
    plane.normal = across.norm() > 0.0 ? across.normalized() : plane.normal;
  }
  plane.offset = plane.normal.dot(center);
  return plane;
}

class Fitting
{
public:
  explicit Fitting(const TriangleMesh& mesh)
    : Fitting(mesh, mesh)
  {
  }
  /// \param other surface that the images are near to
  Fitting(const TriangleMesh& mesh, const TriangleMesh& other)
    : Mesh(mesh)
    , Other(other)
    , Locator(other)
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

  SymmetryPlane measured(const SymmetryPlane& plane) const
  {
    std::vector<ClosestPoint> closest;
    return this->measured(plane, closest);
  }

  std::optional<SymmetryPlane> run(double tolerance) const
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
      if (plane.spread < tolerance && (!best || plane.error < best->error) &&
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
    for (int step = 0; step < maxPlaneRefinements && best.error > exactly; ++step)
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
    std::vector<double> distances;
    plane.error = 0.0;
    closest.clear();
    for (Index v : this->Samples)
    {
      closest.push_back(this->Locator.closest(plane.mirrored(this->Mesh.point(v))));
      plane.error += closest.back().distance;
      distances.push_back(closest.back().distance / this->Size);
    }
    const auto most = distances.begin() + static_cast<std::ptrdiff_t>(0.95 * distances.size());
    std::nth_element(distances.begin(), most, distances.end());
    plane.spread = *most;
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
      const Point3 across = triangleNormal(this->Other, closest[k].triangle);
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
  const TriangleMesh& Other;
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

SymmetryPlane measuredPlane(const TriangleMesh& mesh, const SymmetryPlane& plane)
{
  return measuredPlane(mesh, mesh, plane);
}

SymmetryPlane measuredPlane(
  const TriangleMesh& mesh, const TriangleMesh& other, const SymmetryPlane& plane)
{
  return Fitting(mesh, other).measured(plane);
}

Point3 frontOf(const TriangleMesh& mesh)
{
  constexpr double minAlong = 0.9; // else it is the symmetry of front and back, or of both ends
  Eigen::AlignedBox3d box;
  for (const Point3& point : mesh.points())
  {
    box.extend(point);
  }
  const Point3 sides = box.sizes();
  const Eigen::Index up = upAxisOf(sides);
  const Eigen::Index level = 3 - up;
  const Point3 front = Point3::Unit(sides.x() >= sides[level] ? level : 0);
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(mesh);
  const Point3 along = plane ? Point3(Point3::Unit(up).cross(plane->normal)) : Point3::Zero();
  return std::abs(along.dot(front)) > minAlong ? along.normalized() : front;
}

Status readSymmetry(const std::string& text, const TriangleMesh& mesh,
  const std::vector<Polyline>& curves, SymmetryChoice& choice)
{
  const std::map<std::string, SymmetryChoice::Kind> words{ { "off", SymmetryChoice::Off },
    { "on", SymmetryChoice::Found }, { "force", SymmetryChoice::Forced } };
  if (words.count(text) > 0)
  {
    choice.kind = words.at(text);
    return {};
  }
  choice.kind = SymmetryChoice::Stated;
  const auto curve = std::find_if(
    curves.begin(), curves.end(), [&](const Polyline& one) { return one.name == text; });
  if (curve != curves.end())
  {
    choice.plane = planeOf(*curve, mesh);
    return {};
  }
  const std::vector<double> numbers = numbersOfPlane(text);
  const Point3 normal =
    numbers.empty() ? Point3::Zero() : Point3(numbers[0], numbers[1], numbers[2]);
  const double length = normal.norm();
  if (numbers.empty() || !std::isfinite(length) || length == 0.0 || !std::isfinite(numbers[3]))
  {
    return { StatusCode::InvalidOption,
      "the symmetry is \"" + text + "\", which is neither a curve's name nor a plane", {},
      { { Remedy::Give,
        "on, off, force, the name of a curve, or a plane as x, y=0.5 or 1,0,0,0.2" } } };
  }
  choice.plane.normal = normal / length;
  choice.plane.offset = numbers[3] / length;
  return {};
}
}
