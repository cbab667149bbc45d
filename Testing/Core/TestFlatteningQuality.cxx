// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Quality/FlatteningQuality.h"
#include "Quality/StrainMeasures.h"
#include "TestMeshes.h"

#include <Eigen/SVD>

using namespace flattening;
using namespace testmeshes;

namespace
{
Points2 mapped(const Points2& points, const Eigen::Matrix2d& matrix)
{
  Points2 result;
  for (const Point2& p : points)
  {
    result.push_back(matrix * p + Point2(5.0, -3.0));
  }
  return result;
}

Indices allHalfedges(const TriangleMesh& mesh)
{
  Indices edges(mesh.halfedgeCount());
  std::iota(edges.begin(), edges.end(), 0);
  return edges;
}
}

TEST(FlatteningQuality, AnExactUnrollingHasNoError)
{
  for (const Surface& surface : { flatPatch(6, 5), cone(8, 5), cylinder(7, 4) })
  {
    const auto quality =
      measureFlattening(surface.mesh, surface.unrolled, allHalfedges(surface.mesh), {});
    EXPECT_LT(quality.summary.maximumEdgeLengthError, 1e-14);
    EXPECT_LT(quality.summary.angleError, 1e-13);
    EXPECT_LT(quality.summary.areaError, 1e-13);
    EXPECT_NEAR(quality.summary.globalHomogeneity, 1.0, 1e-13);
    EXPECT_NEAR(quality.summary.globalAspectRatio, 1.0, 1e-13);
    EXPECT_LT(quality.summary.strainP95, 1e-12);
    EXPECT_LT(quality.summary.rigidEnergy, 1e-24);
    EXPECT_TRUE(quality.summary.flipped.empty());
  }
}

TEST(FlatteningQuality, OneLinearMapGivesItsSingularValuesEverywhere)
{
  const Surface surface = flatPatch(6, 5);
  Eigen::Matrix2d matrix;
  matrix << 1.7, 0.4, -0.3, 0.8;
  const Eigen::Vector2d singular = Eigen::JacobiSVD<Eigen::Matrix2d>(matrix).singularValues();
  const auto quality = measureFlattening(surface.mesh, mapped(surface.unrolled, matrix), {}, {});
  for (const TriangleQuality& q : quality.triangles)
  {
    EXPECT_NEAR(q.largeStretch, singular[0], 1e-13);
    EXPECT_NEAR(q.smallStretch, singular[1], 1e-13);
    EXPECT_NEAR(q.areaRatio, matrix.determinant(), 1e-13);
    EXPECT_NEAR(q.homogeneity, 1.0 / matrix.determinant(), 1e-13);
    EXPECT_NEAR(q.aspectRatio, singular[1] / singular[0], 1e-13);
  }
  EXPECT_NEAR(quality.summary.globalAspectRatio, singular[1] / singular[0], 1e-13);
  EXPECT_NEAR(quality.summary.globalHomogeneity, 1.0, 1e-13);
  EXPECT_NEAR(quality.summary.areaError, matrix.determinant() - 1.0, 1e-13);
}

TEST(FlatteningQuality, TheAngleErrorOfAStretchedRightTriangleIsThatOfItsAngles)
{
  const TriangleMesh mesh({ Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0) }, { { 0, 1, 2 } });
  const auto quality = measureFlattening(
    mesh, { Point2(0, 0), Point2(1, 0), Point2(0, std::sqrt(3.0)) }, { 0, 2 }, {});
  // 90, 45, 45 degrees become 90, 60, 30.
  EXPECT_NEAR(quality.summary.angleError, (0.0 + 1.0 / 3.0 + 1.0 / 3.0) / 3.0, 1e-14);
  EXPECT_NEAR(quality.summary.edgeLengthError, 0.5 * (std::sqrt(3.0) - 1.0), 1e-14);
  EXPECT_NEAR(quality.triangles[0].areaRatio, std::sqrt(3.0), 1e-14);
}

TEST(FlatteningQuality, AFlippedTriangleIsListedAndMakesHomogeneityNegative)
{
  const Surface surface = flatPatch(4, 4);
  Points2 positions = surface.unrolled;
  const Index vertex = 2 * 5 + 2;
  positions[vertex] += Point2(1.6, 0.1);
  const auto quality = measureFlattening(surface.mesh, positions, {}, {});
  ASSERT_FALSE(quality.summary.flipped.empty());
  for (Index t : quality.summary.flipped)
  {
    const Triangle& c = surface.mesh.triangle(t);
    EXPECT_TRUE(c[0] == vertex || c[1] == vertex || c[2] == vertex);
    EXPECT_LT(quality.triangles[t].smallStretch, 0.0);
    EXPECT_LT(quality.triangles[t].aspectRatio, 0.0);
    EXPECT_EQ(quality.triangles[t].homogeneity, 0.0);
  }
  EXPECT_LT(quality.summary.globalHomogeneity, 0.0);
}

TEST(FlatteningQuality, TheDistortionAloneIsThatOfAllMeasures)
{
  const Surface surface = cushion(8, 6, 0.3);
  Points2 stretched;
  for (const Point3& p : surface.mesh.points())
  {
    stretched.emplace_back(1.1 * p.x() + 0.1 * p.y() * p.y(), 0.9 * p.y());
  }
  Points2 folded = stretched;
  folded[20].x() += 3.0;
  Points2 mirrored = stretched;
  for (Point2& p : mirrored)
  {
    p.x() = -p.x();
  }
  const Points2 collapsed(stretched.size(), Point2(1.0, 2.0));
  for (const Points2& positions : { stretched, folded, mirrored, collapsed })
  {
    const QualitySummary all = measureFlattening(surface.mesh, positions, {}, {}).summary;
    const MapDistortion alone = measureDistortion(surface.mesh, positions, withThreads(3));
    EXPECT_EQ(alone.globalHomogeneity, all.globalHomogeneity);
    EXPECT_EQ(alone.rigidEnergy, all.rigidEnergy);
  }
}

namespace
{
QualitySummary measured(const TriangleMesh& mesh, const Points2& positions)
{
  return measureFlattening(mesh, positions, {}, {}).summary;
}

/// Triangles that share no corner.
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

TEST(StrainMeasures, CompressionCountsLikeExtensionAndAScaleIsNoErrorOfAngles)
{
  const Surface surface = flatPatch(4, 4);
  for (const double factor : { 1.25, 0.8 })
  {
    const QualitySummary summary = measureFlattening(surface.mesh,
      mapped(surface.unrolled, stretch(factor, factor)), allHalfedges(surface.mesh), {})
                                     .summary;
    EXPECT_NEAR(summary.strainP95, std::log(1.25), 1e-13);
    EXPECT_NEAR(summary.rigidEnergy, 2.0 * (factor - 1.0) * (factor - 1.0), 1e-13);
    EXPECT_NEAR(summary.edgeLengthError, std::abs(factor - 1.0), 1e-13);
    EXPECT_NEAR(summary.maximumEdgeLengthError, std::abs(factor - 1.0), 1e-13);
    EXPECT_LT(summary.angleError, 1e-13);
    EXPECT_NEAR(summary.areaError, std::abs(factor * factor - 1.0), 1e-13);
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
    EXPECT_NEAR(quality.triangles[t].largeStretch, sigma[0], 1e-12);
    EXPECT_NEAR(quality.triangles[t].smallStretch, sigma[1], 1e-12);
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
  const Surface surface = unitSquares(3, 1);
  const Points2 point(surface.mesh.vertexCount(), Point2(1.0, 2.0));
  const Points2 line = mapped(surface.unrolled, stretch(1.0, 0.0));
  EXPECT_DOUBLE_EQ(measured(surface.mesh, point).rigidEnergy, 2.0);
  EXPECT_NEAR(measured(surface.mesh, line).rigidEnergy, 1.0, 1e-13);
  for (const Points2& positions : { point, line })
  {
    const FlatteningQuality quality =
      measureFlattening(surface.mesh, positions, allHalfedges(surface.mesh), {});
    EXPECT_EQ(quality.summary.strainP95, largestStrain);
    EXPECT_EQ(quality.triangles[0].areaRatio, 0.0);
    EXPECT_EQ(quality.triangles[0].homogeneity, 0.0);
    EXPECT_EQ(quality.summary.globalHomogeneity, 0.0);
    EXPECT_EQ(quality.summary.flipped.size(), 6U);
    EXPECT_TRUE(std::isfinite(quality.summary.angleError));
  }
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

namespace
{
std::vector<double> developability(const TriangleMesh& mesh)
{
  return surfaceDevelopability(mesh, cornerAngles(mesh, {}));
}
}

TEST(SurfaceDevelopability, IsZeroOnDevelopableSurfaces)
{
  for (const Surface& surface : { flatPatch(7, 5), cone(9, 6), cylinder(8, 5) })
  {
    for (double value : developability(surface.mesh))
    {
      EXPECT_LT(value, 1e-13);
    }
  }
}

TEST(SurfaceDevelopability, MeasuresASaddleAsMuchAsAPeak)
{
  // Six triangles around a vertex whose neighbours alternate above and below.
  Points3 points{ Point3::Zero() };
  Triangles triangles;
  for (Index k = 0; k < 6; ++k)
  {
    points.push_back(
      Point3(std::cos(k * pi / 3.0), std::sin(k * pi / 3.0), k % 2 == 0 ? 0.5 : -0.5));
    triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 6 });
  }
  const double expected = 6.0 * std::acos((0.5 - 0.25) / 1.25) - 2.0 * pi;
  ASSERT_GT(expected, 1.0);
  EXPECT_NEAR(developability(TriangleMesh(points, triangles))[0], expected, 1e-14);
}

TEST(CutLength, ASeamBoundsBothPiecesADartHasTwoSidesAndEachCountsOnce)
{
  Surface surface = unitSquares(4, 4);
  // A seam along the boundary and a curve inside cut nothing.
  surface.curves = { columnCurve(4, 4, 1, CurveType::Seam),
    curveOf(CurveType::Dart, "dart", { 3, 8 }), rowCurve(4, 0, CurveType::Seam), rowCurve(4, 2) };
  const FlatteningResult result = flattenOk(surface);
  ASSERT_EQ(result.pieces.size(), 2U);
  EXPECT_EQ(result.pieces[0].cutLength, 4.0);
  EXPECT_EQ(result.pieces[1].cutLength, 5.0);
  // Both together are cut open once along each.
  EXPECT_EQ(cutLength(cutSurface(surface.mesh, surface.curves).mesh), 5.0);
}

TEST(CutLength, WhereThreeSheetsMeetTheLineCountsOnce)
{
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  for (const Point3& apex : { Point3(0, 1, 0), Point3(0, -1, 0), Point3(0, 0, 1) })
  {
    const Index first = static_cast<Index>(points.size());
    // Zeros of either sign are one place.
    points.insert(points.end(), { Point3(-0.0, 0, 0), Point3(2, 0, first > 0 ? -0.0 : 0.0), apex });
    triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_EQ(cutLength(TriangleMesh(points, triangles)), 2.0);
}
