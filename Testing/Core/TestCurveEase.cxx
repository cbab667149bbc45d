// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index cells = 10;

/// A cushion that an elastic seam divides in two, with an elastic edge along one side.
Surface seamedCushion(double tolerance)
{
  Surface surface = cushion(cells, cells, 0.4);
  FeatureCurve seam = columnCurve(cells, cells, 4, CurveType::Seam);
  seam.name = "seam";
  seam.tolerance = tolerance;
  FeatureCurve hem = rowCurve(cells, 0);
  hem.name = "hem";
  hem.tolerance = tolerance;
  hem.vertices.erase(hem.vertices.begin() + 4, hem.vertices.end());
  surface.curves = { seam, hem };
  return surface;
}

FlatteningResult flattened(const Surface& surface, const std::vector<CurveEase>& eases = {})
{
  FlatteningOptions options;
  options.eases = eases;
  return flatten(surface, options);
}

/// By how much a curve's edges are longer in a piece than on the surface: the least and the most.
std::array<double, 2> stretchesOf(const FlatteningResult& result, Index curve, Index piece)
{
  std::array<double, 2> range{ 10.0, -10.0 };
  for (const Wire& wire : result.wires)
  {
    for (std::size_t k = 0;
         wire.curve == curve && wire.piece == piece && k + 1 < wire.vertices.size(); ++k)
    {
      const Index a = wire.vertices[k];
      const Index b = wire.vertices[k + 1];
      const double rest = (result.cut->mesh.point(b) - result.cut->mesh.point(a)).norm();
      const double stretch = (result.positions[b] - result.positions[a]).norm() / rest - 1.0;
      range = { std::min(range[0], stretch), std::max(range[1], stretch) };
    }
  }
  return range;
}

/// \param expected of the curve's edges, by piece
void expectStretches(
  const FlatteningResult& result, Index curve, const std::array<double, 2>& expected)
{
  for (const Index piece : { 0, 1 })
  {
    for (const double stretch : stretchesOf(result, curve, piece))
    {
      EXPECT_NEAR(stretch, expected[piece], 1e-9);
    }
  }
}

void expectRefusal(const FlatteningResult& result, const std::vector<std::string>& words)
{
  EXPECT_EQ(result.status.code, StatusCode::InvalidOption);
  EXPECT_TRUE(result.positions.empty());
  for (const std::string& word : words)
  {
    EXPECT_NE(result.status.message.find(word), std::string::npos) << result.status.message;
  }
}
}

TEST(CurveEase, OneSideIsLongerByItAndTheOtherIsAsOnTheSurface)
{
  for (const double ease : { 0.03, -0.02 })
  {
    const FlatteningResult result = flattened(seamedCushion(0.05), { { "seam", 1, ease } });
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    expectStretches(result, 0, { 0.0, ease });
  }
}

TEST(CurveEase, AnEdgeOfOnePieceNeedsNoNumber)
{
  const FlatteningResult result = flattened(seamedCushion(0.05), { { "hem", none, 0.04 } });
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const Index piece = stretchesOf(result, 1, 0)[1] > -10.0 ? 0 : 1;
  for (const double stretch : stretchesOf(result, 1, piece))
  {
    EXPECT_NEAR(stretch, 0.04, 1e-9);
  }
}

TEST(CurveEase, ACurveBringsItsOwnUnlessOneIsGivenForItsName)
{
  Surface surface = seamedCushion(0.05);
  surface.curves[0].ease = { 0.03, 1 };
  expectStretches(flattened(surface), 0, { 0.0, 0.03 });
  expectStretches(flattened(surface, { { "seam", 0, -0.02 } }), 0, { -0.02, 0.0 });
}

TEST(CurveEase, IsRefusedOfDartsWhoseSidesAreInOnePieceAndOfNoCurve)
{
  Surface surface = withCurves(
    cushion(cells, cells, 0.4), { curveOf(CurveType::Dart, "dart", { 4, 4 + 11, 4 + 22 }) });
  surface.curves[0].tolerance = 0.05;
  expectRefusal(flattened(surface, { { "dart", 0, 0.03 } }), { "both sides", "dart" });
  expectRefusal(flattened(surface, { { "cuff", 0, 0.03 } }), { "cuff" });
}

namespace
{
FlatteningResult flatten(double tolerance, Scheme scheme)
{
  Surface surface = quarterSphere();
  surface.curves[0].tolerance = tolerance;
  FlatteningOptions options = withScheme(scheme);
  options.interior.method = InteriorMethod::Laplacian;
  return flatten(surface, options);
}
}

TEST(ElasticCurves, StayInTheirBandWhileRigidOnesStayExact)
{
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
  {
    for (const double tolerance : { 0.01, 0.05, 0.3 })
    {
      const FlatteningResult result = flatten(tolerance, scheme);
      ASSERT_FALSE(result.status.refused()) << result.status.message;
      EXPECT_STRNE(statusName(result.status.code), "NotConverged");
      EXPECT_STRNE(statusName(result.status.code), "LengthError");
      ASSERT_EQ(result.curves.size(), 1U);
      EXPECT_LE(result.curves[0].error, tolerance * (1.0 + 1e-9));
      EXPECT_GT(result.curves[0].error, 1e-3) << "the band is of use here";
      EXPECT_LT(result.pieces.front().quality.maximumEdgeLengthError, 1e-12);
      for (const Wire& wire : result.wires)
      {
        if (wire.boundary)
        {
          EXPECT_LT(wire.maximumEdgeError, 1e-12);
        }
      }
    }
  }
}

TEST(ElasticCurves, TheWiderTheBandTheLowerTheObjective)
{
  double previous = flatten(0.0, Scheme::Global).pieces.front().objective;
  EXPECT_NEAR(previous, 0.197157, 5e-7);
  for (const double tolerance : { 0.01, 0.03, 0.1 })
  {
    const double objective = flatten(tolerance, Scheme::Global).pieces.front().objective;
    EXPECT_LT(objective, previous);
    previous = objective;
  }
}

TEST(ElasticCurves, OfAFlatSurfaceKeepTheirLength)
{
  Surface surface = withCurves(flatPatch(6, 6), { rowCurve(6, 3), columnCurve(6, 6, 2) });
  surface.curves[0].tolerance = 0.1;
  const FlatteningResult result = flatten(surface);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  EXPECT_LT(result.curves[0].error, 1e-10);
  EXPECT_LT(rigidDistance(result.positions, surface.unrolled), 1e-9);
}

TEST(ElasticCurves, ASeamBetweenTwoPiecesIsAsLongOnBothSides)
{
  // One half of the surface is curved more than the other, so each by itself would choose another
  // length.
  Surface surface =
    withCurves(cushion(10, 8, 0.5), { columnCurve(10, 8, 3, CurveType::Seam), rowCurve(10, 4) });
  surface.curves[0].tolerance = 0.05;
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::Isometric })
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    const FlatteningResult result = flatten(surface, withScheme(scheme));
    ASSERT_FALSE(result.status.refused()) << result.status.message;
    ASSERT_EQ(result.pieces.size(), 2U);
    const TriangleMesh& mesh = result.cut->mesh;
    const auto length = [&](Index h) {
      return (result.positions[mesh.to(h)] - result.positions[mesh.from(h)]).norm();
    };
    for (const SeamPair& pair : result.cut->seamPairs)
    {
      EXPECT_NEAR(length(pair.first) / length(pair.second), 1.0, 1e-12);
    }
    EXPECT_LE(result.curves[0].error, 0.05 * (1.0 + 1e-9));
    EXPECT_GT(result.curves[0].error, 1e-4) << "the band is of use here";
    EXPECT_LT(result.curves[1].error, 1e-12);
  }
}
