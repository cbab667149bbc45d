// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CurvedSurface.h"

#include "Base/Types.h"
#include "Cut/SurfaceCut.h"
#include "Input/StatusWords.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace flattening
{
namespace
{
Status outcomeOfImprint(
  const Status& status, const CurveInput& curves, const SurfaceTriangles& input)
{
  switch (status.ids.kind)
  {
    case ElementKind::Cells:
      return inInput(status, input.cellOfTriangle);
    case ElementKind::Curves:
      return inInput(status, curves.cellOfPolyline);
    default:
      return status; // points of a curve are the caller's already
  }
}

bool sameOptions(const ImprintOptions& a, const ImprintOptions& b)
{
  return a.split == b.split && a.tolerance == b.tolerance && a.snap == b.snap;
}

/// The cells in which a straight key runs along two edges of a triangle, which keeps no area then.
std::vector<std::int64_t> cellsPressedFlat(const CurvedSurface& source, const FeatureCurve& curve)
{
  const TriangleMesh& mesh = source.imprinted.mesh;
  std::vector<std::int64_t> cells;
  for (std::size_t k = 2; k < curve.vertices.size(); ++k)
  {
    const Index from = curve.vertices[k - 2];
    const Index to = curve.vertices[k - 1];
    for (const Index h : { mesh.find(from, to), mesh.find(to, from) })
    {
      if (h != none && mesh.from(TriangleMesh::previous(h)) == curve.vertices[k])
      {
        cells.push_back(source.cellOf(h / 3));
      }
    }
  }
  return cells;
}

void warnOfStraightKeys(CurvedSurface& source)
{
  for (const FeatureCurve& curve : source.imprinted.curves)
  {
    const bool straight = curve.type == CurveType::Key && curve.keyShape == KeyShape::Straight;
    const std::vector<std::int64_t> cells =
      straight ? cellsPressedFlat(source, curve) : std::vector<std::int64_t>();
    if (!cells.empty())
    {
      source.warnings.push_back("the straight key curve '" + curve.name +
        "' runs along two edges of a triangle in cells " + listIds(cells) +
        ", which keeps no area in the plane; draw it through the vertices there, or beside them by "
        "more than the snap tolerance");
    }
  }
}

/// Whether polylines run through the same points.
bool samePlaces(const std::vector<Polyline>& a, const std::vector<Polyline>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const Polyline& p, const Polyline& q) { return sameBits(p.points, q.points); });
}

std::string listed(const std::vector<Polyline>& curves)
{
  std::vector<std::string> names;
  for (const Polyline& curve : curves)
  {
    names.push_back(curve.name);
  }
  sortUnique(names);
  return listNames(names, 20);
}

/// The point's id in the input, or where it is if the imprint made it.
std::string pointWords(const CurvedSurface& source, Index vertex)
{
  const std::int64_t point = source.pointOf(vertex);
  if (point >= 0)
  {
    return "point " + std::to_string(point);
  }
  const Point3& x = source.imprinted.mesh.point(vertex);
  char place[120];
  std::snprintf(place, sizeof(place), "(%.6g, %.6g, %.6g)", x.x(), x.y(), x.z());
  return place;
}
}

std::int64_t CurvedSurface::cellOf(Index triangle) const
{
  return this->surface.input.cellOfTriangle[this->imprinted.originalTriangle[triangle]];
}

std::int64_t CurvedSurface::pointOf(Index vertex) const
{
  const VertexSource& source = this->imprinted.vertexSource[vertex];
  return source.weights[0] == 1.0 ? this->surface.prepared.originalPoint[source.vertices[0]] : -1;
}

Index CurvedSurface::vertexOf(std::int64_t point) const
{
  const Indices& vertexOfPoint = this->surface.prepared.vertexOfPoint;
  const bool known = point >= 0 && point < static_cast<std::int64_t>(vertexOfPoint.size());
  return known ? vertexOfPoint[point] : none;
}

Status CurvedSurface::pinVertices(
  const std::array<std::int64_t, 2>& points, std::array<Index, 2>& pins) const
{
  pins = { this->vertexOf(points[0]), this->vertexOf(points[1]) };
  const bool automatic = points[0] < 0 && points[1] < 0;
  if (automatic || (pins[0] != none && pins[1] != none && pins[0] != pins[1]))
  {
    return {};
  }
  return { StatusCode::InvalidOption,
    "the pins " + std::to_string(points[0]) + " and " + std::to_string(points[1]) +
      " are not two different points of the surface's triangles",
    { ElementKind::Points, std::vector<std::int64_t>{ points[0], points[1] } },
    { Remedy::NamePins } };
}

Status CurvedSurface::outcomeOfStage(const Status& status, const CutSurface* cut) const
{
  std::vector<std::int64_t> inputId;
  switch (status.ids.kind)
  {
    case ElementKind::Curves:
      return inInput(status, this->curves.cellOfPolyline);
    case ElementKind::Points:
    case ElementKind::Edges:
      for (Index v = 0; v < this->imprinted.mesh.vertexCount(); ++v)
      {
        inputId.push_back(this->pointOf(v));
      }
      break;
    case ElementKind::Cells:
      for (Index t = 0; t < (cut ? cut->mesh : this->imprinted.mesh).triangleCount(); ++t)
      {
        inputId.push_back(this->cellOf(cut ? cut->originalTriangle(t) : t));
      }
      break;
    default:
      break; // ids of a stage's own making (wire-patches of a piece) mean nothing to the caller
  }
  return inInput(status, inputId);
}

Status refuseCurve(std::int64_t cell, const std::string& what, const char* suggested)
{
  return { StatusCode::InvalidCurve, "cell " + std::to_string(cell) + " of the curves " + what,
    { ElementKind::Curves, std::vector<std::int64_t>{ cell } }, { { Remedy::Give, suggested } } };
}

Status checkTolerance(std::int64_t cell, double tolerance)
{
  return tolerance >= 0.0 && tolerance < 1.0
    ? Status()
    : refuseCurve(cell, "has a LengthTolerance outside [0, 1)", "a fraction of the length");
}

Status takePlanarShape(const Points2& shape, Polyline& curve)
{
  if (curve.type != CurveType::Key || curve.keyShape == KeyShape::Straight)
  {
    return {};
  }
  Indices without;
  for (std::size_t k = 0; k < shape.size(); ++k)
  {
    if (isFinite(shape[k]))
    {
      curve.planarShape.push_back(shape[k]);
    }
    else
    {
      without.push_back(curve.pointIds[k]);
    }
  }
  if (!without.empty() && !curve.planarShape.empty())
  {
    return { StatusCode::InvalidCurve,
      "the curve \"" + curve.name + "\" has a PlanarShape at some of its points, but not at " +
        listIds(without),
      { ElementKind::CurvePoints, without },
      { { Remedy::Give, "it at all of them, or at none" } } };
  }
  if (without.empty())
  {
    curve.keyShape = KeyShape::Planar;
  }
  return {};
}

void imprintInput(
  CurveInput read, const ImprintOptions& options, const Execution& execution, CurvedSurface& source)
{
  if (!read.outcome.ok())
  {
    source.outcome = std::move(read.outcome);
    source.blamed = read.blamed;
    return;
  }
  source.warnings.insert(source.warnings.end(), read.warnings.begin(), read.warnings.end());
  const bool imprinted = source.imprintedBy && sameOptions(*source.imprintedBy, options) &&
    samePlaces(source.curves.polylines, read.polylines);
  // Should something be thrown, the next run starts anew.
  source.imprintedBy.reset();
  source.curves = std::move(read);
  if (imprinted)
  {
    describeCurves(source.imprinted, source.curves.polylines);
  }
  else
  {
    source.imprinted =
      imprintCurves(source.surface.prepared.mesh, source.curves.polylines, options, execution);
  }
  if (source.imprinted.status.ok())
  {
    source.imprintedBy = options;
  }
  warnOfStraightKeys(source);
  const Status& status = source.imprinted.status;
  source.outcome = outcomeOfImprint(status, source.curves, source.surface.input);
  source.blamed = status.curve == none ? -1 : source.curves.sourceOfPolyline[status.curve];
}

Status noCurveNamed(const std::string& name, const CurvedSurface& source)
{
  const std::vector<Polyline>& polylines = source.curves.polylines;
  return { StatusCode::InvalidOption,
    "no curve is named \"" + name + "\"; " +
      (polylines.empty() ? "there is no feature curve" : "the curves are " + listed(polylines)),
    {}, { Remedy::NameCurve } };
}

Status applyTolerances(const std::map<std::string, double>& tolerances, CurvedSurface& source)
{
  std::vector<Polyline>& polylines = source.curves.polylines;
  for (const auto& entry : tolerances)
  {
    if (!std::isfinite(entry.second) || entry.second < 0.0 || entry.second >= 1.0)
    {
      return invalidOption("the length tolerance of \"" + entry.first + "\" lies outside [0, 1)",
        "a fraction of the length");
    }
    bool known = entry.first == boundaryName;
    for (std::size_t c = 0; c < polylines.size(); ++c)
    {
      if (polylines[c].name == entry.first)
      {
        known = true;
        polylines[c].tolerance = entry.second;
        source.imprinted.curves[c].tolerance = entry.second;
      }
    }
    if (!known)
    {
      return noCurveNamed(entry.first, source);
    }
  }
  return {};
}

std::vector<std::string> describeShortEnds(const CurvedSurface& source)
{
  std::vector<std::string> sentences;
  const std::vector<FeatureCurve>& curves = source.imprinted.curves;
  for (const ShortEnd& end : endsShortOfBoundary(source.imprinted.mesh, curves))
  {
    const FeatureCurve& curve = curves[end.curve];
    const bool dart = curve.type == CurveType::Dart;
    sentences.push_back(curveTypeName(curve.type) + (" \"" + curve.name) + "\" ends at " +
      pointWords(source, end.vertex) + ", one edge inside the boundary, and " +
      (dart ? "does not open there" : "divides nothing there") + "; begin it at " +
      pointWords(source, end.boundary));
  }
  return sentences;
}
}
