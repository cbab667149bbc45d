// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/FlatteningQuality.h"

#include "Base/Types.h"
#include "Quality/StrainMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Angles of a triangle in the plane, whichever way it turns.
std::array<double, 3> cornerAngles(const Point2& a, const Point2& b, const Point2& c)
{
  // Edge k lies opposite to corner k.
  const std::array<Point2, 3> edge{ c - b, a - c, b - a };
  const auto angle = [&edge](int k) {
    const Point2& u = edge[(k + 1) % 3];
    const Point2& v = edge[(k + 2) % 3];
    return std::atan2(std::abs(cross(u, v)), -u.dot(v));
  };
  // The largest angle, of pi / 3 or more, loses nothing as what the others leave of pi.
  int largest = edge[1].squaredNorm() > edge[0].squaredNorm() ? 1 : 0;
  largest = edge[2].squaredNorm() > edge[largest].squaredNorm() ? 2 : largest;
  const int next = (largest + 1) % 3;
  const int last = (largest + 2) % 3;
  std::array<double, 3> angles{};
  angles[next] = angle(next);
  angles[last] = angle(last);
  const bool collapsed = !(angles[next] > 0.0 && angles[last] > 0.0);
  angles[largest] = collapsed ? angle(largest) : pi - angles[next] - angles[last];
  return angles;
}

/// Without the angles.
TriangleQuality measureStretch(
  const Triangle& corner, const TriangleFrame& frame, const Points2& positions)
{
  std::array<Complex, 3> image;
  for (int k = 0; k < 3; ++k)
  {
    image[k] = Complex(positions[corner[k]].x(), positions[corner[k]].y());
  }

  TriangleQuality quality;
  quality.largeStretch =
    std::sqrt(std::norm(frame.alpha(image))) + std::sqrt(std::norm(frame.beta(image)));
  if (frame.area > 0.0 && quality.largeStretch > 0.0)
  {
    quality.areaRatio =
      0.5 * (std::conj(image[1] - image[0]) * (image[2] - image[0])).imag() / frame.area;
    // |alpha| - |beta| would lose all digits of a collapsed triangle.
    quality.smallStretch = quality.areaRatio / quality.largeStretch;
    quality.aspectRatio = quality.smallStretch / quality.largeStretch;
  }
  if (quality.areaRatio > 0.0)
  {
    quality.homogeneity = quality.areaRatio < 1.0 ? quality.areaRatio : 1.0 / quality.areaRatio;
  }
  return quality;
}

TriangleQuality measureTriangle(
  const TriangleMesh& mesh, const SurfaceMeasures& surface, const Points2& positions, Index t)
{
  const Triangle& corner = mesh.triangle(t);
  TriangleQuality quality = measureStretch(corner, surface.frames[t], positions);
  const std::array<double, 3> flat =
    cornerAngles(positions[corner[0]], positions[corner[1]], positions[corner[2]]);
  for (int k = 0; k < 3; ++k)
  {
    const double angle = surface.angles[3 * t + k];
    quality.angleError += angle > 0.0 ? std::abs(flat[k] - angle) / angle / 3.0 : 0.0;
  }
  return quality;
}

/// E_h of the least and the greatest ratio of areas.
double homogeneityOf(double smallestArea, double largestArea)
{
  // Where all triangles are turned over there is no positive ratio to divide by.
  const double scale = largestArea > 0.0 ? largestArea : std::abs(smallestArea);
  return scale > 0.0 ? smallestArea / scale : 0.0;
}

void summarizeTriangles(const TriangleFrames& frames, const std::vector<TriangleQuality>& triangles,
  QualitySummary& summary)
{
  double smallestArea = std::numeric_limits<double>::max();
  double largestArea = std::numeric_limits<double>::lowest();
  double smallestStretch = std::numeric_limits<double>::max();
  double largestStretch = 0.0;
  double area = 0.0;
  double change = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const TriangleQuality& q = triangles[t];
    smallestArea = std::min(smallestArea, q.areaRatio);
    largestArea = std::max(largestArea, q.areaRatio);
    smallestStretch = std::min(smallestStretch, q.smallStretch);
    largestStretch = std::max(largestStretch, q.largeStretch);
    const double a = frames[t].area;
    area += a;
    change += a * std::abs(q.areaRatio - 1.0);
    summary.angleError += q.angleError;
    if (!(q.areaRatio > 0.0))
    {
      summary.flipped.push_back(static_cast<Index>(t));
    }
  }
  summary.angleError /= static_cast<double>(std::max<std::size_t>(triangles.size(), 1));
  if (area > 0.0)
  {
    summary.areaError = change / area;
  }
  if (largestStretch > 0.0)
  {
    summary.globalHomogeneity = homogeneityOf(smallestArea, largestArea);
    summary.globalAspectRatio = smallestStretch / largestStretch;
  }
  const StrainMeasures strain = measureStrain(frames, triangles);
  summary.strainP95 = strain.quantile;
  summary.rigidEnergy = strain.rigidEnergy;
}
}

double roundingOfLength(const Point2& a, const Point2& b)
{
  // Half a unit in the last place at both ends.
  return std::numeric_limits<double>::epsilon() * std::max(a.norm(), b.norm());
}

EdgeLengthError edgeLengthError(
  const TriangleMesh& mesh, const Points2& positions, Index a, Index b)
{
  const double length = (mesh.point(b) - mesh.point(a)).norm();
  if (!(length > 0.0))
  {
    return {};
  }
  const double flat = (positions[b] - positions[a]).norm();
  const double error = std::abs(flat - length) / length;
  return { error, std::max(error - roundingOfLength(positions[a], positions[b]) / length, 0.0) };
}

SurfaceMeasures measureSurface(const TriangleMesh& mesh, const Execution& execution)
{
  SurfaceMeasures measures;
  measures.angles = cornerAngles(mesh, execution);
  measures.frames.resize(mesh.triangleCount());
  execution.forEach(mesh.triangleCount(),
    [&](Index t) { measures.frames[t] = TriangleFrame(mesh.points(), mesh.triangle(t)); });
  return measures;
}

FlatteningQuality measureFlattening(const TriangleMesh& mesh, const Points2& positions,
  const Indices& edges, const Execution& execution)
{
  return measureFlattening(mesh, measureSurface(mesh, execution), positions, edges, execution);
}

FlatteningQuality measureFlattening(const TriangleMesh& mesh, const SurfaceMeasures& surface,
  const Points2& positions, const Indices& edges, const Execution& execution)
{
  FlatteningQuality quality;
  quality.triangles.resize(mesh.triangleCount());
  execution.forEach(mesh.triangleCount(),
    [&](Index t) { quality.triangles[t] = measureTriangle(mesh, surface, positions, t); });
  // Sums in the order of the triangles do not depend on the threads.
  summarizeTriangles(surface.frames, quality.triangles, quality.summary);
  const auto lengthError = [&](Index h) {
    return edgeLengthError(mesh, positions, mesh.from(h), mesh.to(h));
  };
  QualitySummary& summary = quality.summary;
  for (Index h : edges)
  {
    const EdgeLengthError error = lengthError(h);
    summary.edgeLengthError += error.measured;
    summary.maximumEdgeLengthError = std::max(summary.maximumEdgeLengthError, error.measured);
    summary.resolvedEdgeLengthError = std::max(summary.resolvedEdgeLengthError, error.resolved);
  }
  summary.edgeLengthError /= static_cast<double>(std::max<std::size_t>(edges.size(), 1));
  Index count = 0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) < h) // none is, too
    {
      summary.edgeLengthErrorAll += lengthError(h).measured;
      ++count;
    }
  }
  summary.edgeLengthErrorAll /= std::max<Index>(count, 1);
  return quality;
}

MapDistortion measureDistortion(
  const TriangleMesh& mesh, const Points2& positions, const Execution& execution)
{
  TriangleFrames frames(mesh.triangleCount());
  std::vector<TriangleQuality> triangles(mesh.triangleCount());
  execution.forEach(mesh.triangleCount(), [&](Index t) {
    frames[t] = TriangleFrame(mesh.points(), mesh.triangle(t));
    triangles[t] = measureStretch(mesh.triangle(t), frames[t], positions);
  });
  MapDistortion distortion;
  const auto [least, most] = std::minmax_element(triangles.begin(), triangles.end(),
    [](const TriangleQuality& a, const TriangleQuality& b) { return a.areaRatio < b.areaRatio; });
  if (least != triangles.end())
  {
    distortion.globalHomogeneity = homogeneityOf(least->areaRatio, most->areaRatio);
  }
  distortion.rigidEnergy = measureRigidEnergy(frames, triangles);
  return distortion;
}

Index countFlipped(const TriangleMesh& mesh, const Points2& positions)
{
  Index count = 0;
  for (const Triangle& c : mesh.triangles())
  {
    count += cross(positions, c) > 0.0 ? 0 : 1;
  }
  return count;
}

namespace
{
using Place = std::array<double, 3>;

struct BoundaryEdge
{
  std::array<Place, 2> ends; ///< in ascending order
  double length = 0.0;
};

Place placeOf(const TriangleMesh& mesh, Index vertex)
{
  const Point3& p = mesh.point(vertex);
  // -0 and 0 are one place.
  return { p.x() + 0.0, p.y() + 0.0, p.z() + 0.0 };
}
}

double cutLength(const TriangleMesh& mesh)
{
  std::vector<BoundaryEdge> edges;
  for (const Indices& loop : mesh.boundaryLoops())
  {
    for (Index h : loop)
    {
      BoundaryEdge edge{ { placeOf(mesh, mesh.from(h)), placeOf(mesh, mesh.to(h)) },
        mesh.length(h) };
      std::sort(edge.ends.begin(), edge.ends.end());
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const BoundaryEdge& a, const BoundaryEdge& b) { return a.ends < b.ends; });
  double length = 0.0;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].ends == edges[begin].ends)
    {
      ++end;
    }
    length += end - begin > 1 ? edges[begin].length : 0.0;
  }
  return length;
}

std::vector<double> cornerAngles(const TriangleMesh& mesh, const Execution& execution)
{
  std::vector<double> angles(mesh.halfedgeCount());
  execution.forEach(mesh.halfedgeCount(), [&](Index h) { angles[h] = mesh.angle(h); });
  return angles;
}

std::vector<double> surfaceDevelopability(
  const TriangleMesh& mesh, const std::vector<double>& angles)
{
  std::vector<double> sum(mesh.vertexCount(), 0.0);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    sum[mesh.from(h)] += angles[h];
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const bool inside = mesh.outgoing(v) != none && !mesh.onBoundary(v);
    sum[v] = inside ? std::abs(sum[v] - 2.0 * pi) : 0.0;
  }
  return sum;
}
}
