// SPDX-License-Identifier: BSD-3-Clause
#include "PieceSizes.h"

#include "FieldRows.h"
#include "Flattening.h"
#include "PlainText.h"
#include "Units.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTriangle.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace wirewarp
{
namespace
{
using Place = std::array<double, 3>;

constexpr double leastSize = 20.0; // mm
constexpr double largestSize = 3000.0;
/// Less is not worth a word.
constexpr double hardlyAny = 5e-4;

template <typename... Values>
std::string format(const char* pattern, Values... values)
{
  char text[120];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

/// Areas of the triangles around a point.
struct Star
{
  double surface = 0.0;
  double flat = 0.0;
  vtkIdType piece = 0;
};

struct Totals
{
  vtkBoundingBox box;
  double surface = 0.0;
  double more = 0.0;
  double less = 0.0;
  vtkIdType points = 0;
  vtkIdType worstPoint = -1;
  double worst = 0.0;
};

double areaOf(vtkPoints* points, const vtkIdType* ids)
{
  Place a;
  Place b;
  Place c;
  points->GetPoint(ids[0], a.data());
  points->GetPoint(ids[1], b.data());
  points->GetPoint(ids[2], c.data());
  return vtkTriangle::TriangleArea(a.data(), b.data(), c.data());
}

vtkIdType pieceOf(vtkPolyData* data, vtkIdType cell)
{
  vtkDataArray* const pieces = data->GetCellData()->GetArray("PieceId");
  return pieces ? static_cast<vtkIdType>(pieces->GetComponent(cell, 0)) : 0;
}

std::vector<Totals> measure(const Flattening& result, vtkIdType pieces)
{
  std::vector<Totals> totals(static_cast<std::size_t>(pieces));
  vtkPoints* const flat = result.flat->GetPoints();
  std::vector<Star> stars(static_cast<std::size_t>(flat->GetNumberOfPoints()));
  const auto cells = vtk::TakeSmartPointer(result.flat->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const vtkIdType piece = pieceOf(result.flat, cells->GetCurrentCellId());
    const double surface = areaOf(result.cut->GetPoints(), ids);
    const double change = areaOf(flat, ids) - surface;
    Totals& total = totals[static_cast<std::size_t>(piece)];
    total.surface += surface;
    (change > 0.0 ? total.more : total.less) += std::abs(change);
    for (vtkIdType k = 0; k < count; ++k)
    {
      Star& star = stars[static_cast<std::size_t>(ids[k])];
      star.surface += surface;
      star.flat += surface + change;
      star.piece = piece;
      Place x;
      flat->GetPoint(ids[k], x.data());
      total.box.AddPoint(x.data());
    }
  }
  for (const Star& star : stars)
  {
    totals[static_cast<std::size_t>(star.piece)].points += star.surface > 0.0 ? 1 : 0;
  }
  for (std::size_t p = 0; p < stars.size(); ++p)
  {
    Totals& total = totals[static_cast<std::size_t>(stars[p].piece)];
    // Slivers beside curves say nothing of the cloth: a tenth of the mean around a point.
    if (stars[p].surface * static_cast<double>(total.points) > 0.3 * total.surface)
    {
      const double change = stars[p].flat / stars[p].surface - 1.0;
      if (std::abs(change) > std::abs(total.worst))
      {
        total.worst = change;
        total.worstPoint = static_cast<vtkIdType>(p);
      }
    }
  }
  return totals;
}

double distanceInPlane(vtkPoints* points, vtkIdType p, vtkIdType q)
{
  Place a;
  Place b;
  points->GetPoint(p, a.data());
  points->GetPoint(q, b.data());
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// The curve, or the boundary, within a twentieth of the piece's diagonal; empty for none.
std::string wireNear(const Flattening& result, vtkIdType piece, const Totals& total)
{
  auto* const names =
    vtkStringArray::SafeDownCast(result.wires->GetCellData()->GetAbstractArray("CurveName"));
  vtkDataArray* const curves = result.wires->GetCellData()->GetArray("CurveId");
  vtkDataArray* const connectors = result.wires->GetCellData()->GetArray("Connector");
  if (!names || !curves)
  {
    return "";
  }
  const double reach = 0.05 * total.box.GetDiagonalLength();
  std::pair<double, std::string> nearest{ reach, "" };
  bool atBoundary = false;
  const auto wires = vtk::TakeSmartPointer(result.wires->GetLines()->NewIterator());
  for (wires->GoToFirstCell(); !wires->IsDoneWithTraversal(); wires->GoToNextCell())
  {
    const vtkIdType wire = wires->GetCurrentCellId();
    if (pieceOf(result.wires, wire) != piece ||
      (connectors && connectors->GetComponent(wire, 0) != 0.0))
    {
      continue;
    }
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    wires->GetCurrentCell(count, ids);
    for (vtkIdType k = 0; k < count; ++k)
    {
      const double distance = distanceInPlane(result.flat->GetPoints(), ids[k], total.worstPoint);
      if (curves->GetComponent(wire, 0) < 0.0)
      {
        atBoundary = atBoundary || distance <= reach;
      }
      else if (distance < nearest.first)
      {
        nearest = { distance, names->GetValue(wire) };
      }
    }
  }
  return !nearest.second.empty() ? "near \"" + plainText(nearest.second) + '"'
    : atBoundary                 ? std::string("at the boundary")
                                 : std::string();
}

/// Which ninth of the bounding box, as on the sheet.
std::string regionOf(const Place& x, const vtkBoundingBox& box)
{
  const auto third = [&](int axis) {
    const double length = box.GetLength(axis);
    const double at =
      length > 0.0 ? (x[static_cast<std::size_t>(axis)] - box.GetBound(2 * axis)) / length : 0.5;
    return at < 1.0 / 3.0 ? 0 : at > 2.0 / 3.0 ? 2 : 1;
  };
  static constexpr std::array<const char*, 3> rows{ "bottom", "", "top" };
  static constexpr std::array<const char*, 3> columns{ "left", "", "right" };
  const std::string row = rows[static_cast<std::size_t>(third(1))];
  const std::string column = columns[static_cast<std::size_t>(third(0))];
  return row.empty() && column.empty()
    ? "in the middle"
    : "at the " + row + (row.empty() || column.empty() ? "" : " ") + column;
}

std::string percent(double fraction)
{
  return format(std::abs(fraction) < 0.0995 ? "%.1f %%" : "%.0f %%", 100.0 * std::abs(fraction));
}

/// Whole centimetres say enough of a large piece, tenths of a small one.
std::string sizeInWords(const PieceSize& size)
{
  const bool small = std::min(size.width, size.height) < 100.0;
  return format(small ? "%.1f x %.1f cm" : "%.0f x %.0f cm", size.width / 10.0, size.height / 10.0);
}

std::string verdictOf(const PieceSize& size)
{
  const bool more = size.easedIn > hardlyAny;
  const bool less = size.stretched > hardlyAny;
  if (!more && !less)
  {
    return "it lies flat as it is";
  }
  std::string text = more ? percent(size.easedIn) + " of the area must be eased in" : "";
  text += more && less ? " and " + percent(size.stretched) + " stretched"
    : less             ? percent(size.stretched) + " of the area must be stretched"
                       : "";
  if (std::abs(size.worst) > hardlyAny)
  {
    text += ", worst " + percent(size.worst) +
      (more && less ? (size.worst > 0.0 ? " to ease in" : " to stretch") : "") + " " + size.place;
  }
  return text;
}
}

//------------------------------------------------------------------------------
std::vector<PieceSize> pieceSizes(const Flattening& result)
{
  std::vector<PieceSize> sizes;
  const vtkIdType pieces = FieldRows(result.flat).count("Triangles");
  if (pieces == 0)
  {
    return sizes;
  }
  const double millimetres = millimetresOf(result.unit);
  const std::vector<Totals> totals = measure(result, pieces);
  for (vtkIdType piece = 0; piece < pieces; ++piece)
  {
    const Totals& total = totals[static_cast<std::size_t>(piece)];
    PieceSize size;
    size.width = millimetres * total.box.GetLength(0);
    size.height = millimetres * total.box.GetLength(1);
    size.easedIn = total.surface > 0.0 ? total.more / total.surface : 0.0;
    size.stretched = total.surface > 0.0 ? total.less / total.surface : 0.0;
    size.worst = total.worst;
    if (total.worstPoint >= 0)
    {
      Place x;
      result.flat->GetPoint(total.worstPoint, x.data());
      const std::string wire = wireNear(result, piece, total);
      size.place = regionOf(x, total.box) + (wire.empty() ? "" : ", " + wire);
    }
    sizes.push_back(size);
  }
  return sizes;
}

//------------------------------------------------------------------------------
std::string verdicts(const Flattening& result, bool unitAsked)
{
  const std::vector<PieceSize>& sizes = result.sizes;
  std::string text;
  for (std::size_t piece = 0; piece < sizes.size(); ++piece)
  {
    text += "piece " + std::to_string(piece + 1) + ": " + sizeInWords(sizes[piece]) +
      (result.unitStated || unitAsked || piece > 0 ? "" : " (lengths taken as cm: --unit)") + "; " +
      verdictOf(sizes[piece]) + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::string sizeWarning(const Flattening& result)
{
  double least = std::numeric_limits<double>::max();
  double largest = 0.0;
  for (const PieceSize& size : result.sizes)
  {
    const double side = std::max(size.width, size.height);
    least = std::min(least, side);
    largest = std::max(largest, side);
  }
  const std::string text = result.sizes.empty() ? ""
    : least < leastSize     ? format("the smallest piece is %.2g mm long", least)
    : largest > largestSize ? format("the largest piece is %.3g m long", largest / 1000.0)
                            : "";
  return text.empty()   ? text
    : result.unitStated ? text + " in the stated unit, " + result.unit
                        : text +
      ", where the unit is not stated and taken as cm; state it with "
      "--unit mm, cm, m or inch";
}
}
