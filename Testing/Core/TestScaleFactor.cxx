// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/ScaleFactor.h"

#include "ClosedMeshes.h"
#include "Quality/IntrinsicDelaunay.h"

#include <Eigen/LU>

#include <map>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Vertices 0, 1, ... of ring 0 to count along the first spoke, from the rim to the middle.
Indices spoke(Index count, Index n)
{
  Indices path;
  for (Index j = count; j > 0; --j)
  {
    path.push_back(1 + (j - 1) * n);
  }
  path.push_back(0);
  return path;
}

/// A second solver: the mesh's own cotangents, dense, by LU.
std::vector<double> denseFactor(const TriangleMesh& mesh, const Indices& fixed)
{
  std::vector<char> held(mesh.vertexCount(), 0);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    held[v] = mesh.onBoundary(v) ? 1 : 0;
  }
  for (Index v : fixed)
  {
    held[v] = 1;
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(mesh.vertexCount(), mesh.vertexCount());
  Eigen::VectorXd right = Eigen::VectorXd::Constant(mesh.vertexCount(), 2.0 * pi);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    const Index i = mesh.from(h);
    const Index j = mesh.to(h);
    const double weight = 0.5 / std::tan(mesh.angle(TriangleMesh::previous(h)));
    matrix(i, i) += weight;
    matrix(j, j) += weight;
    matrix(i, j) -= weight;
    matrix(j, i) -= weight;
    right[i] -= mesh.angle(h);
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (held[v])
    {
      matrix.row(v).setZero();
      matrix(v, v) = 1.0;
      right[v] = 0.0;
    }
  }
  const Eigen::VectorXd u = matrix.partialPivLu().solve(right);
  return { u.data(), u.data() + u.size() };
}

double squareIntegral(const TriangleMesh& mesh, const std::vector<double>& u)
{
  double sum = 0.0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    sum += mesh.area(h / 3) / 3.0 * u[mesh.from(h)] * u[mesh.from(h)];
  }
  return sum;
}

/// The sphere's cap down to an angle from its pole.
TriangleMesh cap(double angle, Index count)
{
  return disk(count, 6 * count, [=](double r, double turn) {
    return Point3(std::sin(angle * r) * std::cos(turn), std::sin(angle * r) * std::sin(turn),
      std::cos(angle * r));
  });
}
}

TEST(ScaleFactor, ForetellsTheFactorThatIsSolvedAnewWithTheCutFixed)
{
  // Its quadrilaterals have a circle each, so that the mesh is Delaunay as it is.
  const TriangleMesh mesh = cap(0.9, 6);
  Indices cut = spoke(6, 36);
  cut.resize(5);
  const std::vector<double> before = denseFactor(mesh, {});
  const std::vector<double> after = denseFactor(mesh, cut);

  const ScaleFactor factor(mesh, {}, {});
  ASSERT_TRUE(factor.ok());
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_NEAR(factor.values()[v], before[v], 1e-12);
  }
  const double drop = squareIntegral(mesh, before) - squareIntegral(mesh, after);
  ASSERT_GT(drop, 0.1 * squareIntegral(mesh, before));
  EXPECT_NEAR(factor.energy(), squareIntegral(mesh, before), 1e-12 * factor.energy());
  EXPECT_NEAR(factor.forecast(cut).gain, drop, 1e-9 * drop);

  ScaleFactorOptions fixed;
  fixed.fixed = cut;
  const ScaleFactor anew(mesh, fixed, {});
  for (std::size_t v = 0; v < after.size(); ++v)
  {
    EXPECT_NEAR(anew.values()[v], after[v], 1e-12);
  }
  EXPECT_EQ(anew.forecast(cut).gain, 0.0);
}

TEST(ScaleFactor, IsZeroOnDevelopableSurfaces)
{
  for (const Surface& surface : { flatPatch(9, 7), cone(16, 6), cylinder(16, 8) })
  {
    const ScaleFactor factor(surface.mesh, {}, {});
    ASSERT_TRUE(factor.ok());
    for (const double value : factor.values())
    {
      EXPECT_LT(std::abs(value), 1e-12);
    }
    EXPECT_LT(std::abs(factor.forecast({ 3, 12, 21 }).gain), 1e-24);
  }
}

TEST(ScaleFactor, IsThatOfTheSpheresCap)
{
  // - (sin t u')' / sin t = 1 and u(angle) = 0 have the solution 2 ln(cos(t / 2) / cos(angle / 2)).
  const double angle = 1.0;
  double before = 1.0;
  for (Index count : { 8, 16 })
  {
    const ScaleFactor factor(cap(angle, count), {}, {});
    const double error = std::abs(factor.values()[0] + 2.0 * std::log(std::cos(0.5 * angle)));
    EXPECT_LT(error, 0.3 * before); // of second order
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(ScaleFactor, DoesNotDependOnPlaceAndUnit)
{
  const TriangleMesh mesh = cushion(12, 9, 0.3).mesh;
  const Indices cut = columnCurve(12, 4, 6).vertices;
  const ScaleFactor factor(mesh, {}, {});
  const Eigen::AngleAxisd turn(0.7, Point3(1.0, -2.0, 0.5).normalized());
  for (double scale : { 1e-3, 1.0, 1e3 })
  {
    const TriangleMesh placed = moved(
      mesh, [&](const Point3& p) -> Point3 { return scale * (turn * p + Point3(3.0, -1.0, 8.0)); });
    const ScaleFactor other(placed, {}, {});
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      EXPECT_NEAR(other.values()[v], factor.values()[v], 1e-12);
    }
    const double gain = factor.forecast(cut).gain * scale * scale;
    EXPECT_NEAR(other.forecast(cut).gain, gain, 1e-9 * gain);
    EXPECT_NEAR(
      other.forecast(cut).opening(0.0), factor.forecast(cut).opening(0.0) * scale, 1e-9 * scale);
  }
}

TEST(ScaleFactor, ADartToTheApexOfAConeOpensByItsAngleDefect)
{
  const Index count = 6;
  const Index n = 24;
  const TriangleMesh mesh = disk(count, n, [](double r, double turn) {
    return Point3(r * std::cos(turn), r * std::sin(turn), 0.5 * (1.0 - r));
  });
  double defect = 2.0 * pi;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    defect -= mesh.from(h) == 0 ? mesh.angle(h) : 0.0;
  }
  const ScaleFactor factor(mesh, {}, {});
  const CutForecast forecast = factor.forecast(spoke(count, n));
  EXPECT_NEAR(forecast.gain, factor.energy(), 1e-10 * factor.energy()); // nothing is left
  ASSERT_EQ(static_cast<Index>(forecast.swallowed.size()), count);
  EXPECT_NEAR(forecast.swallowed.back(), defect, 1e-10);
  EXPECT_NEAR(
    std::accumulate(forecast.swallowed.begin(), forecast.swallowed.end(), 0.0), defect, 1e-10);
  const double length = std::hypot(1.0, 0.5);
  EXPECT_NEAR(forecast.arc.back(), length, 1e-12);
  EXPECT_NEAR(forecast.opening(0.0), defect * length, 1e-10);
  EXPECT_NEAR(forecast.opening(0.25 * length), defect * 0.75 * length, 1e-10);
  EXPECT_NEAR(forecast.leastOpening(), 0.0, 1e-10);
}

TEST(ScaleFactor, ADartInsideIsClosedAtBothEndsAndOpensAtAWaist)
{
  const Index columns = 12;
  const TriangleMesh mesh = patch(columns, 20, [](double i, double j) {
    const double turn = 0.35 * pi * (i / 6.0 - 1.0);
    const double y = j / 5.0 - 2.0;
    const double radius = 1.0 - 0.25 * std::exp(-y * y / 0.36);
    return Point3(radius * std::sin(turn), y, radius * std::cos(turn));
  }).mesh;
  const ScaleFactor factor(mesh, {}, {});
  ASSERT_TRUE(factor.ok());
  Indices meridian;
  for (Index j = 6; j <= 14; ++j)
  {
    meridian.push_back(j * (columns + 1) + columns / 2);
  }
  const CutForecast dart = factor.forecastInside(meridian);
  ASSERT_EQ(dart.arc.size(), meridian.size());
  double turn = 0.0;
  double most = 0.0;
  for (double swallowed : dart.swallowed)
  {
    turn += swallowed;
    most = std::max(most, std::abs(swallowed));
  }
  EXPECT_LT(std::abs(turn), 1e-9 * most);
  EXPECT_LT(std::abs(dart.opening(0.0)), 1e-9 * dart.greatestOpening());
  EXPECT_GE(dart.leastOpening(), -1e-9 * dart.greatestOpening());
  EXPECT_LT(dart.swallowed[4], 0.0); // the saddle
  EXPECT_GT(dart.swallowed.front(), 0.0);
  EXPECT_GT(dart.swallowed.back(), 0.0);
  EXPECT_GT(dart.gain, 0.3 * factor.energy());
  EXPECT_NEAR(dart.opening(dart.arc[4]), dart.greatestOpening(), 1e-9);
}

TEST(ScaleFactor, ADartIntoASaddleIsToldToOverlap)
{
  const auto saddle = [](double sign) {
    return heightField(16, [=](double x, double y) { return 0.3 * (x * x + sign * y * y); }).mesh;
  };
  const Indices cut = columnCurve(16, 8, 8).vertices;
  EXPECT_GT(ScaleFactor(saddle(1.0), {}, {}).forecast(cut).opening(0.0), 0.0);
  EXPECT_LT(ScaleFactor(saddle(-1.0), {}, {}).forecast(cut).leastOpening(), -0.01);
}

TEST(ScaleFactor, FindsTheBestCutThroughFewClustersAsThroughAllVertices)
{
  const TriangleMesh mesh = cushion(60, 45, 0.2).mesh;
  std::vector<std::vector<double>> gains;
  for (Index sites : { 250, 1000, mesh.vertexCount() })
  {
    ScaleFactorOptions options;
    options.maxSites = sites;
    const ScaleFactor factor(mesh, options, {});
    gains.emplace_back();
    for (Index i : { 6, 10, 16, 25, 33, 40, 52 })
    {
      for (Index last : { 7, 15, 22, 30, 45 })
      {
        gains.back().push_back(factor.forecast(columnCurve(60, last, i).vertices).gain);
      }
    }
  }
  // The best by fewer clusters is nearly the best by all.
  const double most = *std::max_element(gains[2].begin(), gains[2].end());
  for (const std::vector<double>& some : { gains[0], gains[1] })
  {
    const auto best = std::max_element(some.begin(), some.end()) - some.begin();
    EXPECT_GT(gains[2][static_cast<std::size_t>(best)], 0.98 * most);
  }
}

TEST(ScaleFactor, WeighsWhatMattersMore)
{
  const TriangleMesh mesh = cushion(20, 20, 0.2).mesh;
  ScaleFactorOptions left;
  for (const Point3& p : mesh.points())
  {
    left.weight.push_back(p.x() < 0.5 ? 1.0 : 0.0);
  }
  const Indices near = columnCurve(20, 10, 5).vertices;
  const Indices far = columnCurve(20, 10, 15).vertices;
  const ScaleFactor even(mesh, {}, {});
  const ScaleFactor weighted(mesh, left, {});
  EXPECT_NEAR(even.forecast(near).gain, even.forecast(far).gain, 0.05 * even.forecast(far).gain);
  EXPECT_GT(weighted.forecast(near).gain, 2.0 * weighted.forecast(far).gain);
}

TEST(ScaleFactor, IsUndefinedWhereNothingFixesTheScale)
{
  ScaleFactorOptions one;
  one.fixed = { 2 };
  for (int halvings : { 0, 1, 2, 3 })
  {
    const TriangleMesh closed = sphere(halvings);
    EXPECT_FALSE(ScaleFactor(closed, {}, {}).ok()) << halvings;
    EXPECT_TRUE(ScaleFactor(closed, one, {}).ok()) << halvings;
  }
}

TEST(IntrinsicDelaunay, GivesLinearFunctionsOfAPlaneNoLaplacianHoweverObtuseItsTriangles)
{
  // A sheared grid: every triangle of the mesh is obtuse, and edges are far from Delaunay.
  const TriangleMesh mesh = patch(12, 9, [](double i, double j) {
    return Point3(i + 2.3 * j + 0.2 * std::sin(3.0 * i * j), j + 0.1 * std::sin(i), 0.0);
  }).mesh;
  const IntrinsicTriangulation result = intrinsicDelaunay(mesh);
  std::vector<double> laplacian(mesh.vertexCount(), 0.0);
  std::vector<double> angles(mesh.vertexCount(), 0.0);
  std::map<std::pair<Index, Index>, double> weight;
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index i = result.triangles[t][(k + 1) % 3];
      const Index j = result.triangles[t][(k + 2) % 3];
      const double difference =
        mesh.point(j).dot(Point3(0.4, -1.3, 0.0)) - mesh.point(i).dot(Point3(0.4, -1.3, 0.0));
      laplacian[i] += result.cotangents[t][k] * difference;
      laplacian[j] -= result.cotangents[t][k] * difference;
      angles[result.triangles[t][k]] += std::atan2(1.0, result.cotangents[t][k]);
      weight[{ std::min(i, j), std::max(i, j) }] += result.cotangents[t][k];
    }
  }
  Index inner = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!mesh.onBoundary(v))
    {
      ++inner;
      EXPECT_NEAR(laplacian[v], 0.0, 1e-9);
      EXPECT_NEAR(angles[v], 2.0 * pi, 1e-9);
    }
  }
  EXPECT_EQ(inner, 11 * 8);
  for (const auto& [edge, sum] : weight)
  {
    const bool outer = mesh.onBoundary(edge.first) && mesh.onBoundary(edge.second);
    EXPECT_TRUE(outer || sum >= -1e-9) << edge.first << " " << edge.second << " " << sum;
  }
}
