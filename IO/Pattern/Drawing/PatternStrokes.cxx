// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PatternStrokes.h"

#include "Base/Utf8.h"
#include "Outlines/Grainlines.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <string_view>

namespace flattening::pattern
{
namespace
{
constexpr Color black{ 0.0, 0.0, 0.0 };
constexpr Color red{ 0.8, 0.0, 0.0 };
constexpr Color green{ 0.0, 0.5, 0.1 };
constexpr Color blue{ 0.0, 0.2, 0.8 };

struct Look
{
  StrokeStyle onPaper;
  Color laser;
};

/// In the order of LineKind.
const std::array<Look, 12> looks{ {
  { { "cut-line", black, 0.5, {} }, { 1.0, 0.0, 0.0 } },
  { { "cut-out", black, 0.5, {} }, { 1.0, 0.5, 0.0 } },
  { { "sew-line", black, 0.25, { 4.0, 2.0 } }, { 0.0, 0.0, 1.0 } },
  { { "dart-leg", blue, 0.3, { 4.0, 2.0 } }, { 0.0, 0.5, 1.0 } },
  { { "dart-fold", blue, 0.25, { 1.0, 1.5 } }, { 0.5, 0.0, 1.0 } },
  { { "fold", black, 0.35, { 12.0, 2.0, 2.0, 2.0 } }, { 0.5, 0.5, 0.5 } },
  { { "key-curve", red, 0.25, { 8.0, 1.5, 1.0, 1.5 } }, { 1.0, 0.0, 1.0 } },
  { { "internal", green, 0.25, {} }, { 0.5, 0.5, 0.0 } },
  { { "notch", black, 0.4, {} }, { 0.0, 1.0, 0.0 } },
  { { "dart-mark", black, 0.4, {} }, { 0.0, 0.5, 0.0 } },
  { { "drill-hole", black, 0.25, {} }, { 0.0, 1.0, 1.0 } },
  { { "grain", black, 0.35, {} }, { 0.0, 0.0, 0.0 } },
} };

void addGrain(const PatternPiece& piece, std::vector<Stroke>& strokes)
{
  const auto add = [&strokes](const Points2& points) {
    Stroke stroke;
    stroke.role = LineKind::Grain;
    stroke.closed = stroke.filled = points.size() > 2;
    stroke.points = points;
    strokes.push_back(std::move(stroke));
  };
  if (piece.grain.from != piece.grain.to)
  {
    add({ piece.grain.from, piece.grain.to });
  }
  for (const std::array<Point2, 3>& head : arrowHeads(piece.grain))
  {
    add({ head.begin(), head.end() });
  }
}
}

StrokeStyle styleOf(LineKind role)
{
  return looks.at(static_cast<std::size_t>(role)).onPaper;
}

Color laserColor(LineKind role)
{
  return looks.at(static_cast<std::size_t>(role)).laser;
}

std::vector<Stroke> strokesOf(const PatternPiece& piece)
{
  std::vector<Stroke> strokes;
  for (const PatternLine& line : piece.lines)
  {
    Stroke stroke;
    stroke.role = line.kind;
    stroke.closed = line.closed;
    stroke.points = line.points;
    stroke.smooth = line.curve;
    stroke.curve = line.name;
    stroke.measure = line.restLength;
    strokes.push_back(std::move(stroke));
  }
  for (const Notch& notch : piece.notches)
  {
    Stroke stroke;
    stroke.role = notch.onCutLine ? LineKind::Notch : LineKind::DartMark;
    stroke.points = { notch.from, notch.to };
    stroke.curve = notch.name;
    stroke.measure = notch.arcLength;
    strokes.push_back(std::move(stroke));
  }
  const double arm = std::min(3.0, 0.03 * piece.extent.maxCoeff());
  for (const Point2& hole : piece.drillHoles)
  {
    for (const Point2& way : { Point2(arm, 0.0), Point2(0.0, arm) })
    {
      Stroke stroke;
      stroke.role = LineKind::DrillHole;
      stroke.points = { hole - way, hole + way };
      strokes.push_back(std::move(stroke));
    }
  }
  addGrain(piece, strokes);
  std::stable_sort(strokes.begin(), strokes.end(),
    [](const Stroke& a, const Stroke& b) { return a.role < b.role; });
  return strokes;
}

std::string fitText(const std::string& text, double height, double width)
{
  if (textWidth(text, height) <= width)
  {
    return text;
  }
  const std::string dots = "...";
  const double room = width / textWidth(".", height) - static_cast<double>(dots.size());
  std::string_view rest(text);
  for (double characters = 1.0; characters <= room && !rest.empty(); characters += 1.0)
  {
    takeCharacter(rest);
  }
  return text.substr(0, text.size() - rest.size()) + dots;
}
}
