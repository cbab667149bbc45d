// SPDX-License-Identifier: BSD-3-Clause
// Curves drawn on surfaces by commands, and undone; what points snap to; offsets and strokes.
#include "DrawnCurves.h"
#include "Editing/CurveEditor.h"
#include "Editing/CurveSnapping.h"
#include "Editing/DerivedCurves.h"
#include "Paths/PathPoints.h"

using namespace drawncurves;
using namespace flattening;

namespace
{
CurveSet copied(const CurveSet& set)
{
  CurveSet copy;
  copy.mirror = set.mirror;
  for (const auto& curve : set.curves)
  {
    copy.curves.push_back(std::make_shared<const EditedCurve>(*curve));
  }
  return copy;
}

/// Commands drawn at random; `size` of the surface makes the same ones on every scale.
class RandomHand
{
public:
  RandomHand(CurveEditor& editor, unsigned seed)
    : Editor(editor)
    , Generator(seed)
  {
  }

  Status edit()
  {
    if (this->Editor.curveCount() == 0 || this->pick(12) == 0)
    {
      return this->Editor.add(through(this->Editor.surface(), { this->place() }));
    }
    const std::size_t c = this->pick(this->Editor.curveCount());
    const EditedCurve& curve = this->Editor.curve(c);
    const std::size_t node = this->pick(curve.nodes.size());
    CurveTraits traits = curve.traits;
    switch (this->pick(13))
    {
      case 0:
        return this->Editor.remove(c);
      case 1:
      case 2:
      case 3:
        return this->Editor.insertNode(c, this->pick(curve.nodes.size() + 1),
          this->Editor.surface().pointNear(this->place()),
          this->pick(2) == 0 ? SegmentKind::Geodesic : SegmentKind::Section);
      case 4:
      case 5:
        return this->Editor.moveNode(c, node, this->Editor.surface().pointNear(this->place()));
      case 6:
        return this->Editor.removeNode(c, node);
      case 7:
        return this->Editor.setClosed(c, !curve.closed);
      case 8:
        return this->Editor.split(c, node);
      case 9:
        return this->Editor.join(c, this->pick(this->Editor.curveCount()));
      case 10:
        return this->Editor.setKind(c, node, SegmentKind::Section);
      case 11:
        traits.mirrored = !traits.mirrored;
        traits.type = static_cast<CurveType>(this->pick(4));
        return this->Editor.describe(c, traits);
      default:
        return this->Editor.setMirror(MirrorPlane{ this->place(), Point3::UnitX() });
    }
  }

private:
  std::size_t pick(std::size_t count) { return this->Generator() % count; }
  Point3 place()
  {
    const Points3& points = this->Editor.surface().mesh().points();
    const Point3& a = points[this->pick(points.size())];
    const Point3& b = points[this->pick(points.size())];
    return 0.5 * (a + b);
  }

  CurveEditor& Editor;
  std::mt19937 Generator;
};
}

TEST(CurveEditor, RandomEditsAreTheSameInEveryUnitAndUndoneBitForBit)
{
  // On the plane many ways are equally long.
  for (const auto& surface : { hill, plane })
  {
    CurveEditor unit(drawing(surface(1.0)));
    RandomHand unitHand(unit, 7);
    const CurveSet first = copied(unit.state());
    std::vector<std::pair<Status, CurveSet>> states;
    for (int k = 0; k < 150; ++k)
    {
      const CurveSet before = copied(unit.state());
      const Status status = unitHand.edit();
      ASSERT_TRUE(!status.refused() || identical(unit.state(), before)) << "edit " << k;
      states.emplace_back(status, copied(unit.state()));
    }
    while (unit.canUndo())
    {
      unit.undo();
    }
    EXPECT_TRUE(identical(unit.state(), first));
    while (unit.canRedo())
    {
      unit.redo();
    }
    EXPECT_TRUE(identical(unit.state(), states.back().second));
    for (const double scale : { 1e-3, 1e3 })
    {
      CurveEditor scaled(drawing(surface(scale)));
      RandomHand scaledHand(scaled, 7);
      for (const auto& [status, state] : states)
      {
        ASSERT_EQ(scaledHand.edit().code, status.code);
        ASSERT_EQ(scaled.curveCount(), state.curves.size());
        for (std::size_t c = 0; c < state.curves.size(); ++c)
        {
          EXPECT_EQ(scaled.curve(c).nodes.size(), state.curves[c]->nodes.size());
          const double length = lengthOf(*state.curves[c]);
          // The plane of a girth through two nodes is sought by a golden section, which knows the
          // place of a minimum to the root of the rounding.
          const bool sought = scaled.curve(c).closed && scaled.curve(c).nodes.size() == 2;
          EXPECT_NEAR(
            lengthOf(scaled.curve(c)) / scale, length, (sought ? 1e-7 : 1e-9) * (1.0 + length));
        }
      }
    }
  }
}

TEST(CurveEditor, OnThePlaneSegmentsAreStraightAndAClosedCurveHasItsPerimeter)
{
  const Points3 places{ { 1.3, 2.1, 0 }, { 16.2, 3.4, 0 }, { 9.7, 15.8, 0 } };
  CurveEditor editor = editorWith(plane(), places);
  const double open = (places[1] - places[0]).norm() + (places[2] - places[1]).norm();
  EXPECT_NEAR(lengthOf(editor.curve(0)), open, 1e-9 * open);
  ASSERT_TRUE(editor.setClosed(0, true).ok());
  const double perimeter = open + (places[0] - places[2]).norm();
  EXPECT_NEAR(lengthOf(editor.curve(0)), perimeter, 1e-9 * perimeter);
  // A node on its way changes no length.
  ASSERT_TRUE(editor
                .insertNode(0, 3, editor.surface().pointNear(0.5 * (places[0] + places[2])),
                  SegmentKind::Geodesic)
                .ok());
  EXPECT_NEAR(lengthOf(editor.curve(0)), perimeter, 1e-9 * perimeter);
}

TEST(CurveEditor, AnOpenedLoopKeepsItsLength)
{
  CurveEditor editor = editorWith(hill(), { { 4, 4, 0 }, { 15, 5, 0 }, { 10, 16, 0 } });
  ASSERT_TRUE(editor.setClosed(0, true).ok());
  const double around = lengthOf(editor.curve(0));
  ASSERT_TRUE(editor.split(0, 1).ok());
  EXPECT_FALSE(editor.curve(0).closed);
  EXPECT_EQ(editor.curve(0).nodes.size(), 4);
  EXPECT_NEAR(lengthOf(editor.curve(0)), around, 1e-9 * around);
}

TEST(CurveEditor, AMovedNodeLeavesTheSegmentsOfOtherNodes)
{
  CurveEditor editor =
    editorWith(hill(), { { 1, 2, 0 }, { 6, 14, 0 }, { 14, 13, 0 }, { 18, 3, 0 } });
  const EditedCurve before = editor.curve(0);
  ASSERT_TRUE(editor.moveNode(0, 3, editor.surface().pointNear({ 17, 9, 0 })).ok());
  for (const std::size_t s : { 0, 1 })
  {
    EXPECT_EQ(pointsAlong({ editor.curve(0).segments[s] }), pointsAlong({ before.segments[s] }));
  }
  EXPECT_NE(pointsAlong({ editor.curve(0).segments[2] }), pointsAlong({ before.segments[2] }));
}

TEST(CurveEditor, ADragIsUndoneAsOne)
{
  CurveEditor editor = editorWith(hill(), { { 1, 2, 0 }, { 6, 14, 0 } });
  const CurveSet before = copied(editor.state());
  editor.beginGroup();
  for (double x = 6.0; x < 16.0; x += 0.25)
  {
    ASSERT_TRUE(editor.moveNode(0, 1, editor.surface().pointNear({ x, 13, 0 })).ok());
  }
  editor.endGroup();
  editor.undo();
  EXPECT_TRUE(identical(editor.state(), before));
}

TEST(CurveEditor, CommandsThatAreJoinedAreUndoneAndRedoneAsOne)
{
  CurveEditor editor = editorWith(hill(), { { 1, 2, 0 }, { 6, 14, 0 } });
  const auto place = [&](double x) { return editor.surface().pointNear({ x, 7, 0 }); };
  const CurveSet before = copied(editor.state());
  const std::size_t since = editor.commandCount();
  ASSERT_EQ(since, 1U);
  ASSERT_TRUE(editor.add(through(editor.surface(), { { 2, 7, 0 } })).ok());
  for (std::size_t node = 1; node < 4; ++node)
  {
    ASSERT_TRUE(
      editor.insertNode(1, node, place(2.0 + 2.0 * double(node)), SegmentKind::Geodesic).ok());
  }
  const CurveSet drawn = copied(editor.state());
  EXPECT_EQ(editor.commandCount(), since + 4);
  editor.joinSince(since);
  EXPECT_EQ(editor.commandCount(), since + 1);
  editor.undo();
  EXPECT_TRUE(identical(editor.state(), before));
  editor.redo();
  EXPECT_TRUE(identical(editor.state(), drawn));
  // What came to nothing is no step.
  ASSERT_TRUE(editor.add(through(editor.surface(), { { 3, 3, 0 } })).ok());
  ASSERT_TRUE(editor.remove(2).ok());
  editor.joinSince(since + 1);
  EXPECT_EQ(editor.commandCount(), since + 1);
  editor.joinSince(since + 7);
  EXPECT_EQ(editor.commandCount(), since + 1);
  editor.undo();
  EXPECT_TRUE(identical(editor.state(), before));
}

TEST(CurveEditor, AMirroredCurveHasItsImageOnTheOtherSide)
{
  CurveEditor editor(drawing(plane()));
  ASSERT_TRUE(editor.setMirror(MirrorPlane{ { 10, 0, 0 }, Point3::UnitX() }).ok());
  EditedCurve curve = through(editor.surface(), { { 1.5, 2.5, 0 }, { 8.2, 17.1, 0 } });
  curve.traits.mirrored = true;
  ASSERT_TRUE(editor.add(curve).ok());
  Points3 image = pointsAlong(editor.curve(0).image);
  ASSERT_GE(image.size(), 2);
  EXPECT_LT((image.front() - Point3(18.5, 2.5, 0)).norm(), 1e-9);
  EXPECT_LT((image.back() - Point3(11.8, 17.1, 0)).norm(), 1e-9);
  ASSERT_TRUE(editor.moveNode(0, 0, editor.surface().pointNear({ 3, 4, 0 })).ok());
  image = pointsAlong(editor.curve(0).image);
  EXPECT_LT((image.front() - Point3(17, 4, 0)).norm(), 1e-9);
  ASSERT_TRUE(editor.addImage(0).ok());
  EXPECT_NEAR(lengthOf(editor.curve(1)), lengthOf(editor.curve(0)), 1e-9);
}

TEST(CurveEditor, ImagesOfEndsOnTheBoundaryLieOnItWhereTheSurfaceIsNotQuiteSymmetric)
{
  for (const double scale : { 1e-3, 1.0, 2e3 })
  {
    // The right side is up to 3 % wider or narrower than the left one, the upper one bent.
    const auto wide = [](double i, double j) {
      return i > 10 ? i + 0.06 * (i - 10) * std::sin(1.3 * j) : i;
    };
    const auto shape = [&](double i, double j) -> Point3 {
      const double rise = j + (i > 10 ? 0.004 * j * (i - 10) : 0.0);
      return scale * Point3(wide(i, j), rise, 2.0 * std::sin(pi * i / 20) * std::sin(pi * j / 20));
    };
    for (const SegmentKind kind :
      { SegmentKind::Geodesic, SegmentKind::Section, SegmentKind::Spline })
    {
      CurveEditor editor(drawing(testmeshes::patch(20, 20, shape)));
      const TriangleMesh& mesh = editor.surface().mesh();
      ASSERT_TRUE(editor.setMirror(MirrorPlane{ scale * Point3(10, 0, 0), Point3::UnitX() }).ok());
      for (const Point3& start : { Point3(0, 1, 0), Point3(0, 5.37, 0), Point3(0, 9, 0),
             Point3(0, 12.61, 0), Point3(3.3, 20, 0), Point3(7, 20, 0) })
      {
        EditedCurve curve = through(editor.surface(),
          { scale * start, scale * Point3(5, 0.5 * (start.y() + 9.0), 1),
            shape(7.0, 0.7 * start.y() + 3.0) },
          kind);
        curve.traits.mirrored = true;
        ASSERT_TRUE(onBoundary(mesh, curve.nodes.front()));
        ASSERT_TRUE(editor.add(curve).ok());
        const std::size_t own = editor.state().curves.size() - 1;
        const SurfacePoint image = editor.curve(own).image.front().points.front();
        EXPECT_TRUE(onBoundary(mesh, image)) << scale << ": " << start.transpose();
        EXPECT_LT(
          (image.position - scale * Point3(20 - start.x(), start.y(), 0)).norm(), 1.2 * scale);
        // An end within the surface stays the image that it was.
        const Point3 tip = editor.curve(own).nodes.back().position;
        const Point3 place(2.0 * scale * 10 - tip.x(), tip.y(), tip.z());
        EXPECT_LT(
          (editor.curve(own).image.back().points.back().position - place).norm(), 0.5 * scale);
        ASSERT_TRUE(editor.addImage(own).ok());
        EXPECT_TRUE(onBoundary(mesh, editor.curve(own + 1).nodes.front()));
      }
    }
  }
}

TEST(CurveEditor, ImagesOfEndsOnAMirroredCurveLieOnItsImage)
{
  for (const double scale : { 1e-2, 1.0, 500.0 })
  {
    // The right half has a bump more.
    const auto shape = [&](double i, double j) -> Point3 {
      const double bump = i > 10 ? 0.8 * std::sin(pi * (i - 10) / 10) * std::sin(pi * j / 20) : 0.0;
      return scale * Point3(i, j + 0.5 * bump, 1.5 * std::sin(pi * i / 20) + bump);
    };
    CurveEditor editor(drawing(testmeshes::patch(20, 20, shape)));
    ASSERT_TRUE(editor.setMirror(MirrorPlane{ scale * Point3(10, 0, 0), Point3::UnitX() }).ok());
    EditedCurve seam = through(editor.surface(), { shape(0, 9), shape(8.3, 9.4) });
    seam.traits.mirrored = true;
    ASSERT_TRUE(editor.add(seam).ok());
    const Points3 whole = pointsAlong(editor.curve(0).segments);
    for (const std::size_t at : { whole.size() / 4, whole.size() / 2, whole.size() - 3 })
    {
      const Point3 start = 0.5 * (whole[at] + whole[at + 1]);
      EditedCurve dart =
        through(editor.surface(), { start, start + scale * Point3(0.4, 3.7, 0.0) });
      dart.traits.mirrored = true;
      ASSERT_TRUE(editor.add(dart).ok());
      const std::size_t own = editor.state().curves.size() - 1;
      const Point3 image = editor.curve(own).image.front().points.front().position;
      EXPECT_LT(gap(pointsAlong(editor.curve(0).image), image), 1e-6 * scale) << scale;
      EXPECT_LT((image - Point3(2 * scale * 10 - start.x(), start.y(), start.z())).norm(), scale);
      // Moved off the curve its image follows it alone.
      const SurfacePoint off = editor.surface().pointNear(start + scale * Point3(0.3, 1.2, 0.0));
      ASSERT_TRUE(editor.moveNode(own, 0, off).ok());
      const Point3 place(2 * scale * 10 - off.position.x(), off.position.y(), off.position.z());
      EXPECT_EQ(editor.curve(own).image.front().points.front().position,
        editor.surface().pointNear(place).position);
    }
  }
}

TEST(CurveEditor, AnImageFarFromAnyBoundaryStaysWhereItIs)
{
  // A hole at the left alone.
  testmeshes::Surface holed;
  holed.mesh = testmeshes::partWhere(plane().mesh, [](const Point3& p) {
    return (p - Point3(5, 10, 0)).norm() > 2.0;
  }).mesh;
  CurveEditor editor(drawing(holed));
  ASSERT_TRUE(editor.setMirror(MirrorPlane{ { 10, 0, 0 }, Point3::UnitX() }).ok());
  EditedCurve curve = through(editor.surface(), { { 6.9, 10, 0 }, { 9, 14, 0 } });
  curve.traits.mirrored = true;
  ASSERT_TRUE(editor.add(curve).ok());
  const Point3 start = editor.curve(0).nodes.front().position;
  const Point3 image = editor.curve(0).image.front().points.front().position;
  EXPECT_LT((image - Point3(20 - start.x(), start.y(), 0)).norm(), 1e-9);
}

TEST(CurveEditor, NamesAreTakenOnce)
{
  CurveEditor editor(drawing(hill()));
  EditedCurve curve = through(editor.surface(), { { 1, 2, 0 }, { 6, 14, 0 } });
  curve.traits.name = "hem";
  ASSERT_TRUE(editor.add(curve).ok());
  ASSERT_TRUE(editor.add(curve).ok());
  EXPECT_EQ(editor.curve(0).traits.name, "hem");
  EXPECT_NE(editor.curve(1).traits.name, "hem");
  CurveTraits traits = editor.curve(1).traits;
  traits.name = "hem";
  EXPECT_EQ(editor.describe(1, traits).code, StatusCode::InvalidOption);
}

// Only a drag, or a node that was there, brings a curve to the longer side of a hill.
TEST(CurveNodes, AnEditedCurveStaysOnItsSideOfAHill)
{
  CurveEditor editor(drawing(sheet([](double i, double j) {
    return 15.0 * std::exp(-0.08 * ((i - 10.0) * (i - 10.0) + (j - 10.5) * (j - 10.5)));
  })));
  ASSERT_TRUE(
    editor.add(through(editor.surface(), { { 1, 9, 0 }, { 10, 19, 0 }, { 19, 9, 0 } })).ok());
  ASSERT_TRUE(editor.add(through(editor.surface(), { { 1, 9, 0 }, { 19, 9, 0 } })).ok());
  const double direct = lengthOf(editor.curve(1));
  ASSERT_TRUE(editor.removeNode(0, 1).ok());
  const double around = lengthOf(editor.curve(0));
  EXPECT_GT(around, 1.01 * direct);
  const auto pointAt = [&](double part) {
    const SurfacePath path = wholePath(editor.curve(0));
    return pointAlong(editor.surface().mesh(), path, part * lengthOf(path));
  };
  ASSERT_TRUE(editor.insertNode(0, 1, pointAt(0.9), SegmentKind::Geodesic).ok());
  EXPECT_NEAR(lengthOf(editor.curve(0)), around, 1e-9 * around);
  ASSERT_TRUE(editor.insertNode(0, 1, pointAt(0.05), SegmentKind::Geodesic).ok());
  EXPECT_NEAR(lengthOf(editor.curve(0)), around, 1e-9 * around);
  for (const bool first : { true, false })
  {
    ASSERT_TRUE(editor.split(0, 1).ok());
    ASSERT_TRUE((first ? editor.join(0, 2) : editor.join(2, 0)).ok());
    const std::size_t whole = first ? 0 : editor.curveCount() - 1;
    EXPECT_EQ(editor.curve(whole).nodes.size(), 4U);
    EXPECT_NEAR(lengthOf(editor.curve(whole)), around, 1e-9 * around);
  }
  while (editor.canUndo())
  {
    editor.undo();
  }
  EXPECT_EQ(editor.curveCount(), 0U);
}

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

namespace
{
testmeshes::Surface bulge(double height)
{
  return sheet([height](double i, double j) {
    return height * std::sin(pi * i / 20) * std::sin(pi * j / 20);
  });
}
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
