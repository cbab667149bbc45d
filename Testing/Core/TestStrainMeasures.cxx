// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/StrainMeasures.h"

#include "Quality/FlatteningQuality.h"
#include "TestMeshes.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <numeric>

using namespace flattening;
using namespace testmeshes;

namespace
{
QualitySummary measured(const TriangleMesh& mesh, const Points2& positions)
{
  return measureFlattening(mesh, positions, {}, {}).summary;
}

Points2 mapped(const Points2& points, const Eigen::Matrix2d& matrix)
{
  Points2 result;
  for (const Point2& p : points)
  {
    result.push_back(matrix * p);
  }
  return result;
}

/// A row of unit squares in the plane z = 0, two triangles each.
Surface squares(Index count)
{
  return patch(
    count, 1, [](double i, double j) -> Point3 { return Point3(i, j, 0.0); },
    [](double i, double j) { return Point2(i, j); });
}

/// Moves the corners of one triangle that no other one uses: three separate triangles are enough.
struct Separate
{
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  Points2 positions;

  /// A right triangle with legs of a length, and its image under a map.
  void add(double leg, const Eigen::Matrix2d& map)
  {
    const Index first = static_cast<Index>(this->points.size());
    for (const Point2& corner : { Point2(0, 0), Point2(leg, 0), Point2(0, leg) })
    {
      this->points.emplace_back(corner.x(), corner.y(), 0.0);
      this->positions.emplace_back(map * corner);
    }
    this->triangles.push_back({ first, first + 1, first + 2 });
  }
  QualitySummary measures() const
  {
    return measured(TriangleMesh(this->points, this->triangles), this->positions);
  }
};

Eigen::Matrix2d stretch(double x, double y)
{
  return Eigen::Vector2d(x, y).asDiagonal();
}
}

TEST(StrainMeasures, CompressionCountsLikeExtension)
{
  const Surface surface = flatPatch(4, 4);
  for (const double factor : { 1.25, 0.8 })
  {
    const QualitySummary summary =
      measured(surface.mesh, mapped(surface.unrolled, stretch(factor, factor)));
    EXPECT_NEAR(summary.strainP95, std::log(1.25), 1e-13);
    EXPECT_NEAR(summary.rigidEnergy, 2.0 * (factor - 1.0) * (factor - 1.0), 1e-13);
  }
}

TEST(StrainMeasures, TheQuantileIsThatOfSortedStrains)
{
  const Surface surface = cushion(23, 17, 0.4);
  Points2 positions;
  for (const Point3& p : surface.mesh.points())
  {
    positions.emplace_back(1.1 * p.x() + 0.05 * std::sin(p.y()), 0.9 * p.y());
  }
  const FlatteningQuality quality = measureFlattening(surface.mesh, positions, {}, {});
  ASSERT_TRUE(quality.summary.flipped.empty());
  std::vector<std::pair<double, double>> strains;
  double area = 0.0;
  double energy = 0.0;
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    const Triangle& c = surface.mesh.triangle(t);
    const Point3 u = surface.mesh.point(c[1]) - surface.mesh.point(c[0]);
    const Point3 v = surface.mesh.point(c[2]) - surface.mesh.point(c[0]);
    Eigen::Matrix2d before;
    before << u.norm(), u.dot(v) / u.norm(), 0.0, u.cross(v).norm() / u.norm();
    Eigen::Matrix2d after;
    after << positions[c[1]] - positions[c[0]], positions[c[2]] - positions[c[0]];
    const Eigen::Vector2d sigma =
      Eigen::JacobiSVD<Eigen::Matrix2d>(after * before.inverse()).singularValues();
    const double size = 0.5 * before.determinant();
    strains.emplace_back(sigma.array().log().abs().maxCoeff(), size);
    area += size;
    energy += size * (sigma.array() - 1.0).square().sum();
  }
  std::sort(strains.begin(), strains.end());
  double sum = 0.0;
  std::size_t k = 0;
  while (sum + strains[k].second < 0.95 * area)
  {
    sum += strains[k++].second;
  }
  EXPECT_GT(k, strains.size() / 2);
  EXPECT_NEAR(quality.summary.strainP95, strains[k].first, 1e-12);
  EXPECT_NEAR(quality.summary.rigidEnergy, energy / area, 1e-12);
}

TEST(StrainMeasures, AFlippedTriangleCountsAsStrainedBeyondAllOthers)
{
  for (const double share : { 0.04, 0.06 })
  {
    Separate mesh;
    mesh.add(std::sqrt(share), stretch(-1.0, 1.0));
    mesh.add(std::sqrt(1.0 - share), stretch(1.0, 1.1));
    const QualitySummary summary = mesh.measures();
    EXPECT_NEAR(summary.strainP95, share > 0.05 ? largestStrain : std::log(1.1), 1e-12);
    // A mirror is by (-1 - 1)^2 from the nearest rotation.
    EXPECT_NEAR(summary.rigidEnergy, 4.0 * share + 0.01 * (1.0 - share), 1e-12);
  }
}

TEST(StrainMeasures, WhatCollapsesOrExplodesGivesFiniteNumbers)
{
  const Surface surface = squares(3);
  const Points2 collapsed(surface.mesh.vertexCount(), Point2(1.0, 2.0));
  const QualitySummary point = measured(surface.mesh, collapsed);
  EXPECT_EQ(point.strainP95, largestStrain);
  EXPECT_DOUBLE_EQ(point.rigidEnergy, 2.0);
  const QualitySummary line = measured(surface.mesh, mapped(surface.unrolled, stretch(1.0, 0.0)));
  EXPECT_EQ(line.strainP95, largestStrain);
  EXPECT_NEAR(line.rigidEnergy, 1.0, 1e-13);
  for (const double factor : { 1e-60, 1e60 })
  {
    const QualitySummary summary =
      measured(surface.mesh, mapped(surface.unrolled, stretch(factor, factor)));
    EXPECT_EQ(summary.strainP95, largestStrain);
    EXPECT_TRUE(std::isfinite(summary.rigidEnergy));
  }
}

TEST(StrainMeasures, TrianglesWithoutAreaInSpaceDoNotCount)
{
  Separate mesh;
  mesh.add(1.0, stretch(1.2, 1.0));
  const QualitySummary alone = mesh.measures();
  mesh.add(0.0, stretch(1.0, 1.0));
  mesh.positions.back() = Point2(7.0, 8.0);
  EXPECT_EQ(mesh.measures().strainP95, alone.strainP95);
  EXPECT_EQ(mesh.measures().rigidEnergy, alone.rigidEnergy);
  Separate nothing;
  nothing.add(0.0, stretch(1.0, 1.0));
  EXPECT_EQ(nothing.measures().strainP95, 0.0);
  EXPECT_EQ(nothing.measures().rigidEnergy, 0.0);
}
