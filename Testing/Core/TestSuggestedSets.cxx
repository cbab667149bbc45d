// SPDX-License-Identifier: BSD-3-Clause
#include "Report/SuggestionReport.h"
#include "Sewing/PieceSewing.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/SmallPieces.h"
#include "SuggestionTesting.h"

#include <map>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A closed body that is its own mirror image in x = 0, and in no other plane.
TriangleMesh pear()
{
  return moved(sphere(3), [](const Point3& p) {
    return Point3(
      p.x() * (1.0 + 0.3 * p.y()), 1.3 * p.y() + 0.2 * p.z() * p.z(), p.z() * (1.0 + 0.2 * p.z()));
  });
}

constexpr Index hipColumns = 32;
constexpr Index hipRows = 20;

/// The back of a tube that is narrower above.
TriangleMesh hip()
{
  return patch(hipColumns, hipRows, [](double i, double j) {
    const double angle = 1.2 * (i / 16.0 - 1.0);
    const double height = 0.1 * j;
    const double above = std::max(0.0, height - 1.2) / 0.8;
    const double radius = 1.0 - 0.3 * above * above;
    return Point3(radius * std::sin(angle), radius * std::cos(angle), height);
  }).mesh;
}

/// What is sewn from a flat pattern with four darts from the waist.
struct Skirt
{
  TriangleMesh mesh;
  std::vector<Polyline> darts;
};

Skirt sewnSkirt()
{
  const TriangleMesh body = hip();
  Skirt result;
  for (Index column : { 6, 12, 20, 26 })
  {
    Indices vertices;
    for (Index row = hipRows; row >= 12; --row)
    {
      vertices.push_back(at(hipColumns, column, row));
    }
    result.darts.push_back(
      lineOver(body, vertices, CurveType::Dart, "designed at " + std::to_string(column)));
  }
  const ImprintedSurface surface = imprintCurves(body, result.darts, {});
  const FlatteningResult pattern = flattenSurface(surface.mesh, surface.curves, {}, {});
  SewingOptions options;
  options.secondStart = false;
  const SewingResult sewn = sewPieces(*pattern.cut, pattern.positions, options, {});
  EXPECT_TRUE(sewn.status.ok()) << sewn.status.message;
  Points3 points(surface.mesh.vertexCount());
  for (Index v = 0; v < pattern.cut->mesh.vertexCount(); ++v)
  {
    points[pattern.cut->originalVertex[v]] = sewn.points[v];
  }
  for (std::size_t d = 0; d < result.darts.size(); ++d)
  {
    for (std::size_t k = 0; k < result.darts[d].points.size(); ++k)
    {
      result.darts[d].points[k] = points[surface.curves[d].vertices[k]];
    }
  }
  result.mesh = TriangleMesh(std::move(points), surface.mesh.triangles());
  return result;
}

/// How far the farther end of the nearest proposal lies from that of a line.
double missOf(const Polyline& line, const CurveSuggestions& suggestions)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    const Points3& points = cut.curve.points;
    least = std::min(least,
      std::max((points.front() - line.points.front()).norm(),
        (points.back() - line.points.back()).norm()));
  }
  return least;
}
}

TEST(SuggestedSets, AClosedBodyThatIsNotOpenedWithinTheWorkMeetsNoBound)
{
  for (const double bound : { 0.02, 0.2 })
  {
    for (const double work : { 0.001, 0.005, 0.02 })
    {
      const CurveSuggestions suggestions =
        suggestCurves(pear(), {}, optionsOf(bound, 9, SuggestedCuts::All, work));
      ASSERT_TRUE(std::isnan(suggestions.strainAfter)) << work;
      EXPECT_EQ(suggestions.end, SearchEnd::WorkUsedUp) << work;
      EXPECT_FALSE(suggestions.boundMet);
    }
  }
}

TEST(SuggestedSets, HalvesOfAClosedBodyAreCutAlike)
{
  const CurveSuggestions suggestions =
    suggestCurves(pear(), {}, optionsOf(0.1, 9, SuggestedCuts::All, 8.0));
  ASSERT_TRUE(suggestions.mirror && suggestions.mirror->plane());
  // Closed it has no flattening of which anything could be said.
  EXPECT_TRUE(std::isnan(suggestions.strainBefore));
  EXPECT_TRUE(std::isnan(suggestions.curves.front().gain));
  EXPECT_GT(suggestions.curves.front().strainAfter, 0.1);
  std::size_t pairs = 0;
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    if (cut.mirrorOf == none)
    {
      // Alone only what opens the body in its mirror plane.
      const bool paired =
        std::any_of(suggestions.curves.begin(), suggestions.curves.end(), [&](const auto& other) {
          return other.mirrorOf != none && &suggestions.curves[other.mirrorOf] == &cut;
        });
      for (const Point3& point : cut.curve.points)
      {
        EXPECT_TRUE(paired || std::abs(point.x()) < 1e-9) << cut.curve.name;
      }
      continue;
    }
    ++pairs;
    const SuggestedCurve& image = suggestions.curves[cut.mirrorOf];
    EXPECT_NEAR(cut.length, image.length, 1e-12) << cut.curve.name;
    ASSERT_EQ(cut.curve.points.size(), image.curve.points.size());
    for (std::size_t k = 0; k < cut.curve.points.size(); ++k)
    {
      const Point3& point = cut.curve.points[k];
      EXPECT_LT((Point3(-point.x(), point.y(), point.z()) - image.curve.points[k]).norm(), 1e-9);
    }
  }
  EXPECT_GE(pairs, 2U);
  const FlatteningResult result = flattened(pear(), {}, suggestions);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
}

TEST(SuggestedSets, HalvesAreImagesWhereCoordinatesHaveSixDigits)
{
  for (double turn : { 0.4, 1.1 })
  {
    for (double scale : { 1.0, 80.0 })
    {
      const TriangleMesh body = moved(pear(), [&](const Point3& p) -> Point3 {
        const Point3 turned(p.x() * std::cos(turn) - p.y() * std::sin(turn),
          p.x() * std::sin(turn) + p.y() * std::cos(turn), p.z());
        return (1e5 * turned).array().round().matrix() * 1e-5 * scale;
      });
      const CurveSuggestions suggestions =
        suggestCurves(body, {}, optionsOf(0.15, 9, SuggestedCuts::All, 3.0));
      EXPECT_TRUE(suggestions.mirror.has_value()) << turn << ' ' << scale;
      EXPECT_TRUE(arePaired(suggestions.curves));
    }
  }
}

TEST(SuggestedSets, FindTheDartsThatASkirtWasSewnWith)
{
  const Skirt sewn = sewnSkirt();
  const CurveSuggestions suggestions =
    suggestCurves(sewn.mesh, {}, optionsOf(0.004, 4, SuggestedCuts::Darts, 40.0));
  EXPECT_EQ(suggestions.curves.size(), 4U);
  const double size = std::sqrt(sewn.mesh.area() / pi);
  for (const Polyline& dart : sewn.darts)
  {
    EXPECT_LT(missOf(dart, suggestions), 0.1 * size) << dart.name;
  }
}

namespace
{
/// A box whose faces are divided along each side; turned, so that no face lies along an axis.
TriangleMesh box(const Point3& size, Index divisions, double scale)
{
  std::vector<Surface> faces;
  for (Index axis = 0; axis < 3; ++axis)
  {
    for (const bool far : { false, true })
    {
      faces.push_back(patch(divisions, divisions, [&](double i, double j) {
        Point3 at;
        at[axis] = far ? divisions : 0.0;
        at[(axis + 1) % 3] = far ? i : j;
        at[(axis + 2) % 3] = far ? j : i;
        const Point3 p = scale / divisions * size.cwiseProduct(at);
        return Point3(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y(), p.z());
      }));
    }
  }
  const TriangleMesh apart = together(faces).mesh;
  return prepareSurface(apart.points(), apart.triangles(), CoincidentPoints::Join).mesh;
}

/// A pyramid without its base.
TriangleMesh pyramid(Index sides, double height)
{
  Points3 points;
  Triangles triangles;
  for (Index k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * pi * k / sides;
    points.emplace_back(std::cos(angle), 1.3 * std::sin(angle), 0.0);
    triangles.push_back({ k, (k + 1) % sides, sides });
  }
  points.emplace_back(0.1, 0.2, height);
  return { std::move(points), std::move(triangles) };
}

/// A closed can with a polygon for its rim.
TriangleMesh can(Index sides, double height)
{
  const TriangleMesh wall = revolved(sides, 1, height);
  Points3 points = wall.points();
  Triangles triangles = wall.triangles();
  points.insert(points.end(), { Point3(0.0, 0.0, 0.0), Point3(0.0, 0.0, height) });
  for (Index k = 0; k < sides; ++k)
  {
    const Index next = (k + 1) % sides;
    triangles.push_back({ next, k, 2 * sides });
    triangles.push_back({ sides + k, sides + next, 2 * sides + 1 });
  }
  return { std::move(points), std::move(triangles) };
}

void expectExact(const TriangleMesh& mesh, SuggestedCuts cuts, std::size_t most)
{
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, optionsOf(0.01, 8, cuts, 5.0));
  ASSERT_TRUE(suggestions.status.ok()) << suggestions.status.message;
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_FALSE(suggestions.curves.empty());
  EXPECT_LE(suggestions.curves.size(), most);
  EXPECT_LT(suggestions.strainAfter, 1e-9);
  EXPECT_TRUE(flattened(mesh, {}, suggestions).status.ok());
}
}

TEST(SuggestedSets, SharpEdgesOfABoxBecomeItsNet)
{
  for (Index divisions : { 1, 2, 3 })
  {
    for (double scale : { 1e-3, 1.0, 500.0 })
    {
      expectExact(box({ 2.0, 3.0, 1.2 }, divisions, scale), SuggestedCuts::All, 7);
    }
  }
  // Edges of the ends are far shorter than the mean.
  for (const Point3& rod :
    { Point3(300.0, 2.0, 2.0), Point3(2.0, 300.0, 2.0), Point3(2.0, 2.0, 300.0) })
  {
    for (Index divisions : { 1, 2 })
    {
      expectExact(box(rod, divisions, 1.0), SuggestedCuts::All, 8);
      expectExact(box(rod, divisions, 1.0), SuggestedCuts::Seams, 8);
    }
  }
  expectExact(box({ 2.0, 3.0, 1.2 }, 2, 1.0), SuggestedCuts::Darts, 7);
  expectExact(box({ 2.0, 3.0, 1.2 }, 2, 1.0), SuggestedCuts::Seams, 7);
}

TEST(SuggestedSets, SeamsOfABoxDoNotGoAcrossItsFaces)
{
  const Point3 size(24.0, 16.0, 10.0);
  const CurveSuggestions suggestions = suggestCurves(box(size, 8, 1.0), {}, optionsOf(0.01, 8));
  ASSERT_TRUE(suggestions.boundMet);
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    for (const Point3& p : cut.curve.points)
    {
      const Point3 at(0.6 * p.x() + 0.8 * p.y(), 0.6 * p.y() - 0.8 * p.x(), p.z()); // turned back
      const Point3 off = at.cwiseAbs().cwiseMin((size - at).cwiseAbs());
      EXPECT_GE((off.array() < 1e-9).count(), 2) << at.transpose();
    }
  }
}

TEST(SuggestedSets, APyramidIsCutFromItsBaseToItsApex)
{
  for (Index sides : { 3, 4, 7 })
  {
    for (double height : { 0.5, 1.5 })
    {
      expectExact(pyramid(sides, height), SuggestedCuts::All, 1);
      expectExact(pyramid(sides, height), SuggestedCuts::Darts, 1);
    }
  }
}

TEST(SuggestedSets, ACanIsCutAlongItsRims)
{
  for (Index sides : { 16, 40 })
  {
    expectExact(can(sides, 1.0), SuggestedCuts::All, 3);
    expectExact(can(sides, 3.0), SuggestedCuts::All, 3);
  }
}

TEST(CurveSuggestion, PartsWhatLiesOverItselfWithoutStrain)
{
  // Ramps round an axis: rings of more than a turn in the plane. In ribbons of one row no vertex is
  // inside, so that a large one has no version with fewer triangles.
  struct Ramp
  {
    double turns;
    Index columns;
    Index rows;
  };
  for (const auto& [turns, columns, rows] : { Ramp{ 1.02, 90, 5 }, Ramp{ 1.5, 90, 5 },
         Ramp{ 2.6, 90, 5 }, Ramp{ 8.0, 500, 1 }, Ramp{ 1.5, 7600, 1 } })
  {
    const double step = 1.0 / columns;
    const double width = 0.5 / rows;
    const double rise = turns / 3.0;
    const double angleStep = 2.0 * pi * turns * step;
    const TriangleMesh ramp = patch(columns, rows, [=](double i, double j) {
      const double radius = 1.0 + width * j;
      return Point3(
        radius * std::cos(angleStep * i), radius * std::sin(angleStep * i), rise * step * i);
    }).mesh;
    const FlatteningResult uncut = flattenSurface(ramp, {}, {}, {});
    ASSERT_EQ(uncut.status.code, StatusCode::Overlap) << turns;
    const CurveSuggestions suggestions = suggestCurves(ramp, {}, optionsOf(0.05, 0));
    EXPECT_TRUE(suggestions.boundMet) << turns;
    EXPECT_LE(suggestions.curves.size(), static_cast<std::size_t>(2.0 * turns)) << turns;
    const FlatteningResult flat = flattened(ramp, {}, suggestions);
    EXPECT_EQ(flat.status.code, StatusCode::Ok) << turns;
  }
}

TEST(CutSets, SliversBetweenSeamsAreJoinedWithALargerNeighbor)
{
  // Across a flat sheet, beside a straight seam another one: all along it, or bent across it twice,
  // of which two stretches stay. The same in two halves that mirror each other.
  const TriangleMesh sheet = unitSquares(20, 10).mesh;
  const std::vector<Polyline> none;
  SuggestionOptions options = optionsOf(0.05, 0);
  const Points3 straight{ { 5, 0, 0 }, { 5, 10, 0 } };
  const Points3 beside{ { 5.1, 0, 0 }, { 5.1, 10, 0 } };
  const Points3 across{ { 7, 0, 0 }, { 4.9, 4, 0 }, { 4.9, 6, 0 }, { 7, 10, 0 } };
  for (bool mirrored : { false, true })
  {
    for (bool crossed : { false, true })
    {
      SCOPED_TRACE(crossed);
      CutSet set;
      const auto add = [&set](Points3 points, Index mirrorOf) {
        for (Point3& p : points)
        {
          p.x() = mirrorOf == flattening::none ? p.x() : 20.0 - p.x();
        }
        set.cuts.push_back(proposedCut(std::move(points), CurveType::Seam, mirrorOf));
      };
      add(straight, flattening::none);
      add(crossed ? across : beside, flattening::none);
      if (mirrored)
      {
        add(straight, 0);
        add(crossed ? across : beside, 1);
      }
      const std::size_t sides = mirrored ? 2 : 1;
      const CutTrials trials(sheet, {}, {}, options.flattening);
      TrialBudget budget(1e12);
      set.outcome = trials.trial(linesOf(set.cuts), budget, {}).outcome;
      ASSERT_EQ(set.outcome.pieceAreas.size(), 1 + (crossed ? 4 : 2) * sides);
      const SearchSubject subject{ sheet, none, options.imprint, options.flattening, options.search,
        std::nullopt, {} };
      const CutSet fewer = withoutSmallPieces(set, subject, trials, budget, {});
      ASSERT_EQ(fewer.cuts.size(), (crossed ? 3 : 1) * sides);
      EXPECT_EQ(fewer.outcome.pieceAreas.size(), 1 + (crossed ? 3 : 1) * sides);
      EXPECT_TRUE(fewer.outcome.keeps(0.05));
      options.search.maximumCuts = static_cast<Index>(2 * sides); // seams in parts are more
      const SearchSubject limited{ sheet, none, options.imprint, options.flattening, options.search,
        std::nullopt, {} };
      EXPECT_EQ(withoutSmallPieces(set, limited, trials, budget, {}).cuts.size(),
        (crossed ? 2 : 1) * sides);
      options.search.maximumCuts = 0;
      for (std::size_t k = fewer.cuts.size() / sides; k < fewer.cuts.size(); ++k)
      {
        const SuggestedCurve& image = fewer.cuts[k];
        ASSERT_NE(image.mirrorOf, flattening::none) << k;
        EXPECT_NEAR(image.length, fewer.cuts[image.mirrorOf].length, 1e-9);
      }
    }
  }
}

TEST(CurveSuggestion, SaysThatPiecesOverlapWhereTheStrainIsWithinTheBound)
{
  CurveSuggestions suggestions;
  suggestions.strainBefore = 0.4;
  suggestions.strainAfter = 0.2;
  const std::string within = describeShortfall(suggestions, 0.3, 0.0, {});
  EXPECT_NE(within.find("fold or overlap"), std::string::npos) << within;
  EXPECT_EQ(within.find("above"), std::string::npos) << within;
  const std::string above = describeShortfall(suggestions, 0.1, 0.0, {});
  EXPECT_NE(above.find("above the bound of 10 %"), std::string::npos) << above;
}
