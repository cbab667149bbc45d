// SPDX-License-Identifier: BSD-3-Clause
// What inserted and removed nodes, splits and joints leave as it was.
#include "DrawnCurves.h"
#include "Editing/CurveEditor.h"
#include "Paths/PathPoints.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace drawncurves;

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
