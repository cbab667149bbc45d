// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/PatternBuilder.h"
#include "Drawing/SeamWalk.h"
#include "Outlines/Outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What tests of drawings share.
namespace drawnpieces
{
using namespace flattening;
using namespace flattening::pattern;

/// Options of patterns whose surfaces are in millimetres, with borders as the mesh has them.
inline PatternOptions inMillimetres(double allowance = 10.0)
{
  PatternOptions options;
  options.unit = Unit::Millimetre;
  options.allowance = allowance;
  options.fairTolerance = 0.0;
  options.notchSpacing = 100.0;
  return options;
}

/// Draws a pattern.
inline Status draw(const PatternSource& source, const PatternOptions& options, Pattern& pattern)
{
  std::optional<DrawingSource> all;
  const Status status = prepareDrawing(source, options, nullptr, all);
  return status.ok() ? buildPattern(*all, pattern) : status;
}

/// Walks the seams of a pattern.
inline Status walk(
  const PatternSource& source, const PatternOptions& options, std::vector<WalkInterval>& intervals)
{
  std::optional<DrawingSource> all;
  const Status status = prepareDrawing(source, options, nullptr, all);
  intervals = status.ok() ? walkSeams(*all) : std::vector<WalkInterval>();
  return status;
}

/// What is drawn, with its pieces; expects that it is.
inline Pattern patternOf(const PatternSource& source, const PatternOptions& options)
{
  Pattern pattern;
  const Status status = draw(source, options, pattern);
  EXPECT_TRUE(status.ok()) << status.message;
  return pattern;
}

/// The first piece of what is drawn.
inline PatternPiece drawn(const PatternSource& source, const PatternOptions& options)
{
  const Pattern pattern = patternOf(source, options);
  return pattern.pieces.empty() ? PatternPiece() : pattern.pieces.front();
}

inline std::vector<PatternLine> linesOf(const PatternPiece& piece, LineKind kind)
{
  std::vector<PatternLine> lines;
  std::copy_if(piece.lines.begin(), piece.lines.end(), std::back_inserter(lines),
    [kind](const PatternLine& line) { return line.kind == kind; });
  return lines;
}

/// The only line of a kind.
inline PatternLine lineOf(const PatternPiece& piece, LineKind kind)
{
  const std::vector<PatternLine> lines = linesOf(piece, kind);
  EXPECT_EQ(lines.size(), 1U);
  return lines.empty() ? PatternLine() : lines.front();
}

inline double areaOf(const Points2& polygon)
{
  return doubleArea(polygon) / 2.0;
}

inline PatternSource onePiece(const Points2& positions, const Triangles& triangles,
  const std::vector<SourceWire>& wires, const std::vector<SewnEdges>& sewn = {})
{
  PatternSource source;
  source.positions = positions;
  source.triangles = triangles;
  source.pieceOfTriangle.assign(triangles.size(), 0);
  source.wires = wires;
  source.sewn = sewn;
  return source;
}

/// A square of 200 with a dart of depth 120 in the middle of its upper side and a mouth of 40, as
/// a fan of triangles around a point below the tip. Unit: millimetre.
inline PatternSource dartedSquare()
{
  // 0..3 corners, 4 and 6 the mouth, 5 the tip, 7 the centre of the fan.
  return onePiece({ { 0.0, 0.0 }, { 200.0, 0.0 }, { 200.0, 200.0 }, { 0.0, 200.0 },
                    { 120.0, 200.0 }, { 100.0, 80.0 }, { 80.0, 200.0 }, { 100.0, 40.0 } },
    { { 0, 1, 7 }, { 1, 2, 5 }, { 2, 4, 5 }, { 6, 3, 5 }, { 3, 0, 5 }, { 1, 5, 7 }, { 5, 0, 7 } },
    { { { 4, 2, 1, 0, 3, 6 }, WireType::Boundary, none, 0, "boundary" },
      { { 4, 5 }, WireType::Dart, 0, 0, "dart" }, { { 6, 5 }, WireType::Dart, 0, 0, "dart" } },
    { { { 4, 5 }, { 6, 5 } } });
}

/// Whether a text of a piece is this.
inline bool says(const PatternPiece& piece, const std::string& words)
{
  return std::any_of(piece.texts.begin(), piece.texts.end(),
    [&words](const PatternText& text) { return text.text == words; });
}

/// Expects that a pattern is refused with all of some words.
inline void expectRefusal(
  const PatternSource& source, const PatternOptions& options, const std::vector<std::string>& words)
{
  Pattern pattern;
  const Status status = draw(source, options, pattern);
  EXPECT_EQ(status.code, StatusCode::InvalidOption);
  for (const std::string& word : words)
  {
    EXPECT_NE(status.message.find(word), std::string::npos) << word << ": " << status.message;
  }
}

/// A piece of this extent.
inline PatternPiece rectangle(const Point2& extent)
{
  PatternPiece piece;
  piece.name = "rectangle";
  piece.extent = extent;
  PatternLine line;
  line.kind = LineKind::CutLine;
  line.closed = true;
  line.points = { { 0.0, 0.0 }, { extent.x(), 0.0 }, extent, { 0.0, extent.y() } };
  piece.lines.push_back(line);
  return piece;
}
}
