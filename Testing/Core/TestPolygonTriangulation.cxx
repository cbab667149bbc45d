// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/PolygonTriangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace flattening;

namespace
{
Point3 areaOf(const Points3& x, const Triangle& t)
{
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
}

/// As many triangles as there must be, each with area on the polygon's side, of its area together.
void expectDivision(const Points3& x, const Indices& corners, double area)
{
  const Triangles triangles = triangulatePolygon(x, corners);
  ASSERT_EQ(triangles.size() + 2, corners.size());
  Point3 whole = Point3::Zero();
  for (const Triangle& t : triangles)
  {
    whole += areaOf(x, t);
  }
  EXPECT_NEAR(whole.norm(), area, 1e-9 * area);
  for (const Triangle& t : triangles)
  {
    EXPECT_GT(areaOf(x, t).dot(whole), 1e-9 * area * area / static_cast<double>(corners.size()));
  }
  EXPECT_TRUE(isTriangulationOf(triangles, x, corners));
}

/// The corners from each beginning and both ways round, in several sizes, places and planes.
void expectDivisions(const Points3& flat, const Indices& corners, double area)
{
  const Eigen::AngleAxisd turn(0.7, Point3(1, 2, 3).normalized());
  for (const double size : { 1e-6, 1.0, 1e6 })
  {
    for (const bool tilted : { false, true })
    {
      Points3 x;
      for (const Point3& p : flat)
      {
        x.push_back(size * (tilted ? Point3(turn * p + Point3(5, -3, 2)) : p));
      }
      for (std::size_t begin = 0; begin < corners.size(); ++begin)
      {
        Indices round = corners;
        std::rotate(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(begin), round.end());
        expectDivision(x, round, size * size * area);
        std::reverse(round.begin(), round.end());
        expectDivision(x, round, size * size * area);
      }
    }
  }
}

const Points3 keyhole{ Point3(0, 0, 0), Point3(10, 0, 0), Point3(10, 10, 0), Point3(0, 10, 0),
  Point3(3, 3, 0), Point3(7, 3, 0), Point3(7, 7, 0), Point3(3, 7, 0) };
}

TEST(PolygonTriangulation, DividesFacesWithABridgeToAHole)
{
  expectDivisions(keyhole, { 0, 1, 2, 3, 0, 4, 7, 6, 5, 4 }, 84.0);
  // The bridge run through by points of its own, as texture coordinates make them.
  Points3 doubled = keyhole;
  doubled.push_back(keyhole[0]);
  doubled.push_back(keyhole[4]);
  expectDivisions(doubled, { 0, 1, 2, 3, 8, 9, 7, 6, 5, 4 }, 84.0);
}

TEST(PolygonTriangulation, DividesFacesWithHolesOneBehindTheOther)
{
  Points3 x{ Point3(0, 0, 0), Point3(9, 0, 0), Point3(9, 3, 0), Point3(0, 3, 0) };
  for (const double left : { 1.0, 4.0, 7.0 })
  {
    x.insert(x.end(),
      { Point3(left, 1, 0), Point3(left, 2, 0), Point3(left + 1, 2, 0), Point3(left + 1, 1, 0) });
  }
  // From the outline to the first hole, from its far side on to the second and the third.
  expectDivisions(
    x, { 0, 1, 2, 3, 0, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 12, 11, 8, 7, 4 }, 24.0);
}

TEST(PolygonTriangulation, GivesCornersInALineTrianglesWithArea)
{
  Points3 x;
  for (int k = 0; k < 12; ++k) // a square with three points on each side
  {
    const int side = k / 3;
    const double at = k % 3;
    x.push_back(side == 0 ? Point3(at, 0, 0)
        : side == 1       ? Point3(3, at, 0)
        : side == 2       ? Point3(3 - at, 3, 0)
                          : Point3(0, 3 - at, 0));
  }
  Indices corners(x.size());
  std::iota(corners.begin(), corners.end(), 0);
  expectDivisions(x, corners, 9.0);
}

TEST(PolygonTriangulation, DividesStarsOfAnyShape)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int sides = 4; sides < 60; ++sides)
  {
    Points3 x;
    Indices corners;
    double area = 0.0;
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * pi * k / sides;
      x.push_back(radius(random) * Point3(std::cos(angle), std::sin(angle), 0.0));
      corners.push_back(k);
    }
    for (int k = 0; k < sides; ++k)
    {
      area += 0.5 * x[k].cross(x[(k + 1) % sides]).z();
    }
    expectDivision(x, corners, area);
  }
}

TEST(PolygonTriangulation, DividesWhatHasNoAreaIntoTrianglesWithoutArea)
{
  const Points3 slit{ Point3(0, 0, 0), Point3(0, 0, 0), Point3(0, 4, 0), Point3(0, 4, 0) };
  const Points3 line{ Point3(0, 0, 0), Point3(1, 1, 1), Point3(2, 2, 2), Point3(3, 3, 3) };
  for (const Points3& x : { slit, line, Points3(4, Point3(1, 2, 3)) })
  {
    const Triangles triangles = triangulatePolygon(x, { 0, 1, 2, 3 });
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_NEAR(areaOf(x, triangles[0]).norm() + areaOf(x, triangles[1]).norm(), 0.0, 1e-15);
    EXPECT_FALSE(isTriangulationOf(triangles, x, { 0, 1, 2, 3 }));
  }
  // A wedge keeps all of its area.
  const Points3 wedge{ Point3(0, 0, 0), Point3(0, 0, 0), Point3(1, 4, 0), Point3(-1, 4, 0) };
  double area = 0.0;
  for (const Triangle& t : triangulatePolygon(wedge, { 0, 1, 2, 3 }))
  {
    area += areaOf(wedge, t).z();
  }
  EXPECT_DOUBLE_EQ(area, 4.0);
}

TEST(PolygonTriangulation, EndsWithPolygonsThatCrossThemselves)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (const std::size_t sides : { 4u, 5u, 16u, 300u })
  {
    Points3 x;
    Indices corners;
    for (std::size_t k = 0; k < sides; ++k)
    {
      x.emplace_back(place(random), place(random), place(random));
      corners.push_back(static_cast<Index>(k));
    }
    EXPECT_EQ(triangulatePolygon(x, corners).size() + 2, sides);
  }
}
