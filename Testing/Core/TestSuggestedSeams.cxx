// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/PieceTopology.h"
#include "Suggestion/CutCandidates.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/SideSeams.h"
#include "SuggestionTesting.h"
#include "TestMeshes.h"

#include <map>
#include <set>

using namespace flattening;
using namespace testmeshes;

namespace
{
using Place = std::pair<int, int>;

/// Two sheets over the squares of a lattice, joined along their outline but for openings, and
/// farther from each other the farther they are from there.
/// \param opens whether the edge of the outline with this middle is of an opening
TriangleMesh garment(
  const std::set<Place>& squares, const std::function<bool(double x, double y)>& opens)
{
  std::set<Place> joined;
  for (const auto& [x, y] : squares)
  {
    for (const auto& [dx, dy] : { Place(1, 0), Place(-1, 0), Place(0, 1), Place(0, -1) })
    {
      if (squares.count({ x + dx, y + dy }) == 0 && !opens(x + 0.5 + 0.5 * dx, y + 0.5 + 0.5 * dy))
      {
        joined.insert({ x + (dx > 0 ? 1 : 0), y + (dy > 0 ? 1 : 0) });
        joined.insert({ x + (dx < 0 ? 0 : 1), y + (dy < 0 ? 0 : 1) });
      }
    }
  }
  Points3 points;
  std::map<std::pair<Place, int>, Index> numbers;
  const auto vertex = [&](Place place, int side) {
    double apart = 1e9;
    for (const auto& [x, y] : joined)
    {
      apart = std::min(apart, std::hypot(x - place.first, y - place.second));
    }
    const auto [found, isNew] =
      numbers.try_emplace({ place, apart > 0.0 ? side : 0 }, static_cast<Index>(points.size()));
    if (isNew)
    {
      points.push_back({ double(place.first), double(place.second), 0.15 * side * apart });
    }
    return found->second;
  };
  Triangles triangles;
  for (const auto& [x, y] : squares)
  {
    for (int side : { 1, -1 })
    {
      const Index a = vertex({ x, y }, side);
      const Index b = vertex({ x + (side > 0 ? 1 : 0), y + (side > 0 ? 0 : 1) }, side);
      const Index c = vertex({ x + 1, y + 1 }, side);
      const Index d = vertex({ x + (side > 0 ? 0 : 1), y + (side > 0 ? 1 : 0) }, side);
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return TriangleMesh(std::move(points), std::move(triangles));
}

/// The squares from x = -half to half and y = 0 to top that a function keeps.
std::set<Place> squaresOf(int half, int top, const std::function<bool(int x, int y)>& isKept)
{
  std::set<Place> squares;
  for (int x = -half; x < half; ++x)
  {
    for (int y = 0; y < top; ++y)
    {
      if (isKept(x, y))
      {
        squares.insert({ x, y });
      }
    }
  }
  return squares;
}

/// With neck, hem and two sleeves.
TriangleMesh shirt()
{
  return garment(squaresOf(12, 15, [](int x, int y) { return y >= 10 || std::abs(x + 0.5) < 5; }),
    [](double x, double y) {
      return y == 0.0 || std::abs(x) == 12.0 || (y == 15.0 && std::abs(x) < 3.0);
    });
}

TriangleMesh trousers()
{
  return garment(squaresOf(6, 20, [](int x, int y) { return y >= 14 || std::abs(x + 0.5) >= 2; }),
    [](double, double y) { return y == 0.0 || y == 20.0; });
}

TriangleMesh skirt()
{
  return garment(squaresOf(5, 14, [](int, int) { return true; }),
    [](double, double y) { return y == 0.0 || y == 14.0; });
}

std::optional<SurfaceMirror> mirrorOf(const TriangleMesh& mesh)
{
  return SurfaceMirror(measuredPlane(mesh, SymmetryPlane{ Point3::UnitX(), 0.0 }));
}

/// Each seam lies where the sheets are joined, and they part the surface into both.
void expectSheets(const TriangleMesh& mesh, const std::vector<SuggestedCurve>& seams)
{
  std::vector<Polyline> lines;
  for (const SuggestedCurve& seam : seams)
  {
    lines.push_back(seam.curve);
    for (const Point3& point : seam.curve.points)
    {
      EXPECT_NEAR(point.z(), 0.0, 0.2) << point.transpose();
    }
  }
  const ImprintedSurface surface = imprintCurves(mesh, lines, {});
  ASSERT_TRUE(surface.status.ok()) << surface.status.message;
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  ASSERT_EQ(cut.pieceCount, 2);
  for (const Piece& piece : extractPieces(cut))
  {
    EXPECT_EQ(eulerCharacteristic(piece.mesh), 1);
    EXPECT_NEAR(piece.mesh.area(), 0.5 * mesh.area(), 0.02 * mesh.area());
  }
}
}

TEST(SideSeams, PartAGarmentIntoFrontAndBackInPairsOfEqualLength)
{
  const struct
  {
    TriangleMesh mesh;
    std::size_t seams;
  } cases[] = { { skirt(), 2 }, { trousers(), 3 }, { shirt(), 4 } };
  for (const auto& [mesh, count] : cases)
  {
    for (bool mirrored : { true, false })
    {
      SCOPED_TRACE(count + (mirrored ? 10 : 0));
      const std::vector<SuggestedCurve> seams =
        sideSeams(mesh, mirrored ? mirrorOf(mesh) : std::nullopt);
      ASSERT_EQ(seams.size(), count);
      expectSheets(mesh, seams);
      std::size_t pairs = 0;
      for (const SuggestedCurve& seam : seams)
      {
        if (seam.mirrorOf != none)
        {
          ++pairs;
          EXPECT_NEAR(seam.length, seams[seam.mirrorOf].length, 1e-12 * seam.length);
        }
      }
      EXPECT_TRUE(!mirrored || count != 4 || pairs == 2);
    }
  }
}

TEST(SideSeams, AreOfSurfacesWithTwoOpenings)
{
  EXPECT_TRUE(sideSeams(cushion(6, 6, 0.4).mesh, {}).empty());
  EXPECT_TRUE(sideSeams(torus(14, 3.0), {}).empty());
}

TEST(SideSeams, AreProposedFirst)
{
  // Shallow sheets lie flat within the bound, and no seam but those along the outline is needed.
  const CurveSuggestions suggestions = suggestCurves(trousers(), {}, optionsOf(0.05, 0));
  EXPECT_TRUE(suggestions.boundMet);
  ASSERT_EQ(suggestions.curves.size(), 3u);
  expectSheets(trousers(), suggestions.curves);
}

TEST(SideSeams, AreNotProposedWhereFewerOpenATube)
{
  // The neckline of a flat shirt is a hole, and its sleeves and shoulders fold.
  const CurveSuggestions suggestions = suggestCurves(shirt(), {}, optionsOf(0.05, 0));
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_EQ(suggestions.curves.size(), 2u);
}

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

namespace
{
/// The outcome with the proposals that is measured anew.
struct Cut
{
  CurveSuggestions found;
  FlatteningResult flat;
  std::vector<double> areas; ///< by piece, on the surface
  double worst = 0.0;        ///< strain
};

Cut cutInto(const TriangleMesh& mesh, const std::function<void(SearchOptions&)>& choose)
{
  SuggestionOptions options;
  choose(options.search);
  Cut cut;
  cut.found = suggestCurves(mesh, {}, options);
  cut.flat = flattened(mesh, {}, cut.found);
  cut.areas.assign(cut.flat.pieces.size(), 0.0);
  for (Index t = 0; t < cut.flat.cut->mesh.triangleCount(); ++t)
  {
    cut.areas[cut.flat.cut->pieceOfTriangle[t]] += cut.flat.cut->mesh.area(t);
  }
  cut.worst = worstStrain(cut.flat);
  for (const PieceReport& piece : cut.flat.pieces)
  {
    EXPECT_TRUE(piece.status.ok()) << piece.status.message;
  }
  return cut;
}

/// The unit sphere between two of its parallels, turned and shifted so that the axis is none of the
/// coordinates'.
TriangleMesh zone(double from, double to)
{
  const Eigen::AngleAxisd turn(0.7, Point3(1.0, 2.0, 3.0).normalized());
  return rolledUp(48, 32, [&](double around, double share) {
    const double height = from + share * (to - from);
    const double radius = std::cos(height);
    return Point3(
      turn * Point3(radius * std::cos(around), radius * std::sin(around), std::sin(height)) +
      Point3(5.0, -3.0, 2.0));
  });
}
}

TEST(GoreSeams, PartABallIntoEqualGoresFromPoleToPole)
{
  const TriangleMesh ball = sphere(4);
  for (double bound : { 0.05, 0.1 })
  {
    const Cut cut = cutInto(ball, [&](SearchOptions& search) { search.bound = bound; });
    const std::size_t count = cut.found.curves.size();
    ASSERT_EQ(cut.flat.pieces.size(), count);
    EXPECT_TRUE(cut.found.boundMet);
    EXPECT_LE(cut.worst, bound);
    for (const SuggestedCurve& seam : cut.found.curves)
    {
      EXPECT_NEAR(seam.length, pi, 0.01); // half a great circle of the chords
    }
    for (double area : cut.areas)
    {
      EXPECT_NEAR(area, ball.area() / static_cast<double>(count), 0.01);
    }
    // One less does not do.
    const Cut fewer =
      cutInto(ball, [&](SearchOptions& search) { search.pieces = static_cast<Index>(count) - 1; });
    EXPECT_EQ(fewer.flat.pieces.size(), count - 1);
    EXPECT_GT(fewer.worst, bound);
  }
}

TEST(GoreSeams, PartZonesOfRevolutionFromEdgeToEdge)
{
  const Cut cut = cutInto(zone(-0.9, 1.1), [](SearchOptions& search) { search.bound = 0.05; });
  EXPECT_GE(cut.found.curves.size(), 2U);
  EXPECT_EQ(cut.flat.pieces.size(), cut.found.curves.size());
  EXPECT_LE(cut.worst, 0.05);
  for (const SuggestedCurve& seam : cut.found.curves)
  {
    EXPECT_NEAR(seam.length, 2.0, 0.01); // a meridian
  }
}

TEST(GoreSeams, OpenADevelopableZoneOnce)
{
  const TriangleMesh cone = revolved(60, 10, 2.0, [](double share) { return 1.0 + share; });
  const Cut cut = cutInto(cone, [](SearchOptions& search) { search.bound = 0.05; });
  ASSERT_EQ(cut.found.curves.size(), 1U);
  EXPECT_NEAR(cut.found.curves.front().length, std::sqrt(5.0), 1e-9);
  EXPECT_LT(cut.worst, 1e-6);
}

TEST(GoreSeams, HaveEqualWidthsInTheMiddleWhereTheSurfaceIsNotRound)
{
  const TriangleMesh pebble = moved(
    sphere(4), [](const Point3& p) -> Point3 { return p.cwiseProduct(Point3(1.3, 0.8, 1.7)); });
  const Cut cut = cutInto(pebble, [](SearchOptions& search) {
    search.pieces = 8;
    search.cuts = SuggestedCuts::Gores;
  });
  ASSERT_EQ(cut.found.curves.size(), 8U);
  // Where seams cross the middle.
  std::vector<double> angles;
  for (const SuggestedCurve& seam : cut.found.curves)
  {
    const Points3& line = seam.curve.points;
    for (std::size_t k = 1; k < line.size(); ++k)
    {
      if ((line[k - 1].z() < 0.0) != (line[k].z() < 0.0))
      {
        const double share = line[k - 1].z() / (line[k - 1].z() - line[k].z());
        const Point3 place = line[k - 1] + share * (line[k] - line[k - 1]);
        angles.push_back(std::atan2(place.y() / 0.8, place.x() / 1.3));
      }
    }
  }
  ASSERT_EQ(angles.size(), 8U);
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2.0 * pi);
  std::vector<double> widths;
  for (std::size_t k = 1; k < angles.size(); ++k)
  {
    double width = 0.0; // of the ellipse
    for (int step = 0; step < 1000; ++step)
    {
      const double at = angles[k - 1] + (step + 0.5) / 1000.0 * (angles[k] - angles[k - 1]);
      width += std::hypot(1.3 * std::sin(at), 0.8 * std::cos(at)) * (angles[k] - angles[k - 1]);
    }
    widths.push_back(width / 1000.0);
  }
  const auto [least, most] = std::minmax_element(widths.begin(), widths.end());
  EXPECT_LT(*most / *least, 1.03);
}

TEST(GoreSeams, PartARingIntoTubesOpenedAlongItsInside)
{
  const double arm = 3.0;
  const TriangleMesh ring = torus(24, arm);
  for (Index pieces : { 0, 1, 5 })
  {
    const Cut cut = cutInto(ring, [&](SearchOptions& search) { search.pieces = pieces; });
    const auto count = static_cast<Index>(cut.areas.size());
    ASSERT_EQ(static_cast<Index>(cut.found.curves.size()), 2 * count);
    EXPECT_EQ(cut.found.boundMet, cut.worst <= 0.05);
    EXPECT_TRUE(pieces == 0 ? cut.found.boundMet : count == pieces);
    for (double area : cut.areas)
    {
      EXPECT_NEAR(area * static_cast<double>(count), ring.area(), 0.02 * ring.area());
    }
    double around = 0.0;
    double along = 0.0;
    for (const SuggestedCurve& seam : cut.found.curves)
    {
      const bool loop = seam.curve.points.front() == seam.curve.points.back() &&
        std::abs(seam.length - 2.0 * pi) < 0.1;
      (loop ? around : along) += seam.length;
    }
    EXPECT_NEAR(around, 2.0 * pi * static_cast<double>(count), 0.1 * static_cast<double>(count));
    EXPECT_NEAR(along, 2.0 * pi * (arm - 1.0), 0.2);
  }
}

TEST(GoreSeams, LeaveABentTubeToOtherSeams)
{
  const TriangleMesh bent = rolledUp(24, 32, [](double around, double share) {
    const double turn = 1.2 * pi * share; // of a ring a part, whose axis is outside
    const double arm = 3.0 + std::cos(around);
    return Point3(arm * std::cos(turn), arm * std::sin(turn), std::sin(around));
  });
  SuggestionOptions options;
  options.search.cuts = SuggestedCuts::Gores;
  EXPECT_EQ(suggestCurves(bent, {}, options).status.code, StatusCode::InvalidOption);
}

TEST(OpeningCuts, MakeADiskOfATorus)
{
  const TriangleMesh mesh = torus(14, 3.0);
  const ImprintedSurface surface = imprintCurves(mesh, openingCuts(mesh), {});
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  EXPECT_EQ(cut.pieceCount, 1);
  EXPECT_EQ(eulerCharacteristic(cut.mesh), 1);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 1u);
}

TEST(OpeningCuts, JoinTheEndsOfATubeAndLeaveASmallHole)
{
  const auto tube = [](Index missing) {
    const TriangleMesh whole = revolved(24, 16, 3.2);
    Triangles triangles = whole.triangles();
    triangles.erase(triangles.begin() + 350, triangles.begin() + 350 + missing);
    return TriangleMesh(whole.points(), triangles);
  };
  EXPECT_EQ(openingCuts(tube(0)).size(), 1u);
  const TriangleMesh holed = tube(1);
  ASSERT_EQ(holed.boundaryLoops().size(), 3u);
  const ImprintedSurface surface = imprintCurves(holed, openingCuts(holed), {});
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  EXPECT_EQ(cut.mesh.boundaryLoops().size(), 2u);
}

TEST(OpeningCuts, LeaveAWideHoleInASheetThatLiesFlat)
{
  // A ring on a drum: outer edge and hole, half as wide, turn by 2 pi and -2 pi wherever it is
  // bent.
  const auto ring = [](double bend) {
    return rolledUp(30, 6, [=](double turn, double across) {
      const double x = (1.0 + across) * std::cos(turn);
      const double y = (1.0 + across) * std::sin(turn);
      return bend > 0.0 ? Point3(std::sin(bend * x) / bend, y, (1.0 - std::cos(bend * x)) / bend)
                        : Point3(x, y, 0.0);
    });
  };
  for (double bend : { 0.0, 0.2 })
  {
    EXPECT_TRUE(openingCuts(ring(bend)).empty());
    const CurveSuggestions suggestions = suggestCurves(ring(bend), {}, optionsOf(0.02, 8));
    EXPECT_TRUE(suggestions.boundMet);
    EXPECT_TRUE(suggestions.curves.empty());
  }
}

TEST(OpeningCuts, JoinTheEndsOfAFrustum)
{
  // Its edges turn by less than a hole's: by the sine of the angle between its wall and its axis.
  const auto frustum = [](double share) { return 1.0 + share; };
  EXPECT_EQ(openingCuts(revolved(30, 6, 1.0, frustum)).size(), 1u);
}

TEST(OpeningCuts, KeepOffKeyCurves)
{
  // Straight across the tube all ways are equally long, and the key takes half of one end.
  const TriangleMesh tube = revolved(24, 6, 1.0);
  Indices half(13);
  std::iota(half.begin(), half.end(), 0);
  const Polyline key = lineOver(tube, half, CurveType::Key);
  const CurveSuggestions suggestions = suggestCurves(tube, { key }, optionsOf(0.02, 4));
  ASSERT_EQ(suggestions.curves.size(), 1u);
  EXPECT_TRUE(suggestions.boundMet);
  EXPECT_LT(suggestions.strainAfter, 1e-6);
}

namespace
{
SearchedPiece plainPiece(const TriangleMesh& mesh)
{
  return { mesh, std::vector<char>(mesh.vertexCount(), 0), {}, {}, std::nullopt };
}

double highest(const Polyline& line)
{
  double top = -1.0;
  for (const Point3& p : line.points)
  {
    top = std::max(top, p.z());
  }
  return top;
}
}

TEST(CutCandidates, HaveSeamsOverTheTopOfADeepCap)
{
  // Between two places of its boundary, a circle of 30 degrees about the lower pole, the shortest
  // way stays near that circle; only a seam over a place of the inside divides it.
  const TriangleMesh mesh = sphereCap(150.0 * pi / 180.0, 12, 0).mesh;
  const SearchedPiece piece = plainPiece(mesh);
  const ScaleFactor factor(mesh, {}, {});
  ASSERT_TRUE(factor.ok());
  SearchOptions options;
  options.cuts = SuggestedCuts::Seams;
  double shortest = -1.0;
  double over = -1.0;
  for (const CutPlan& plan : planCuts(piece, factor, options, 1e9, {}))
  {
    const std::vector<Polyline> lines = piece.polylines(plan);
    ASSERT_EQ(lines.size(), 1U);
    if (plan.via)
    {
      EXPECT_GE(highest(lines[0]), plan.via->z() - 1e-9);
      over = std::max(over, highest(lines[0]));
    }
    else
    {
      shortest = std::max(shortest, highest(lines[0]));
    }
  }
  EXPECT_LT(shortest, 0.0);
  EXPECT_GT(over, 0.9);
}
