// SPDX-License-Identifier: BSD-3-Clause
// What a point near curves and boundaries snaps to.
#include "DrawnCurves.h"
#include "Editing/CurveSnapping.h"

using namespace flattening;
using namespace drawncurves;

TEST(CurveSnapping, PointsComeBeforeLinesAndLinesBeforeVertices)
{
  for (const double scale : { 1.0, 1e-3, 1e3 })
  {
    CurveEditor editor(drawing(plane(scale)));
    EditedCurve dart =
      through(editor.surface(), { scale * Point3(5, 0, 0), scale * Point3(5, 8.5, 0) });
    dart.traits.type = CurveType::Dart;
    ASSERT_TRUE(editor.add(dart).ok());
    SnapOptions options;
    options.reach = 0.4 * scale;
    const auto snapped = [&](double x, double y) {
      return snapPoint(editor.surface(), editor.state(),
        editor.surface().pointNear(scale * Point3(x, y, 0)), options);
    };
    struct Case
    {
      Point3 from;
      SnapTarget target;
      Point3 to;
    };
    for (const Case& expected : { Case{ { 5.2, 8.7, 0 }, SnapTarget::DartTip, { 5, 8.5, 0 } },
           Case{ { 5.2, 4.4, 0 }, SnapTarget::Curve, { 5, 4.4, 0 } },
           Case{ { 5.2, 4.1, 0 }, SnapTarget::Vertex, { 5, 4, 0 } },
           Case{ { 0.2, 0.1, 0 }, SnapTarget::Corner, { 0, 0, 0 } },
           Case{ { 12.5, 0.3, 0 }, SnapTarget::Boundary, { 12.5, 0, 0 } },
           Case{ { 12.1, 0.3, 0 }, SnapTarget::Vertex, { 12, 0, 0 } },
           Case{ { 12.2, 7.1, 0 }, SnapTarget::Vertex, { 12, 7, 0 } },
           Case{ { 12.5, 7.45, 0 }, SnapTarget::Nothing, { 12.5, 7.45, 0 } } })
    {
      const SnappedPoint result = snapped(expected.from.x(), expected.from.y());
      EXPECT_EQ(result.target, expected.target) << expected.from.transpose();
      EXPECT_LT((result.point.position - scale * expected.to).norm(), 1e-9 * scale)
        << expected.from.transpose();
    }
    options.reach = 0.0;
    EXPECT_EQ(snapped(5.2, 8.7).target, SnapTarget::Nothing);
  }
}

TEST(CurveSnapping, APointNearTheMirrorPlaneGoesOntoIt)
{
  CurveEditor editor(drawing(hill()));
  ASSERT_TRUE(editor.setMirror(MirrorPlane{ { 7.3, 0, 0 }, Point3::UnitX() }).ok());
  SnapOptions options;
  options.reach = 0.3;
  const SurfacePoint near = editor.surface().pointNear({ 7.4, 9.6, 2.5 });
  const SnappedPoint result = snapPoint(editor.surface(), editor.state(), near, options);
  EXPECT_EQ(result.target, SnapTarget::MirrorPlane);
  EXPECT_NEAR(result.point.position.x(), 7.3, 1e-9);
  EXPECT_LT(
    (editor.surface().pointNear(result.point.position).position - result.point.position).norm(),
    1e-9);
}

TEST(CurveSnapping, WhoLooksAtTheSideMissesInDepthAndStillHitsTheBoundary)
{
  const CurveEditor editor(drawing(plane()));
  SnapOptions options;
  options.reach = 0.3;
  const SurfacePoint deep = editor.surface().pointNear({ 7.1, 1.6, 0 });
  EXPECT_EQ(snapPoint(editor.surface(), editor.state(), deep, options).target, SnapTarget::Nothing);
  options.sight = SightMetric({ 0, 5, 0.1 });
  const SnappedPoint snapped = snapPoint(editor.surface(), editor.state(), deep, options);
  EXPECT_EQ(snapped.target, SnapTarget::Vertex);
  EXPECT_EQ(snapped.point.position, Point3(7, 0, 0));
  // What lies as far to the side stays out of reach.
  const SurfacePoint beside = editor.surface().pointNear({ 1.6, 10.5, 0 });
  EXPECT_EQ(
    snapPoint(editor.surface(), editor.state(), beside, options).target, SnapTarget::Nothing);
}

TEST(CurveSnapping, TheCurveThatIsMovedDoesNotHoldItsNode)
{
  const CurveEditor editor = editorWith(hill(), { { 3, 3, 0 }, { 12, 13, 0 } });
  SnapOptions options;
  options.reach = 0.3;
  options.vertex = false;
  const SurfacePoint near =
    editor.surface().pointNear(pointsAlong(editor.curve(0).segments)[5] + Point3(0.1, 0, 0));
  EXPECT_EQ(snapPoint(editor.surface(), editor.state(), near, options).target, SnapTarget::Curve);
  options.exceptCurve = 0;
  EXPECT_EQ(snapPoint(editor.surface(), editor.state(), near, options).target, SnapTarget::Nothing);
}
