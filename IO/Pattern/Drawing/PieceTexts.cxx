// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PieceTexts.h"

#include "Drawing/CurveNames.h"
#include "Drawing/PatternStrokes.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double largestTitle = 8.0;
constexpr double longestName = 80.0; // letters, where the piece has no room for more

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
    // Nobody reads more, and a page with tens of thousands of letters takes seconds.
    text.text = fitText(
      text.text, text.height, std::max(2.0 * room, longestName * textWidth(".", text.height)));
    text.position = { center.x(), y - text.height / 2.0 };
    y -= lineFeed * text.height;
  }
}
}

void placeTexts(const Segments& boundary, PatternPiece& piece)
{
  placeTitle(boundary, piece);
  placeCurveNames(boundary, piece);
}
}
}
