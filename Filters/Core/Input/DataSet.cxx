// SPDX-License-Identifier: BSD-3-Clause
#include "Input/DataSet.h"

#include "Base/Types.h"
#include "Surface/PolygonTriangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{
// Bits of vtkGhostType.
constexpr int duplicateCell = 1;
constexpr int hiddenCell = 32;

/// An id that does not fit stays out of range, for prepareSurface() to refuse.
Index pointIndex(std::int64_t id)
{
  return id >= 0 && id <= std::numeric_limits<Index>::max() ? static_cast<Index>(id) : none;
}

/// A corner twice joins nothing, but two points in one place may hold parts together.
Triangles trianglesOfPolygon(const Points3& points, const Indices& corners)
{
  Triangles triangles = triangulatePolygon(points, corners);
  eraseIf(triangles, repeatsCorner);
  return triangles;
}

/// The triangles of a strip, every other one turned, or of a fan: that keeps unsound points for
/// prepareSurface() to refuse.
Triangles trianglesInRow(const Indices& corners, bool strip)
{
  Triangles triangles;
  for (std::size_t k = 2; k < corners.size(); ++k)
  {
    triangles.push_back({ corners[strip ? k - 2 : 0], corners[k - 1], corners[k] });
    if (strip && k % 2 == 1)
    {
      std::swap(triangles.back()[0], triangles.back()[1]);
    }
  }
  return triangles;
}

/// The mean of rows of an array, of texts that of the largest weight.
template <class Value>
Value meanOf(const std::vector<Value>& values, int components, int component,
  const std::array<std::int64_t, 3>& rows, const std::array<double, 3>& weights)
{
  const auto at = [&](std::size_t k) -> const Value& {
    return values[static_cast<std::size_t>(rows[k] * components + component)];
  };
  if constexpr (std::is_same_v<Value, std::string>)
  {
    const auto largest = std::max_element(weights.begin(), weights.end());
    return at(static_cast<std::size_t>(largest - weights.begin()));
  }
  else
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += weights[k] != 0.0 ? weights[k] * static_cast<double>(at(k)) : 0.0;
    }
    return static_cast<Value>(std::is_floating_point_v<Value> ? sum : std::round(sum));
  }
}
}

CellChoice::CellChoice(const DataSet& data, GhostCells ghosts)
  : Ghosts(findColumn(data.cellArrays, "vtkGhostType"))
  , LeftOut(ghosts == GhostCells::LeftOut ? hiddenCell | duplicateCell : hiddenCell)
{
  if (this->Ghosts && (this->Ghosts->isText() || this->Ghosts->rows() < data.cells()))
  {
    this->Ghosts = nullptr;
  }
}

bool CellChoice::reads(std::size_t cell) const
{
  return !this->Ghosts || (static_cast<int>(this->Ghosts->number(cell)) & this->LeftOut) == 0;
}

SurfaceTriangles readTriangles(const DataSet& surface, GhostCells ghosts)
{
  SurfaceTriangles result;
  const auto pointCount = static_cast<std::int64_t>(surface.points->size());
  result.outcome = checkSize(
    pointCount, static_cast<std::int64_t>(surface.faces.ids.size() + surface.strips.ids.size()));
  if (!result.outcome.ok())
  {
    return result;
  }
  result.points = *surface.points;
  const CellChoice choice(surface, ghosts);
  const auto sound = [&](const CellList& cells) {
    return std::all_of(cells.ids.begin(), cells.ids.end(), [&](std::int64_t id) {
      return id >= 0 && id < pointCount && isFinite(result.points[static_cast<std::size_t>(id)]);
    });
  };
  const bool divides = sound(surface.faces) && sound(surface.strips);
  std::vector<std::int64_t> lost;
  std::size_t cell = surface.firstFace();
  const auto append = [&](const CellList& cells, bool strips) {
    for (std::size_t k = 0; k < cells.size(); ++k, ++cell)
    {
      if (!choice.reads(cell))
      {
        continue;
      }
      const auto id = static_cast<std::int64_t>(cell);
      const std::int64_t* const ids = cells.begin(k);
      if (cells.end(k) - ids == 3)
      {
        result.triangles.push_back({ pointIndex(ids[0]), pointIndex(ids[1]), pointIndex(ids[2]) });
        result.cellOfTriangle.push_back(id);
        continue;
      }
      Indices corners;
      std::transform(ids, cells.end(k), std::back_inserter(corners), pointIndex);
      const Triangles triangles = !strips && divides && corners.size() > 3
        ? trianglesOfPolygon(result.points, corners)
        : trianglesInRow(corners, strips);
      result.triangles.insert(result.triangles.end(), triangles.begin(), triangles.end());
      result.cellOfTriangle.insert(result.cellOfTriangle.end(), triangles.size(), id);
      if (divides && triangles.empty())
      {
        lost.push_back(id);
      }
    }
  };
  append(surface.faces, false);
  append(surface.strips, true);
  if (!lost.empty())
  {
    result.outcome = { StatusCode::DegenerateTriangle,
      "cells " + listIds(lost) + " are polygons with fewer than three different corners",
      { ElementKind::Cells, lost }, { Remedy::RemeshTriangles } };
  }
  return result;
}

std::string withoutNul(std::string text)
{
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
  {
    text.replace(at, 1, "\\0");
  }
  return text;
}

Columns arraysOfVertices(
  const Columns& pointArrays, const CurvedSurface& source, const Indices& vertices)
{
  std::vector<std::int64_t> rows;
  rows.reserve(vertices.size());
  for (const Index vertex : vertices)
  {
    const VertexSource& mean = source.imprinted.vertexSource[vertex];
    rows.push_back(source.surface.prepared.originalPoint[mean.vertices[0]]);
  }
  Columns arrays = copiedRows(pointArrays, rows);
  for (std::size_t v = 0; v < vertices.size() && !arrays.empty(); ++v)
  {
    const VertexSource& mean = source.imprinted.vertexSource[vertices[v]];
    if (mean.weights[0] == 1.0)
    {
      continue;
    }
    std::array<std::int64_t, 3> points{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      points[k] =
        mean.vertices[k] == none ? 0 : source.surface.prepared.originalPoint[mean.vertices[k]];
    }
    for (Column& column : arrays)
    {
      const Column& from = *findColumn(pointArrays, column.name);
      std::visit(
        [&](auto& values) {
          const auto& all = std::get<std::decay_t<decltype(values)>>(from.values);
          for (int c = 0; c < column.components; ++c)
          {
            values[v * static_cast<std::size_t>(column.components) + static_cast<std::size_t>(c)] =
              meanOf(all, column.components, c, points, mean.weights);
          }
        },
        column.values);
    }
  }
  return arrays;
}
}
