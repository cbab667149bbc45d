// SPDX-License-Identifier: BSD-3-Clause
// Offsets and strokes as curves of an editor.
#include "DrawnCurves.h"
#include "Editing/CurveEditor.h"
#include "Editing/DerivedCurves.h"
#include "Paths/PathPoints.h"

using namespace flattening;
using namespace drawncurves;

namespace
{
testmeshes::Surface bulge(double height)
{
  return sheet([height](double i, double j) {
    return height * std::sin(pi * i / 20) * std::sin(pi * j / 20);
  });
}
}

TEST(DerivedCurves, AnOffsetIsACurveOfItsOwnThatCanBeUndone)
{
  CurveEditor editor(drawing(plane()));
  EditedCurve hem = through(editor.surface(), { { 0, 8, 0 }, { 20, 8, 0 } });
  hem.traits.name = "hem";
  hem.traits.type = CurveType::Key;
  hem.traits.tolerance = 0.01;
  ASSERT_TRUE(editor.add(hem).ok());
  const CurveSet before = editor.state();
  ASSERT_TRUE(editor.addOffset(0, 2.5).ok());
  ASSERT_EQ(editor.curveCount(), 2U);
  const EditedCurve& offset = editor.curve(1);
  EXPECT_EQ(offset.traits.name, "hem offset");
  EXPECT_EQ(offset.traits.type, CurveType::Key);
  EXPECT_EQ(offset.traits.tolerance, 0.01);
  ASSERT_EQ(offset.nodes.size(), 2U); // a straight line needs no more
  EXPECT_NEAR(lengthOf(offset), 20.0, 1e-12);
  EXPECT_LE((offset.nodes[0].position - Point3(0, 10.5, 0)).norm(), 1e-12);
  editor.undo();
  EXPECT_TRUE(identical(editor.state(), before));
  EXPECT_EQ(editor.addOffset(0, 30.0).code, StatusCode::CurveLeavesSurface);
  EXPECT_EQ(editor.addOffset(7, 1.0).code, StatusCode::InvalidOption);
  EXPECT_TRUE(identical(editor.state(), before));
}

TEST(DerivedCurves, AnOffsetHasFewNodesAndKeepsItsDistance)
{
  for (const SegmentKind kind : { SegmentKind::Geodesic, SegmentKind::Spline })
  {
    CurveEditor editor =
      editorWith(plane(), { { 3, 3, 0 }, { 9, 6, 0 }, { 15, 4, 0 }, { 18, 9, 0 } }, kind);
    ASSERT_TRUE(editor.addOffset(0, 1.5).ok());
    const EditedCurve& offset = editor.curve(1);
    EXPECT_LT(offset.nodes.size(), 30U) << static_cast<int>(kind);
    EXPECT_EQ(offset.kinds[0], kind);
    const Points3 source = pointsAlong(editor.curve(0).segments);
    for (const Point3& point : pointsAlong(offset.segments))
    {
      // 3 thousandths for its nodes, and one for the tangents of arcs.
      EXPECT_NEAR(gap(source, point), 1.5, 4.1e-3 * 1.5);
    }
  }
}

TEST(DerivedCurves, AStrokeBecomesASmoothCurveWithinItsTolerance)
{
  for (const double height : { 0.0, 4.0 })
  {
    CurveEditor editor(drawing(bulge(height)));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shaking(-0.02, 0.02);
    std::vector<SurfacePoint> stroke;
    Points3 meant;
    for (int k = 0; k <= 200; ++k)
    {
      const double x = 2.0 + 16.0 * k / 200 + shaking(random);
      const double y = 10.0 + 3.0 * std::sin(0.5 * x) + shaking(random);
      stroke.push_back(editor.surface().pointNear(
        Point3(x, y, height * std::sin(pi * x / 20) * std::sin(pi * y / 20))));
      meant.push_back(stroke.back().position);
    }
    ASSERT_TRUE(editor.addStroke(stroke, 0.1).ok());
    const EditedCurve& curve = editor.curve(0);
    const Points3 line = pointsAlong(curve.segments);
    for (const Point3& point : meant)
    {
      EXPECT_LE(gap(line, point), 0.1 * (1.0 + 1e-9));
    }
    EXPECT_LE(curve.nodes.size(), 16U); // of 201
    EXPECT_EQ(curve.kinds[0], SegmentKind::Spline);
    EXPECT_FALSE(curve.closed);
    editor.undo();
    EXPECT_EQ(editor.curveCount(), 0U);
  }
}

TEST(DerivedCurves, AStrokeThatComesBackIsClosed)
{
  CurveEditor editor(drawing(bulge(2.0)));
  std::vector<SurfacePoint> stroke;
  for (int k = 0; k <= 100; ++k)
  {
    const double turn = 2.0 * pi * k / 101;
    stroke.push_back(
      editor.surface().pointNear(Point3(10 + 4 * std::cos(turn), 10 + 4 * std::sin(turn), 1.5)));
  }
  ASSERT_TRUE(editor.addStroke(stroke, 0.15).ok());
  EXPECT_TRUE(editor.curve(0).closed);
  EXPECT_LE(editor.curve(0).nodes.size(), 12U);
  EXPECT_EQ(editor.addStroke({ stroke[0] }, 0.1).code, StatusCode::CurveTooShort);
  EXPECT_EQ(editor.addStroke({}, 0.1).code, StatusCode::CurveTooShort);
  EXPECT_EQ(editor.curveCount(), 1U);
}

TEST(DerivedCurves, SplitAndJoinedACurveIsItselfAgain)
{
  for (const SegmentKind kind : { SegmentKind::Geodesic, SegmentKind::Section, SegmentKind::Edges })
  {
    CurveEditor editor =
      editorWith(bulge(3.0), { { 3, 3, 0 }, { 9, 6, 2 }, { 15, 4, 2 }, { 18, 9, 1 } }, kind);
    const Points3 before = pointsAlong(editor.curve(0).segments);
    ASSERT_TRUE(editor.split(0, 2).ok());
    ASSERT_EQ(editor.curveCount(), 2U);
    EXPECT_EQ(editor.curve(0).nodes.size() + editor.curve(1).nodes.size(), 5U);
    Points3 halves = pointsAlong(editor.curve(0).segments);
    const Points3 second = pointsAlong(editor.curve(1).segments);
    halves.insert(halves.end(), second.begin() + 1, second.end());
    EXPECT_EQ(halves, before);
    // The other way round as well: their near ends meet.
    ASSERT_TRUE(editor.join(1, 0).ok());
    ASSERT_EQ(editor.curveCount(), 1U);
    ASSERT_EQ(editor.curve(0).nodes.size(), 4U);
    const Points3 after = pointsAlong(editor.curve(0).segments);
    ASSERT_EQ(after.size(), before.size());
    const bool turned = (after.front() - before.front()).norm() > 1.0;
    for (std::size_t k = 0; k < after.size(); ++k)
    {
      EXPECT_LE((after[turned ? after.size() - 1 - k : k] - before[k]).norm(), 1e-9);
    }
  }
}
