// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PatternBuilder.h"

#include "Drawing/PieceDrawing.h"
#include "Fairing/FairBorders.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening::pattern
{
namespace
{
template <typename Value>
std::set<std::string> namesIn(const std::map<std::string, Value>& ofCurve)
{
  std::set<std::string> names;
  for (const auto& entry : ofCurve)
  {
    names.insert(entry.first);
  }
  return names;
}

/// Curves that an option names.
struct NamedCurves
{
  std::set<std::string> names;
  const char* what;   ///< names them
  bool sides = false; ///< "NAME:2" is what is of the curve in the second piece
};

/// Pieces are known once a surface is flat.
bool hasSide(const PatternSource& source, const std::string& name)
{
  const auto [curve, piece] = curveSide(name);
  const auto isSide = [&curve = curve, &piece = piece](const SourceWire& wire) {
    return wire.name == curve && (wire.piece == none || wire.piece == piece);
  };
  return piece != none &&
    (curve == "boundary" || std::any_of(source.wires.begin(), source.wires.end(), isSide));
}

Status checkCurveNames(const PatternSource& source, const NamedCurves& wanted)
{
  std::set<std::string> known{ "boundary" };
  std::string list = "boundary";
  for (const SourceWire& wire : source.wires)
  {
    if (known.insert(wire.name).second && list.size() < 200)
    {
      list.append(", ").append(wire.name);
    }
  }
  for (const std::string& name : wanted.names)
  {
    if (known.count(name) == 0 && !(wanted.sides && hasSide(source, name)))
    {
      std::string message = wanted.what;
      message.append(" names the curve ").append(name);
      message.append(", which is not there; there are ").append(list);
      return { StatusCode::InvalidOption, message };
    }
  }
  return {};
}

Status checkSource(const PatternSource& source)
{
  if (source.triangles.empty())
  {
    return { StatusCode::NothingToDraw,
      "there is no piece to draw: the flat surface has no triangles", {},
      { Remedy::ReadTheFlattening } };
  }
  for (std::size_t v = 0; v < source.positions.size(); ++v)
  {
    if (!isFinite(source.positions[v]))
    {
      return invalidPieces("point " + std::to_string(v) + " of the flat surface is not finite");
    }
  }
  std::vector<double> area;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    const Index piece = source.pieceOfTriangle[t];
    if (piece < 0 || static_cast<std::size_t>(piece) >= source.triangles.size())
    {
      return invalidPieces("the PieceId of cell " + std::to_string(t) + " is " +
        std::to_string(piece) + ", and pieces are counted from 0");
    }
    area.resize(std::max(area.size(), static_cast<std::size_t>(piece) + 1), 0.0);
    area[static_cast<std::size_t>(piece)] += cross(source.positions, source.triangles[t]);
  }
  const std::size_t pieces = area.size();
  for (const SourceWire& wire : source.wires)
  {
    if (wire.piece >= static_cast<Index>(pieces))
    {
      return invalidPieces("the PieceId of a wire is " + std::to_string(wire.piece) +
        ", and there are " + std::to_string(pieces) + " pieces");
    }
  }
  for (std::size_t p = 0; p < pieces; ++p)
  {
    if (!(area[p] > 0.0))
    {
      return { StatusCode::NothingToDraw,
        "piece " + std::to_string(p + 1) + " of " + std::to_string(pieces) +
          " has no area, or is turned over: its triangles must be counter-clockwise",
        {}, { Remedy::GiveFlatPieces } };
    }
  }
  return {};
}

std::string pieceName(
  const PatternSource& source, const PatternOptions& options, std::size_t piece, std::size_t pieces)
{
  if (piece < options.pieceNames.size() && !options.pieceNames[piece].empty())
  {
    return cleanText(options.pieceNames[piece]);
  }
  if (piece < source.garment.panels.size())
  {
    return cleanText(source.garment.panels[piece].name);
  }
  if (piece < source.pieceNames.size() && !source.pieceNames[piece].empty())
  {
    const std::vector<std::string>& names = source.pieceNames;
    const auto last = names.begin() + static_cast<std::ptrdiff_t>(piece);
    const auto before = std::count(names.begin(), last, *last);
    const bool several = std::count(names.begin(), names.end(), *last) > 1;
    return cleanText(*last) + (several ? " " + std::to_string(before + 1) : "");
  }
  return cleanText(options.name) + (pieces > 1 ? " " + std::to_string(piece + 1) : "");
}

std::vector<PieceShape> shapesOf(const DrawingSource& all)
{
  std::vector<PieceShape> shapes(all.loops.size());
  for (std::size_t p = 0; p < shapes.size(); ++p)
  {
    shapes[p].outline = all.at(all.loops[p].front());
  }
  for (const SourceWire& wire : all.source.wires)
  {
    if (wire.piece != none)
    {
      shapes[static_cast<std::size_t>(wire.piece)].lines.push_back(all.at(wire.points));
    }
  }
  return shapes;
}

/// About a sixth of the largest piece, as 1, 2 or 5 times a power of ten, in mm.
double notchSpacingOf(const PatternSource& source, double scale)
{
  std::vector<Eigen::AlignedBox2d> boxes;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    const std::size_t piece = static_cast<std::size_t>(source.pieceOfTriangle[t]);
    boxes.resize(std::max(boxes.size(), piece + 1));
    for (const Index v : source.triangles[t])
    {
      boxes[piece].extend(source.positions[v]);
    }
  }
  double largest = 0.0;
  for (const Eigen::AlignedBox2d& box : boxes)
  {
    largest = box.isEmpty() ? largest : std::max(largest, box.sizes().maxCoeff());
  }
  const double wanted = largest * scale / 6.0;
  if (!(wanted > 0.0) || !std::isfinite(wanted))
  {
    return 100.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double first = wanted / power;
  return power *
    (first < std::sqrt(2.0)       ? 1.0
        : first < std::sqrt(10.0) ? 2.0
        : first < std::sqrt(50.0) ? 5.0
                                  : 10.0);
}

std::string plural(int count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}
}

std::set<std::string> curvesWithOptions(const PatternOptions& options)
{
  std::set<std::string> names = options.doubleNotches;
  names.insert(options.foldsAlong.begin(), options.foldsAlong.end());
  names.merge(namesIn(options.allowanceOfCurve));
  names.merge(namesIn(options.dartTipOfCurve));
  names.merge(namesIn(options.fairToleranceOfCurve));
  names.merge(namesIn(options.notchesOfCurve));
  return names;
}

Status checkPatternOptions(const PatternSource& source, const PatternOptions& options)
{
  if (options.symmetrize && !options.isFair(source))
  {
    return { StatusCode::InvalidOption,
      "outlines are made their own mirror images as smooth borders alone, and none is to be smooth",
      {}, { { Remedy::Give, "a tolerance of smooth borders above 0 mm" } } };
  }
  const NamedCurves all[] = {
    { namesIn(options.allowanceOfCurve), "a seam allowance", true },
    { namesIn(options.fairToleranceOfCurve), "a tolerance of smooth borders" },
    { namesIn(options.dartTipOfCurve), "a tip to be drawn back" },
    { options.foldsAlong, "a fold" },
    { options.doubleNotches, "a double notch" },
    { namesIn(options.notchesOfCurve), "a notch" },
  };
  for (const NamedCurves& named : all)
  {
    if (Status status = checkCurveNames(source, named); !status.ok())
    {
      return status;
    }
  }
  return {};
}

bool isWire(LineKind kind)
{
  return kind == LineKind::SewLine || kind == LineKind::DartLeg || kind == LineKind::KeyCurve ||
    kind == LineKind::Internal;
}

bool isCut(LineKind kind)
{
  return kind == LineKind::CutLine || kind == LineKind::CutOut;
}

double lengthOf(const PatternLine& line)
{
  return line.curve.empty() ? polylineLength(line.points) : curveLength(line.curve);
}

Box boxOf(const PatternPiece& piece)
{
  Box box;
  for (const PatternLine& line : piece.lines)
  {
    box.extend(boxOf(line.points));
  }
  return box;
}

Status prepareDrawing(const PatternSource& source, const PatternOptions& given, FairCache* cache,
  std::optional<DrawingSource>& all)
{
  Status status = checkSource(source);
  if (!status.ok())
  {
    return status;
  }
  PatternOptions options = given;
  options.allowance = options.allowance < 0.0 ? usualAllowance(source.isSheet) : options.allowance;
  options.notchSpacing = options.notchSpacing < 0.0
    ? notchSpacingOf(source, millimetresPer(options.unit))
    : options.notchSpacing;
  status = checkPatternOptions(source, options);
  const std::size_t pieces = pieceCount(source);
  for (std::size_t p = pieces; status.ok() && p < options.pieceQuantities.size(); ++p)
  {
    if (options.pieceQuantities[p] > 0)
    {
      status = { StatusCode::InvalidOption,
        "there is a quantity for piece " + std::to_string(p + 1) + ", and there are " +
          plural(static_cast<int>(pieces), "piece") };
    }
  }
  if (status.ok())
  {
    all.emplace(source, options);
    status = findBorders(*all);
  }
  if (status.ok() && all->options.isFair(all->source))
  {
    all->fair = cache ? cache->of(*all) : std::make_shared<const FairBorders>(*all);
    all->moved = &all->fair->positions();
  }
  return status;
}

Status buildPattern(const DrawingSource& all, Pattern& pattern)
{
  const PatternSource& source = all.source;
  const PatternOptions& options = all.options;
  const std::size_t pieces = all.loops.size();
  Status status;
  const std::vector<BorderMark> marks = findBorderMarks(all);

  pattern.name = cleanText(options.name);
  pattern.unit = options.unit;
  pattern.isSheet = source.isSheet;
  const std::vector<PieceShape> shapes = shapesOf(all);
  const std::vector<std::size_t> mirrored = findMirrorPairs(shapes, mirrorTolerance);
  pattern.pieces.clear();
  pattern.names.clear();
  for (std::size_t p = 0; p < pieces; ++p)
  {
    pattern.names.push_back(pieceName(source, options, p, pieces));
  }
  for (std::size_t p = 0; p < pieces && status.ok(); ++p)
  {
    const std::size_t second =
      static_cast<std::size_t>(std::find(mirrored.begin(), mirrored.end(), p) - mirrored.begin());
    const bool isSecond = mirrored[p] != noPair;
    const bool forBoth = options.pairs && second < pieces;
    if (options.pairs && isSecond)
    {
      continue;
    }
    PatternPiece& piece = pattern.pieces.emplace_back();
    piece.name = pattern.names[p];
    piece.size = cleanText(options.size);
    const bool own = p < options.pieceQuantities.size() && options.pieceQuantities[p] > 0;
    piece.quantity = own ? options.pieceQuantities[p] : options.quantity;
    piece.number = static_cast<int>(p) + 1;
    const auto addLabel = [&piece](const std::string& text) {
      piece.texts.push_back({ TextRole::Label, text });
    };
    piece.texts.push_back({ TextRole::Title, piece.name });
    std::optional<PieceFold> fold;
    status = findFold(all, p, piece.name, shapes[p], fold);
    if (!status.ok())
    {
      break;
    }
    const std::string onFold = fold ? " on fold" : "";
    if (!piece.size.empty())
    {
      addLabel("size " + piece.size);
    }
    if (forBoth)
    {
      addLabel("cut " + plural(piece.quantity, "pair") + onFold + ", one of each turned over");
      piece.turnedOver = piece.quantity;
      piece.quantity *= 2;
    }
    else
    {
      addLabel("cut " + std::to_string(piece.quantity) + onFold);
      if (isSecond || second < pieces)
      {
        const std::size_t other = isSecond ? mirrored[p] : second;
        addLabel("mirror image of piece " + std::to_string(other + 1));
      }
    }
    if (all.fair && all.fair->reports()[p].mirror)
    {
      addLabel("drawn as its own mirror image");
    }
    const auto addCompensation = [&addLabel](double percent, const char* along) {
      if (percent != 0.0)
      {
        addLabel((percent > 0.0 ? "drawn longer by " : "drawn shorter by ") +
          formatNumber(std::abs(percent), 2) + " % along the " + along);
      }
    };
    addCompensation(options.warpCompensation, "warp");
    addCompensation(options.weftCompensation, "weft");
    addLabel("piece " + std::to_string(piece.number) + " of " + std::to_string(pieces));
    status = drawPiece(all, p, forBoth ? std::optional(second) : std::nullopt, marks, fold, piece);
    if (fold && !fold->isBorder)
    {
      piece.addNote("a half, to be cut on the fold; the halves differed by " +
        formatNumber(fold->axis.miss, 2) + " mm");
    }
    else if (!fold && options.cutOnFold && !options.oneLayer)
    {
      piece.addNote(
        "not symmetric to " + formatNumber(mirrorTolerance, 1) + " mm, and so drawn whole");
    }
    if (all.fair)
    {
      addFairNotes(all.fair->reports()[p], piece);
    }
  }
  return status;
}
}
