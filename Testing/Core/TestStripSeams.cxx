// SPDX-License-Identifier: BSD-3-Clause

#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Points placed by a function of [0, 1] x [0, 1].
TriangleMesh sheet(Index columns, Index rows, const std::function<Point3(double, double)>& place)
{
  return patch(columns, rows, [&](double i, double j) {
    return place(i / static_cast<double>(columns), j / static_cast<double>(rows));
  }).mesh;
}

/// The least extent of each flat piece, over directions a tenth of a degree apart.
std::vector<double> widths(const FlatteningResult& flat)
{
  std::vector<double> least(flat.cut->pieceCount, std::numeric_limits<double>::infinity());
  for (int k = 0; k < 1800; ++k)
  {
    const Point2 across(std::cos(pi * k / 1800), std::sin(pi * k / 1800));
    std::vector<double> low(least.size(), std::numeric_limits<double>::infinity());
    std::vector<double> high(least.size(), -std::numeric_limits<double>::infinity());
    for (Index t = 0; t < flat.cut->mesh.triangleCount(); ++t)
    {
      const Index piece = flat.cut->pieceOfTriangle[t];
      for (Index v : flat.cut->mesh.triangle(t))
      {
        const double height = across.dot(flat.positions[v]);
        low[piece] = std::min(low[piece], height);
        high[piece] = std::max(high[piece], height);
      }
    }
    for (std::size_t p = 0; p < least.size(); ++p)
    {
      least[p] = std::min(least[p], high[p] - low[p]);
    }
  }
  return least;
}

CurveSuggestions inStrips(const TriangleMesh& mesh, double width, double bound = 0.05)
{
  SuggestionOptions options;
  options.search.bound = bound;
  options.search.maximumWidth = width;
  return suggestCurves(mesh, {}, options);
}
}

TEST(StripSeams, PartADevelopableSurfaceIntoTheFewestStripsOfEqualWidths)
{
  const auto plane = [](double u, double v) { return Point3(5.0 * u, 3.0 * v, 0.0); };
  const auto tunnel = [](double u, double v) {
    return Point3(4.0 * v, std::cos(pi * u), std::sin(pi * u)); // pi x 4
  };
  const double round = 80.0 * std::sin(pi / 80.0); // the arc of 40 chords
  struct Case
  {
    TriangleMesh mesh;
    double width;
    double allowed;
    Index strips;
    double length; ///< of a seam
  };
  for (const Case& one : { Case{ sheet(20, 20, plane), 3.0, 1.5, 2, 5.0 },
         Case{ sheet(20, 20, plane), 3.0, 1.4, 3, 5.0 },
         Case{ sheet(40, 20, tunnel), round, 1.0, 4, 4.0 },
         Case{ sheet(40, 20, tunnel), round, 4.0, 1, 4.0 } })
  {
    const CurveSuggestions found = inStrips(one.mesh, one.allowed);
    ASSERT_TRUE(found.status.ok()) << found.status.message;
    EXPECT_TRUE(found.boundMet);
    ASSERT_EQ(static_cast<Index>(found.curves.size()), one.strips - 1);
    for (const SuggestedCurve& seam : found.curves)
    {
      EXPECT_NEAR(seam.length, one.length, 1e-6);
    }
    const FlatteningResult flat = flattened(one.mesh, {}, found);
    for (double width : widths(flat))
    {
      EXPECT_NEAR(width, one.width / one.strips, 1e-5 * one.width);
    }
  }
}

TEST(StripSeams, AreOfTheSameWidthsInEveryUnit)
{
  const auto place = [](double u, double v) {
    return Point3(6.0 * u, 2.5 * v, 0.6 * std::pow(2.0 * v - 1.0, 2.0) + 0.4 * u * u);
  };
  const CurveSuggestions meters = inStrips(sheet(30, 20, place), 1.5, 0.03);
  const CurveSuggestions millimeters = inStrips(
    sheet(30, 20, [&](double u, double v) { return Point3(1e3 * place(u, v)); }), 1.5e3, 0.03);
  ASSERT_FALSE(meters.curves.empty());
  EXPECT_LE(meters.width, 1.5);
  EXPECT_TRUE(meters.boundMet);
  ASSERT_EQ(meters.curves.size(), millimeters.curves.size());
  EXPECT_NEAR(1e3 * meters.width, millimeters.width, 1e-3);
}

TEST(StripSeams, PartClosedBodiesAndThoseWithDarts)
{
  for (double width : { 1.5, 0.8 })
  {
    const TriangleMesh mesh = torus(16, 3.0);
    const CurveSuggestions found = inStrips(mesh, width, 0.1);
    ASSERT_TRUE(found.status.ok()) << found.status.message;
    EXPECT_LE(found.width, width);
    const FlatteningResult flat = flattened(mesh, {}, found);
    ASSERT_TRUE(flat.status.ok()) << flat.status.message;
    for (double one : widths(flat))
    {
      EXPECT_LE(one, (1.0 + 1e-4) * width);
    }
  }
}

TEST(StripSeams, KeepToTheLimitOfCutsAndSayHowWideAPieceIs)
{
  SuggestionOptions options;
  options.search.maximumWidth = 0.5;
  options.search.maximumCuts = 2;
  const auto plane = [](double u, double v) { return Point3(5.0 * u, 3.0 * v, 0.0); };
  const CurveSuggestions found = suggestCurves(sheet(10, 10, plane), {}, options);
  EXPECT_TRUE(found.curves.empty());
  EXPECT_FALSE(found.boundMet);
  EXPECT_NEAR(found.width, 3.0, 1e-9);
}
