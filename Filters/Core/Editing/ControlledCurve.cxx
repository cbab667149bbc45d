// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ControlledCurve.h"

#include "Base/Types.h"
#include "Editing/CurveDrawing.h"
#include "Editing/DerivedCurves.h"

#include <algorithm>
#include <string>
#include <utility>

namespace flattening
{
namespace
{
/// Nodes of a curve at its control points, each once where several in a row mean the same point.
Status placeNodes(const DrawingSurface& surface, const Points3& points, EditedCurve& curve)
{
  if (!std::all_of(
        points.begin(), points.end(), [](const Point3& point) { return isFinite(point); }))
  {
    return { StatusCode::NonFinitePoint, "a control point has a coordinate that is not finite", {},
      { Remedy::MendPoints } };
  }
  for (const Point3& point : points)
  {
    const SurfacePoint node = surface.pointNear(point);
    if (curve.nodes.empty() || curve.nodes.back().position != node.position)
    {
      curve.nodes.push_back(node);
    }
  }
  // A polyline that ends where it starts is closed.
  const bool returns =
    curve.nodes.size() > 2 && curve.nodes.front().position == curve.nodes.back().position;
  if (returns)
  {
    curve.nodes.pop_back();
    curve.closed = true;
  }
  return {};
}

Status drawCurveOf(const DrawingSurface& surface, const Points3& points,
  const std::optional<MirrorPlane>& mirror, SegmentKind kind, EditedCurve& curve)
{
  Status status = placeNodes(surface, points, curve);
  if (!status.ok())
  {
    return status;
  }
  const std::size_t fewest = curve.closed && kind != SegmentKind::Section ? 3 : 2;
  if (curve.nodes.size() < fewest)
  {
    const char* const more = curve.closed && curve.nodes.size() == 2
      ? "more control points, or the kind Section, which goes round through two"
      : "more control points";
    return { StatusCode::CurveTooShort,
      std::to_string(curve.nodes.size()) + " different control points are given where " +
        std::to_string(fewest) + " are needed",
      {}, { { Remedy::Give, more } } };
  }
  curve.kinds.assign(segmentCount(curve.nodes.size(), curve.closed), kind);
  return drawCurve(surface, { {}, mirror }, nullptr, curve);
}

/// Puts what follows from a curve, the last one, in its place.
Status replaceCurve(const DrawingSurface& surface, const std::optional<MirrorPlane>& mirror,
  DerivedCurves derived, std::vector<EditedCurve>& curves)
{
  const EditedCurve drawn = std::move(curves.back());
  curves.pop_back();
  Status status = std::move(derived.status);
  for (EditedCurve& part : derived.curves)
  {
    if (!status.refused())
    {
      part.traits = drawn.traits;
      status = drawCurve(surface, { {}, mirror }, nullptr, part);
      curves.push_back(std::move(part));
    }
  }
  return status;
}
}

Status drawControlledCurves(const DrawingSurface& surface, const std::vector<Points3>& controls,
  const CurveControl& control, std::vector<EditedCurve>& curves)
{
  Status status;
  std::size_t drawn = 0; // lists
  for (; drawn < controls.size() && !status.refused(); ++drawn)
  {
    EditedCurve curve;
    curve.closed = control.closed;
    curve.traits = control.traits;
    status = drawCurveOf(surface, controls[drawn], control.mirror, control.kind, curve);
    curves.push_back(std::move(curve));
    if (control.tight && !status.refused())
    {
      status = replaceCurve(surface, control.mirror, tightCurve(surface, curves.back()), curves);
    }
    if (control.offset != 0.0 && !status.refused())
    {
      status = replaceCurve(
        surface, control.mirror, offsetCurves(surface, curves.back(), control.offset), curves);
    }
  }
  const std::string& name = control.traits.name;
  if (status.refused() && !curves.empty() && (controls.size() > 1 || !name.empty()))
  {
    const std::string number = controls.size() > 1 ? std::to_string(drawn) : "";
    status.message = "curve " +
      (name.empty() ? number : "\"" + name + (number.empty() ? "" : " " + number) + "\"") + ": " +
      status.message;
  }
  for (std::size_t k = 0; k < curves.size() && curves.size() > 1 && !name.empty(); ++k)
  {
    curves[k].traits.name = name + " " + std::to_string(k + 1);
  }
  return status;
}
}
