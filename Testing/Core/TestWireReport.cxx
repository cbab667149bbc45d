// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/WireReport.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
std::vector<Wire> wiresOf(const std::vector<Wire>& wires, Index curve)
{
  std::vector<Wire> found;
  std::copy_if(wires.begin(), wires.end(), std::back_inserter(found),
    [curve](const Wire& wire) { return wire.curve == curve; });
  return found;
}

/// Edges of all wires, each of the cut surface once.
Index edgeCount(const std::vector<Wire>& wires)
{
  Index count = 0;
  for (const Wire& wire : wires)
  {
    count += static_cast<Index>(wire.vertices.size()) - 1;
  }
  return count;
}
}

TEST(WireReport, ACurveThatNothingCutsIsOneWireInItsOwnOrder)
{
  Surface surface = cushion(6, 4, 0.2);
  surface.curves = { rowCurve(6, 2) };
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  const std::vector<Wire> wires = traceWires(surface.mesh, cut, surface.curves);
  ASSERT_EQ(wiresOf(wires, 0).size(), 1U);
  EXPECT_EQ(wiresOf(wires, 0).front().vertices, surface.curves[0].vertices);
  // The boundary is one loop.
  ASSERT_EQ(wiresOf(wires, none).size(), 1U);
  const Wire boundary = wiresOf(wires, none).front();
  EXPECT_TRUE(boundary.boundary);
  EXPECT_EQ(boundary.vertices.front(), boundary.vertices.back());
  EXPECT_EQ(edgeCount(wires), 6 + 20);
}

TEST(WireReport, ADartHasTwoBanksOfOneLength)
{
  Surface surface = cushion(6, 4, 0.2);
  surface.curves = { curveOf(CurveType::Dart, "dart", { 3, 10, 17 }) };
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  std::vector<Wire> wires = traceWires(surface.mesh, cut, surface.curves);
  std::vector<Wire> banks = wiresOf(wires, 0);
  ASSERT_EQ(banks.size(), 2U);
  EXPECT_EQ(banks[0].vertices.back(), banks[1].vertices.back()) << "the tip";
  EXPECT_NE(banks[0].vertices.front(), banks[1].vertices.front());
  Points2 positions;
  for (const Point3& p : cut.mesh.points())
  {
    positions.emplace_back(p.x(), p.y());
  }
  for (Wire& wire : banks)
  {
    measureWire(cut, positions, wire);
  }
  EXPECT_DOUBLE_EQ(banks[0].restLength, banks[1].restLength);
  // The curve counts once.
  const std::vector<CurveReport> reports =
    summarizeCurves(surface.mesh, cut, surface.curves, banks);
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].name, "dart");
  EXPECT_NEAR(reports[0].restLength, banks[0].restLength, 1e-15);
  EXPECT_NEAR(reports[0].flatLength, surface.mesh.point(17).y(), 1e-12) << "its projection";
}

TEST(WireReport, ACurveAcrossADartGoesOnOnBothItsSides)
{
  Surface surface = cushion(6, 4, 0.2);
  surface.curves = { curveOf(CurveType::Dart, "dart", { 3, 10, 17 }), rowCurve(6, 1) };
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  const std::vector<Wire> wires = traceWires(surface.mesh, cut, surface.curves);
  const std::vector<Wire> parts = wiresOf(wires, 1);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].vertices.size(), 4U);
  EXPECT_EQ(parts[1].vertices.size(), 4U);
  EXPECT_NE(parts[0].vertices.back(), parts[1].vertices.front());
  for (const Wire& wire : wires)
  {
    for (std::size_t k = 0; k + 1 < wire.vertices.size(); ++k)
    {
      const Index a = wire.vertices[k];
      const Index b = wire.vertices[k + 1];
      EXPECT_TRUE(cut.mesh.find(a, b) != none || cut.mesh.find(b, a) != none);
    }
  }
}

TEST(WireReport, EachPieceHasItsOwnBankOfASeam)
{
  Surface surface = cushion(6, 4, 0.2);
  surface.curves = { columnCurve(6, 4, 3, CurveType::Seam) };
  const CutSurface cut = cutSurface(surface.mesh, surface.curves);
  const std::vector<Wire> banks = wiresOf(traceWires(surface.mesh, cut, surface.curves), 0);
  ASSERT_EQ(banks.size(), 2U);
  EXPECT_NE(banks[0].piece, banks[1].piece);
  for (const Wire& bank : banks)
  {
    EXPECT_EQ(bank.vertices.size(), 5U);
    EXPECT_EQ(bank.type, CurveType::Seam);
  }
}

TEST(WireReport, MeasuresTheWorstEdgeNotTheMean)
{
  Surface surface = flatPatch(2, 1);
  const CutSurface cut = cutSurface(surface.mesh, {});
  Points2 positions = surface.unrolled;
  const Point2 along = positions[2] - positions[1];
  positions[2] += 0.1 * along; // the second edge is 10 % too long
  Wire wire;
  wire.vertices = { 0, 1, 2 };
  measureWire(cut, positions, wire);
  EXPECT_NEAR(wire.maximumEdgeError, 0.1, 1e-12);
  EXPECT_NEAR(wire.flatLength - wire.restLength, 0.1 * along.norm(), 1e-12);
}
