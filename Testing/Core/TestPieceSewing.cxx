// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Sewing/PieceSewing.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
SewingResult sewn(const Surface& surface, const SewingOptions& options, const Execution& run = {})
{
  const FlatteningResult result = flatten(surface);
  return sewPieces(*result.cut, result.positions, options, run);
}

SewingOptions panel(double thickness = 1e-3)
{
  SewingOptions options;
  options.thickness = thickness;
  return options;
}
}

TEST(PieceSewing, ThreadsChangeNoBit)
{
  const FlatteningResult pieces = flatten(cushion(12, 12, 0.2));
  const SewingResult one = sewPieces(*pieces.cut, pieces.positions, panel(), {});
  const SewingResult three = sewPieces(*pieces.cut, pieces.positions, panel(), withThreads(3));
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.shapes.front().measures.distanceMean, three.shapes.front().measures.distanceMean);
}

TEST(PieceSewing, RefusesWhatItCannotSew)
{
  const FlatteningResult pieces = flatten(cushion(12, 12, 0.2));
  const auto code = [&pieces](const Points2& positions, const SewingOptions& options) {
    return sewPieces(*pieces.cut, positions, options, {}).status.code;
  };
  EXPECT_EQ(code({}, panel()), StatusCode::InvalidOption);
  EXPECT_EQ(code(Points2(pieces.positions.size(), Point2(1.0, 1.0)), panel()),
    StatusCode::DegenerateTriangle);
  EXPECT_EQ(sewPieces({}, {}, panel(), {}).status.code, StatusCode::EmptySurface);
  SewingOptions options = panel();
  options.material.emplace();
  const SewingResult refused = sewn(cushion(12, 12, 0.2), options);
  EXPECT_EQ(refused.status.code, StatusCode::InvalidOption);
  EXPECT_NE(refused.status.message.find("stiffness"), std::string::npos);
  EXPECT_TRUE(refused.points.empty());
}

TEST(PieceSewing, LeavesNothingWhenItIsCancelled)
{
  Execution run;
  run.cancel = [] { return true; };
  const SewingResult cancelled = sewn(cushion(12, 12, 0.2), panel(), run);
  EXPECT_EQ(cancelled.status.code, StatusCode::Cancelled);
  EXPECT_TRUE(cancelled.points.empty());
}

TEST(SewnCloth, ASheetThatIsTooLargeForItsFrameHasAShapeAtRestOnEachSide)
{
  // Nothing but the frame, which is plane, tells cloth where the design is: what is at rest above
  // the frame is so below, and only the design tells the two apart. So thick it has no other shape.
  const Surface surface = cushion(12, 12, 0.03);
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  Points2 larger;
  for (const Point3& p : cut.mesh.points())
  {
    larger.emplace_back(1.02 * p.x(), 1.02 * p.y());
  }
  const SewingResult result = sewPieces(cut, larger, panel(0.04), {});
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const SewnReport& report = result.shapes.front();
  EXPECT_TRUE(report.severalShapes);
  const SewnTopology topology = sewnShapes(cut, larger, SewingTest::Panel);
  Points3 mirrored;
  double height = 0.0;
  for (Index v : topology.shapes.front().vertices)
  {
    const Point3& p = result.points[v];
    height = std::max(height, p.z());
    mirrored.emplace_back(p.x(), p.y(), -p.z());
  }
  EXPECT_GT(height, 0.06);
  const double other = measureSewn(topology.shapes.front().cloth, mirrored, {}).distanceMean;
  EXPECT_GT(other, 1.3 * report.measures.distanceMean);
  EXPECT_NEAR(report.secondDistance / other, 1.0, 1e-4);
}
