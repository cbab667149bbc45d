// SPDX-License-Identifier: BSD-3-Clause
#include "Cut/CutClosure.h"
#include "Flattened.h"
#include "SameResult.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr Index spokes = 24;

/// A point at the distance 1 from the apex: on a circular cone for parameters below 0, on one that
/// waves up and down above.
Point3 onCone(double parameter, Index spoke)
{
  const double t = 2.0 * pi * spoke / spokes;
  return Point3(
    std::cos(t), std::sin(t), parameter < 0.0 ? -parameter : parameter * std::sin(2.0 * t))
    .normalized();
}

/// The parameter with which the apex is surrounded by an angle.
double parameterFor(double angle)
{
  double low = -10.0;
  double high = 10.0;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (low + high);
    double sum = 0.0;
    for (Index s = 0; s < spokes; ++s)
    {
      sum += std::acos(onCone(middle, s).dot(onCone(middle, s + 1)));
    }
    (sum < angle ? low : high) = middle;
  }
  return low;
}

/// Rings around an apex, ring k = 1, 2, ... at the distance k and seen from the apex under the
/// angle angles[k - 1], cut from the rim to the apex. Vertex 0 is the apex, ring k has the vertices
/// 1 + spokes (k - 1) to spokes k.
Surface cutCone(const std::vector<double>& angles)
{
  Points3 points{ Point3::Zero() };
  Indices spoke{ 0 };
  const auto rings = static_cast<Index>(angles.size());
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double parameter = parameterFor(angles[ring - 1]);
    spoke.push_back(1 + spokes * (ring - 1));
    for (Index s = 0; s < spokes; ++s)
    {
      points.push_back(ring * onCone(parameter, s));
    }
  }
  return { TriangleMesh(points, ringTriangles(spokes, rings, spokes)),
    { curveOf(CurveType::Dart, "slit", spoke) }, {} };
}

FlatteningResult flattened(const Surface& surface, Scheme scheme, bool closeCuts)
{
  FlatteningOptions options = withScheme(scheme);
  options.closeCuts = closeCuts;
  return flatten(surface, options);
}
}

TEST(CutClosure, TakesTimeInProportionToTheLengthOfTheCut)
{
  // A slit along the middle of a strip, every other vertex of one side across the other.
  constexpr Index columns = 100000;
  constexpr Index rows = 4;
  Surface strip = unitSquares(columns, rows);
  Indices slit;
  for (Index i = 1; i <= columns; ++i)
  {
    slit.push_back(2 * (columns + 1) + i);
  }
  strip.curves = { curveOf(CurveType::Dart, "slit", slit) };
  const CutSurface cut = cutSurface(strip.mesh, strip.curves);
  const Piece piece = extractPieces(cut).front();
  Points2 positions;
  for (const Point3& p : piece.mesh.points())
  {
    positions.emplace_back(p.x(), p.y());
  }
  const Points2 open = positions;
  const std::vector<CutSides> sides = findCutSides(piece, cut);
  for (const auto& pair : sides.front().pairs)
  {
    Point2& first = positions[pair[0]];
    Point2& second = positions[pair[1]];
    const double across = static_cast<Index>(first.x()) % 2 == 0 ? 0.1 : -0.1;
    first.y() += across;
    second.y() -= across;
  }

  Indices joined;
  const double whole = secondsOf([&] {
    closeCuts(piece, cut, positions, [&](const Indices& first) {
      joined = first;
      return std::optional<Points2>(open);
    });
  });
  const double once = secondsOf([&] { joinVertices(piece, joined); });
  EXPECT_LT(whole, 30.0 * once);

  Index copies = 0;
  for (std::size_t v = 0; v < joined.size(); ++v)
  {
    copies += joined[v] == static_cast<Index>(v) ? 0 : 1;
  }
  EXPECT_GE(copies, columns / 2 - 1);
}

TEST(CutClosure, ASaddleConeCutToItsApexOverlapsUnlessTheCutIsClosed)
{
  // Around the apex there are 6.6 radians, in the plane 2 pi at the most.
  const Surface surface = cutCone({ 6.6, 6.6, 6.6, 6.6 });
  for (Scheme scheme : { Scheme::Progressive, Scheme::Global, Scheme::Isometric })
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    const FlatteningResult open = flattened(surface, scheme, false);
    EXPECT_STREQ(statusName(open.status.code), "Overlap");
    EXPECT_NE(open.status.message.find("\"slit\""), std::string::npos) << open.status.message;
    EXPECT_EQ(open.curves[0].closedLength, 0.0);
    EXPECT_TRUE(std::all_of(
      open.wires.begin(), open.wires.end(), [](const Wire& wire) { return wire.boundary; }));

    const FlatteningResult closed = flattened(surface, scheme, true);
    EXPECT_STREQ(statusName(closed.status.code), "Ok") << closed.status.message;
    EXPECT_NEAR(closed.curves[0].closedLength, 4.0, 1e-12);
    for (const Wire& wire : closed.wires)
    {
      EXPECT_EQ(wire.boundary, wire.curve != 0) << "closed sides do not bound the piece";
    }
    EXPECT_EQ(std::count_if(closed.wires.begin(), closed.wires.end(),
                [](const Wire& wire) { return wire.curve == 0; }),
      2);
    EXPECT_EQ(closed.pieces[0].vertices, open.pieces[0].vertices);
    for (const SeamPair& pair : closed.cut->seamPairs)
    {
      const TriangleMesh& mesh = closed.cut->mesh;
      EXPECT_EQ(closed.positions[mesh.from(pair.first)], closed.positions[mesh.to(pair.second)]);
      EXPECT_EQ(closed.positions[mesh.to(pair.first)], closed.positions[mesh.from(pair.second)]);
    }
    EXPECT_LE(worstLength(closed), 1e-12);
  }
}

TEST(CutClosure, ACutWhoseSidesOpenIsLeftAsItIs)
{
  const Surface surface = cutCone({ 5.5, 5.5, 5.5, 5.5 });
  const FlatteningResult open = flattened(surface, Scheme::Isometric, false);
  const FlatteningResult closed = flattened(surface, Scheme::Isometric, true);
  EXPECT_TRUE(closed.status.ok());
  EXPECT_EQ(closed.positions, open.positions);
  EXPECT_TRUE(closed.pieces[0].closedEdges.empty());
}

TEST(CutClosure, ACutIsClosedOnlyWhereItsSidesCross)
{
  // The inner rings ask for an open cut, the outer ones for more cloth than there is.
  const Surface surface = cutCone({ 5.6, 5.6, 6.6, 7.4, 7.8 });
  EXPECT_STREQ(statusName(flattened(surface, Scheme::Isometric, false).status.code), "Overlap");
  const FlatteningResult closed = flattened(surface, Scheme::Isometric, true);
  EXPECT_STREQ(statusName(closed.status.code), "Ok") << closed.status.message;
  EXPECT_GT(closed.curves[0].closedLength, 0.0);
  EXPECT_LT(closed.curves[0].closedLength, closed.curves[0].restLength);
  EXPECT_LE(worstLength(closed), 1e-12);
}

TEST(CutClosure, WhereOnlyTheMouthCrossesNoTwoFansOfTrianglesAreHeldTogetherAtAVertex)
{
  int overlapping = 0;
  for (double inner = 4.5; inner < 6.2; inner += 0.2)
  {
    for (double outer = 6.4; outer < 9.5; outer += 0.2)
    {
      const Surface surface = cutCone({ inner, inner, inner, inner, outer });
      if (flattened(surface, Scheme::Isometric, false).status.ok())
      {
        continue;
      }
      ++overlapping;
      SCOPED_TRACE(std::to_string(inner) + " inside, " + std::to_string(outer) + " at the rim");
      const FlatteningResult closed = flattened(surface, Scheme::Isometric, true);
      EXPECT_STREQ(statusName(closed.status.code), "Ok") << closed.status.message;
      // A closed pair of vertices has a closed edge beside it.
      const TriangleMesh& mesh = closed.cut->mesh;
      for (const SeamPair& pair : closed.cut->seamPairs)
      {
        const Index ends[2][2] = { { mesh.from(pair.first), mesh.to(pair.second) },
          { mesh.to(pair.first), mesh.from(pair.second) } };
        for (const auto& end : ends)
        {
          if (end[0] == end[1] || closed.positions[end[0]] != closed.positions[end[1]])
          {
            continue;
          }
          const std::vector<Index>& edges = closed.pieces[0].closedEdges;
          EXPECT_TRUE(std::any_of(edges.begin(), edges.end(),
            [&](Index h) { return mesh.from(h) == end[0] || mesh.to(h) == end[0]; }));
        }
      }
    }
  }
  EXPECT_GE(overlapping, 8);
}

TEST(CutClosure, JoinedSidesLeaveNothingInTheCache)
{
  const Surface surface = cutCone({ 5.6, 5.6, 6.6, 7.4, 7.8 });
  FlatteningOptions options;
  FlatteningCache cache;
  for (const bool closeCuts : { false, true, true, false })
  {
    options.closeCuts = closeCuts;
    const FlatteningResult with = flatten(surface, options, {}, &cache);
    const FlatteningResult without = flatten(surface, options);
    expectSame(with, without);
    EXPECT_EQ(with.pieces[0].closedEdges, without.pieces[0].closedEdges);
    EXPECT_EQ(with.pieces[0].closedEdges.empty(), !closeCuts);
  }
}
