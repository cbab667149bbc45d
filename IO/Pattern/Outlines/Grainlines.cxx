// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/Grainlines.h"

#include "Outlines/Outline.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <limits>

namespace flattening::pattern
{
namespace
{
constexpr double longestHead = 5.0;  ///< of an arrow, millimetres
constexpr double headOfShort = 0.15; ///< of the whole arrow
constexpr double widthOfHead = 0.3;  ///< on either side, of its length

/// The largest distance of a line's points from its chord, as a fraction of the chord.
double bendOf(const PatternLine& line)
{
  return farthestFromChord(line.points) / (line.points.back() - line.points.front()).norm();
}

bool isOpenKey(const PatternLine& line)
{
  return line.kind == LineKind::KeyCurve && !line.closed &&
    line.points.front() != line.points.back();
}

/// The first straight key curve, or null.
const PatternLine* straightKey(const PatternPiece& piece)
{
  const auto isStraight = [](const PatternLine& line) {
    return isOpenKey(line) && bendOf(line) <= straightness;
  };
  const auto found = std::find_if(piece.lines.begin(), piece.lines.end(), isStraight);
  return found == piece.lines.end() ? nullptr : &*found;
}

/// Of a piece without a straight key curve: a warning of the one that bends least, if there is one.
void warnOfBentKeys(PatternPiece& piece)
{
  const PatternLine* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PatternLine& line : piece.lines)
  {
    const double bend = isOpenKey(line) ? bendOf(line) : least;
    best = bend < least ? &line : best;
    least = std::min(least, bend);
  }
  if (best)
  {
    const double chord = (best->points.back() - best->points.front()).norm();
    piece.warnings.push_back("piece " + piece.name + ": the key curve " + best->name +
      " bends by " + formatNumber(least * chord, 1) +
      " mm, so the grainline is drawn upright, not along it");
  }
}
}

std::optional<Point2> upOf(const PatternSource& source, std::size_t piece, UpAxis axis)
{
  constexpr double leastSlope = 0.3;
  if (axis == UpAxis::None || source.inSpace.empty())
  {
    return std::nullopt;
  }
  Eigen::AlignedBox3d box;
  for (const Point3& x : source.inSpace)
  {
    box.extend(x);
  }
  const Eigen::Index up = axis == UpAxis::X ? 0
    : axis == UpAxis::Y                     ? 1
    : axis == UpAxis::Z                     ? 2
                                            : upAxisOf(box.sizes());
  Point2 slope = Point2::Zero(); // of the height, times the area
  double area = 0.0;
  for (const Triangle& corners : trianglesOf(source, piece))
  {
    const auto at = [&](std::size_t k) { return source.positions[corners[k % 3]]; };
    area += cross(source.positions, corners) / 2.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point2 opposite = at(k + 2) - at(k + 1);
      slope += source.inSpace[corners[k]][up] / 2.0 * Point2(-opposite.y(), opposite.x());
    }
  }
  return slope.norm() > leastSlope * area ? std::optional<Point2>(slope.normalized())
                                          : std::nullopt;
}

Point2 grainOf(const PatternSource& source, std::size_t piece, UpAxis axis)
{
  const Point2 upright(0.0, 1.0);
  for (const SourceWire& wire : source.wires)
  {
    const bool isKey = wire.type == WireType::Key && wire.piece == static_cast<Index>(piece) &&
      wire.points.size() > 1 && wire.points.front() != wire.points.back();
    if (source.onCloth || !isKey)
    {
      continue;
    }
    const Points2 line = positionsOf(source, wire.points);
    const Point2 chord = line.back() - line.front();
    if (farthestFromChord(line) <= straightness * chord.norm())
    {
      return chord.normalized();
    }
  }
  return source.onCloth ? upright : upOf(source, piece, axis).value_or(upright);
}

bool hasStraightKey(const PatternPiece& piece)
{
  return straightKey(piece) != nullptr;
}

void drawGrainline(const Segments& boundary, bool onCloth, bool stands, PatternPiece& piece)
{
  double room = 0.0;
  Point2 anchor = widestPlace(boundary, {}, room);
  Point2 direction(0.0, 1.0);
  double length = std::numeric_limits<double>::infinity();
  const PatternLine* const key = onCloth ? nullptr : straightKey(piece);
  if (!onCloth && !key)
  {
    warnOfBentKeys(piece);
  }
  piece.grain.known = key || onCloth || stands;
  if (key)
  {
    const Point2 chord = key->points.back() - key->points.front();
    direction = chord.normalized();
    length = 0.8 * chord.norm();
    // A key curve on the border leaves no place for an arrow: it moves inwards, in parallel.
    const Point2 middle = (key->points.front() + key->points.back()) / 2.0;
    if (inside(middle, boundary) && distance(middle, boundary) > 0.2 * room)
    {
      anchor = middle;
    }
  }
  double low = -0.4 * room;
  double high = 0.4 * room;
  const std::vector<double> borders = crossings(anchor, direction, boundary);
  for (std::size_t k = 0; k + 1 < borders.size(); ++k)
  {
    if (borders[k] < 0.0 && borders[k + 1] > 0.0)
    {
      const double margin = 0.1 * (borders[k + 1] - borders[k]);
      low = borders[k] + margin;
      high = borders[k + 1] - margin;
    }
  }
  piece.grain.from = anchor + std::max(low, -length / 2.0) * direction;
  piece.grain.to = anchor + std::min(high, length / 2.0) * direction;
}

std::vector<std::array<Point2, 3>> arrowHeads(const Grainline& grain)
{
  std::vector<std::array<Point2, 3>> heads;
  const double length = (grain.to - grain.from).norm();
  if (length == 0.0)
  {
    return heads;
  }
  const double head = std::min(longestHead, headOfShort * length);
  const Point2 unit = (grain.to - grain.from) / length;
  const Point2 side(-unit.y(), unit.x());
  const auto add = [&](const Point2& tip, double direction) {
    const Point2 back = tip - direction * head * unit;
    heads.push_back({ back + widthOfHead * head * side, tip, back - widthOfHead * head * side });
  };
  add(grain.to, 1.0);
  if (!grain.known)
  {
    add(grain.from, -1.0);
  }
  return heads;
}
}
