// SPDX-License-Identifier: BSD-3-Clause
// Paths, sections, girths, loops and splines over surfaces of every shape and unit.
#include "../Core/PathFacts.h"
#include "Editing/DrawingSurface.h"
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
  const SurfaceLocator& locator() const { return this->Drawing->locator(); }
  const TriangleMesh& mesh() const { return this->Drawing->mesh(); }
  const PathGraph& graph() const { return this->Drawing->graph(); }
  double size() const { return this->Box.diagonal().norm() + this->Box.center().norm(); }

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
  const SurfaceSpline spline = surfaceSpline(sheet.graph(), sheet.locator(), points, closed);
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
