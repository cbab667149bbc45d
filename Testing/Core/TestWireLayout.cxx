// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"
#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Positions of the host vertices, and where the unrolling has them.
std::array<Points2, 2> placedAndUnrolled(
  const WiredSurface& wired, const Points2& unrolled, const Points2& layout)
{
  std::array<Points2, 2> both;
  for (const Index v : wired.network.hostVertices)
  {
    both[0].push_back(layout[v]);
    both[1].push_back(unrolled[wired.original(v)]);
  }
  return both;
}

double worstLength(const WireNetwork& network, const Points2& positions)
{
  double worst = 0.0;
  for (const WireEdge& edge : network.edges)
  {
    const double placed = (positions[edge.to] - positions[edge.from]).norm();
    worst = std::max(worst, std::abs(placed - edge.length) / edge.length);
  }
  return worst;
}

Surface wiredCushion()
{
  Surface surface = cushion(8, 6, 0.3);
  surface.curves = { rowCurve(8, 2), rowCurve(8, 4), columnCurve(8, 6, 3),
    accessory("dangling", { 6, 15 }) };
  return surface;
}
}

TEST(WireLayout, DrawsAFlatNetworkAsItIs)
{
  Surface surface = flatPatch(9, 7);
  surface.curves = { rowCurve(9, 2), columnCurve(9, 7, 4), accessory("dangling", { 7, 17, 27 }),
    curveOf(CurveType::Dart, "eye", { 52, 53, 54 }),
    curveOf(CurveType::Dart, "dart", { 2, 12, 22 }) };
  const WiredSurface wired(surface);
  const AngleProblem problem = wired.problem();
  const Points2 layout = layOutWires(wired.network, wired.network.alpha, problem.length);
  const auto both = placedAndUnrolled(wired, surface.unrolled, layout);
  EXPECT_LT(rigidDistance(both[0], both[1]), 1e-13 * perimeter(problem));
}

TEST(WireLayout, KeepsEveryAngleOfTheSolution)
{
  const WiredSurface wired(wiredCushion());
  const AngleSolution solution = wired.solve();
  const Points2 layout = layOutWires(wired.network, solution.theta, solution.length);
  for (Index i = 0; i < wired.network.nodeCount(); ++i)
  {
    const Point2& at = layout[wired.network.vertex[i]];
    const Point2 out = layout[wired.network.endVertex(i)] - at;
    const Point2 back = layout[wired.network.vertex[wired.network.previous[i]]] - at;
    const double angle =
      std::atan2(out.x() * back.y() - out.y() * back.x(), out.dot(back)); // from out to back
    EXPECT_NEAR(std::remainder(angle - solution.theta[i], 2.0 * pi), 0.0, 1e-11);
  }
}

TEST(WireLayout, AnglesWithNoiseStillGiveExactLengths)
{
  const WiredSurface wired(wiredCushion());
  AngleSolution solution = wired.solve();
  const Points2 exact = layOutWires(wired.network, solution.theta, solution.length);
  std::mt19937 random(3);
  for (double& theta : solution.theta)
  {
    theta += 1e-9 * (random() / 2147483648.0 - 1.0);
  }
  const Points2 noisy = layOutWires(wired.network, solution.theta, solution.length);
  EXPECT_LT(worstLength(wired.network, noisy), 1e-13);
  EXPECT_LT(rigidDistance(noisy, exact), 1e-7);
}
