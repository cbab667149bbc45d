// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/LeastSquaresConformalMap.h"

#include "ClosedMeshes.h"
#include "WiredSurface.h"

#include <Eigen/QR>

using namespace flattening;
using namespace testmeshes;

namespace
{
double perimeter(const TriangleMesh& mesh, const Points2* flat = nullptr)
{
  double sum = 0.0;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      sum += flat ? ((*flat)[mesh.to(h)] - (*flat)[mesh.from(h)]).norm() : mesh.length(h);
    }
  }
  return sum;
}

/// Levy's rows as they are written in the article, by a dense QR factorization.
Points2 denseReference(const TriangleMesh& mesh, const LeastSquaresConformalOptions& options)
{
  const Index n = mesh.vertexCount();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * mesh.triangleCount(), 2 * n);
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangle(t);
    const Point3 u = mesh.point(c[1]) - mesh.point(c[0]);
    const Point3 v = mesh.point(c[2]) - mesh.point(c[0]);
    const Point3 x = u.normalized();
    const Point3 y = u.cross(v).cross(u).normalized();
    const std::array<Point2, 3> p{ Point2(0, 0), Point2(u.dot(x), 0), Point2(v.dot(x), v.dot(y)) };
    const double weight = options.areaNormalized ? 1.0 / std::sqrt(2.0 * mesh.area(t)) : 1.0;
    for (int k = 0; k < 3; ++k)
    {
      const Point2 w = weight * (p[(k + 2) % 3] - p[(k + 1) % 3]);
      rows(2 * t, 2 * c[k]) = w.x();
      rows(2 * t, 2 * c[k] + 1) = -w.y();
      rows(2 * t + 1, 2 * c[k]) = w.y();
      rows(2 * t + 1, 2 * c[k] + 1) = w.x();
    }
  }
  Eigen::VectorXd pinned = Eigen::VectorXd::Zero(2 * n);
  pinned[2 * options.pins[1]] = 1.0;
  Indices free;
  for (Index v = 0; v < n; ++v)
  {
    if (v != options.pins[0] && v != options.pins[1])
    {
      free.push_back(2 * v);
      free.push_back(2 * v + 1);
    }
  }
  Eigen::MatrixXd reduced(rows.rows(), static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k)
  {
    reduced.col(static_cast<Eigen::Index>(k)) = rows.col(free[k]);
  }
  const Eigen::VectorXd solution = reduced.colPivHouseholderQr().solve(-rows * pinned);
  for (std::size_t k = 0; k < free.size(); ++k)
  {
    pinned[free[k]] = solution[static_cast<Eigen::Index>(k)];
  }
  Points2 positions(n);
  for (Index v = 0; v < n; ++v)
  {
    positions[v] = pinned.segment<2>(2 * v);
  }
  const double scale = perimeter(mesh) / perimeter(mesh, &positions);
  for (Point2& p : positions)
  {
    p *= scale;
  }
  return positions;
}
}

TEST(LeastSquaresConformalMap, AgreesWithADenseLeastSquaresSolution)
{
  const TriangleMesh mesh = cushion(7, 6, 0.4).mesh;
  for (bool normalized : { true, false })
  {
    for (const auto& pins : { std::array<Index, 2>{ 0, 55 }, std::array<Index, 2>{ 3, 4 } })
    {
      const LeastSquaresConformalOptions options{ pins, normalized };
      const auto map = leastSquaresConformalMap(mesh, options);
      ASSERT_TRUE(map.status.ok());
      EXPECT_LT(rigidDistance(map.positions, denseReference(mesh, options)), 1e-10);
    }
  }
}

TEST(LeastSquaresConformalMap, KeepsThePerimeterAndPinsTheFarthestBoundaryVertices)
{
  const TriangleMesh mesh = cushion(9, 6, 0.3).mesh;
  const auto map = leastSquaresConformalMap(mesh, {});
  ASSERT_TRUE(map.status.ok());
  EXPECT_NEAR(perimeter(mesh, &map.positions), perimeter(mesh), 1e-12);
  // Both diagonals are equally long; the one with the smallest ids counts.
  const auto pinned = leastSquaresConformalMap(mesh, { { 0, 69 }, true });
  EXPECT_EQ(map.positions, pinned.positions);
}

TEST(LeastSquaresConformalMap, DoesNotDependOnPoseAndScalesWithTheSurface)
{
  const TriangleMesh mesh = cushion(9, 6, 0.3).mesh;
  const Points2 reference = leastSquaresConformalMap(mesh, { { 0, 69 }, true }).positions;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Point3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (double scale : { 1e-9, 1.0, 1e9 })
  {
    const TriangleMesh other = moved(
      mesh, [&](const Point3& p) -> Point3 { return scale * (turn * p + Point3(0.3, -4.0, 2.0)); });
    Points2 flat = leastSquaresConformalMap(other, { { 0, 69 }, true }).positions;
    ASSERT_EQ(flat.size(), reference.size());
    for (Point2& p : flat)
    {
      p /= scale;
    }
    EXPECT_LT(rigidDistance(flat, reference), 1e-11);
  }
}

TEST(LeastSquaresConformalMap, RefusesAClosedSurfaceAndWrongPins)
{
  EXPECT_EQ(leastSquaresConformalMap(sphere(0), {}).status.code, StatusCode::ClosedSurface);
  const TriangleMesh mesh = flatPatch(3, 3).mesh;
  for (const auto& pins : { std::array<Index, 2>{ 2, 2 }, std::array<Index, 2>{ 0, 16 },
         std::array<Index, 2>{ none, 4 }, std::array<Index, 2>{ -7, 4 } })
  {
    const auto map = leastSquaresConformalMap(mesh, { pins, true });
    EXPECT_EQ(map.status.code, StatusCode::InvalidOption);
    EXPECT_TRUE(map.positions.empty());
  }
  EXPECT_EQ(leastSquaresConformalMap(TriangleMesh(), {}).status.code, StatusCode::EmptySurface);
}

TEST(LeastSquaresConformalMap, MapsASingleTriangle)
{
  const TriangleMesh mesh({ Point3(0, 0, 0), Point3(3, 0, 0), Point3(0, 4, 0) }, { { 0, 1, 2 } });
  const auto map = leastSquaresConformalMap(mesh, {});
  ASSERT_TRUE(map.status.ok());
  EXPECT_LT(rigidDistance(map.positions, { Point2(0, 0), Point2(3, 0), Point2(0, 4) }), 1e-13);
}
