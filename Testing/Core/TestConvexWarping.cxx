// SPDX-License-Identifier: BSD-3-Clause
// Starts that never fold: deep caps of a sphere, with and without wires across their pole.
#include "ClosedMeshes.h"
#include "Embedding/ConvexEmbedding.h"
#include "Flattened.h"
#include "StatusTesting.h"

using namespace flattening;
using namespace testmeshes;

TEST(ConvexEmbedding, FoldsNothingAroundHoles)
{
  // A tube: its other end is a hole.
  const TriangleMesh mesh = revolved(12, 6, 3.0);
  const Points2 flat = embedConvexly(mesh, {});
  ASSERT_EQ(flat.size(), mesh.points().size());
  EXPECT_EQ(countFlipped(mesh, flat), 0);
}

TEST(ConvexEmbedding, FoldsNothingInPocketsOfTheBoundary)
{
  for (double degrees : { 60.0, 120.0, 150.0 })
  {
    for (double share : { 0.001, 0.01, 0.1, 0.9 })
    {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(share));
      const TriangleMesh cap = sphereCap(degrees * pi / 180.0, 24, 0).mesh;
      Points3 points = cap.points();
      Triangles triangles = cap.triangles();
      const std::vector<Indices> loops = cap.boundaryLoops();
      for (Index h : loops.front())
      {
        // A quadrilateral with a point inside, at a share of its height.
        const Index a = cap.from(h);
        const Index b = cap.to(h);
        const Point3 middle = 0.5 * (points[a] + points[b]);
        const Point3 out = 3.0 * (middle - points[cap.triangle(h / 3)[(h + 2) % 3]]);
        const auto c = static_cast<Index>(points.size());
        points.insert(points.end(), { points[a] + out, points[b] + out, middle + share * out });
        triangles.insert(triangles.end(),
          { { b, a, c + 2 }, { a, c, c + 2 }, { c, c + 1, c + 2 }, { c + 1, b, c + 2 } });
      }
      const TriangleMesh mesh(std::move(points), std::move(triangles));
      const Points2 flat = embedConvexly(mesh, {});
      ASSERT_EQ(flat.size(), mesh.points().size());
      EXPECT_EQ(countFlipped(mesh, flat), 0);
    }
  }
}

namespace
{
void expectExactWithoutAFold(double degrees, Index rings, int wires)
{
  const FlatteningResult result = flatten(sphereCap(degrees * pi / 180.0, rings, wires));
  const PieceReport& piece = result.pieces[0];
  EXPECT_TRUE(piece.quality.flipped.empty()) << degrees << ", " << rings << ", " << wires;
  EXPECT_LT(piece.quality.maximumEdgeLengthError, 1e-10) << degrees << ", " << rings;
  EXPECT_EQ(piece.area.deep(), degrees > 67.0) << degrees;
  if (degrees <= 105.0)
  {
    EXPECT_TRUE(result.status.ok()) << degrees << ", " << rings << ", " << wires;
    EXPECT_LE(piece.iterations, 30) << degrees << ", " << rings << ", " << wires;
  }
}
}

TEST(ConvexWarping, CapsLieWithoutAFoldWithExactLengths)
{
  for (double degrees : { 30.0, 45.0, 60.0, 75.0, 105.0, 125.0, 150.0 })
  {
    for (int wires : { 0, 1, 2 })
    {
      expectExactWithoutAFold(degrees, 12, wires);
    }
  }
  expectExactWithoutAFold(170.0, 12, 0);
  for (double degrees : { 75.0, 105.0, 150.0 })
  {
    expectExactWithoutAFold(degrees, 24, 1);
  }
  // Wires that are more than a third longer than the disk with their boundary is wide give way at
  // once.
  expectExactWithoutAFold(90.0, 24, 1);
  expectExactWithoutAFold(75.0, 24, 2);
}

TEST(ConvexWarping, ADeepPieceThatIsAtNoMinimumIsAdvisedToBeCut)
{
  const FlatteningResult result = flatten(sphereCap(170.0 * pi / 180.0, 12, 2));
  const Status& status = result.pieces[0].status;
  ASSERT_FALSE(status.ok());
  EXPECT_TRUE(statustesting::has(status, Remedy::AddDarts));
}

TEST(ConvexWarping, AWireThatNoPlaneHoldsIsNamedAndNothingFolds)
{
  const FlatteningResult result = flatten(sphereCap(170.0 * pi / 180.0, 12, 1));
  EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
  if (!(result.pieces[0].quality.maximumEdgeLengthError < 1e-9))
  {
    EXPECT_EQ(result.status.code, StatusCode::LengthError);
    EXPECT_NE(result.status.message.find("diameter0"), std::string::npos);
  }
}

TEST(ConvexWarping, ASaddleWhoseSoftWiresBendFarForNextToNothingComesToAMinimum)
{
  // So soft is the sheet across these wires that corrections of their lengths which cost least bend
  // them by more than they mend.
  const Index n = 16;
  Surface saddle = heightField(n, [](double u, double v) { return 0.6 * (u * u - v * v); });
  saddle.curves = { rowCurve(n, n / 2), columnCurve(n, n, n / 2) };
  const FlatteningResult result = flattenOk(saddle);
  EXPECT_LE(result.pieces[0].iterations, 30);
}

TEST(ConvexWarping, ACapWithoutWiresIsTheDiskWithItsBoundary)
{
  // The boundary of a surface of revolution keeps its length on a circle, and no other curve
  // of that length holds as much.
  const double angle = 5.0 * pi / 6.0;
  const FlatteningResult result = flatten(sphereCap(angle, 12, 0));
  const double radius = 48.0 * 2.0 * std::sin(pi / 48.0) * std::sin(angle) / (2.0 * pi);
  double area = 0.0;
  for (const Triangle& t : result.cut->mesh.triangles())
  {
    const Point2 u = result.positions[t[1]] - result.positions[t[0]];
    const Point2 v = result.positions[t[2]] - result.positions[t[0]];
    area += 0.5 * (u.x() * v.y() - u.y() * v.x());
  }
  EXPECT_NEAR(area, pi * radius * radius, 0.01 * area);
}

TEST(ConvexWarping, SaysWhereTheSecondStartWasTheBetterOne)
{
  const FlatteningResult result = flatten(sphereCap(2.6, 12, 1));
  const std::vector<std::string>& said = result.pieces[0].fallbacks;
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
    [](const std::string& text) { return text.find("convex map") != std::string::npos; }));
  EXPECT_TRUE(flatten(sphereCap(0.4, 8, 1)).pieces[0].fallbacks.empty());
}

namespace
{
/// A lopsided dome of 16 by 16 cells over a square. Its flattening has one minimum.
TriangleMesh dome()
{
  return heightField(16, [](double x, double y) {
    return (0.5 + 0.1 * x) * (1.0 - x * x) * (1.0 - 0.8 * y * y);
  }).mesh;
}

/// From the middle of the side j = 0 into the dome.
FeatureCurve dart()
{
  return curveOf(CurveType::Dart, "dart", { 8, 25, 42, 59, 76, 93, 110 });
}

/// Starts where the triangles lie.
FlatteningOptions startingFrom(const FlatteningResult& flat)
{
  FlatteningOptions options;
  for (const auto& [a, b, c] : flat.cut->mesh.triangles())
  {
    options.start.push_back({ flat.positions[a], flat.positions[b], flat.positions[c] });
  }
  return options;
}
}

TEST(ContinuedWarping, ComesToTheMinimumThatTheWiresAnglesLeadTo)
{
  const TriangleMesh mesh = dome();
  const FlatteningResult uncut = flattenSurface(mesh, {}, {}, {});
  const FlatteningResult continued = flattenSurface(mesh, { dart() }, startingFrom(uncut), {});
  const FlatteningResult anew = flattenSurface(mesh, { dart() }, {}, {});
  ASSERT_TRUE(continued.status.ok()) << continued.status.message;
  ASSERT_TRUE(anew.status.ok());
  EXPECT_TRUE(continued.pieces[0].history.empty()); // no angles were solved for
  EXPECT_FALSE(anew.pieces[0].history.empty());
  const double energy = anew.pieces[0].quality.rigidEnergy;
  EXPECT_LT(energy, 0.9 * uncut.pieces[0].quality.rigidEnergy);
  EXPECT_NEAR(continued.pieces[0].quality.rigidEnergy, energy, 1e-7 * energy);
  EXPECT_NEAR(continued.pieces[0].quality.strainP95, anew.pieces[0].quality.strainP95, 1e-7);
  EXPECT_LT(worstLength(continued), 1e-9);
}

TEST(ContinuedWarping, KeepsLengthsWhereItEndsBeforeWiresAreSettled)
{
  const TriangleMesh mesh = dome();
  FlatteningOptions options = startingFrom(flattenSurface(mesh, {}, {}, {}));
  const FlatteningResult settled = flattenSurface(mesh, { dart() }, options, {});
  options.isometric.rough = true;
  const FlatteningResult rough = flattenSurface(mesh, { dart() }, options, {});
  EXPECT_LT(rough.pieces[0].isometricHistory.size(), settled.pieces[0].isometricHistory.size());
  const double energy = settled.pieces[0].quality.rigidEnergy;
  EXPECT_NEAR(rough.pieces[0].quality.rigidEnergy, energy, 0.3 * energy);
  EXPECT_LT(worstLength(rough), 1e-9);
}

TEST(ContinuedWarping, IsNotForKeysThatHoldMoreThanLengthsNorForFoldedStarts)
{
  const TriangleMesh mesh = dome();
  FlatteningOptions options = startingFrom(flattenSurface(mesh, {}, {}, {}));
  const std::vector<FeatureCurve> keys{ rowCurve(16, 10, CurveType::Key), dart() };
  EXPECT_EQ(flattenSurface(mesh, keys, options, {}).positions,
    flattenSurface(mesh, keys, {}, {}).positions);
  options.start.assign(mesh.triangleCount(), { Point2(0, 0), Point2(0, 1), Point2(1, 0) });
  EXPECT_EQ(flattenSurface(mesh, { dart() }, options, {}).positions,
    flattenSurface(mesh, { dart() }, {}, {}).positions);
}
