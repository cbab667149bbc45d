// SPDX-License-Identifier: BSD-3-Clause
#include "PieceTexts.h"

#include "PatternText.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double largestTitle = 8.0;
constexpr double largestCurveName = 3.0;
constexpr double leastReadable = 1.5;

void placeTitle(const Segments& boundary, PatternPiece& piece)
{
  Segments obstacles{ { piece.grain.from, piece.grain.to } };
  for (const PatternLine& line : piece.lines)
  {
    if (line.kind != LineKind::CutLine && line.kind != LineKind::CutOut)
    {
      addSegments(line.points, line.closed, obstacles);
    }
  }
  double room = 0.0;
  Point2 center = widestPlace(boundary, obstacles, room);

  // A block of lines, the first one larger, that fits a circle of this radius at height 1.
  const double lineFeed = 1.4;
  double width = 0.0;
  double height = -0.4;
  for (std::size_t k = 0; k < piece.texts.size(); ++k)
  {
    const double size = k == 0 ? 1.0 : 0.7;
    width = std::max(width, textWidth(piece.texts[k].text, size));
    height += lineFeed * size;
  }
  const double radius = std::hypot(width, height) / 2.0;
  const double size =
    std::max(std::min(0.9 * room / radius, largestTitle), std::min(2.0, 0.5 * room));
  double y = center.y() + size * height / 2.0;
  for (std::size_t k = 0; k < piece.texts.size(); ++k)
  {
    PatternText& text = piece.texts[k];
    text.height = k == 0 ? size : 0.7 * size;
    text.position = { center.x(), y - text.height / 2.0 };
    y -= lineFeed * text.height;
  }
}

/// The name of a line beside it, on its left or right.
/// \param where fraction of its length
void placeName(const PatternLine& line, double side, double where, std::vector<PatternText>& texts)
{
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
  {
    length += (line.points[k + 1] - line.points[k]).norm();
  }
  const double height = std::min(largestCurveName, 0.5 * length / textWidth(line.name, 1.0));
  if (height < leastReadable)
  {
    return;
  }
  double left = where * length;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
  {
    const Point2 along = line.points[k + 1] - line.points[k];
    const double edge = along.norm();
    if (left > edge || edge == 0.0)
    {
      left -= edge;
      continue;
    }
    const Point2 unit = along / edge;
    PatternText text;
    text.role = TextRole::Curve;
    text.text = line.name;
    text.height = height;
    text.position =
      line.points[k] + left * unit + side * 0.9 * height * Point2(-unit.y(), unit.x());
    // Readable from below or from the right.
    text.angle = std::atan2(unit.y(), unit.x());
    if (text.angle > 0.5 * pi + 1e-6)
    {
      text.angle -= pi;
    }
    else if (text.angle < -0.5 * pi + 1e-6)
    {
      text.angle += pi;
    }
    texts.push_back(std::move(text));
    return;
  }
}

/// 1 where the cloth is on the left of the line's middle, -1 on its right.
double clothSide(const PatternLine& line, const Segments& boundary)
{
  const std::size_t k = (line.points.size() - 1) / 2;
  const Point2 along = line.points[k + 1 < line.points.size() ? k + 1 : k] - line.points[k];
  const Point2 middle = line.points[k] + along / 2.0;
  const Point2 left(-along.y(), along.x());
  return inside(middle + 1e-3 * left, boundary) ? 1.0 : -1.0;
}
}

void placeTexts(const Segments& boundary, PatternPiece& piece)
{
  placeTitle(boundary, piece);
  for (const PatternLine& line : piece.lines)
  {
    if (line.name.empty() || line.points.size() < 2 || line.kind == LineKind::DartLeg)
    {
      continue;
    }
    // Off the middle, where curves like to cross each other and notches are.
    const bool sewn = line.kind == LineKind::SewLine;
    const double where = line.kind == LineKind::DartFold ? 0.55 : sewn ? 0.4 : 0.3;
    placeName(line, sewn ? clothSide(line, boundary) : 1.0, where, piece.texts);
  }
  if (piece.grain.from != piece.grain.to)
  {
    PatternLine arrow;
    arrow.name = piece.grain.fromKeyCurve ? "grain" : "upright";
    arrow.points = { piece.grain.from,
      piece.grain.from + 0.3 * (piece.grain.to - piece.grain.from) };
    placeName(arrow, 1.0, 0.5, piece.texts);
  }
}
}
}
