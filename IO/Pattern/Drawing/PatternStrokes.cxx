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
    strokes.push_back(
      { line.kind, line.closed, false, line.points, line.curve, line.name, line.restLength });
  }
  for (const Notch& notch : piece.notches)
  {
    strokes.push_back({ notch.onCutLine ? LineKind::Notch : LineKind::DartMark, false, false,
      { notch.from, notch.to }, {}, notch.name, notch.arcLength });
  }
  const double arm = std::min(3.0, 0.03 * piece.extent.maxCoeff());
  for (const Point2& hole : piece.drillHoles)
  {
    for (const Point2& way : { Point2(arm, 0.0), Point2(0.0, arm) })
    {
      strokes.push_back({ LineKind::DrillHole, false, false, { hole - way, hole + way } });
    }
  }
  if (piece.grain.from != piece.grain.to)
  {
    strokes.push_back({ LineKind::Grain, false, false, { piece.grain.from, piece.grain.to } });
  }
  for (const std::array<Point2, 3>& head : arrowHeads(piece.grain))
  {
    strokes.push_back({ LineKind::Grain, true, true, { head.begin(), head.end() } });
  }
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
