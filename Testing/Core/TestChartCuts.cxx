// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartCuts.h"

#include "Cut/PieceTopology.h"
#include "Flattening/PieceArrangement.h"
#include "Suggestion/SeamDrawing.h"
#include "SuggestionTesting.h"

#include <map>

using namespace flattening;
using namespace testmeshes;

namespace
{
TriangleMesh ball(double radius, Index around = 24, double x = 0.0)
{
  return betweenPoles(around, around / 2 + 2, [radius, x](double turn, double down) {
    return Point3(x + radius * std::sin(down) * std::cos(turn),
      radius * std::sin(down) * std::sin(turn), radius * std::cos(down));
  });
}

/// Without a mirror plane.
TriangleMesh bean()
{
  return betweenPoles(24, 16, [](double turn, double down) {
    const double r = std::sin(down) * (1.0 + 0.25 * std::sin(2.0 * down));
    return Point3(r * std::cos(turn) + 0.4 * down * down / pi,
      1.3 * r * std::sin(turn + 0.2 * down), 2.0 * std::cos(down) + 0.1 * r * std::sin(turn));
  });
}

/// Bulges at its ends, and a bent waist.
TriangleMesh pear()
{
  return betweenPoles(24, 18, [](double turn, double down) {
    const double r = std::sin(down) *
      (1.0 - 0.25 * std::cos(3.0 * down) + 0.1 * std::cos(2.0 * turn) * std::sin(down));
    return Point3(1.2 * r * std::cos(turn) + 0.6 * std::sin(2.0 * down),
      r * std::sin(turn) + 0.2 * down * r, 1.6 * std::cos(down));
  });
}

std::vector<SuggestedCurve> chartsOf(const TriangleMesh& mesh, double bound,
  const std::optional<SymmetryPlane>& plane = {}, const Execution& execution = {})
{
  ChartOptions options;
  options.bound = bound;
  TrialBudget budget(30e6);
  return chartCuts(mesh, plane, options, budget, execution);
}
}

TEST(ChartCuts, PartClosedBodiesIntoDisksWithinTheBound)
{
  for (const TriangleMesh& mesh : { ball(1.0), bean(), pear(), torus(16, 3.0) })
  {
    double before = std::numeric_limits<double>::infinity();
    for (double bound : { 0.05, 0.1 })
    {
      const std::vector<SuggestedCurve> cuts = chartsOf(mesh, bound);
      ASSERT_FALSE(cuts.empty());
      EXPECT_LT(totalLength(cuts), before); // a looser bound takes less seam
      before = totalLength(cuts);
      const FlatteningResult flat = flattened(mesh, {}, cuts);
      ASSERT_TRUE(flat.status.ok()) << flat.status.message;
      EXPECT_TRUE(flat.leftOut.empty());
      EXPECT_LE(worstStrain(flat), bound);
      EXPECT_EQ(eulerCharacteristic(flat.cut->mesh), flat.cut->pieceCount);
      std::vector<Points2> pieces(flat.pieces.size());
      for (Index h = 0; h < flat.cut->mesh.halfedgeCount(); ++h)
      {
        pieces[flat.cut->pieceOfTriangle[h / 3]].push_back(flat.positions[flat.cut->mesh.from(h)]);
      }
      double cloth = 0.0;
      for (const Points2& piece : pieces)
      {
        cloth += hullArea(piece);
      }
      // Large pieces hardly wind: the convex hulls of those that do take 1.8 to 2.6 times their
      // area.
      EXPECT_TRUE(bound < 0.1 || cloth <= 1.7 * mesh.area()) << cloth;
    }
  }
}

TEST(ChartCuts, AreTheSameInEveryUnitAndForAnyNumberOfThreads)
{
  const std::vector<SuggestedCurve> one = chartsOf(ball(1.0), 0.08);
  const std::vector<SuggestedCurve> threads = chartsOf(ball(1.0), 0.08, {}, withThreads(3));
  const std::vector<SuggestedCurve> large = chartsOf(ball(1024.0), 0.08);
  ASSERT_EQ(one.size(), threads.size());
  ASSERT_EQ(one.size(), large.size());
  for (std::size_t k = 0; k < one.size(); ++k)
  {
    EXPECT_EQ(one[k].curve.points, threads[k].curve.points);
    EXPECT_NEAR(large[k].length, 1024.0 * one[k].length, 1e-6 * large[k].length);
  }
}

TEST(ChartCuts, ComeInPairsOfEqualLengthWhereThereIsAMirror)
{
  const TriangleMesh mesh = ball(1.0);
  SymmetryPlane plane;
  plane.normal = Point3::UnitY();
  const std::vector<SuggestedCurve> cuts = chartsOf(mesh, 0.05, plane);
  std::size_t pairs = 0;
  for (const SuggestedCurve& cut : cuts)
  {
    if (cut.mirrorOf != none)
    {
      EXPECT_NEAR(cut.length, cuts[cut.mirrorOf].length, 1e-9);
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 0u);
  EXPECT_LE(worstStrain(flattened(mesh, {}, cuts)), 0.05);
}

TEST(ChartCuts, PartMoreTrianglesThanTheyAreFoundOn)
{
  const TriangleMesh mesh = ball(1.0, 182);
  ASSERT_GT(mesh.triangleCount(), 30000);
  const std::vector<SuggestedCurve> cuts = chartsOf(mesh, 0.05);
  ASSERT_FALSE(cuts.empty());
  // Drawn on others than they were found on.
  EXPECT_LE(worstStrain(flattened(mesh, {}, cuts)), 0.05);
}

TEST(ChartCuts, MakeAsManyPiecesAsAreWanted)
{
  for (bool symmetric : { true, false })
  {
    const TriangleMesh mesh = symmetric ? ball(1.0) : bean();
    double before = std::numeric_limits<double>::infinity();
    for (Index wanted : { 3, 12 })
    {
      SuggestionOptions options = optionsOf(0.05, 0);
      options.search.pieces = wanted;
      const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
      const FlatteningResult flat = flattened(mesh, {}, suggestions);
      EXPECT_LE(flat.pieces.size(), wanted);
      // Seams that cannot be drawn apart, and images of each other, leave one or a few fewer.
      EXPECT_GE(flat.pieces.size() + (symmetric ? 1 : wanted / 4), wanted);
      EXPECT_LT(worstStrain(flat), before) << wanted;
      before = worstStrain(flat);
    }
  }
}

TEST(ChartCuts, OpenABodyWithLimbsAsOnePieceWithAFreeBoundary)
{
  for (double limbs : { 0.0, 0.8, 1.6 })
  {
    const TriangleMesh body = limbedBall(3, limbs);
    double before = 0.0;
    for (double bound : { 0.5, 0.3 })
    {
      SCOPED_TRACE(std::to_string(limbs) + " long, within " + std::to_string(bound));
      SuggestionOptions options;
      options.search.pieces = 1;
      options.search.bound = bound;
      options.flattening.boundary = BoundaryMode::Free;
      options.flattening.preventOverlap = true;
      const CurveSuggestions found = suggestCurves(body, {}, options);
      ASSERT_TRUE(found.status.ok()) << found.status.message;
      const FlatteningResult flat = flattened(body, {}, found, options.flattening);
      ASSERT_EQ(flat.pieces.size(), 1u);
      EXPECT_LE(flat.pieces[0].quality.strainP95, bound);
      EXPECT_EQ(flat.pieces[0].overlaps.count, 0u);
      EXPECT_TRUE(flat.pieces[0].quality.flipped.empty());
      const double length = totalLength(found.curves);
      EXPECT_GT(length, before); // less strain takes more seams
      before = length;
      // Where each trial begins anew, and ends at its minimum, the last takes 10.7.
      EXPECT_LT(found.work, 8.0);
    }
  }
}

TEST(ChartCuts, LieFlatWhereTheSearchIsInterrupted)
{
  for (const TriangleMesh& body : { bean(), limbedBall(3, 0.8) })
  {
    for (int most : { 1000, 3000, 9000 })
    {
      SCOPED_TRACE(most);
      int polls = 0;
      Execution execution;
      execution.cancel = [&] { return ++polls > most; };
      const SuggestionOptions options;
      const CurveSuggestions found = suggestCurves(body, {}, options, execution);
      ASSERT_TRUE(found.status.ok()) << found.status.message;
      const FlatteningResult flat = flattened(body, {}, found);
      ASSERT_FALSE(flat.status.refused()) << flat.status.message;
      const double strain = worstStrain(flat);
      const auto overlapping = std::count_if(flat.pieces.begin(), flat.pieces.end(),
        [](const PieceReport& piece) { return piece.overlaps.count > 0; });
      // Seams that are drawn along their chains are not tried.
      EXPECT_LE(overlapping, 1);
      EXPECT_LE(strain, 3.0 * options.search.bound);
      EXPECT_NEAR(found.strainAfter, strain, 1e-6 * strain);
    }
  }
}

TEST(ChartCuts, AreHandedOnWhileTheSearchGoesOn)
{
  double done = 0.0;
  double first = 1.0;
  std::vector<CurveSuggestions> previews;
  Execution execution;
  execution.progress = [&](double fraction, const char*) { done = fraction; };
  execution.preview = [&](const std::vector<Points3>& lines) {
    first = std::min(first, done);
    CurveSuggestions found;
    for (const Points3& line : lines)
    {
      found.curves.push_back(proposedCut(line));
    }
    previews.push_back(std::move(found));
  };
  ASSERT_TRUE(suggestCurves(bean(), {}, {}, execution).status.ok());
  ASSERT_GE(previews.size(), 3u);
  EXPECT_LT(first, 0.05);
  for (const CurveSuggestions& preview : previews)
  {
    const FlatteningResult flat = flattened(bean(), {}, preview);
    EXPECT_FALSE(flat.status.refused()) << flat.status.message;
  }
}

TEST(ChartCuts, AreNoNumberOfPiecesWhereKeyCurvesAre)
{
  Polyline key;
  key.name = "key";
  key.type = CurveType::Key;
  key.points = { Point3(0.0, 0.0, 1.0), Point3(std::sin(pi / 14.0), 0.0, std::cos(pi / 14.0)) };
  SuggestionOptions options = optionsOf(0.05, 0);
  options.search.pieces = 4;
  EXPECT_EQ(suggestCurves(ball(1.0), { key }, options).status.code, StatusCode::InvalidOption);
}

TEST(ChartCuts, KeepToTheMirrorThatIsStated)
{
  const TriangleMesh mesh = ball(1.0, 24, 0.3);
  Polyline middle;
  middle.name = "middle";
  for (int k = 0; k <= 12; ++k)
  {
    middle.points.emplace_back(
      0.3 + std::sin(pi * k / 12.0), 0.0, std::cos(pi * k / 12.0)); // in y = 0
  }
  const std::map<std::string, std::pair<Point3, double>> planes{
    { "x=0.3", { Point3::UnitX(), 0.3 } }, { "y", { Point3::UnitY(), 0.0 } },
    { "middle", { Point3::UnitY(), 0.0 } }, { "0,3,4,0", { Point3(0.0, 0.6, 0.8), 0.0 } }
  };
  for (const auto& [text, expected] : planes)
  {
    SuggestionOptions options = optionsOf(0.1, 0);
    options.search.symmetric = text;
    const CurveSuggestions suggestions = suggestCurves(mesh, { middle }, options);
    ASSERT_TRUE(suggestions.status.ok()) << text << suggestions.status.message;
    ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane()) << text;
    const SymmetryPlane& plane = *suggestions.mirror->plane();
    EXPECT_NEAR(std::abs(plane.normal.dot(expected.first)), 1.0, 1e-9) << text;
    EXPECT_NEAR(std::abs(plane.offset), expected.second, 1e-9) << text;
  }
  for (const char* text : { "mirror", "q=1", "x=", "x=1,2", "0,0,0,1", "1,2,3", "1,0,0,nan", "" })
  {
    SuggestionOptions options = optionsOf(0.05, 0);
    options.search.symmetric = text;
    EXPECT_EQ(suggestCurves(mesh, { middle }, options).status.code, StatusCode::InvalidOption)
      << text;
  }
}

TEST(ChartCuts, AreMappedToTheOtherSideWhereAMirrorIsForced)
{
  SuggestionOptions options = optionsOf(0.1, 0);
  options.search.symmetric = "force";
  const CurveSuggestions forced = suggestCurves(bean(), {}, options);
  ASSERT_TRUE(forced.mirror.has_value());
  const FlatteningResult flat = flattened(bean(), {}, forced);
  EXPECT_TRUE(flat.status.ok());
  EXPECT_TRUE(arePaired(forced.curves));
}

TEST(ChartCuts, OfPartsThatAreNearlyImagesComeInPairsAndThoseOfAMiddlePartToo)
{
  const auto placed = [](double side, double size) {
    TriangleMesh mesh = moved(bean(), [side, size](const Point3& p) -> Point3 {
      return { p.x(), side * (3.0 + size * p.y()), p.z() };
    });
    Triangles triangles = mesh.triangles();
    for (Triangle& t : triangles)
    {
      std::swap(t[1], side < 0.0 ? t[2] : t[1]);
    }
    return Surface{ TriangleMesh(mesh.points(), std::move(triangles)), {}, {} };
  };
  for (double size : { 1.0, 1.01 }) // exact images, and others
  {
    const TriangleMesh mesh =
      together({ placed(1.0, 1.0), Surface{ ball(1.0), {}, {} }, placed(-1.0, size) }).mesh;
    const CurveSuggestions suggestions = suggestCurves(mesh, {}, optionsOf(0.05, 0));
    ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane()) << size;
    EXPECT_TRUE(suggestions.boundMet) << size;
    std::map<int, double> lengths; // on either side, and in the middle part
    std::size_t middlePairs = 0;
    std::size_t pairs = 0;
    for (const SuggestedCurve& cut : suggestions.curves)
    {
      const double side = cut.curve.points.front().y();
      lengths[side > 1.5 ? 1 : side < -1.5 ? -1 : 0] += cut.length;
      middlePairs += std::abs(side) < 1.5 && cut.mirrorOf != none ? 1 : 0;
      pairs += cut.mirrorOf != none ? 1 : 0;
    }
    EXPECT_NEAR(lengths[1], lengths[-1], 0.02 * lengths[1]) << size;
    EXPECT_GT(middlePairs, 0u) << size;
    EXPECT_GT(pairs, middlePairs) << size;
  }
}

TEST(ChartCuts, ReachTheirBoundWithLegsOfDartsThatFold)
{
  // With free legs alone they were flat, and with folded ones 0.14 was left on the pear.
  const double bound = 0.1;
  for (const TriangleMesh& mesh : { ball(1.0), pear() })
  {
    SuggestionOptions options;
    options.search.bound = bound;
    const CurveSuggestions found = suggestCurves(mesh, {}, options);
    ASSERT_TRUE(found.status.ok()) << found.status.message;
    EXPECT_TRUE(found.boundMet);
    const FlatteningResult flat = flattened(mesh, {}, found);
    ASSERT_TRUE(flat.status.ok()) << flat.status.message;
    EXPECT_LE(worstStrain(flat), bound);
    EXPECT_NEAR(worstStrain(flat), found.strainAfter, 1e-4 * bound);
  }
}

TEST(ChartCuts, KeepToTheirSideOfASlit)
{
  // Half a great circle is open: its two sides lie on each other.
  Polyline slit;
  slit.type = CurveType::Seam;
  for (int k = 0; k <= 16; ++k)
  {
    slit.points.emplace_back(std::cos(pi * k / 16), std::sin(pi * k / 16), 0.0);
  }
  const ImprintedSurface surface = imprintCurves(sphere(3), { slit }, {});
  ASSERT_TRUE(surface.status.ok()) << surface.status.message;
  const TriangleMesh open = cutSurface(surface.mesh, surface.curves).mesh;
  ASSERT_EQ(open.boundaryLoops().size(), 1U);
  const std::vector<SuggestedCurve> cuts = chartsOf(open, 0.05);
  ASSERT_FALSE(cuts.empty());
  const FlatteningResult flat = flattened(open, {}, cuts);
  EXPECT_TRUE(flat.status.ok()) << flat.status.message;
  EXPECT_LE(worstStrain(flat), 0.05);
}

TEST(ChartCuts, OfSmallPartsAreLaidIntoTheWholeSurface)
{
  // A bent cord hangs from a balloon whose edges are far longer than the cord is thick.
  const Points3 bends{ { 0.0, 0.0, -1.3 }, { 0.2, 0.1, -1.8 }, { -0.2, 0.0, -2.0 },
    { 0.1, 0.2, -2.6 } };
  for (Index sides : { 5, 6 })
  {
    const TriangleMesh cord = betweenPoles(sides, 16, [&bends](double turn, double down) {
      const double s = 3.0 * down / pi;
      const auto k = std::min<std::size_t>(2, static_cast<std::size_t>(s));
      const Point3 at = bends[k] + (s - static_cast<double>(k)) * (bends[k + 1] - bends[k]);
      const double radius = 0.005 * (1.0 + 2.0 * std::sin(5.0 * down));
      return Point3(at + radius * Point3(std::cos(turn), -std::sin(turn), 0.2));
    });
    const TriangleMesh mesh =
      together({ Surface{ ball(1.0, 10), {}, {} }, Surface{ cord, {}, {} } }).mesh;
    Polyline edge;
    edge.points = { mesh.point(mesh.from(60)), mesh.point(mesh.to(60)) }; // of the balloon
    for (CurveType type : { CurveType::Accessory, CurveType::Dart })
    {
      edge.type = type;
      EXPECT_TRUE(suggestCurves(mesh, { edge }, optionsOf(0.05, 0)).boundMet) << sides;
    }
    EXPECT_TRUE(suggestCurves(mesh, {}, optionsOf(0.05, 0)).boundMet) << sides;
  }
}

TEST(ChartCuts, LeaveWhatLiesFlatAsItIs)
{
  EXPECT_TRUE(chartsOf(unitSquares(8, 8).mesh, 0.05).empty());
}

TEST(SeamDrawing, DrawsNothingWhereThereIsNoWay)
{
  const TriangleMesh parts = together({ flatPatch(4, 4), cushion(4, 4, 0.3) }).mesh;
  const SeamDrawing drawing(parts);
  const auto from = [&](Index v) { return vertexPoint(parts, v); };
  for (int level = 0; level < SeamDrawing::levels; ++level)
  {
    EXPECT_GT(drawing.draw({ from(0), from(12), from(24) }, level).size(), 2u);
    EXPECT_TRUE(drawing.draw({ from(0), from(12), from(30) }, level).empty());
    EXPECT_TRUE(drawing.draw({ from(0), from(30), from(12) }, level).empty());
  }
}
