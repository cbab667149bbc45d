// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SearchedPiece.h"

#include "Paths/StraightPath.h"
#include "Surface/SurfacePoint.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Mean distance of mirrored vertices, in sqrt(area / pi), up to which a piece is its own image.
constexpr double ownImage = 1e-2;
/// How far darts inside stay from the boundary, in sqrt(area / pi).
constexpr double clearOfBoundary = 0.3;

/// From where on both sides the direction of the boundary is seen, in sqrt(area / pi).
constexpr double edgeSeenFrom = 0.05;
/// More slanted darts cost no more.
constexpr double minSine = 0.5;
}

SearchedPiece::SearchedPiece(TriangleMesh mesh, std::vector<char> barred,
  std::vector<double> preference, std::vector<double> weight,
  const std::optional<SurfaceMirror>& mirror)
  : Mesh(std::move(mesh))
  , Barred(std::move(barred))
  , Preference(std::move(preference))
  , Weight(std::move(weight))
  , Area(this->Mesh.area())
  , Size(std::sqrt(this->Area / pi))
  , Ruler(this->Mesh)
  , Locator(this->Mesh)
  , Graph(this->Mesh)
  , Snap(this->Mesh, ImprintOptions().snap)
  , Mirror(mirror)
{
  if (this->Mirror)
  {
    this->findMirrorVertices();
  }
}

void SearchedPiece::findMirrorVertices()
{
  double sum = 0.0;
  double worst = 0.0;
  for (Index v = 0; v < this->Mesh.vertexCount(); ++v)
  {
    const ClosestPoint closest = this->Locator.closest(this->Mirror->mirrored(this->Mesh.point(v)));
    const auto heaviest = std::max_element(closest.weights.begin(), closest.weights.end());
    this->MirrorVertex.push_back(
      this->Mesh.triangle(closest.triangle)[heaviest - closest.weights.begin()]);
    sum += closest.distance;
    worst = std::max(worst, closest.distance);
  }
  // Vertices may have their images among them, and triangles not.
  for (Index h = 0; h < this->Mesh.halfedgeCount() && worst < SurfaceMirror::exact * this->Size;
       ++h)
  {
    const Point3 middle =
      0.5 * (this->Mesh.point(this->Mesh.from(h)) + this->Mesh.point(this->Mesh.to(h)));
    worst = std::max(worst, this->Locator.closest(this->Mirror->mirrored(middle)).distance);
  }
  // Images by an intrinsic mirror lie on the surface whatever it is worth.
  const IntrinsicMirror* const intrinsic = this->Mirror->intrinsic();
  this->Mirror->error = std::max(worst / this->Size, intrinsic ? intrinsic->error() : 0.0);
  if (sum > ownImage * this->Size * this->Mesh.vertexCount())
  {
    this->Mirror.reset();
  }
}

bool SearchedPiece::mirrorIsExact() const
{
  return this->Mirror && this->Mirror->error < SurfaceMirror::exact;
}

double SearchedPiece::endpointPreference(const BoundaryPlace& place) const
{
  return this->Preference.empty() ? 1.0 : this->Preference[this->Ruler.vertex(place)];
}

Point3 SearchedPiece::normalNear(const Point3& point) const
{
  return triangleNormal(this->Mesh, this->Locator.closest(point).triangle);
}

bool SearchedPiece::takesInnerTip(const Point3& point) const
{
  const Point3 edge = this->Ruler.point(this->Ruler.nearest(point, point));
  return (point - edge).norm() > clearOfBoundary * this->Size;
}

Point3 SearchedPiece::endOf(const CutPlan& plan) const
{
  if (plan.type == CurveType::Dart)
  {
    return plan.tip;
  }
  return this->Ruler.point(plan.role == MirrorRole::Across ? this->mirrored(plan.base) : plan.end);
}

BoundaryPlace SearchedPiece::mirrored(const BoundaryPlace& place) const
{
  return this->Ruler.nearest(this->Mirror->mirrored(this->Ruler.point(place)),
    this->Mirror->mirrored(this->Ruler.inside(place)));
}

SurfacePoint SearchedPiece::surfacePoint(const Point3& point) const
{
  return snapToMesh(this->Mesh, this->Snap, this->Locator.closest(point));
}

Points3 SearchedPiece::straightLine(
  const SurfacePoint& from, const std::optional<SurfacePoint>& via, const SurfacePoint& to) const
{
  if (via)
  {
    Points3 points = this->straightLine(from, {}, *via);
    const Points3 rest = this->straightLine(*via, {}, to);
    if (points.empty() || rest.empty())
    {
      return {};
    }
    points.insert(points.end(), rest.begin() + 1, rest.end());
    return points;
  }
  const StraightPath straight = straightPath(this->Graph, from, to);
  return straight.status.refused() ? Points3{} : positionsOf(straight.path.points);
}

std::vector<Polyline> SearchedPiece::polylines(const CutPlan& plan) const
{
  const BoundaryPlace end = plan.role == MirrorRole::Across ? this->mirrored(plan.base) : plan.end;
  std::vector<Polyline> lines(plan.role == MirrorRole::Pair ? 2 : 1);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const auto inside = [&](const Point3& point) {
      return this->surfacePoint(k == 0 ? point : this->Mirror->mirrored(point));
    };
    const auto onEdge = [&](const BoundaryPlace& place) {
      return this->Ruler.surfacePoint(k == 0 ? place : this->mirrored(place));
    };
    lines[k].type = plan.type;
    lines[k].points = k > 0 && this->mirrorIsExact()
      ? this->Mirror->mirrored(lines[0].points)
      : this->straightLine(plan.start ? inside(*plan.start) : onEdge(plan.base),
          plan.via ? std::optional(inside(*plan.via)) : std::nullopt,
          plan.type == CurveType::Dart ? inside(plan.tip) : onEdge(end));
    if (lines[k].points.size() < 2)
    {
      return {};
    }
  }
  return lines;
}

/// 1 for a dart across its edge, more where it runs along that: legs that meet it at unequal angles
/// are sewn badly.
double SearchedPiece::slant(const CutPlan& plan) const
{
  const double step = edgeSeenFrom * this->Size;
  const Point3 edge = this->Ruler.point(this->Ruler.moved(plan.base, step)) -
    this->Ruler.point(this->Ruler.moved(plan.base, -step));
  const Point3 ahead = plan.tip - this->Ruler.point(plan.base);
  const double most = edge.norm() * ahead.norm();
  const double across = edge.cross(ahead).norm();
  return across > minSine * most ? most / across : 1.0 / minSine;
}

double SearchedPiece::price(const CutPlan& plan, double length, const SearchOptions& options) const
{
  const double fixed =
    (plan.role == MirrorRole::Pair ? 2.0 : 1.0) * options.fixedPrice * this->Size;
  double preference = plan.start ? 1.0 : this->endpointPreference(plan.base);
  if (plan.type == CurveType::Seam)
  {
    preference = std::sqrt(preference * this->endpointPreference(plan.end));
  }
  return (fixed + length) *
    (plan.type == CurveType::Dart && !plan.start ? this->slant(plan) : 1.0) / preference;
}
}
