// SPDX-License-Identifier: BSD-3-Clause
#include "CurveEditorData.h"

#include "Base/Types.h"
#include "CurvedPolyData.h"
#include "Editing/DrawingSurface.h"
#include "Imprint/ImprintedSurface.h"
#include "Input/Columns.h"
#include "PolyDataSets.h"
#include "Report/FlatteningData.h"
#include "Surface/FeatureCurve.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace flattening::bridge
{
namespace
{
/// Words on the curve that lies farthest from a surface; empty where all lie on it as the filters'
/// default has it. \pre The points are finite.
std::string noteOnFarthest(const std::vector<const Polyline*>& lines, const DrawingSurface& surface)
{
  double largest = 0.0;
  std::string name;
  for (const Polyline* const line : lines)
  {
    for (const Point3& point : line->points)
    {
      const double distance = surface.locator().closest(point).distance;
      if (distance > largest)
      {
        largest = distance;
        name = line->name;
      }
    }
  }
  Eigen::AlignedBox3d box;
  for (const Point3& point : surface.mesh().points())
  {
    box.extend(point);
  }
  return largest > ImprintOptions().tolerance * box.diagonal().norm()
    ? "the curve \"" + name + "\" was up to " + shortNumber(largest) +
      " from the surface and is laid onto it; was it drawn on another one, or in another unit?"
    : "";
}

const char* const imageOf = "CurveImageOf";
const char* const controlPoints = "ControlPoints";
const char* const controlCurve = "ControlPointCurve";
const char* const controlKind = "ControlPointKind";
const char* const mirrorPlane = "MirrorPlane";
const char* const imageName = " (image)";

void replace(vtkPolyData* data, const DataSet& set)
{
  data->Initialize();
  fill(data, set);
}

struct CurveRow
{
  const EditedCurve* curve;
  vtkIdType imageOf; ///< -1: the curve itself
};

Columns traitsOf(const std::vector<CurveRow>& rows)
{
  Columns cells;
  const std::size_t count = rows.size();
  const auto traits = [&rows](
                        std::size_t k) -> const CurveTraits& { return rows[k].curve->traits; };
  addRows<int>(
    cells, "CurveType", count, [&](std::size_t k) { return static_cast<int>(traits(k).type); });
  addRows<std::string>(cells, "CurveName", count,
    [&](std::size_t k) { return traits(k).name + (rows[k].imageOf < 0 ? "" : imageName); });
  addRows<int>(
    cells, "KeyShape", count, [&](std::size_t k) { return static_cast<int>(traits(k).keyShape); });
  addRows<double>(
    cells, "LengthTolerance", count, [&](std::size_t k) { return traits(k).tolerance; });
  addEases(cells, count, [&](std::size_t k) {
    return rows[k].imageOf < 0 ? traits(k).ease : easeOfImage(traits(k).ease);
  });
  addRows<std::int64_t>(cells, imageOf, count, [&](std::size_t k) { return rows[k].imageOf; });
  return cells;
}

Columns nodesOf(const CurveSet& set, const std::vector<CurveRow>& rows)
{
  std::vector<double> places;
  std::vector<std::int64_t> cells;
  std::vector<int> kinds;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const EditedCurve& curve = *rows[row].curve;
    for (std::size_t k = 0; k < curve.nodes.size() && rows[row].imageOf < 0; ++k)
    {
      const Point3& place = curve.nodes[k].position;
      places.insert(places.end(), place.data(), place.data() + 3);
      cells.push_back(static_cast<std::int64_t>(row));
      kinds.push_back(
        static_cast<int>(k < curve.kinds.size() ? curve.kinds[k] : SegmentKind::Geodesic));
    }
  }
  Columns field{ { controlPoints, std::move(places), 3 }, { controlCurve, std::move(cells) },
    { controlKind, std::move(kinds) } };
  if (set.mirror)
  {
    const Point3& o = set.mirror->origin;
    const Point3& n = set.mirror->normal;
    field.push_back(
      { mirrorPlane, std::vector<double>{ o.x(), o.y(), o.z(), n.x(), n.y(), n.z() }, 6 });
  }
  return field;
}

Status refusal(const std::string& defect, const char* suggested)
{
  return { StatusCode::InvalidCurve, defect, {}, { { Remedy::Give, suggested } } };
}

/// A field array with so many components of numbers; null where there is none such.
vtkDataArray* numbers(vtkPolyData* data, const char* name, int components)
{
  vtkDataArray* const array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

bool isImage(vtkPolyData* data, vtkIdType cell)
{
  vtkDataArray* const array = data->GetCellData()->GetArray(imageOf);
  return array && cell < array->GetNumberOfTuples() && array->GetComponent(cell, 0) >= 0.0;
}

/// The control points of each cell.
struct ControlPoints
{
  std::map<vtkIdType, EditedCurve> curves;
  Status status;
};

ControlPoints readNodes(vtkPolyData* data, const DrawingSurface& surface)
{
  ControlPoints result;
  if (!data->GetFieldData()->GetAbstractArray(controlPoints))
  {
    return result;
  }
  vtkDataArray* const places = numbers(data, controlPoints, 3);
  vtkDataArray* const cells = numbers(data, controlCurve, 1);
  vtkDataArray* const kinds = numbers(data, controlKind, 1);
  const vtkIdType count = places ? places->GetNumberOfTuples() : 0;
  if (!places || !cells || !kinds || cells->GetNumberOfTuples() != count ||
    kinds->GetNumberOfTuples() != count)
  {
    result.status = refusal("the arrays of control points do not fit each other",
      "ControlPoints with 3 components, and ControlPointCurve and ControlPointKind with as many "
      "values");
    return result;
  }
  for (vtkIdType k = 0; k < count; ++k)
  {
    const Point3 place(
      places->GetComponent(k, 0), places->GetComponent(k, 1), places->GetComponent(k, 2));
    const double kind = kinds->GetComponent(k, 0);
    if (!isFinite(place) || !(kind >= 0.0 && kind <= 3.0 && kind == std::floor(kind)))
    {
      result.status = refusal("control point " + std::to_string(k) +
          (isFinite(place) ? " has an unknown kind" : " is not finite"),
        "finite points, and 0 (geodesic), 1 (section), 2 (edges) or 3 (spline)");
      return result;
    }
    EditedCurve& curve = result.curves[static_cast<vtkIdType>(cells->GetComponent(k, 0))];
    curve.nodes.push_back(surface.pointNear(place));
    curve.kinds.push_back(static_cast<SegmentKind>(static_cast<int>(kind)));
  }
  return result;
}

/// Which of a polyline's points each node is, in order; shorter where some are none of them.
std::vector<std::size_t> placesOf(const EditedCurve& curve, const Points3& points)
{
  std::vector<std::size_t> places;
  std::size_t k = 0;
  for (const SurfacePoint& node : curve.nodes)
  {
    while (k < points.size() && points[k] != node.position)
    {
      ++k;
    }
    if (k == points.size())
    {
      break;
    }
    places.push_back(k);
  }
  return places;
}

/// Where the segments ran when they were written, so that they go round bumps on the same side.
void readHints(const DrawingSurface& surface, const Points3& points, EditedCurve& curve)
{
  std::vector<std::size_t> places = placesOf(curve, points);
  if (places.size() != curve.nodes.size())
  {
    return;
  }
  if (curve.closed)
  {
    places.push_back(points.size() - 1);
  }
  for (std::size_t s = 0; s + 1 < places.size(); ++s)
  {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(places[s]);
    const auto last = points.begin() + static_cast<std::ptrdiff_t>(places[s + 1]);
    SurfacePath hint = surface.pathThrough({ first, last + 1 });
    if (!hint.arrived)
    {
      curve.segments.clear();
      return;
    }
    curve.segments.push_back(std::move(hint));
  }
}

Status checkLine(const Polyline& line)
{
  const bool finite = std::all_of(
    line.points.begin(), line.points.end(), [](const Point3& point) { return isFinite(point); });
  if (!finite || line.points.size() < 2)
  {
    return refusal("the curve \"" + line.name +
        (finite ? "\" has fewer than two points" : "\" has points that are not finite"),
      "two finite points or more");
  }
  return line.keyShape == KeyShape::Planar
    ? refusal("the curve \"" + line.name + "\" has a PlanarShape, which would not follow its nodes",
        "it without this array")
    : Status();
}

EditedCurve curveOf(const Polyline& line, const EditedCurve* nodes, const DrawingSurface& surface)
{
  EditedCurve curve;
  curve.closed = line.points.size() > 3 && line.points.front() == line.points.back();
  if (nodes)
  {
    curve.nodes = nodes->nodes;
    curve.kinds = nodes->kinds;
    curve.kinds.resize(segmentCount(curve.nodes.size(), curve.closed), SegmentKind::Geodesic);
    readHints(surface, line.points, curve);
  }
  else
  {
    for (const Point3& point : line.points)
    {
      curve.nodes.push_back(surface.pointNear(point));
    }
    curve.nodes.resize(curve.nodes.size() - (curve.closed ? 1 : 0));
    curve.kinds.assign(segmentCount(curve.nodes.size(), curve.closed), SegmentKind::Section);
  }
  curve.traits.name = line.name;
  curve.traits.type = line.type;
  curve.traits.keyShape = line.keyShape;
  curve.traits.tolerance = line.tolerance;
  curve.traits.ease = line.ease;
  return curve;
}
}

void writeCurveSet(const CurveSet& set, vtkPolyData* data)
{
  std::vector<Points3> lines;
  std::vector<CurveRow> rows;
  for (const auto& curve : set.curves)
  {
    const Points3 line = pointsAlong(curve->segments);
    if (line.size() < 2)
    {
      continue;
    }
    lines.push_back(line);
    const auto row = static_cast<vtkIdType>(rows.size());
    rows.push_back({ curve.get(), -1 });
    const Points3 image = pointsAlong(curve->image);
    if (image.size() > 1)
    {
      lines.push_back(image);
      rows.push_back({ curve.get(), row });
    }
  }
  DataSet drawn = lineData(lines);
  drawn.cellArrays = traitsOf(rows);
  drawn.fieldArrays = nodesOf(set, rows);
  replace(data, drawn);
}

void writeCurve(const EditedCurve& curve, vtkPolyData* data)
{
  std::vector<Points3> lines;
  for (const SurfacePath& segment : curve.segments)
  {
    lines.push_back(pointsAlong({ segment }));
  }
  if (!curve.image.empty())
  {
    lines.push_back(pointsAlong(curve.image));
  }
  replace(data, lineData(lines));
}

void writePath(const SurfacePath& path, vtkPolyData* data)
{
  const bool any = path.points.size() > 1;
  replace(
    data, lineData(any ? std::vector<Points3>{ pointsAlong({ path }) } : std::vector<Points3>()));
}

CurveSetInput readCurveSet(vtkPolyData* data, const DrawingSurface& surface)
{
  CurveSetInput result;
  CurveInput input;
  readCurvesOf(data, 0, input);
  if (!input.outcome.ok())
  {
    result.status = input.outcome;
    return result;
  }
  if (vtkDataArray* const plane = numbers(data, mirrorPlane, 6))
  {
    MirrorPlane mirror;
    for (int k = 0; k < 3; ++k)
    {
      mirror.origin[k] = plane->GetComponent(0, k);
      mirror.normal[k] = plane->GetComponent(0, k + 3);
    }
    result.mirror = mirror;
  }
  const ControlPoints nodes = readNodes(data, surface);
  result.status = nodes.status;
  std::map<vtkIdType, std::size_t> curveOfCell;
  std::vector<const Polyline*> drawn;
  for (std::size_t k = 0; k < input.polylines.size() && result.status.ok(); ++k)
  {
    const Polyline& line = input.polylines[k];
    const vtkIdType cell = input.cellOfPolyline[k];
    const auto found = nodes.curves.find(cell);
    result.status = checkLine(line);
    if (isImage(data, cell))
    {
      const auto original =
        static_cast<vtkIdType>(data->GetCellData()->GetArray(imageOf)->GetComponent(cell, 0));
      if (curveOfCell.count(original))
      {
        result.curves[curveOfCell[original]].traits.mirrored = true;
      }
      continue;
    }
    if (!result.status.ok())
    {
      break;
    }
    drawn.push_back(&line);
    curveOfCell[cell] = result.curves.size();
    result.curves.push_back(
      curveOf(line, found == nodes.curves.end() ? nullptr : &found->second, surface));
  }
  result.note = noteOnFarthest(drawn, surface);
  return result;
}
}
