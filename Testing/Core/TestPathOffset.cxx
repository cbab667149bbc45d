// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/PathOffset.h"

#include "ClosedMeshes.h"
#include "PathFacts.h"
#include "Paths/PathDistance.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
SurfacePath through(const PathGraph& graph, const std::vector<SurfacePoint>& points)
{
  SurfacePath path;
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const StraightPath leg = straightPath(graph, points[k - 1], points[k]);
    EXPECT_TRUE(leg.status.ok());
    if (k == 1)
    {
      path = leg.path;
    }
    else
    {
      append(path, leg.path);
    }
  }
  return path;
}

SurfacePath through(const PathGraph& graph, const Points3& points)
{
  std::vector<SurfacePoint> nodes;
  for (const Point3& point : points)
  {
    nodes.push_back(nearestPoint(graph.mesh(), point));
  }
  return through(graph, nodes);
}

Surface square(Index count, double size)
{
  const auto flat = [=](double i, double j) { return Point2(size * i / count, size * j / count); };
  return patch(
    count, count, [&](double i, double j) { return Point3(flat(i, j).x(), flat(i, j).y(), 0.0); },
    flat);
}

/// Of a point of the plane from a polygon: the nearest foot, and whether it is within an edge.
struct Foot
{
  double distance = std::numeric_limits<double>::infinity();
  bool within = false;
  bool left = false;
};

Foot footOn(const Points2& line, const Point2& point)
{
  Foot foot;
  for (std::size_t k = 1; k < line.size(); ++k)
  {
    const Point2 side = line[k] - line[k - 1];
    const double s = side.dot(point - line[k - 1]) / side.squaredNorm();
    const Point2 way = point - line[k - 1] - std::clamp(s, 0.0, 1.0) * side;
    if (way.norm() < foot.distance * (1.0 - 1e-12))
    {
      foot = { way.norm(), s > 1e-6 && s<1.0 - 1e-6, side.x() * way.y() - side.y() * way.x()> 0 };
    }
  }
  return foot;
}

Points2 unrolledPath(const Surface& surface, const SurfacePath& path)
{
  Points2 line;
  for (const SurfacePoint& point : path.points)
  {
    line.push_back(testmeshes::unrolled(surface.mesh, surface.unrolled, point));
  }
  return line;
}

constexpr double exactly = 1e-9;
const double tangent = 1.0 / std::cos(pi / 72.0); // of an arc of 5 degrees, at its end

/// A part of a cylinder, 1.2 radii wide, that unrolls to a square.
Surface bentSheet(Index columns, Index rows)
{
  const double turn = 1.2 / columns;
  const double side = 2.0 * std::sin(0.5 * turn);
  return patch(
    columns, rows,
    [=](double i, double j) {
      return Point3(std::cos(turn * i), std::sin(turn * i), j * side * columns / rows);
    },
    [=](double i, double j) { return Point2(i * side, j * side * columns / rows); });
}

double sideOf(const Surface& sheet)
{
  return sheet.unrolled.back().x();
}

/// Places on edges of the unrolled mesh that lie at a distance from a polygon, on its left and
/// beside an edge of it.
Points2 parallelPlaces(const Surface& sheet, const Points2& line, double distance)
{
  Points2 places;
  for (Index h = 0; h < sheet.mesh.halfedgeCount(); ++h)
  {
    const Point2& from = sheet.unrolled[sheet.mesh.from(h)];
    const Point2& to = sheet.unrolled[sheet.mesh.to(h)];
    const auto beyond = [&](double s) {
      return footOn(line, Point2((1.0 - s) * from + s * to)).distance - distance;
    };
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < 50 && beyond(0.0) < 0.0 && beyond(1.0) > 0.0; ++k)
    {
      const double middle = 0.5 * (low + high);
      (beyond(middle) < 0.0 ? low : high) = middle;
    }
    const Point2 place = (1.0 - low) * from + low * to;
    const Foot foot = footOn(line, place);
    if (low > 0.0 && foot.within && foot.left)
    {
      places.push_back(place);
    }
  }
  return places;
}

/// \return how many places of the parallel set were asked
std::size_t expectTheParallelSet(const Surface& sheet, const SurfacePath& path, double distance)
{
  const PathGraph graph(sheet.mesh);
  const Points2 line = unrolledPath(sheet, path);
  const double reach = std::abs(distance);
  const PathOffset offset = offsetPath(graph, path, distance);
  if (offset.status.code != StatusCode::CurveLeavesSurface)
  {
    EXPECT_TRUE(offset.status.ok()) << offset.status.message;
  }
  std::vector<Points2> parts;
  for (const SurfacePath& part : offset.parts)
  {
    EXPECT_TRUE(liesOn(sheet.mesh, part));
    parts.push_back(unrolledPath(sheet, part));
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
    {
      for (const double s : { 0.0, 0.3, 0.5, 1.0 })
      {
        const Foot foot =
          footOn(line, Point2((1.0 - s) * parts.back()[i] + s * parts.back()[i + 1]));
        EXPECT_GE(foot.distance, reach * (1.0 - exactly));
        EXPECT_LE(foot.distance, reach * tangent);
      }
    }
  }
  const Points2 mirrored(line.rbegin(), line.rend());
  const Points2& walked = distance > 0.0 ? line : mirrored;
  const Points2 places = parallelPlaces(sheet, walked, reach);
  std::size_t exact = 0;
  for (const Point2& place : places)
  {
    double gap = std::numeric_limits<double>::infinity();
    for (const Points2& part : parts)
    {
      gap = std::min(gap, footOn(part, place).distance);
    }
    // A line ends where it comes into the tangents that stand for an arc, 2.5 degrees early.
    EXPECT_LE(gap, 0.05 * reach) << place.transpose();
    exact += gap <= (tangent - 1.0) * reach ? 1 : 0;
  }
  EXPECT_GE(exact, 0.95 * places.size());
  return places.size();
}
}

TEST(PathOffset, OfWildCurvesIsTheWholeParallelSet)
{
  std::mt19937 random(11);
  std::size_t places = 0;
  for (const Surface& sheet : { square(25, 1.0), bentSheet(30, 24) })
  {
    for (const int count : { 4, 8, 20 })
    {
      for (const double fraction : { 0.02, -0.05, 0.1 })
      {
        for (const bool closed : { false, true })
        {
          std::vector<SurfacePoint> nodes(count);
          std::generate(
            nodes.begin(), nodes.end(), [&] { return randomPoint(sheet.mesh, random); });
          if (closed)
          {
            nodes.push_back(nodes.front());
          }
          const PathGraph graph(sheet.mesh);
          SCOPED_TRACE(testing::Message() << sheet.mesh.triangleCount() << " triangles, " << count
                                          << " nodes, " << fraction << (closed ? ", closed" : ""));
          places += expectTheParallelSet(sheet, through(graph, nodes), fraction * sideOf(sheet));
        }
      }
    }
  }
  EXPECT_GT(places, 3000U);
}

TEST(PathOffset, ReachesFarOverAFineSurface)
{
  const Surface surface = square(300, 1.0); // 180,000 triangles
  const PathGraph graph(surface.mesh);
  const SurfacePath line =
    through(graph, Points3{ { 0.2, 0.3, 0.0 }, { 0.5, 0.6, 0.0 }, { 0.8, 0.3, 0.0 } });
  const PathOffset offset = offsetPath(graph, line, 0.2);
  ASSERT_TRUE(offset.status.ok()) << offset.status.message;
  ASSERT_EQ(offset.parts.size(), 1U);
  const double length = 0.6 * std::sqrt(2.0) + 0.5 * pi * 0.2;
  EXPECT_GE(lengthOf(offset.parts[0]), length * (1.0 - 1e-9));
  EXPECT_LE(lengthOf(offset.parts[0]), length * tangent);
}

TEST(PathOffset, OfALineThatMeetsTheSideAtAnAngleEndsOnTheSide)
{
  const Surface surface = square(10, 10.0);
  const PathGraph graph(surface.mesh);
  const SurfacePath line = through(graph, Points3{ { 0.0, 2.0, 0.0 }, { 10.0, 7.0, 0.0 } });
  const PathOffset offset = offsetPath(graph, line, 1.5);
  ASSERT_EQ(offset.parts.size(), 1U);
  // On the left it is cut off; on the right the arc round the line's end leads to the side.
  const Point3 start = offset.parts[0].points.front().position;
  const Point3 end = offset.parts[0].points.back().position;
  EXPECT_NEAR(start.x(), 0.0, 1e-9);
  EXPECT_NEAR(start.y(), 2.0 + 1.5 * std::sqrt(1.25), 1e-8);
  EXPECT_NEAR(end.x(), 10.0, 1e-9);
  EXPECT_NEAR(end.y(), 8.5, 1e-9);
}

TEST(PathOffset, RoundACylinderIsTheNextRound)
{
  // Forty sides, closed, so that every round is a polygon of one length.
  const TriangleMesh mesh = revolved(40, 10, 3.0);
  const PathGraph graph(mesh);
  std::vector<SurfacePoint> ring;
  for (Index i = 0; i <= 4; ++i)
  {
    ring.push_back(vertexPoint(mesh, 160 + 10 * (i % 4)));
  }
  const SurfacePath loop = through(graph, ring);
  for (const double distance : { 0.3, 0.47, -0.9, -1.2 })
  {
    const PathOffset offset = offsetPath(graph, loop, distance);
    ASSERT_EQ(offset.parts.size(), 1U) << offset.status.message;
    EXPECT_NEAR(lengthOf(offset.parts[0]), lengthOf(loop), 1e-9);
    for (const SurfacePoint& point : offset.parts[0].points)
    {
      EXPECT_NEAR(point.position.z(), 1.2 + distance, 1e-9);
    }
  }
  EXPECT_EQ(offsetPath(graph, loop, 2.0).status.code, StatusCode::CurveLeavesSurface);
}

TEST(PathOffset, OfAGreatCircleIsACircleOfLatitude)
{
  for (const Index n : { 30, 60 })
  {
    const Surface cap = patch(n, n, [=](double i, double j) {
      const double a = 0.6 * (2.0 * i / n - 1.0);
      const double b = 0.6 * (2.0 * j / n - 1.0);
      return Point3(std::tan(a), std::tan(b), 1.0).normalized();
    });
    const PathGraph graph(cap.mesh);
    std::vector<SurfacePoint> row; // its edges; a straight path goes beside their vertices
    for (Index i = n / 6; i <= n - n / 6; ++i)
    {
      row.push_back(vertexPoint(cap.mesh, n / 2 * (n + 1) + i));
    }
    const SurfacePath line = through(graph, row);
    const PathOffset offset = offsetPath(graph, line, 0.3);
    ASSERT_EQ(offset.parts.size(), 1U);
    const double bound = 1.44 / (n * n); // the square of an edge, as the mesh comes near the sphere
    for (const SurfacePoint& point : offset.parts[0].points)
    {
      EXPECT_NEAR(std::asin(point.position.normalized().y()), 0.3, bound);
    }
  }
}

TEST(PathOffset, IsInterruptedByAHole)
{
  const auto isOutside = [](const Point3& p) {
    return (p - Point3(6.0, 6.0, 0.0)).cwiseAbs().maxCoeff() > 2.0;
  };
  const TriangleMesh mesh = partWhere(square(12, 12.0).mesh, isOutside).mesh;
  const PathGraph graph(mesh);
  const SurfacePath line = through(graph, Points3{ { 0.0, 3.0, 0.0 }, { 12.0, 3.0, 0.0 } });
  const PathOffset offset = offsetPath(graph, line, 2.5);
  ASSERT_EQ(offset.parts.size(), 2U);
  for (const SurfacePath& part : offset.parts)
  {
    EXPECT_NEAR(lengthOf(part), 4.0, 1e-8);
  }
}

TEST(PathOffset, OfAPathThatTurnsBackGoesRoundItHoweverItIsRounded)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const double scale = seed % 3 == 0 ? 1e-3 : seed % 3 == 1 ? 1.0 : 1e3;
    const Eigen::AngleAxisd turn(1.0 + seed, Point3(1.0, std::sin(seed), 0.5).normalized());
    const TriangleMesh mesh = patch(12, 12, [&](double i, double j) -> Point3 {
      return scale * (turn * Point3(i, j, 0.0));
    }).mesh;
    const PathGraph graph(mesh);
    const auto at = [](Index i, Index j) { return j * 13 + i; };
    const SurfacePoint from = vertexPoint(mesh, at(3, 4));
    const SurfacePoint to = vertexPoint(mesh, at(7 + static_cast<Index>(seed % 2), 7));
    const PathOffset offset = offsetPath(graph, through(graph, { from, to, from }), 1.5 * scale);
    ASSERT_EQ(offset.parts.size(), 1U);
    // Both sides and two half circles; tangents of an arc are a little longer.
    const double length = 2.0 * (to.position - from.position).norm() + 3.0 * pi * scale;
    EXPECT_GE(lengthOf(offset.parts[0]), length * (1.0 - 1e-9));
    EXPECT_LE(lengthOf(offset.parts[0]), length * (1.0 + 1e-3));
  }
}

TEST(PathOffset, RefusesWhatHasNone)
{
  const Surface surface = square(4, 4.0);
  const PathGraph graph(surface.mesh);
  const SurfacePath line = through(graph, Points3{ { 1.0, 1.0, 0.0 }, { 3.0, 1.0, 0.0 } });
  for (const double distance :
    { 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(offsetPath(graph, line, distance).status.code, StatusCode::InvalidOption);
  }
  const PathOffset far = offsetPath(graph, line, 40.0);
  EXPECT_EQ(far.status.code, StatusCode::CurveLeavesSurface);
  EXPECT_NE(far.status.message.find("40"), std::string::npos);
  EXPECT_EQ(offsetPath(graph, {}, 1.0).status.code, StatusCode::InvalidCurve);
  EXPECT_EQ(offsetPath(graph, { { line.points.front() }, {}, true }, 1.0).status.code,
    StatusCode::InvalidCurve);
}

TEST(PathDistance, IsThatOfTheUnrolledSurface)
{
  const Surface surface = cone(40, 20);
  const PathGraph graph(surface.mesh);
  std::mt19937 random(5);
  int measured = 0;
  for (int k = 0; k < 40; ++k)
  {
    const SurfacePath path = through(graph,
      std::vector<SurfacePoint>{
        randomPoint(surface.mesh, random), randomPoint(surface.mesh, random) });
    const SurfacePoint point = randomPoint(surface.mesh, random);
    const PathDistance distance = distanceFrom(graph, path, point);
    ASSERT_TRUE(distance.way.status.ok());
    const Foot foot = footOn(
      unrolledPath(surface, path), testmeshes::unrolled(surface.mesh, surface.unrolled, point));
    // Round the cut-off tip no straight line of the plane goes.
    EXPECT_GE(distance.way.length, foot.distance * (1.0 - exactly));
    if (distance.way.length < foot.distance * (1.0 + 1e-7))
    {
      EXPECT_TRUE(!foot.within || distance.left == foot.left) << k;
      ++measured;
    }
  }
  EXPECT_GT(measured, 30);
}
