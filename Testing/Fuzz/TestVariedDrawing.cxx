// SPDX-License-Identifier: BSD-3-Clause
// Sections, girths, loops, splines and edited curves over surfaces of every shape and unit.
#include "../Core/PathFacts.h"
#include "Editing/CurveEditor.h"
#include "Editing/CurveSnapping.h"
#include "HostileSurface.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"
#include "Paths/SurfaceSpline.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace hostile;
using namespace testmeshes;

namespace
{
constexpr double exactly = 1e-9;

/// One surface to draw on, and what is drawn at random.
class Sheet
{
public:
  explicit Sheet(unsigned seed)
    : Random(seed)
  {
    const Specimen specimen = makeVariedSurface(this->Random);
    this->Name = specimen.name + ", seed " + std::to_string(seed);
    PreparedSurface surface =
      prepareSurface(specimen.points, specimen.triangles, CoincidentPoints::Keep);
    EXPECT_TRUE(surface.status.ok()) << this->Name << ": " << surface.status.message;
    for (const Point3& point : surface.mesh.points())
    {
      this->Box.extend(point);
    }
    this->Drawing = std::make_shared<const DrawingSurface>(std::move(surface.mesh));
  }

  const std::string& name() const { return this->Name; }
  const std::shared_ptr<const DrawingSurface>& drawing() const { return this->Drawing; }
  const TriangleMesh& mesh() const { return this->Drawing->mesh(); }
  const PathGraph& graph() const { return this->Drawing->graph(); }
  double size() const { return this->Box.diagonal().norm() + this->Box.center().norm(); }
  Point3 middle() const { return this->Box.center(); }

  std::size_t pick(std::size_t count) { return this->Random() % count; }
  /// Sometimes one of those before.
  SurfacePoint point()
  {
    if (this->Before.empty() || this->pick(6) != 0)
    {
      this->Before.push_back(randomPoint(this->mesh(), this->Random));
      return this->Before.back();
    }
    return this->Before[this->pick(this->Before.size())];
  }
  std::vector<SurfacePoint> points(std::size_t count)
  {
    std::vector<SurfacePoint> points;
    while (points.size() < count)
    {
      points.push_back(this->point());
    }
    return points;
  }
  /// Of planes in general, along axes, and through a vertex as well.
  Point3 normalAt(const Point3& point)
  {
    switch (this->pick(3))
    {
      case 0:
        return Point3::Unit(static_cast<Eigen::Index>(this->pick(3)));
      case 1:
        return this->mesh().point(static_cast<Index>(this->pick(this->mesh().vertexCount()))) -
          point;
      default:
        return Point3(this->unit(), this->unit(), this->unit());
    }
  }

private:
  double unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->Random); }

  std::mt19937 Random;
  std::string Name;
  Eigen::AlignedBox3d Box;
  std::shared_ptr<const DrawingSurface> Drawing;
  std::vector<SurfacePoint> Before;
};

bool isClosed(const SurfacePath& path)
{
  return samePlace(path.points.front(), path.points.back());
}

/// The length in which a plane cuts the triangles that have corners on both sides of it.
double lengthInPlane(const TriangleMesh& mesh, const Point3& origin, const Point3& normal)
{
  double length = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    Points3 crossings;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Point3& a = mesh.point(mesh.from(h));
      const Point3& b = mesh.point(mesh.to(h));
      const double below = normal.dot(a - origin);
      const double above = normal.dot(b - origin);
      if ((below >= 0.0) != (above >= 0.0))
      {
        crossings.push_back(a + below / (below - above) * (b - a));
      }
    }
    length += crossings.size() == 2 ? (crossings[1] - crossings[0]).norm() : 0.0;
  }
  return length;
}

void expectSection(Sheet& sheet)
{
  const SurfacePoint start = sheet.point();
  const Point3 normal = sheet.normalAt(start.position);
  const PlaneSection section = planeSection(sheet.mesh(), start, normal);
  if (!(normal.norm() > 0.0))
  {
    EXPECT_EQ(section.status.code, StatusCode::InvalidOption);
    return;
  }
  double total = 0.0;
  for (const PlaneSection& one : planeSections(sheet.mesh(), start.position, normal))
  {
    EXPECT_TRUE(liesOn(sheet.mesh(), one.path));
    EXPECT_TRUE(!one.closed || isClosed(one.path));
    total += one.length;
  }
  EXPECT_NEAR(total, lengthInPlane(sheet.mesh(), start.position, normal.normalized()),
    exactly * sheet.size());
  if (section.status.refused())
  {
    EXPECT_EQ(section.status.code, StatusCode::CurveLeavesSurface) << section.status.message;
    return;
  }
  EXPECT_TRUE(liesOn(sheet.mesh(), section.path));
  EXPECT_TRUE(section.closed ? isClosed(section.path)
                             : onBoundary(sheet.mesh(), section.path.points.front()) &&
        onBoundary(sheet.mesh(), section.path.points.back()));
  for (const SurfacePoint& point : section.path.points)
  {
    EXPECT_NEAR(
      normal.normalized().dot(point.position - start.position), 0.0, exactly * sheet.size());
  }
}

/// A tape round the surface, and the same pulled tight. \return whether there was one
bool expectGirth(Sheet& sheet)
{
  const std::vector<SurfacePoint> points = sheet.points(2 + sheet.pick(2));
  std::vector<std::size_t> stations;
  const PlaneSection tape = girth(sheet.mesh(), points, &stations);
  if (tape.status.refused())
  {
    EXPECT_EQ(tape.status.code, StatusCode::CurveLeavesSurface) << tape.status.message;
    return false;
  }
  EXPECT_TRUE(tape.closed && isClosed(tape.path) && liesOn(sheet.mesh(), tape.path));
  EXPECT_EQ(stations.size(), points.size());
  EXPECT_TRUE(std::is_sorted(stations.begin(), stations.end()));
  for (std::size_t k = 0; k < stations.size(); ++k)
  {
    EXPECT_TRUE(samePlace(tape.path.points[stations[k]], points[k])) << k;
  }
  const StraightPath tight = straightLoop(sheet.graph(), tape.path);
  if (tight.status.code != StatusCode::CurveTooShort)
  {
    EXPECT_TRUE(tight.status.ok()) << tight.status.message;
    EXPECT_LE(tight.length, (1.0 + exactly) * tape.length);
    SurfacePath twice = tight.path;
    append(twice, tight.path);
    EXPECT_LE(worstBend(sheet.mesh(), twice), 1e-7);
  }
  return true;
}

void expectSpline(Sheet& sheet)
{
  const std::vector<SurfacePoint> points = sheet.points(2 + sheet.pick(5));
  const bool closed = sheet.pick(2) == 0;
  const SurfaceSpline spline =
    surfaceSpline(sheet.graph(), sheet.drawing()->locator(), points, closed);
  if (spline.status.refused())
  {
    EXPECT_TRUE(spline.status.code == StatusCode::CurveLeavesSurface ||
      (spline.status.code == StatusCode::CurveTooShort && closed && points.size() == 2))
      << spline.status.message;
    return;
  }
  EXPECT_TRUE(liesOn(sheet.mesh(), spline.path));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    EXPECT_TRUE(samePlace(spline.path.points[spline.stations[k]], points[k])) << k;
  }
}

void expectPaths(Sheet& sheet)
{
  const SurfacePoint from = sheet.point();
  const SurfacePoint to = sheet.point();
  const SurfacePoint other = sheet.point();
  const double byEdges = lengthByEdges(sheet.mesh(), from, to);
  const StraightPath path = straightPath(sheet.graph(), from, to);
  EXPECT_EQ(path.status.refused(), !std::isfinite(byEdges)) << path.status.message;
  if (path.status.refused())
  {
    return;
  }
  EXPECT_LE(path.length, (1.0 + 1e-12) * byEdges);
  EXPECT_LE(worstBend(sheet.mesh(), path.path), exactly);
  const StraightPath dragged = straightPathNear(sheet.graph(), path.path, from, other);
  const PathDistance distance = distanceFrom(sheet.graph(), path.path, other);
  EXPECT_EQ(dragged.status.refused(), distance.way.status.refused());
  if (!dragged.status.refused())
  {
    EXPECT_TRUE(liesOn(sheet.mesh(), dragged.path));
    EXPECT_LE(worstBend(sheet.mesh(), dragged.path), exactly);
    for (const SurfacePoint* end : { &from, &to })
    {
      EXPECT_LE(distance.way.length, straightPath(sheet.graph(), *end, other).length);
    }
  }
}

/// Segments from node to node on the surface, one a kind.
void expectWhole(const Sheet& sheet, const EditedCurve& curve, bool mirror)
{
  const std::size_t count = segmentCount(curve.nodes.size(), curve.closed);
  ASSERT_EQ(curve.kinds.size(), count);
  ASSERT_EQ(curve.segments.size(), count);
  EXPECT_EQ(curve.image.size(), curve.traits.mirrored && mirror ? count : 0U);
  for (std::size_t s = 0; s < count; ++s)
  {
    const SurfacePath& segment = curve.segments[s];
    ASSERT_TRUE(liesOn(sheet.mesh(), segment));
    const auto gap = [&](const SurfacePoint& a, const SurfacePoint& b) {
      return (a.position - b.position).norm();
    };
    EXPECT_LE(gap(segment.points.front(), curve.nodes[s]), 1e-12 * sheet.size());
    EXPECT_LE(
      gap(segment.points.back(), curve.nodes[(s + 1) % curve.nodes.size()]), 1e-12 * sheet.size());
  }
}

Status editAtRandom(Sheet& sheet, CurveEditor& editor)
{
  const auto kind = [&] { return static_cast<SegmentKind>(sheet.pick(4)); };
  const std::size_t c = editor.curveCount() == 0 ? 0 : sheet.pick(editor.curveCount());
  const std::size_t nodes = editor.curveCount() == 0 ? 1 : editor.curve(c).nodes.size();
  switch (sheet.pick(12))
  {
    case 0:
      return editor.insertNode(c, sheet.pick(nodes + 1), sheet.point(), kind());
    case 1:
      return editor.moveNode(c, sheet.pick(nodes), sheet.point());
    case 2:
      return editor.removeNode(c, sheet.pick(nodes));
    case 3:
      return editor.setClosed(c, sheet.pick(3) != 0);
    case 4:
      return editor.split(c, sheet.pick(nodes));
    case 5:
      return editor.join(c, sheet.pick(editor.curveCount() + 1));
    case 6:
      return editor.setMirror(
        MirrorPlane{ sheet.middle(), Point3::Unit(static_cast<Eigen::Index>(sheet.pick(3))) });
    case 7:
      return editor.tighten(c);
    case 8:
      return editor.addStroke(sheet.points(1 + sheet.pick(4)), 0.03 * sheet.size(), kind());
    case 9:
      return editor.setKind(c, sheet.pick(nodes), kind());
    case 10:
      return editor.addImage(c);
    default:
    {
      EditedCurve curve;
      curve.nodes = sheet.points(1 + sheet.pick(4));
      curve.kinds.assign(curve.nodes.size(), kind());
      curve.closed = sheet.pick(3) == 0;
      curve.traits.mirrored = sheet.pick(2) == 0;
      return editor.add(curve);
    }
  }
}
}

TEST(VariedFewSheets, PathsAreStraightAndNoLongerThanByEdges)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    Sheet sheet(seed);
    SCOPED_TRACE(sheet.name());
    for (int k = 0; k < 6; ++k)
    {
      expectPaths(sheet);
    }
  }
}

TEST(VariedFewSheets, SectionsAreWholeAndFoundOnce)
{
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    Sheet sheet(seed);
    SCOPED_TRACE(sheet.name());
    for (int k = 0; k < 6; ++k)
    {
      expectSection(sheet);
    }
  }
}

TEST(VariedFewSheets, GirthsGoThroughTheirPointsAndSplinesAsWell)
{
  int girths = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    Sheet sheet(seed);
    SCOPED_TRACE(sheet.name());
    for (int k = 0; k < 6; ++k)
    {
      girths += expectGirth(sheet) ? 1 : 0;
      expectSpline(sheet);
    }
  }
  EXPECT_GT(girths, 200);
}

TEST(VariedFewSheets, EditsAreWholeOrRefusedAndUndone)
{
  int accepted = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    Sheet sheet(seed);
    SCOPED_TRACE(sheet.name());
    CurveEditor editor(sheet.drawing());
    for (int k = 0; k < 40; ++k)
    {
      const CurveSet before = editor.state();
      const bool refused = editAtRandom(sheet, editor).refused();
      accepted += refused ? 0 : 1;
      ASSERT_TRUE(!refused || identical(editor.state(), before));
      for (std::size_t c = 0; c < editor.curveCount(); ++c)
      {
        expectWhole(sheet, editor.curve(c), editor.state().mirror.has_value());
      }
      SnapOptions options;
      options.reach = 0.05 * sheet.size();
      EXPECT_TRUE(liesOn(
        sheet.mesh(), snapPoint(*sheet.drawing(), editor.state(), sheet.point(), options).point));
    }
    while (editor.canUndo())
    {
      editor.undo();
    }
    EXPECT_EQ(editor.curveCount(), 0U);
  }
  EXPECT_GT(accepted, 1500);
}
