// SPDX-License-Identifier: BSD-3-Clause
// Surfaces to draw on, and curves on them.
#pragma once

#include "Editing/CurveEditor.h"
#include "TestMeshes.h"

#include <memory>

namespace drawncurves
{
using namespace flattening;

inline std::shared_ptr<const DrawingSurface> drawing(const testmeshes::Surface& surface)
{
  return std::make_shared<const DrawingSurface>(surface.mesh);
}

inline EditedCurve through(
  const DrawingSurface& surface, const Points3& points, SegmentKind kind = SegmentKind::Geodesic)
{
  EditedCurve curve;
  for (const Point3& point : points)
  {
    curve.nodes.push_back(surface.pointNear(point));
  }
  curve.kinds.assign(points.size() - 1, kind);
  return curve;
}

/// With one curve.
inline CurveEditor editorWith(const testmeshes::Surface& surface, const Points3& points,
  SegmentKind kind = SegmentKind::Geodesic)
{
  CurveEditor editor(drawing(surface));
  EXPECT_TRUE(editor.add(through(editor.surface(), points, kind)).ok());
  return editor;
}

/// How far a point is from a line in space.
inline double gap(const Points3& line, const Point3& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < line.size(); ++k)
  {
    const Point3 side = line[k] - line[k - 1];
    const double s = std::clamp(side.dot(point - line[k - 1]) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (line[k - 1] + s * side - point).norm());
  }
  return least;
}

inline testmeshes::Surface sheet(
  const std::function<double(double, double)>& height, double scale = 1.0)
{
  return testmeshes::patch(
    20, 20, [&](double i, double j) -> Point3 { return scale * Point3(i, j, height(i, j)); });
}
/// 20 x 20, vertices at whole numbers.
inline testmeshes::Surface plane(double scale = 1.0)
{
  return sheet([](double, double) { return 0.0; }, scale);
}
/// The same with a hill, on which no two ways are equally long.
inline testmeshes::Surface hill(double scale = 1.0)
{
  return sheet(
    [](double i, double j) {
      return 3.0 * std::sin(pi * i / 20) * std::sin(pi * j / 20) +
        0.1 * std::sin(1.7 * i + 2.9 * j * j);
    },
    scale);
}
}
