// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/NamedFolds.h"

#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
const Point2& farthestFrom(const Point2& place, const Points2& points)
{
  return *std::max_element(
    points.begin(), points.end(), [&place](const Point2& a, const Point2& b) {
      return (a - place).squaredNorm() < (b - place).squaredNorm();
    });
}
}

Status findNamedFold(const DrawingSource& all, std::size_t piece, const std::string& pieceName,
  const PieceShape& shape, std::optional<NamedFold>& fold)
{
  fold.reset();
  Points2 points;
  bool isBorder = true;
  const auto refused = [&pieceName](const std::string& curve, const std::string& why) {
    return Status{ StatusCode::InvalidOption,
      "piece " + pieceName + " cannot be cut on the fold along " + curve + ", " + why, {},
      { { Remedy::Give, "a straight curve about which the piece is symmetric" } } };
  };
  for (const SourceWire& wire : all.source.wires)
  {
    if (wire.piece != static_cast<Index>(piece) || all.options.foldsAlong.count(wire.name) == 0)
    {
      continue;
    }
    if (wire.type == WireType::Seam || wire.type == WireType::Dart)
    {
      return refused(wire.name, "which is sewn");
    }
    if (fold && fold->curve != wire.name)
    {
      return refused(wire.name, "since it is folded along " + fold->curve);
    }
    fold.emplace();
    fold->curve = wire.name;
    const Points2 line = all.at(wire.points);
    points.insert(points.end(), line.begin(), line.end());
    isBorder = isBorder && areOnBorder(all.border, wire.points);
  }
  if (!fold)
  {
    return {};
  }
  const Point2 from = farthestFrom(points.front(), points);
  const Point2 way = farthestFrom(from, points) - from;
  fold->axis.at = from;
  fold->axis.along = (way.y() < 0.0 ? -1.0 : 1.0) * way.normalized();
  double bend = 0.0;
  for (const Point2& p : points)
  {
    bend = std::max(bend, std::abs(cross(fold->axis.along, p - from)));
  }
  const std::string limit = " mm, more than " + formatNumber(mirrorTolerance, 1) + " mm";
  if (bend > mirrorTolerance)
  {
    return refused(fold->curve, "which bends by " + formatNumber(bend, 1) + limit);
  }
  fold->isBorder = isBorder;
  if (fold->isBorder)
  {
    return all.options.oneLayer
      ? refused(fold->curve, "since the cloth of a lay is one layer and the piece is a half")
      : Status{};
  }
  if (all.options.oneLayer)
  {
    fold.reset(); // drawn whole
    return {};
  }
  fold->axis.miss = mirrorMiss(shape, fold->axis);
  if (fold->axis.miss > mirrorTolerance)
  {
    return refused(fold->curve,
      "about which it is not symmetric: mirrored it misses itself by " +
        formatNumber(fold->axis.miss, 1) + limit);
  }
  return {};
}
}
