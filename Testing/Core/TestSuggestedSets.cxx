// SPDX-License-Identifier: BSD-3-Clause
#include "Report/SuggestionReport.h"
#include "Sewing/PieceSewing.h"
#include "SuggestionTesting.h"

#include <array>
#include <map>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A closed body that is its own mirror image in x = 0, and in no other plane.
TriangleMesh pear()
{
  const TriangleMesh ball = sphere(3);
  Points3 points;
  for (const Point3& p : ball.points())
  {
    points.emplace_back(
      p.x() * (1.0 + 0.3 * p.y()), 1.3 * p.y() + 0.2 * p.z() * p.z(), p.z() * (1.0 + 0.2 * p.z()));
  }
  return { std::move(points), ball.triangles() };
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
    Polyline dart;
    dart.type = CurveType::Dart;
    dart.name = "designed at " + std::to_string(column);
    for (Index row = hipRows; row >= 12; --row)
    {
      dart.points.push_back(body.point(row * (hipColumns + 1) + column));
    }
    result.darts.push_back(dart);
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
      SuggestionOptions options = optionsOf(bound, 9);
      options.search.maximumWork = work;
      const CurveSuggestions suggestions = suggestCurves(pear(), {}, options);
      ASSERT_TRUE(std::isnan(suggestions.strainAfter)) << work;
      EXPECT_EQ(suggestions.end, SearchEnd::WorkUsedUp) << work;
      EXPECT_FALSE(suggestions.boundMet);
    }
  }
}

TEST(SuggestedSets, HalvesOfAClosedBodyAreCutAlike)
{
  SuggestionOptions options = optionsOf(0.1, 9);
  options.search.maximumWork = 8.0;
  const CurveSuggestions suggestions = suggestCurves(pear(), {}, options);
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
      const TriangleMesh body = pear();
      Points3 points;
      for (const Point3& p : body.points())
      {
        const Point3 turned(p.x() * std::cos(turn) - p.y() * std::sin(turn),
          p.x() * std::sin(turn) + p.y() * std::cos(turn), p.z());
        points.push_back((1e5 * turned).array().round().matrix() * 1e-5 * scale);
      }
      SuggestionOptions options = optionsOf(0.15, 9);
      options.search.maximumWork = 3.0;
      const CurveSuggestions suggestions =
        suggestCurves({ std::move(points), body.triangles() }, {}, options);
      EXPECT_TRUE(suggestions.mirror.has_value()) << turn << ' ' << scale;
      EXPECT_TRUE(std::any_of(suggestions.curves.begin(), suggestions.curves.end(),
        [](const SuggestedCurve& cut) { return cut.mirrorOf != none; }));
    }
  }
}

TEST(SuggestedSets, FindTheDartsThatASkirtWasSewnWith)
{
  const Skirt sewn = sewnSkirt();
  SuggestionOptions options = optionsOf(0.004, 4);
  options.search.cuts = SuggestedCuts::Darts;
  options.search.maximumWork = 40.0;
  const CurveSuggestions suggestions = suggestCurves(sewn.mesh, {}, options);
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
  std::map<std::array<Index, 3>, Index> ids;
  Points3 points;
  Triangles triangles;
  const auto vertex = [&](std::array<Index, 3> at) {
    const auto found = ids.emplace(at, static_cast<Index>(points.size()));
    if (found.second)
    {
      const Point3 p =
        scale / static_cast<double>(divisions) * size.cwiseProduct(Point3(at[0], at[1], at[2]));
      points.emplace_back(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y(), p.z());
    }
    return found.first->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (Index side : { 0, divisions })
    {
      for (Index i = 0; i < divisions; ++i)
      {
        for (Index j = 0; j < divisions; ++j)
        {
          const auto corner = [&](Index a, Index b) {
            std::array<Index, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + a;
            at[(axis + 2) % 3] = j + b;
            return vertex(at);
          };
          const std::array<Index, 4> square{ corner(0, 0), corner(1, 0), corner(1, 1),
            corner(0, 1) };
          for (Triangle t : { Triangle{ square[0], square[1], square[2] },
                 Triangle{ square[0], square[2], square[3] } })
          {
            if (side == 0)
            {
              std::swap(t[1], t[2]);
            }
            triangles.push_back(t);
          }
        }
      }
    }
  }
  return { std::move(points), std::move(triangles) };
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
  Points3 points;
  Triangles triangles;
  for (Index k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * pi * k / sides;
    const Index next = (k + 1) % sides;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    triangles.push_back({ k, next, sides + next });
    triangles.push_back({ k, sides + next, sides + k });
    triangles.push_back({ next, k, 2 * sides });
    triangles.push_back({ sides + k, sides + next, 2 * sides + 1 });
  }
  for (Index k = 0; k < sides; ++k)
  {
    points.push_back(points[k] + Point3(0.0, 0.0, height));
  }
  points.emplace_back(0.0, 0.0, 0.0);
  points.emplace_back(0.0, 0.0, height);
  return { std::move(points), std::move(triangles) };
}

void expectExact(const TriangleMesh& mesh, SuggestedCuts cuts, std::size_t most)
{
  SuggestionOptions options = optionsOf(0.01, 8);
  options.search.cuts = cuts;
  options.search.maximumWork = 5.0;
  const CurveSuggestions suggestions = suggestCurves(mesh, {}, options);
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
  // Ramps round an axis: rings of more than a turn in the plane.
  for (double turns : { 1.02, 1.5, 2.6 })
  {
    const TriangleMesh ramp = patch(90, 5, [turns](double i, double j) {
      const double angle = 2.0 * pi * turns * i / 90.0;
      const double radius = 1.0 + 0.1 * j;
      return Point3(radius * std::cos(angle), radius * std::sin(angle), i / 150.0);
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
