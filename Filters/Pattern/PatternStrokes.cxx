// SPDX-License-Identifier: BSD-3-Clause
#include "PatternStrokes.h"

#include "PatternText.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr std::array<double, 3> black{ 0.0, 0.0, 0.0 };
constexpr std::array<double, 3> red{ 0.8, 0.0, 0.0 };
constexpr std::array<double, 3> green{ 0.0, 0.5, 0.1 };
constexpr std::array<double, 3> blue{ 0.0, 0.2, 0.8 };

StrokeStyle styleOf(LineKind kind)
{
  switch (kind)
  {
    case LineKind::CutLine:
      return { "cut-line", black, 0.5, {} };
    case LineKind::CutOut:
      return { "cut-out", black, 0.5, {} };
    case LineKind::SewLine:
      return { "sew-line", black, 0.25, { 4.0, 2.0 } };
    case LineKind::DartLeg:
      return { "dart-leg", blue, 0.3, { 4.0, 2.0 } };
    case LineKind::DartFold:
      return { "dart-fold", blue, 0.25, { 1.0, 1.5 } };
    case LineKind::KeyCurve:
      return { "key-curve", red, 0.25, { 8.0, 1.5, 1.0, 1.5 } };
    default:
      return { "internal", green, 0.25, {} };
  }
}

void addGrain(const PatternPiece& piece, std::vector<Stroke>& strokes)
{
  const Point2 along = piece.grain.to - piece.grain.from;
  const double length = along.norm();
  if (length == 0.0)
  {
    return;
  }
  const double head = std::min(5.0, 0.15 * length);
  const Point2 unit = along / length;
  const Point2 side(-unit.y(), unit.x());
  const auto add = [&strokes](const Points2& points) {
    Stroke stroke;
    stroke.style = { "grain", black, 0.35, {} };
    stroke.points = points;
    strokes.push_back(std::move(stroke));
  };
  const auto addHead = [&](const Point2& tip, double direction) {
    const Point2 back = tip - direction * head * unit;
    add({ back + 0.4 * head * side, tip, back - 0.4 * head * side });
  };
  add({ piece.grain.from, piece.grain.to });
  addHead(piece.grain.to, 1.0);
  if (!piece.grain.fromKeyCurve)
  {
    addHead(piece.grain.from, -1.0);
  }
}
}

std::vector<Stroke> strokesOf(const PatternPiece& piece)
{
  std::vector<Stroke> strokes;
  for (const PatternLine& line : piece.lines)
  {
    Stroke stroke;
    stroke.style = styleOf(line.kind);
    stroke.closed = line.closed;
    stroke.points = line.points;
    stroke.curve = line.name;
    stroke.measure = line.restLength;
    stroke.isWire = isWire(line.kind);
    strokes.push_back(std::move(stroke));
  }
  for (const Notch& notch : piece.notches)
  {
    Stroke stroke;
    stroke.style = { notch.onCutLine ? "notch" : "dart-mark", black, 0.4, {} };
    stroke.points = { notch.from, notch.to };
    stroke.curve = notch.name;
    stroke.measure = notch.arcLength;
    stroke.isNotch = true;
    strokes.push_back(std::move(stroke));
  }
  const double arm = std::min(3.0, 0.03 * piece.extent.maxCoeff());
  for (const Point2& hole : piece.drillHoles)
  {
    for (const Point2& way : { Point2(arm, 0.0), Point2(0.0, arm) })
    {
      Stroke stroke;
      stroke.style = { "drill-hole", black, 0.25, {} };
      stroke.points = { hole - way, hole + way };
      strokes.push_back(std::move(stroke));
    }
  }
  addGrain(piece, strokes);
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
  std::size_t end = 0;
  for (double characters = 1.0; characters <= room && end < text.size(); characters += 1.0)
  {
    // The byte that starts a character and those that go on with it.
    do
    {
      ++end;
    } while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u);
  }
  return text.substr(0, end) + dots;
}
}
}
