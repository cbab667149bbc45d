// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PieceFold.h"

#include "Fairing/FairBorders.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace flattening::pattern
{
namespace
{
constexpr double onAxis = 1e-7; // mm
constexpr int probes = 16;      // of a Bezier curve, between which it crosses the axis once at most

double rightOf(const MirrorAxis& axis, const Point2& p)
{
  return -cross(axis.along, p - axis.at);
}

Point2 ontoAxis(const MirrorAxis& axis, const Point2& p)
{
  return axis.at + axis.along.dot(p - axis.at) * axis.along;
}

/// A line without its form.
PatternLine namesake(const PatternLine& line)
{
  PatternLine part;
  part.kind = line.kind;
  part.name = line.name;
  return part;
}

/// Where a Bezier curve crosses the axis, between its ends and these included.
std::vector<double> stopsOf(const FairSpan& span, const MirrorAxis& axis)
{
  std::vector<double> stops{ span.from };
  const auto place = [&span](int k) { return span.from + (span.to - span.from) * k / probes; };
  for (int k = 0; k < probes; ++k)
  {
    double low = place(k);
    double high = place(k + 1);
    const bool right = rightOf(axis, span.at(low)) > 0.0;
    if ((rightOf(axis, span.at(high)) > 0.0) == right)
    {
      continue;
    }
    for (int step = 0; step < 60; ++step)
    {
      const double middle = (low + high) / 2.0;
      ((rightOf(axis, span.at(middle)) > 0.0) == right ? low : high) = middle;
    }
    stops.push_back((low + high) / 2.0);
  }
  stops.push_back(span.to);
  return stops;
}

/// The parts of an open line on the right.
std::vector<PatternLine> rightParts(const PatternLine& line, const MirrorAxis& axis)
{
  std::vector<FairSpan> curve = line.curve;
  for (std::size_t k = 0; line.curve.empty() && k + 1 < line.points.size(); ++k)
  {
    const Point2 third = (line.points[k + 1] - line.points[k]) / 3.0;
    curve.push_back({ 0.0, 1.0,
      { line.points[k], line.points[k] + third, line.points[k + 1] - third, line.points[k + 1] } });
  }
  std::vector<PatternLine> parts;
  bool going = false;
  for (const FairSpan& span : curve)
  {
    const std::vector<double> stops = stopsOf(span, axis);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k)
    {
      const double middle = (stops[k] + stops[k + 1]) / 2.0;
      if (stops[k] == stops[k + 1])
      {
        continue;
      }
      const FairSpan part = partOf(span, stops[k], stops[k + 1]);
      if (part.length() < onAxis)
      {
        continue;
      }
      const bool right = rightOf(axis, span.at(middle)) >= -onAxis;
      if (right && !going)
      {
        parts.push_back(namesake(line));
      }
      going = right;
      if (right)
      {
        parts.back().curve.push_back(part);
      }
    }
  }
  for (PatternLine& part : parts)
  {
    part.points = sampled(part.curve);
    if (line.curve.empty())
    {
      part.curve.clear();
    }
  }
  return parts;
}

/// What goes on over the first point of a line that was closed is one part.
void joinEnds(std::vector<PatternLine>& parts)
{
  if (parts.size() < 2 || parts.front().points.front() != parts.back().points.back())
  {
    return;
  }
  PatternLine& last = parts.back();
  PatternLine& first = parts.front();
  last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
  last.curve.insert(last.curve.end(), first.curve.begin(), first.curve.end());
  first = std::move(last);
  parts.pop_back();
}

std::vector<PatternLine> halfOf(PatternLine line, const MirrorAxis& axis)
{
  double most = 0.0;
  for (const Point2& p : line.points)
  {
    most = std::max(most, std::abs(rightOf(axis, p)));
  }
  if (most <= mirrorTolerance)
  {
    forEachPoint(line, [&axis](Point2& p) { p = ontoAxis(axis, p); });
    return { std::move(line) };
  }
  if (!isWire(line.kind) && line.closed)
  {
    line.curve.clear();
    line.points = rightHalf(line.points, axis);
    return line.points.size() > 2 ? std::vector<PatternLine>{ std::move(line) }
                                  : std::vector<PatternLine>();
  }
  if (line.closed)
  {
    line.points.push_back(line.points.front());
  }
  const double length = lengthOf(line);
  std::vector<PatternLine> parts = rightParts(line, axis);
  if (line.closed)
  {
    joinEnds(parts);
  }
  eraseIf(parts, [](const PatternLine& part) { return lengthOf(part) < onAxis; });
  for (PatternLine& part : parts)
  {
    part.restLength = line.restLength * lengthOf(part) / length;
    if (part.points.front() == part.points.back())
    {
      part.closed = true;
      part.points.pop_back();
    }
  }
  return parts;
}

const Point2& farthestFrom(const Point2& place, const Points2& points)
{
  return *std::max_element(
    points.begin(), points.end(), [&place](const Point2& a, const Point2& b) {
      return (a - place).squaredNorm() < (b - place).squaredNorm();
    });
}

/// About which a shape is symmetric; of an outline that is drawn as its own mirror image as that
/// is.
std::optional<MirrorAxis> symmetryAxis(
  const DrawingSource& all, std::size_t piece, const PieceShape& shape)
{
  std::optional<MirrorAxis> axis = findMirrorAxis(shape, mirrorTolerance);
  if (axis && all.fair && all.fair->reports()[piece].mirror)
  {
    axis = all.fair->reports()[piece].mirror;
    axis->miss = mirrorMiss(shape, *axis);
  }
  return axis;
}
}

Status findFold(const DrawingSource& all, std::size_t piece, const std::string& pieceName,
  const PieceShape& shape, std::optional<PieceFold>& fold)
{
  fold.reset();
  const PatternOptions& options = all.options;
  const auto refused = [&pieceName](const std::string& curve, const std::string& why) {
    return Status{ StatusCode::InvalidOption,
      "piece " + pieceName + " cannot be cut on the fold along " + curve + ", " + why, {},
      { { Remedy::Give, "a straight curve about which the piece is symmetric" } } };
  };
  const SourceWire* named = nullptr;
  Points2 points;
  bool isBorder = true;
  for (const SourceWire& wire : all.source.wires)
  {
    if (wire.piece != static_cast<Index>(piece) || options.foldsAlong.count(wire.name) == 0)
    {
      continue;
    }
    if (wire.type == WireType::Seam || wire.type == WireType::Dart)
    {
      return refused(wire.name, "which is sewn");
    }
    if (named && named->name != wire.name)
    {
      return refused(wire.name, "since it is folded along " + named->name);
    }
    named = &wire;
    const Points2 line = all.at(wire.points);
    points.insert(points.end(), line.begin(), line.end());
    isBorder = isBorder && areOnBorder(all.border, wire.points);
  }
  if (!named)
  {
    const std::optional<MirrorAxis> axis =
      options.cutOnFold && !options.oneLayer ? symmetryAxis(all, piece, shape) : std::nullopt;
    if (axis)
    {
      fold = PieceFold{ *axis, false };
    }
    return {};
  }
  const Point2 from = farthestFrom(points.front(), points);
  const Point2 way = farthestFrom(from, points) - from;
  MirrorAxis axis{ from, (way.y() < 0.0 ? -1.0 : 1.0) * way.normalized(), 0.0 };
  double bend = 0.0;
  for (const Point2& p : points)
  {
    bend = std::max(bend, std::abs(rightOf(axis, p)));
  }
  const std::string limit = " mm, more than " + formatNumber(mirrorTolerance, 1) + " mm";
  if (bend > mirrorTolerance)
  {
    return refused(named->name, "which bends by " + formatNumber(bend, 1) + limit);
  }
  if (options.oneLayer) // drawn whole
  {
    return isBorder
      ? refused(named->name, "since the cloth of a lay is one layer and the piece is a half")
      : Status();
  }
  if (!isBorder)
  {
    axis.miss = mirrorMiss(shape, axis);
    if (axis.miss > mirrorTolerance)
    {
      return refused(named->name,
        "about which it is not symmetric: mirrored it misses itself by " +
          formatNumber(axis.miss, 1) + limit);
    }
  }
  fold = PieceFold{ axis, isBorder };
  return {};
}

Points2 rightHalf(const Points2& polygon, const MirrorAxis& axis)
{
  // I. E. Sutherland, G. W. Hodgman, Communications of the ACM 17(1), 1974.
  Points2 half;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Point2& a = polygon[k];
    const Point2& b = polygon[(k + 1) % polygon.size()];
    const double atA = rightOf(axis, a);
    const double atB = rightOf(axis, b);
    if (atA >= 0.0)
    {
      half.push_back(a);
    }
    if ((atA > 0.0 && atB < 0.0) || (atA < 0.0 && atB > 0.0))
    {
      half.emplace_back(a + atA / (atA - atB) * (b - a));
    }
  }
  return half;
}

std::vector<JoinSide> rightHalf(const std::vector<JoinSide>& sides, const MirrorAxis& axis)
{
  const auto middleOf = [](const JoinSide& side) {
    const Point2 sum = std::accumulate(side.line.begin(), side.line.end(), Point2(Point2::Zero()));
    return Point2(sum / static_cast<double>(side.line.size()));
  };
  std::vector<JoinSide> half;
  for (const JoinSide& side : sides)
  {
    PatternLine line;
    line.points = side.line;
    std::vector<PatternLine> parts = rightParts(line, axis);
    const auto longest = std::max_element(parts.begin(), parts.end(),
      [](const PatternLine& a, const PatternLine& b) { return lengthOf(a) < lengthOf(b); });
    if (longest == parts.end() || lengthOf(*longest) < 2.0 * mirrorTolerance)
    {
      continue;
    }
    const auto other =
      std::min_element(sides.begin(), sides.end(), [&](const JoinSide& a, const JoinSide& b) {
        const Point2 image = imageOf(middleOf(side), axis);
        return (middleOf(a) - image).norm() < (middleOf(b) - image).norm();
      });
    const auto [first, second] =
      std::minmax(side.mark, other->mark, [](const std::string& a, const std::string& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
      });
    JoinSide& own = half.emplace_back();
    own.mark = first;
    if (first != second)
    {
      own.mark.append("/").append(second);
    }
    own.line = longest->points;
  }
  return half;
}

PatternLine foldLine(const std::vector<PatternLine>& lines, const MirrorAxis& axis)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PatternLine& line : lines)
  {
    for (const Point2& p : line.points)
    {
      if (line.kind == LineKind::CutLine && std::abs(rightOf(axis, p)) < 1e-3)
      {
        const double along = axis.along.dot(p - axis.at);
        low = std::min(low, along);
        high = std::max(high, along);
      }
    }
  }
  PatternLine fold;
  fold.kind = LineKind::Fold;
  fold.name = "cut on fold";
  fold.points = { axis.at + low * axis.along, axis.at + high * axis.along };
  return fold;
}

void keepRightHalf(const MirrorAxis& axis, PatternPiece& piece)
{
  std::vector<PatternLine> lines;
  for (PatternLine& line : piece.lines)
  {
    for (PatternLine& part : halfOf(std::move(line), axis))
    {
      lines.push_back(std::move(part));
    }
  }
  lines.push_back(foldLine(lines, axis));
  piece.lines = std::move(lines);
  const auto keepRight = [&axis](auto& marks, double tolerance, const auto& placeOf) {
    eraseIf(marks, [&](const auto& mark) { return rightOf(axis, placeOf(mark)) < -tolerance; });
  };
  keepRight(piece.notches, onAxis, [](const Notch& notch) { return notch.foot; });
  keepRight(piece.gradePoints, mirrorTolerance, [](const GradePoint& p) { return p.place; });
  keepRight(piece.drillHoles, mirrorTolerance, [](const Point2& p) { return p; });
}
}
