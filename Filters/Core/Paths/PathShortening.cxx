// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathShortening.h"

#include "Paths/PathPoints.h"
#include "Paths/PointDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// The path is relaxed in 2, 4 and 8 parts while each has this many points.
constexpr std::size_t fewestPoints = 8;
constexpr int mostRelaxations = 6;
/// Rounds that gain less are not worth their time.
constexpr double leastShortening = 1e-6;

/// A path is moved at the points between so many parts of it; more where sections between these do
/// not arrive or are longer, as between far points of a roll.
constexpr std::array<std::size_t, 4> partsOfPath{ 8, 16, 32, 64 };
/// How many times as far as the development says it may be moved.
constexpr double mostTimes = 128.0;

/// Sections from point to point; not arrived where one of them does not, or they come to be longer
/// than the limit.
SurfacePath joined(const TriangleMesh& mesh, const SnapDistance& snap,
  const std::vector<SurfacePoint>& points, double limit)
{
  SurfacePath path;
  double length = 0.0;
  path.points = { points.front() };
  for (const SurfacePoint& point : points)
  {
    if (!samePlace(point, path.points.back()))
    {
      const SurfacePath section =
        traceSegment(mesh, snap, path.points.back(), point, limit - length);
      if (!section.arrived)
      {
        return {};
      }
      length += lengthOf(section);
      append(path, section);
    }
  }
  path.arrived = path.points.size() > 1;
  return path;
}

/// Points of the path at equal parts of its length, or half-way between these, and its ends.
std::vector<SurfacePoint> pointsAtParts(
  const SurfacePath& path, double length, std::size_t parts, bool between)
{
  std::vector<SurfacePoint> points{ path.points.front() };
  double done = 0.0;
  double next = (between ? 0.5 : 1.0) / static_cast<double>(parts);
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
  {
    done += (path.points[i].position - path.points[i - 1].position).norm();
    if (done >= next * length && next <= 1.0 - 1e-9)
    {
      points.push_back(path.points[i]);
      next += 1.0 / static_cast<double>(parts);
    }
  }
  points.push_back(path.points.back());
  return points;
}

/// A direction of a triangle's plane and where it starts.
struct Ray
{
  Index triangle = none;
  Index entry = none; ///< the half-edge of the triangle that the start lies on, if any
  Point3 start;
  Point3 direction; ///< of length 1
};

Point3 edgeDirection(const TriangleMesh& mesh, Index h)
{
  return (mesh.point(mesh.to(h)) - mesh.point(mesh.from(h))).normalized();
}

/// Straight on in the triangle on the other side of a half-edge.
void turnOver(const TriangleMesh& mesh, Index h, Ray& ray)
{
  const Point3 along = edgeDirection(mesh, h);
  const double part = std::clamp(ray.direction.dot(along), -1.0, 1.0);
  ray.entry = mesh.twin(h);
  ray.triangle = ray.entry / 3;
  const Point3 inwards = triangleNormal(mesh, ray.triangle).cross(-along);
  ray.direction = (part * along + std::sqrt(1.0 - part * part) * inwards).normalized();
}

SurfacePoint pointInTriangle(const TriangleMesh& mesh, Index triangle, const Point3& position)
{
  const Triangle& c = mesh.triangle(triangle);
  const Point3 normal = triangleNormal(mesh, triangle);
  std::array<double, 3> weights{};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point3& a = mesh.point(c[(k + 1) % 3]);
    const Point3& b = mesh.point(c[(k + 2) % 3]);
    weights[k] = std::max(areaVector(position, a, b).dot(normal), 0.0);
    sum += weights[k];
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return pointOf(mesh, triangle, weights);
}

/// The point at the end of a straight walk; on the boundary where it would leave the surface.
SurfacePoint walk(const TriangleMesh& mesh, Ray ray, double distance)
{
  for (Index step = 0; step < mesh.triangleCount(); ++step)
  {
    const Point3 normal = triangleNormal(mesh, ray.triangle);
    Index exit = none;
    double least = std::numeric_limits<double>::infinity();
    for (Index h = 3 * ray.triangle; h < 3 * ray.triangle + 3; ++h)
    {
      const Point3& from = mesh.point(mesh.from(h));
      const Point3 inwards = normal.cross(edgeDirection(mesh, h));
      const double speed = -ray.direction.dot(inwards);
      if (h != ray.entry && speed > 0.0)
      {
        const double ahead = std::max((ray.start - from).dot(inwards), 0.0);
        if (ahead < least * speed)
        {
          least = ahead / speed;
          exit = h;
        }
      }
    }
    if (exit == none || least >= distance || mesh.twin(exit) == none)
    {
      return pointInTriangle(mesh, ray.triangle,
        ray.start + (exit == none ? 0.0 : std::min(least, distance)) * ray.direction);
    }
    ray.start += least * ray.direction;
    distance -= least;
    turnOver(mesh, exit, ray);
  }
  return pointInTriangle(mesh, ray.triangle, ray.start);
}

/// A path in the plane, seen from its chord.
class Development
{
public:
  Development(const TriangleMesh& mesh, const SurfacePath& path)
    : Mesh(mesh)
    , Path(path)
  {
    double heading = 0.0;
    Point2 place = Point2::Zero();
    this->Places.push_back(place);
    this->Lengths.push_back(0.0);
    for (std::size_t i = 0; i < path.triangles.size(); ++i)
    {
      const Point3 way = path.points[i + 1].position - path.points[i].position;
      heading += i > 0 ? this->turnAt(i) : 0.0;
      place += way.norm() * Point2(std::cos(heading), std::sin(heading));
      this->Headings.push_back(heading);
      this->Places.push_back(place);
      this->Lengths.push_back(this->Lengths.back() + way.norm());
    }
    this->Chord = std::atan2(place.y(), place.x());
  }

  /// How far a point lies on the left of the chord.
  double offset(std::size_t i) const
  {
    const Point2& place = this->Places[i];
    return std::cos(this->Chord) * place.y() - std::sin(this->Chord) * place.x();
  }

  /// Points of the path between so many equal parts of its length, each once.
  std::vector<std::size_t> stations(std::size_t count) const
  {
    std::vector<std::size_t> found;
    for (std::size_t k = 1; k < count; ++k)
    {
      const double length =
        this->Lengths.back() * static_cast<double>(k) / static_cast<double>(count);
      const auto i = static_cast<std::size_t>(
        std::lower_bound(this->Lengths.begin(), this->Lengths.end(), length) -
        this->Lengths.begin());
      if (i > 0 && i < this->Path.triangles.size() && (found.empty() || found.back() < i))
      {
        found.push_back(i);
      }
    }
    return found;
  }

  /// Where a point comes to that goes so many times the way to the chord.
  SurfacePoint moved(std::size_t i, double times) const
  {
    const SurfacePoint& point = this->Path.points[i];
    const Point3 along = this->Path.points[i + 1].position - point.position;
    if (!(along.norm() > 0.0))
    {
      return point;
    }
    const double offset = this->offset(i);
    const PointDirections around(this->Mesh, point);
    const double ahead = around.angleTo(this->Path.triangles[i], this->Path.points[i + 1].position);
    const SurfaceDirection aside =
      around.at(ahead + this->Chord + (offset > 0.0 ? -0.5 : 0.5) * pi - this->Headings[i]);
    if (aside.triangle == none)
    {
      return point;
    }
    const Ray ray{ aside.triangle, this->edgeIn(point, aside.triangle), point.position,
      aside.vector };
    return walk(this->Mesh, ray, times * std::abs(offset));
  }

private:
  /// To the left, in the plane; at a vertex by as much as its sharper side is below pi.
  double turnAt(std::size_t i) const
  {
    const SurfacePoint& point = this->Path.points[i];
    const PointDirections around(this->Mesh, point);
    const double back =
      around.angleTo(this->Path.triangles[i - 1], this->Path.points[i - 1].position);
    const double ahead = around.angleTo(this->Path.triangles[i], this->Path.points[i + 1].position);
    const double outside = around.atBoundary() ? 2.0 * pi : around.total();
    const double left = back >= ahead ? back - ahead : outside + back - ahead;
    const double right = ahead >= back ? ahead - back : outside + ahead - back;
    const double sharper = std::max(pi - std::min(left, right), 0.0);
    return left <= right ? sharper : -sharper;
  }

  /// The half-edge of the triangle that a point lies on; none where it is no point of an edge.
  Index edgeIn(const SurfacePoint& point, Index triangle) const
  {
    return point.type != SurfacePointType::Edge ? none
      : point.id / 3 == triangle                ? point.id
                                                : this->Mesh.twin(point.id);
  }

  const TriangleMesh& Mesh;
  const SurfacePath& Path;
  Points2 Places;
  std::vector<double> Lengths;  ///< up to each point
  std::vector<double> Headings; ///< after each point
  double Chord = 0.0;           ///< its direction
};
}

SurfacePath relaxed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path)
{
  double length = lengthOf(path);
  for (const std::size_t parts : { 2, 4, 8 })
  {
    int idle = 0;
    const double before = length;
    for (int round = 0; round < mostRelaxations && idle < 2; ++round)
    {
      if (path.points.size() < parts * fewestPoints)
      {
        return path;
      }
      SurfacePath next =
        joined(mesh, snap, pointsAtParts(path, length, parts, round % 2 == 1), length);
      const double nextLength = lengthOf(next);
      const bool gained = next.arrived && nextLength < (1.0 - leastShortening) * length;
      idle = gained ? 0 : idle + 1;
      if (gained)
      {
        path = std::move(next);
        length = nextLength;
      }
    }
    if (length == before)
    {
      break;
    }
  }
  return path;
}

SurfacePath developed(const TriangleMesh& mesh, const SnapDistance& snap, SurfacePath path)
{
  const Development development(mesh, path);
  double length = lengthOf(path);
  SurfacePath found;
  for (std::size_t k = 0; k < partsOfPath.size() && !found.arrived; ++k)
  {
    const std::vector<std::size_t> stations = development.stations(partsOfPath[k]);
    // Farther, as long as it gets shorter: down from a hill it is far, and begins slowly.
    for (double times = 1.0; times <= mostTimes; times *= 2.0)
    {
      std::vector<SurfacePoint> points{ path.points.front() };
      for (const std::size_t i : stations)
      {
        points.push_back(development.moved(i, times));
      }
      points.push_back(path.points.back());
      SurfacePath next = joined(mesh, snap, points, length);
      const double nextLength = lengthOf(next);
      if (!next.arrived || !(nextLength < length))
      {
        break;
      }
      found = std::move(next);
      length = nextLength;
    }
  }
  return found.arrived ? found : path;
}
}
