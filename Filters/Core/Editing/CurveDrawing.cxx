// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/CurveDrawing.h"

#include "Base/Memory.h"
#include "Paths/PathPoints.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"
#include "Paths/SurfaceSpline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
constexpr double imageReach = 0.05; ///< of the box around the boundary

/// The nearest of the places offered.
struct NearestPlace
{
  explicit NearestPlace(const Point3& to)
    : point(to)
  {
  }

  void offer(const Point3& a, const Point3& b)
  {
    const Point3 candidate = a + fractionAlong(a, b, point) * (b - a);
    if ((point - candidate).norm() < distance)
    {
      distance = (point - candidate).norm();
      place = candidate;
    }
  }
  void offer(const Points3& line)
  {
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      this->offer(line[k - 1], line[k]);
    }
  }

  Point3 point;
  Point3 place = Point3::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

DrawnSegment drawSection(
  const DrawingSurface& surface, const SurfacePoint& from, const SurfacePoint& to)
{
  DrawnSegment result;
  result.path = traceSegment(surface.mesh(), surface.snap(), from, to);
  if (!result.path.arrived)
  {
    result.status = { StatusCode::CurveLeavesSurface,
      "no plane section joins two nodes: it meets the boundary or a fold", {},
      { Remedy::RedrawCurve } };
  }
  return result;
}

/// Whether a curve is drawn as a measuring tape, where there is such a section.
bool isTape(const EditedCurve& curve)
{
  return curve.closed && curve.nodes.size() <= 3 &&
    std::all_of(curve.kinds.begin(), curve.kinds.end(),
      [](SegmentKind kind) { return kind == SegmentKind::Section; });
}

/// The segment of a curve before that runs between the same nodes in the same way; null where there
/// is none.
const SurfacePath* keptSegment(const EditedCurve& before, const EditedCurve& curve, std::size_t s)
{
  const SurfacePoint& from = curve.nodes[s];
  const SurfacePoint& to = curve.nodes[(s + 1) % curve.nodes.size()];
  // Parts of a tape lie in its plane, not in their own.
  for (std::size_t other = 0; other < before.segments.size() && !isTape(before); ++other)
  {
    if (before.kinds[other] == curve.kinds[s] && curve.kinds[s] != SegmentKind::Spline &&
      samePlace(before.nodes[other], from) &&
      samePlace(before.nodes[(other + 1) % before.nodes.size()], to))
    {
      return &before.segments[other];
    }
  }
  return nullptr;
}

/// What can only be drawn as a whole: a spline through all nodes, and a measuring tape of two or
/// three. No path where the curve is none of both.
SurfaceSpline drawWhole(
  const DrawingSurface& surface, const EditedCurve& curve, const std::vector<SurfacePoint>& nodes)
{
  if (std::count(curve.kinds.begin(), curve.kinds.end(), SegmentKind::Spline) > 0 &&
    nodes.size() > 2)
  {
    return surfaceSpline(surface.graph(), surface.locator(), nodes, curve.closed);
  }
  SurfaceSpline whole;
  if (isTape(curve))
  {
    // Where there is none, each segment is a section of its own.
    PlaneSection tape = girth(surface.mesh(), nodes, &whole.stations);
    if (tape.status.ok())
    {
      whole.stations.push_back(tape.path.points.size() - 1);
      whole.path = std::move(tape.path);
    }
    else if (nodes.size() < 3)
    {
      whole.status = std::move(tape.status); // there and back the same way is no loop
    }
  }
  return whole;
}

/// Whether segment s is a part of what was drawn as a whole.
bool isOfWhole(const SurfaceSpline& whole, const EditedCurve& curve, std::size_t s)
{
  const bool spline = std::count(curve.kinds.begin(), curve.kinds.end(), SegmentKind::Spline) > 0;
  return !whole.path.triangles.empty() && (!spline || curve.kinds[s] == SegmentKind::Spline);
}

/// Draws the segments of a curve between other nodes, or its own.
/// \param before what is as in it is taken over; may be null
/// \param hintOf gives where segment s may run near, or an empty path
template <typename HintOf>
Status drawSegments(const DrawingSurface& surface, const EditedCurve& curve,
  const std::vector<SurfacePoint>& nodes, const EditedCurve* before, const HintOf& hintOf,
  std::vector<SurfacePath>& segments)
{
  const SurfaceSpline whole = drawWhole(surface, curve, nodes);
  if (whole.status.refused())
  {
    return whole.status;
  }
  for (std::size_t s = 0; s < segmentCount(nodes.size(), curve.closed); ++s)
  {
    if (isOfWhole(whole, curve, s))
    {
      segments.push_back(partOf(whole.path, whole.stations[s], whole.stations[s + 1]));
      continue;
    }
    if (const SurfacePath* kept = before ? keptSegment(*before, curve, s) : nullptr)
    {
      segments.push_back(*kept);
      continue;
    }
    const SurfacePath& hint = hintOf(s);
    DrawnSegment drawn = drawSegment(surface, curve.kinds[s], nodes[s],
      nodes[(s + 1) % nodes.size()], hint.points.empty() ? nullptr : &hint);
    if (drawn.status.refused())
    {
      return drawn.status;
    }
    segments.push_back(std::move(drawn.path));
  }
  return {};
}
}

SurfacePoint imageOf(const DrawingSurface& surface, const CurveSet& curves, const EditedCurve* own,
  const SurfacePoint& point)
{
  const TriangleMesh& mesh = surface.mesh();
  const Point3 image = curves.mirror->image(point.position);
  SurfacePoint near = surface.pointNear(image);
  const bool ofBoundary = onBoundary(mesh, point);
  if (ofBoundary && onBoundary(mesh, near))
  {
    return near;
  }
  Eigen::AlignedBox3d box;
  NearestPlace nearest(image);
  for (const Index h : surface.boundary())
  {
    box.extend(mesh.point(mesh.from(h)));
    if (ofBoundary)
    {
      nearest.offer(mesh.point(mesh.from(h)), mesh.point(mesh.to(h)));
    }
  }
  for (const auto& curve : curves.curves)
  {
    if (ofBoundary || curve.get() == own || curve->image.empty())
    {
      continue;
    }
    NearestPlace onCurve(point.position);
    onCurve.offer(pointsAlong(curve->segments));
    if (onCurve.distance <= surface.snap().greatest())
    {
      nearest.offer(pointsAlong(curve->image));
    }
  }
  return nearest.distance < imageReach * box.diagonal().norm() ? surface.pointNear(nearest.place)
                                                               : near;
}

DrawnSegment drawSegment(const DrawingSurface& surface, SegmentKind kind, const SurfacePoint& from,
  const SurfacePoint& to, const SurfacePath* hint)
{
  if (kind == SegmentKind::Section)
  {
    return drawSection(surface, from, to);
  }
  StraightPath straight = kind == SegmentKind::Edges ? pathByEdges(surface.graph(), from, to)
    : hint ? straightPathNear(surface.graph(), *hint, from, to)
           : straightPath(surface.graph(), from, to);
  return { std::move(straight.path), std::move(straight.status) };
}

Status drawCurve(const DrawingSurface& surface, const CurveSet& curves, const EditedCurve* before,
  EditedCurve& curve)
{
  std::vector<SurfacePath> hints = std::exchange(curve.segments, {});
  const std::size_t count = segmentCount(curve.nodes.size(), curve.closed);
  if (hints.size() != count)
  {
    hints.assign(count, SurfacePath());
  }
  curve.image.clear();
  const auto hintOf = [&hints](std::size_t s) -> const SurfacePath& { return hints[s]; };
  Status status = drawSegments(surface, curve, curve.nodes, before, hintOf, curve.segments);
  if (status.refused() || !curve.traits.mirrored || !curves.mirror)
  {
    return status;
  }
  std::vector<SurfacePoint> nodes;
  for (const SurfacePoint& node : curve.nodes)
  {
    nodes.push_back(imageOf(surface, curves, before, node));
  }
  // Near the image of the segment, so that both sides go round a bump alike.
  const auto imageOfSegment = [&](std::size_t s) {
    Points3 points = pointsAlong({ curve.segments[s] });
    for (Point3& point : points)
    {
      point = curves.mirror->image(point);
    }
    const SurfacePath hint = surface.pathThrough(points);
    return hint.arrived ? hint : SurfacePath();
  };
  return drawSegments(surface, curve, nodes, nullptr, imageOfSegment, curve.image);
}

SegmentPreview::SegmentPreview(std::shared_ptr<const DrawingSurface> surface)
  : Surface(std::move(surface))
{
}

DrawnSegment SegmentPreview::draw(
  SegmentKind kind, const SurfacePoint& from, const SurfacePoint& to)
{
  if (kind == SegmentKind::Section || !liesOn(this->Surface->mesh(), from))
  {
    return drawSegment(*this->Surface, kind, from, to);
  }
  DrawnSegment result = withinMemory([&] {
    const PathArcs arcs = kind == SegmentKind::Edges ? PathArcs::Edges : PathArcs::All;
    if (!this->Search || this->Search->arcs() != arcs || !samePlace(this->Search->source(), from))
    {
      this->Search = std::make_unique<PathSearch>(this->Surface->graph(), from, arcs);
    }
    StraightPath straight =
      kind == SegmentKind::Edges ? pathByEdges(*this->Search, to) : straightPath(*this->Search, to);
    return DrawnSegment{ std::move(straight.path), std::move(straight.status) };
  });
  if (result.status.code == StatusCode::OutOfMemory)
  {
    this->Search.reset(); // it was left amid a step
  }
  return result;
}
}
