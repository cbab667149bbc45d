// SPDX-License-Identifier: BSD-3-Clause
#include "OffsetFacts.h"
#include "Paths/PathOffset.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
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

/// A place at a distance from a polygon, and the point of that it is reached from.
struct Reached
{
  Point2 place;
  Point2 foot;
};

/// The places at a distance from a polygon on its left that nothing of it is nearer to, by asking
/// every one.
std::vector<Reached> parallelSet(const Points2& line, double distance, double side)
{
  std::vector<Reached> places;
  const auto take = [&](const Point2& foot, const Point2& way) {
    const Point2 place = foot + way;
    const bool onSheet = place.minCoeff() > 0.0 && place.maxCoeff() < side;
    if (onSheet && footOn(line, place).distance >= distance * (1.0 - exactly))
    {
      places.push_back({ place, foot });
    }
  };
  const bool closed = (line.front() - line.back()).norm() < 1e-12 * side;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Point2 way = line[i + 1] - line[i];
    if (!(way.norm() > 1e-9 * side))
    {
      continue;
    }
    const Point2 left = Point2(-way.y(), way.x()).normalized();
    for (int k = 0; k <= 20; ++k)
    {
      take(line[i] + k / 20.0 * way, distance * left);
    }
    const std::size_t after = i + 2 < line.size() ? i + 2 : 1;
    const Point2 next = line[after] - line[after - 1];
    if ((i + 2 < line.size() || closed) && next.norm() > 1e-9 * side)
    {
      const double turn =
        std::atan2(way.x() * next.y() - way.y() * next.x(), way.dot(next)); // to the right below 0
      for (int k = 0; turn < 0.0 && k <= 20; ++k)
      {
        const double angle = k / 20.0 * turn;
        take(line[i + 1], distance * Eigen::Rotation2Dd(angle).toRotationMatrix() * left);
      }
    }
  }
  return places;
}

/// Whether neither the sheet's side is near nor the polygons that stand for arcs round other parts
/// and round the ends.
bool isClear(const Points2& line, const Reached& reached, double distance, double side)
{
  const double border = std::min(reached.place.minCoeff(), side - reached.place.maxCoeff());
  const bool closed = (line.front() - line.back()).norm() < 1e-12 * side;
  const double end =
    std::min((reached.foot - line.front()).norm(), (reached.foot - line.back()).norm());
  bool clear = border > 0.1 * distance && (closed || end > 0.1 * distance);
  for (std::size_t i = 0; i + 1 < line.size() && clear; ++i)
  {
    const Point2 way = line[i + 1] - line[i];
    const double square = way.squaredNorm();
    const double s =
      square > 0.0 ? std::clamp(way.dot(reached.place - line[i]) / square, 0.0, 1.0) : 0.0;
    const Point2 foot = line[i] + s * way;
    clear = (foot - reached.foot).norm() < 0.1 * distance ||
      (foot - reached.place).norm() > tangent * distance;
  }
  return clear;
}

std::vector<SurfacePoint> wildNodes(const TriangleMesh& mesh, std::mt19937& random, int count)
{
  std::vector<SurfacePoint> nodes;
  for (int n = 0; n < count; ++n)
  {
    nodes.push_back(randomPoint(mesh, random));
  }
  return nodes;
}

/// \return how many places of the parallel set were asked
std::size_t expectTheParallelSet(const Surface& sheet, const SurfacePath& path, double distance)
{
  const PathGraph graph(sheet.mesh);
  const Points2 line = unrolled(sheet, path);
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
    parts.push_back(unrolled(sheet, part));
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
  const double side = sideOf(sheet);
  const std::vector<Reached> places = parallelSet(walked, reach, side);
  for (const Reached& reached : places)
  {
    double gap = std::numeric_limits<double>::infinity();
    for (const Points2& part : parts)
    {
      gap = std::min(gap, footOn(part, reached.place).distance);
    }
    // A line ends where it comes into the tangents that stand for an arc, 2.5 degrees early.
    const bool clear = isClear(walked, reached, reach, side);
    EXPECT_LE(gap, (clear ? tangent - 1.0 : 0.05) * reach) << reached.place.transpose();
  }
  return places.size();
}
}

TEST(OffsetLines, OfWildCurvesAreTheWholeParallelSet)
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
          std::vector<SurfacePoint> nodes = wildNodes(sheet.mesh, random, count);
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
  EXPECT_GT(places, 5000U);
}
