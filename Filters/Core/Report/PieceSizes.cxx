// SPDX-License-Identifier: BSD-3-Clause
#include "Report/PieceSizes.h"

#include "Base/LengthUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

namespace flattening
{
namespace
{
/// In mm, of the largest piece: what is smaller, or larger than any garment's panel, is most likely
/// stated in a wrong unit.
constexpr double minSize = 20.0;
constexpr double largestSize = 3000.0;
constexpr double largestStatedSize = 15000.0; // of sails, tents and hulls
/// Less is not worth a word.
constexpr double hardlyAny = 5e-4;
/// Of a piece's diagonal: what is nearer to a wire is said to be at it.
constexpr double reachOfWire = 0.05;

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
  Index piece = 0;
};

struct Totals
{
  Point2 low = Point2::Constant(std::numeric_limits<double>::max());
  Point2 high = Point2::Constant(std::numeric_limits<double>::lowest());
  double surface = 0.0;
  double more = 0.0;
  double less = 0.0;
  double points = 0.0;
  Index worstPoint = none;
  double worst = 0.0;
};

std::vector<Totals> measure(const FlatteningResult& result)
{
  const TriangleMesh& mesh = result.cut->mesh;
  std::vector<Totals> totals(result.pieces.size());
  std::vector<Star> stars(result.positions.size());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& triangle = mesh.triangles()[t];
    const Index piece = result.cut->pieceOfTriangle[t];
    const double surface = mesh.area(t);
    const double change = 0.5 * std::abs(cross(result.positions, triangle)) - surface;
    Totals& total = totals[piece];
    total.surface += surface;
    (change > 0.0 ? total.more : total.less) += std::abs(change);
    for (const Index v : triangle)
    {
      stars[v].surface += surface;
      stars[v].flat += surface + change;
      stars[v].piece = piece;
      total.low = total.low.cwiseMin(result.positions[v]);
      total.high = total.high.cwiseMax(result.positions[v]);
    }
  }
  for (const Star& star : stars)
  {
    totals[star.piece].points += star.surface > 0.0 ? 1.0 : 0.0;
  }
  for (std::size_t v = 0; v < stars.size(); ++v)
  {
    Totals& total = totals[stars[v].piece];
    // Slivers beside curves say nothing of the cloth: a tenth of the mean around a point.
    if (stars[v].surface * total.points > 0.3 * total.surface)
    {
      const double change = stars[v].flat / stars[v].surface - 1.0;
      if (std::abs(change) > std::abs(total.worst))
      {
        total.worst = change;
        total.worstPoint = static_cast<Index>(v);
      }
    }
  }
  return totals;
}

/// The curve, or the boundary, that is near to the worst point; empty for none.
std::string wireNear(const FlatteningResult& result, Index piece, const Totals& total)
{
  const double reach = reachOfWire * (total.high - total.low).norm();
  double nearest = reach;
  Index curve = none;
  bool atBoundary = false;
  for (const Wire& wire : result.wires)
  {
    if (wire.piece != piece || wire.connector)
    {
      continue;
    }
    for (const Index v : wire.vertices)
    {
      const double distance = (result.positions[v] - result.positions[total.worstPoint]).norm();
      atBoundary = atBoundary || (wire.curve == none && distance <= reach);
      if (wire.curve != none && distance < nearest)
      {
        nearest = distance;
        curve = wire.curve;
      }
    }
  }
  return curve != none ? ", near \"" + result.curves[curve].name + '"'
    : atBoundary       ? ", at the boundary"
                       : "";
}

/// Which ninth of the bounding box, as on the sheet.
std::string regionOf(const Point2& x, const Totals& total)
{
  const auto third = [&](int axis) -> std::size_t {
    const double length = total.high[axis] - total.low[axis];
    const double at = length > 0.0 ? (x[axis] - total.low[axis]) / length : 0.5;
    return at < 1.0 / 3.0 ? 0 : at > 2.0 / 3.0 ? 2 : 1;
  };
  static constexpr std::array<const char*, 3> rows{ "bottom", "", "top" };
  static constexpr std::array<const char*, 3> columns{ "left", "", "right" };
  const std::string row = rows[third(1)];
  const std::string column = columns[third(0)];
  return row.empty() && column.empty()
    ? "in the middle"
    : "at the " + row + (row.empty() || column.empty() ? "" : " ") + column;
}

std::string roundPercent(double fraction)
{
  return format(std::abs(fraction) < 0.0995 ? "%.1f %%" : "%.0f %%", 100.0 * std::abs(fraction));
}
}

/// Whole centimeters say enough of a large piece, tenths of a small one.
std::string sizeInWords(const PieceSize& size, double millimetres)
{
  const Point2 extent = 0.1 * millimetres * size.extent;
  return format(
    extent.minCoeff() < 10.0 ? "%.1f x %.1f cm" : "%.0f x %.0f cm", extent.x(), extent.y());
}

std::string easeInWords(const PieceSize& size)
{
  const bool more = size.easedIn > hardlyAny;
  const bool less = size.stretched > hardlyAny;
  if (!more && !less)
  {
    return "it lies flat as it is";
  }
  std::string text = more ? roundPercent(size.easedIn) + " of the area must be eased in" : "";
  text += more && less ? " and " + roundPercent(size.stretched) + " stretched"
    : less             ? roundPercent(size.stretched) + " of the area must be stretched"
                       : "";
  if (std::abs(size.worst) > hardlyAny)
  {
    text += ", worst " + roundPercent(size.worst) +
      (more && less ? (size.worst > 0.0 ? " to ease in" : " to stretch") : "") + " " + size.place;
  }
  return text;
}

std::vector<PieceSize> pieceSizes(const FlatteningResult& result)
{
  std::vector<PieceSize> sizes;
  const std::vector<Totals> totals = measure(result);
  for (std::size_t p = 0; p < totals.size(); ++p)
  {
    const Totals& total = totals[p];
    PieceSize size;
    size.extent = total.high - total.low;
    size.easedIn = total.surface > 0.0 ? total.more / total.surface : 0.0;
    size.stretched = total.surface > 0.0 ? total.less / total.surface : 0.0;
    size.worst = total.worst;
    if (total.worstPoint != none)
    {
      size.place = regionOf(result.positions[total.worstPoint], total) +
        wireNear(result, static_cast<Index>(p), total);
    }
    sizes.push_back(std::move(size));
  }
  return sizes;
}

std::string sizeWarning(const std::vector<PieceSize>& sizes, const std::string& unit)
{
  double largest = 0.0;
  for (const PieceSize& size : sizes)
  {
    largest = std::max(largest, millimetresPer(unitNamed(unit)) * size.extent.maxCoeff());
  }
  // A wrong unit makes all pieces too small; a small one beside others is a small one.
  const std::string text = sizes.empty() ? ""
    : largest < minSize                  ? format("the largest piece is %.2g mm long", largest)
    : largest > (unit.empty() ? largestSize : largestStatedSize)
    ? format("the largest piece is %.3g m long", largest / 1000.0)
    : "";
  return text.empty() ? text
    : unit.empty()    ? text + ", where the unit is not stated and taken as cm"
                      : text + " in the stated unit, " + unit;
}

std::vector<std::string> pieceNames(
  const std::vector<std::string>& cellNames, const Indices& pieceOfTriangle, std::size_t pieces)
{
  std::vector<std::string> names(pieces);
  std::vector<bool> known(pieces, false);
  for (std::size_t t = 0; t < cellNames.size(); ++t)
  {
    const auto piece = static_cast<std::size_t>(pieceOfTriangle[t]);
    const std::string& name = cellNames[t];
    names[piece] = !known[piece] || names[piece] == name ? name : ""; // cloth of two has neither
    known[piece] = true;
  }
  std::map<std::string, int> count;
  std::map<std::string, int> number;
  for (const std::string& name : names)
  {
    ++count[name];
  }
  for (std::string& name : names)
  {
    if (!name.empty() && count[name] > 1)
    {
      const int of = ++number[name];
      name += " " + std::to_string(of);
    }
  }
  return names;
}
}
