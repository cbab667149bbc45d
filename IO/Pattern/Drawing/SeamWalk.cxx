// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SeamWalk.h"

#include "Drawing/ClothOutline.h"
#include "Fairing/FairBorders.h"
#include "Outlines/PatternText.h"

#include <algorithm>

namespace flattening::pattern
{
namespace
{
constexpr double degreesPerRadian = 57.295779513082320877;

constexpr double withinEdge = 360.0; ///< both sides are straight there
using Side = std::array<Index, 2>;   // an edge in the direction of its curve

/// Borders as they are drawn: smooth, and with the tips of darts drawn back.
class DrawnBorders
{
public:
  /// \param all with its loops; it stays the caller's
  explicit DrawnBorders(const DrawingSource& all)
    : All(all)
  {
    for (std::size_t p = 0; p < all.loops.size(); ++p)
    {
      this->Cloths.emplace_back(all, p);
    }
  }

  /// The length of a part of an edge of a piece, between two fractions of it.
  double length(std::size_t piece, const Side& side, double from, double to) const
  {
    const DartPlacement* const dart = this->Cloths[piece].placementAlong(side[0], side[1]);
    if (!this->All.fair)
    {
      const Point2 way =
        this->placed(dart, this->All.at(side[1])) - this->placed(dart, this->All.at(side[0]));
      return (to - from) * way.norm();
    }
    double length = 0.0;
    for (FairSpan part : this->All.fair->alongEdge(side[0], side[1], from, to))
    {
      for (Point2& p : part.control)
      {
        p = this->placed(dart, p);
      }
      length += part.length();
    }
    return length;
  }

  /// The angle of the cloth around each point of the drawing, radians.
  std::vector<double> angles() const
  {
    const PatternSource& source = this->All.source;
    std::vector<double> angles(source.positions.size(), 0.0);
    for (std::size_t p = 0; p < this->Cloths.size(); ++p)
    {
      for (const Indices& loop : this->All.loops[p])
      {
        for (std::size_t k = 0; k < loop.size(); ++k)
        {
          // The cloth lies on the left, between the way on and the way back.
          const Side edge{ loop[k], loop[(k + 1) % loop.size()] };
          angles[edge[0]] -= this->turn(p, edge);
          angles[edge[1]] += this->turn(p, { edge[1], edge[0] });
        }
      }
    }
    for (const Triangle& corners : source.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index v = corners[k];
        const Point2 a = source.positions[corners[(k + 1) % 3]] - source.positions[v];
        const Point2 b = source.positions[corners[(k + 2) % 3]] - source.positions[v];
        angles[v] += std::abs(std::atan2(cross(a, b), a.dot(b)));
      }
    }
    return angles;
  }

private:
  static Point2 placed(const DartPlacement* dart, const Point2& p)
  {
    return dart ? dart->at(p) : p;
  }

  /// From an edge of the mesh to what is drawn along it, at its first point.
  double turn(std::size_t piece, const Side& side) const
  {
    const PatternSource& source = this->All.source;
    const DartPlacement* const dart = this->Cloths[piece].placementAlong(side[0], side[1]);
    Points2 drawn{ this->All.at(side[0]), this->All.at(side[1]) };
    if (this->All.fair)
    {
      const std::vector<FairSpan> parts = this->All.fair->alongEdge(side[0], side[1]);
      if (!parts.empty())
      {
        drawn = { parts.front().control[0], parts.front().control[1] };
      }
    }
    const Point2 before = source.positions[side[1]] - source.positions[side[0]];
    const Point2 after = this->placed(dart, drawn[1]) - this->placed(dart, drawn[0]);
    return std::atan2(cross(before, after), before.dot(after));
  }

  const DrawingSource& All;
  std::vector<ClothOutline> Cloths; ///< by piece
};

/// A part of a bend; empty where the surface is not known.
std::string bendInDegrees(const WalkInterval& row, double part, int digits)
{
  return std::isnan(row.bend) ? "" : formatNumber(degreesPerRadian * row.bend * part, digits);
}

bool hasThickness(const std::vector<WalkInterval>& walk)
{
  return !walk.empty() && walk.front().thickness > 0.0;
}
}

std::vector<WalkInterval> walkSeams(const DrawingSource& all)
{
  std::vector<WalkInterval> walk;
  const PatternSource& source = all.source;
  const DrawnBorders drawn(all);
  const std::vector<double> angles = drawn.angles();
  const auto angleAt = [&angles](const std::array<Side, 2>& sides, std::size_t end) {
    const Index a = sides[0][end];
    const Index b = sides[1][end];
    return degreesPerRadian * (angles[a] + (a == b ? 0.0 : angles[b]));
  };
  const auto start = [&](const Join& join, int number, double from, double angle) {
    WalkInterval& interval = walk.emplace_back();
    interval.join = join.mark;
    interval.bend = join.bend;
    interval.thickness = all.options.thickness;
    interval.curve = source.wires[join.wire].name;
    interval.type = source.wires[join.wire].type;
    interval.piece = join.piece;
    interval.number = number;
    interval.from = interval.to = all.scale() * from;
    interval.angleSum = { angle, angle };
  };
  const auto add = [&](const std::array<Side, 2>& sides, double from, double to) {
    WalkInterval& interval = walk.back();
    for (std::size_t s = 0; s < 2; ++s)
    {
      interval.length[s] += drawn.length(interval.piece[s], sides[s], from, to);
    }
  };
  const auto finish = [&](double to, double angle) {
    walk.back().to = all.scale() * to;
    walk.back().angleSum[1] = angle;
  };
  std::size_t wireOfLast = source.wires.size(); // of the interval
  for (const Join& join : all.joins)
  {
    const std::vector<double> arc = arcsOnSurface(source, source.wires[join.wire].points);
    std::vector<double> stops = all.stations[join.wire];
    stops.push_back(arc.back());
    auto stop = std::upper_bound(stops.begin(), std::prev(stops.end()), join.from);
    int number = !walk.empty() && wireOfLast == join.wire ? walk.back().number + 1 : 1;
    wireOfLast = join.wire;
    for (std::size_t e = 0; e + 1 < join.points[0].size(); ++e)
    {
      const std::array<Side, 2> sides{ Side{ join.points[0][e], join.points[0][e + 1] },
        Side{ join.points[1][e], join.points[1][e + 1] } };
      if (e == 0)
      {
        start(join, number, join.from, angleAt(sides, 0));
      }
      double at = arc[join.firstEdge + e];
      const double begin = at;
      const double end = arc[join.firstEdge + e + 1];
      for (; *stop < end; ++stop)
      {
        add(sides, (at - begin) / (end - begin), (*stop - begin) / (end - begin));
        at = *stop;
        finish(at, withinEdge);
        start(join, ++number, at, withinEdge);
      }
      add(sides, (at - begin) / (end - begin), 1.0);
      finish(end, angleAt(sides, 1));
    }
  }
  return walk;
}

std::string makeWalkTable(const std::vector<WalkInterval>& walk, const Pattern& pattern)
{
  std::string table =
    "curve,type,piece_a,piece_b,interval,from_mm,to_mm,length_a_mm,length_b_mm,"
    "difference_mm,ease_percent,angle_sum_start_deg,angle_sum_end_deg,join,bend_deg";
  const bool isThick = hasThickness(walk);
  table += isThick ? ",bevel_deg,bevel_mm\n" : "\n";
  for (const WalkInterval& row : walk)
  {
    table += csvField(cleanText(row.curve)) + (row.type == WireType::Dart ? ",dart," : ",seam,") +
      csvField(pattern.names[row.piece[0]]) + "," + csvField(pattern.names[row.piece[1]]) + "," +
      std::to_string(row.number);
    for (const double length :
      { row.from, row.to, row.length[0], row.length[1], row.length[0] - row.length[1] })
    {
      table += "," + formatNumber(length, 6);
    }
    table += "," + formatNumber(row.ease(), 6);
    for (const double angle : row.angleSum)
    {
      table += "," + formatNumber(angle, 3);
    }
    table += "," + row.join + "," + bendInDegrees(row, 1.0, 1);
    if (isThick)
    {
      table += "," + bendInDegrees(row, 0.5, 1) + "," +
        (std::isnan(row.bend) ? "" : formatNumber(row.bevel(), 2));
    }
    table += "\n";
  }
  return table;
}

PatternTable walkRows(const std::vector<WalkInterval>& walk, const Pattern& pattern)
{
  PatternTable table;
  table.title = "Walk of the seams";
  table.columns = { 0.0, 33.0, 59.0, 85.0, 93.0, 111.0, 129.0, 147.0, 163.0 };
  table.rows.push_back(
    { "Curve", "Side A", "Side B", "No.", "A mm", "B mm", "A - B mm", "Ease %", "Angles" });
  for (const WalkInterval& row : walk)
  {
    table.rows.push_back(
      { cleanText(row.curve), pattern.names[row.piece[0]], pattern.names[row.piece[1]],
        std::to_string(row.number), formatNumber(row.length[0], 1), formatNumber(row.length[1], 1),
        formatNumber(row.length[0] - row.length[1], 2), formatNumber(row.ease(), 2),
        formatNumber(row.angleSum[0], 0) + " / " + formatNumber(row.angleSum[1], 0) });
  }
  return table;
}

PatternTable joinRows(const std::vector<WalkInterval>& walk, const Pattern& pattern)
{
  PatternTable table;
  table.title = "Joins";
  table.columns = { 0.0, 14.0, 56.0, 93.0, 130.0, 146.0, 162.0 };
  const bool isThick = hasThickness(walk);
  std::vector<WalkInterval> joins; // each with the lengths of its intervals
  for (const WalkInterval& interval : walk)
  {
    if (interval.join.empty())
    {
      continue;
    }
    if (joins.empty() || joins.back().join != interval.join)
    {
      joins.push_back(interval);
      continue;
    }
    joins.back().length[0] += interval.length[0];
    joins.back().length[1] += interval.length[1];
  }
  if (!joins.empty())
  {
    table.rows.push_back({ "Join", "Curve", "Side 1", "Side 2", "1 mm", "2 mm", "Bend" });
    if (isThick)
    {
      table.columns = { 0.0, 14.0, 50.0, 83.0, 116.0, 131.0, 146.0, 158.0 };
      table.rows.back().emplace_back("Bevel");
    }
  }
  const auto piece = [&pattern](
                       std::size_t p) { return std::to_string(p + 1) + ": " + pattern.names[p]; };
  for (const WalkInterval& join : joins)
  {
    table.rows.push_back({ join.join, cleanText(join.curve), piece(join.piece[0]),
      piece(join.piece[1]), formatNumber(join.length[0], 1), formatNumber(join.length[1], 1),
      bendInDegrees(join, 1.0, 0) + (std::isnan(join.bend) ? "" : "\u00b0") });
    if (isThick)
    {
      table.rows.back().push_back(std::isnan(join.bend)
          ? ""
          : bendInDegrees(join, 0.5, 0) + "\u00b0, " + formatNumber(join.bevel(), 1) + " mm");
    }
  }
  return table;
}
}
