// SPDX-License-Identifier: BSD-3-Clause
#include "PatternBuilder.h"

#include "ClosedCuts.h"
#include "PatternText.h"
#include "PieceDrawing.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
PatternStatus checkOptions(const PatternSource& source, const PatternOptions& options)
{
  const auto invalid = [](const std::string& message) {
    return PatternStatus{ PatternCode::InvalidOption, message };
  };
  const auto length = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!length(options.allowance))
  {
    return invalid("the seam allowance must be a number of millimetres from 0");
  }
  if (!std::isfinite(options.mitreLimit) || options.mitreLimit < 1.0)
  {
    return invalid("the mitre limit must be a number from 1");
  }
  if (!length(options.notchSpacing) || !length(options.notchLength))
  {
    return invalid("notch spacing and length must be numbers of millimetres from 0");
  }
  if (options.quantity < 1)
  {
    return invalid("the quantity must be a whole number from 1");
  }
  for (const auto& [name, allowance] : options.allowanceOfCurve)
  {
    if (!length(allowance))
    {
      return invalid("the seam allowance of " + name + " must be a number of millimetres from 0");
    }
    const std::string& wanted = name;
    const bool known = wanted == "boundary" ||
      std::any_of(source.wires.begin(), source.wires.end(),
        [&wanted](const SourceWire& wire) { return wire.name == wanted; });
    if (!known)
    {
      std::string names = "boundary";
      for (const SourceWire& wire : source.wires)
      {
        if (wire.type != WireType::Boundary && names.find(wire.name) == std::string::npos &&
          names.size() < 200)
        {
          names += ", " + wire.name;
        }
      }
      return invalid("a seam allowance names the curve " +
        std::string(name).append(", which is not there; there are ").append(names));
    }
  }
  return {};
}

PatternStatus checkSource(const PatternSource& source, std::size_t& pieces)
{
  pieces = 0;
  if (source.triangles.empty())
  {
    return {
      PatternCode::NothingToDraw,
      "there is no piece to draw: the flat surface has no triangles; see what the flattening says"
    };
  }
  for (std::size_t v = 0; v < source.positions.size(); ++v)
  {
    if (!source.positions[v].allFinite())
    {
      return { PatternCode::InvalidInput,
        "point " + std::to_string(v) + " of the flat surface is not finite" };
    }
  }
  std::vector<double> area;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    const Index piece = source.pieceOfTriangle[t];
    if (piece < 0 || static_cast<std::size_t>(piece) >= source.triangles.size())
    {
      return { PatternCode::InvalidInput,
        "the PieceId of cell " + std::to_string(t) + " is " + std::to_string(piece) +
          "; pieces are counted from 0" };
    }
    area.resize(std::max(area.size(), static_cast<std::size_t>(piece) + 1), 0.0);
    const Triangle& corners = source.triangles[t];
    const Point2 a = source.positions[corners[1]] - source.positions[corners[0]];
    const Point2 b = source.positions[corners[2]] - source.positions[corners[0]];
    area[static_cast<std::size_t>(piece)] += a.x() * b.y() - a.y() * b.x();
  }
  pieces = area.size();
  for (std::size_t p = 0; p < pieces; ++p)
  {
    if (!(area[p] > 0.0))
    {
      return { PatternCode::NothingToDraw,
        "piece " + std::to_string(p) +
          " has no area, or is turned over: its triangles must be counter-clockwise" };
    }
  }
  return {};
}

std::string pieceName(const PatternOptions& options, std::size_t piece, std::size_t pieces)
{
  if (piece < options.pieceNames.size() && !options.pieceNames[piece].empty())
  {
    return cleanText(options.pieceNames[piece]);
  }
  return cleanText(options.name) + (pieces > 1 ? " " + std::to_string(piece + 1) : "");
}
}

bool isWire(LineKind kind)
{
  return kind != LineKind::CutLine && kind != LineKind::CutOut && kind != LineKind::DartFold;
}

PatternStatus buildPattern(
  const PatternSource& source, const PatternOptions& options, Pattern& pattern)
{
  std::size_t pieces = 0;
  PatternStatus status = checkSource(source, pieces);
  if (status.ok())
  {
    status = checkOptions(source, options);
  }
  if (!status.ok())
  {
    return status;
  }
  const PatternSource whole = withoutClosedCuts(source);
  DrawingSource all{ whole, options, {}, {}, {}, {} };
  status = findLoops(whole, pieces, all.loops);
  if (!status.ok())
  {
    return status;
  }
  all.partners = sewnPartners(whole);
  all.wires = wiresOfEdges(whole);
  status =
    placeNotches(whole, all.loops, all.partners, options.notchSpacing / all.scale(), all.notches);

  pattern.name = cleanText(options.name);
  pattern.unit = options.unit;
  pattern.pieces.assign(pieces, {});
  for (std::size_t p = 0; p < pieces && status.ok(); ++p)
  {
    PatternPiece& piece = pattern.pieces[p];
    piece.name = pieceName(options, p, pieces);
    piece.size = cleanText(options.size);
    piece.quantity = options.quantity;
    piece.number = static_cast<int>(p) + 1;
    const auto addText = [&piece](TextRole role, const std::string& text) {
      PatternText line;
      line.role = role;
      line.text = text;
      piece.texts.push_back(std::move(line));
    };
    addText(TextRole::Title, piece.name);
    if (!piece.size.empty())
    {
      addText(TextRole::Label, "size " + piece.size);
    }
    addText(TextRole::Label, "cut " + std::to_string(piece.quantity));
    addText(
      TextRole::Label, "piece " + std::to_string(piece.number) + " of " + std::to_string(pieces));
    status = drawPiece(all, p, piece);
  }
  return status;
}
}
}
