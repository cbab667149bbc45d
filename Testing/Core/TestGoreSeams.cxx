// SPDX-License-Identifier: BSD-3-Clause

#include "SuggestionTesting.h"

using namespace flattening;
using namespace testmeshes;

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

TEST(GoreSeams, KeepToTheLimitOfCuts)
{
  const Cut cut = cutInto(sphere(3), [](SearchOptions& search) { search.maximumCuts = 4; });
  EXPECT_LE(cut.found.curves.size(), 4U);
  EXPECT_FALSE(cut.found.boundMet);
  EXPECT_NEAR(cut.worst, cut.found.strainAfter, 1e-9);
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
