// SPDX-License-Identifier: BSD-3-Clause
#include "Report/FlatteningData.h"

#include "Base/Types.h"
#include "Report/FlatteningArrays.h"
#include "Report/SuggestionReport.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
/// The columns with a value for each element, texts without NUL.
Columns wholeColumns(const Columns& all, std::size_t count, const std::string& element,
  std::vector<std::string>& warnings)
{
  Columns whole;
  for (const Column& column : all)
  {
    const std::size_t rows = column.rows();
    if (rows < count)
    {
      std::string text = "the " + element + " array \"" + column.name + "\" has ";
      text += std::to_string(rows) + (rows == 1 ? " value for " : " values for ");
      text += std::to_string(count) + " " + element + "s and is left out; give it one for each";
      warnings.push_back(std::move(text));
      continue;
    }
    Column& kept = whole.emplace_back(column);
    auto* const texts = std::get_if<std::vector<std::string>>(&kept.values);
    bool changed = false;
    for (std::size_t k = 0; texts && k < texts->size(); ++k)
    {
      std::string sound = withoutNul((*texts)[k]);
      changed = changed || sound != (*texts)[k];
      (*texts)[k] = std::move(sound);
    }
    if (changed)
    {
      warnings.push_back("the " + element + " array \"" + column.name +
        "\" has texts with the character NUL, which no file of VTK can hold; they are written with "
        "\\0");
    }
  }
  return whole;
}

CellList cellsOf(const Triangles& triangles)
{
  CellList cells;
  for (const Triangle& t : triangles)
  {
    cells.add(t);
  }
  return cells;
}

bool hasRole(const Columns& columns, ArrayRole role)
{
  return std::any_of(
    columns.begin(), columns.end(), [role](const Column& column) { return column.role == role; });
}

/// What viewers color by where the input chose nothing.
void setScalars(DataSet& data, const char* name)
{
  if (!hasRole(data.pointArrays, ArrayRole::Scalars) &&
    !hasRole(data.cellArrays, ArrayRole::Scalars))
  {
    Column scalars = *findColumn(data.cellArrays, name);
    scalars.role = ArrayRole::Scalars;
    setColumn(data.cellArrays, std::move(scalars));
  }
}

/// Normals and tangents of the surface in space, which would shade the flat pieces by its shape.
void dropDirections(Columns& columns)
{
  eraseIf(columns, [](const Column& column) {
    return column.role == ArrayRole::Normals || column.role == ArrayRole::Tangents;
  });
}

/// Fields without rows replace others of the input.
void setFields(Columns& fields, Columns added)
{
  setColumns(fields, std::move(added));
  eraseIf(fields, [](const Column& column) { return column.rows() == 0; });
}

Column planarShapes(std::size_t points, const std::vector<FeatureCurve>& curves)
{
  std::vector<double> shape(2 * points, std::numeric_limits<double>::quiet_NaN());
  for (const FeatureCurve& curve : curves)
  {
    for (std::size_t k = 0; k < curve.planarShape.size(); ++k)
    {
      const std::size_t at = 2 * static_cast<std::size_t>(curve.vertices[k]);
      shape[at] = curve.planarShape[k].x();
      shape[at + 1] = curve.planarShape[k].y();
    }
  }
  return { "PlanarShape", std::move(shape), 2 };
}

double lengthOf(const TriangleMesh& mesh, const Indices& chain)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    sum += (mesh.point(chain[i]) - mesh.point(chain[i - 1])).norm();
  }
  return sum;
}
}

SurfaceArrays::SurfaceArrays(const DataSet& surface, std::vector<std::string>& warnings)
  : points(wholeColumns(surface.pointArrays, surface.points->size(), "point", warnings))
  , cells(wholeColumns(surface.cellArrays, surface.cells(), "cell", warnings))
  , fields(wholeColumns(surface.fieldArrays, 0, "field", warnings))
{
}

FlatteningData flatteningData(const SurfaceArrays& input, const CurvedSurface& source,
  const FlatteningResult& result, const FlatteningOptions& options)
{
  FlatteningArrays arrays = flatteningArrays(source, result, options);
  FlatteningData data;
  DataSet& flat = data.flat;
  Points3 inPlane;
  std::vector<double> coordinates;
  for (const Point2& p : arrays.positions)
  {
    inPlane.emplace_back(p.x(), p.y(), 0.0);
    coordinates.insert(coordinates.end(), { p.x(), p.y() });
  }
  flat.points = std::make_shared<const Points3>(std::move(inPlane));
  flat.faces = cellsOf(result.cut->mesh.triangles());
  flat.pointArrays = arraysOfVertices(input.points, source, arrays.originalVertex);
  setColumns(flat.pointArrays, std::move(arrays.pointArrays));
  flat.cellArrays =
    copiedRows(input.cells, std::get<std::vector<std::int64_t>>(arrays.cellArrays.front().values));
  setColumns(flat.cellArrays, std::move(arrays.cellArrays));
  setScalars(flat, "HomogeneityOfDistortion");

  DataSet& cut = data.cut;
  cut = flat;
  cut.points = std::make_shared<const Points3>(std::move(arrays.points));
  for (Column& column : cut.pointArrays)
  {
    column.role = column.role == ArrayRole::TextureCoordinates ? ArrayRole::None : column.role;
  }
  setColumn(
    cut.pointArrays, { "FlatPositions", std::move(coordinates), 2, ArrayRole::TextureCoordinates });
  dropDirections(flat.pointArrays);
  dropDirections(flat.cellArrays);

  DataSet& wires = data.wires;
  wires.points = flat.points;
  for (const Wire& wire : result.wires)
  {
    wires.lines.add(wire.vertices);
  }
  wires.pointArrays = flat.pointArrays;
  wires.cellArrays = std::move(arrays.wireArrays);
  setScalars(wires, "WireKind");
  flat.fieldArrays = input.fields;
  setFields(flat.fieldArrays, std::move(arrays.fieldArrays));
  return data;
}

DataSet lineData(const std::vector<Points3>& lines)
{
  DataSet data;
  Points3 points;
  for (const Points3& line : lines)
  {
    std::vector<std::int64_t> ids(line.size());
    std::iota(ids.begin(), ids.end(), static_cast<std::int64_t>(points.size()));
    data.lines.add(ids);
    points.insert(points.end(), line.begin(), line.end());
  }
  data.points = std::make_shared<const Points3>(std::move(points));
  return data;
}

DataSet suggestionData(const std::vector<Polyline>& given, const CurveSuggestions& found)
{
  const std::vector<SuggestedCurve> rows = suggestionRows(given, found);
  std::vector<Points3> lines;
  std::vector<double> shape;
  bool shaped = false;
  for (const SuggestedCurve& row : rows)
  {
    lines.push_back(row.curve.points);
    for (std::size_t k = 0; k < row.curve.points.size(); ++k)
    {
      constexpr double no = std::numeric_limits<double>::quiet_NaN();
      const bool has = row.curve.keyShape == KeyShape::Planar && k < row.curve.planarShape.size();
      const Point2 place = has ? row.curve.planarShape[k] : Point2(no, no);
      shape.insert(shape.end(), { place.x(), place.y() });
      shaped = shaped || has;
    }
  }
  DataSet data = lineData(lines);
  if (shaped)
  {
    data.pointArrays.push_back({ "PlanarShape", std::move(shape), 2 });
  }
  data.cellArrays = suggestionArrays(rows, given.size());
  setFields(data.fieldArrays, mirrorArrays(found));
  return data;
}

ImprintData imprintData(const SurfaceArrays& input, const CurvedSurface& source)
{
  const TriangleMesh& mesh = source.imprinted.mesh;
  ImprintData data;
  DataSet& surface = data.surface;
  Indices vertices(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<std::int64_t> cells;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    cells.push_back(source.cellOf(t));
  }
  surface.points = std::make_shared<const Points3>(mesh.points());
  surface.faces = cellsOf(mesh.triangles());
  surface.pointArrays = arraysOfVertices(input.points, source, vertices);
  Columns ids;
  addRows<std::int64_t>(ids, "vtkOriginalPointIds", vertices.size(),
    [&](std::size_t v) { return source.pointOf(vertices[v]); });
  setColumns(surface.pointArrays, std::move(ids));
  surface.cellArrays = copiedRows(input.cells, cells);
  setColumn(surface.cellArrays, { "vtkOriginalCellIds", std::move(cells) });
  surface.fieldArrays = input.fields;

  const std::vector<FeatureCurve>& curves = source.imprinted.curves;
  DataSet& lines = data.curves;
  lines.points = surface.points;
  for (const FeatureCurve& curve : curves)
  {
    lines.lines.add(curve.vertices);
  }
  lines.pointArrays = surface.pointArrays;
  if (std::any_of(curves.begin(), curves.end(),
        [](const FeatureCurve& curve) { return curve.keyShape == KeyShape::Planar; }))
  {
    setColumn(lines.pointArrays, planarShapes(vertices.size(), curves));
  }
  Columns& arrays = lines.cellArrays;
  const TableColumns<FeatureCurve> columns(arrays, curves);
  columns.addAs<int>("CurveType", &FeatureCurve::type);
  columns.add("CurveName", &FeatureCurve::name);
  columns.addAs<int>("KeyShape",
    [](const FeatureCurve& curve) { return curve.keyShape == KeyShape::Straight ? 1 : 0; });
  columns.add("LengthTolerance", &FeatureCurve::tolerance);
  addEases(arrays, curves.size(), [&](std::size_t c) { return curves[c].ease; });
  columns.addNumbers("CurveId");
  columns.add(
    "RestLength", [&mesh](const FeatureCurve& curve) { return lengthOf(mesh, curve.vertices); });
  addRows<std::int64_t>(arrays, "vtkOriginalCellIds", curves.size(),
    [&](std::size_t c) { return source.curves.cellOfPolyline[c]; });
  return data;
}

std::vector<std::string> healData(const DataSet& surface, DataSet& healed)
{
  const LoadedSurface loaded =
    loadSurface(readTriangles(surface), CoincidentPoints::Automatic, Defects::Separate);
  std::vector<std::string> sentences = loaded.mendings;
  if (!loaded.outcome.ok())
  {
    sentences.push_back(loaded.outcome.message);
  }
  healed = surface;
  if (!loaded.outcome.ok() || loaded.prepared.mendings.empty())
  {
    return sentences;
  }
  Points3 points = *surface.points;
  std::vector<std::int64_t> rows(points.size());
  std::iota(rows.begin(), rows.end(), std::int64_t{ 0 });
  Indices pointOf;
  std::vector<char> taken(points.size(), 0);
  for (const Index p : loaded.prepared.originalPoint)
  {
    const auto at = static_cast<std::size_t>(p);
    pointOf.push_back(p);
    if (taken[at] != 0)
    {
      pointOf.back() = static_cast<Index>(points.size());
      rows.push_back(p);
      points.push_back(points[at]);
    }
    taken[at] = 1;
  }
  healed.faces = {};
  healed.strips = {};
  for (const Triangle& t : loaded.prepared.mesh.triangles())
  {
    healed.faces.add(Triangle{ pointOf[t[0]], pointOf[t[1]], pointOf[t[2]] });
  }
  healed.points = std::make_shared<const Points3>(std::move(points));
  healed.pointArrays = copiedRows(surface.pointArrays, rows);
  std::vector<std::int64_t> cells(surface.firstFace());
  std::iota(cells.begin(), cells.end(), std::int64_t{ 0 });
  const std::vector<std::int64_t>& faces = loaded.input.cellOfTriangle;
  cells.insert(cells.end(), faces.begin(), faces.end());
  healed.cellArrays = copiedRows(surface.cellArrays, cells);
  setColumn(healed.cellArrays, { "vtkOriginalCellIds", std::move(cells) });
  return sentences;
}
}
