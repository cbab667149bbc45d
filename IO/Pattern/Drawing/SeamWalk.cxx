// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SeamWalk.h"

#include "Base/Types.h"
#include "Drawing/ClothOutline.h"
#include "Drawing/PatternBuilder.h"
#include "Fairing/FairBorders.h"
#include "Outlines/Notches.h"
#include "Outlines/Outline.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

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
    for (const std::vector<Indices>& loops : all.loops)
    {
      this->Cloths.emplace_back(all, loops);
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

  /// By how much the cloth's angle at each point of the borders is larger than that of the flat
  /// triangles there, radians.
  std::vector<double> widening() const
  {
    std::vector<double> wider(this->All.source.positions.size(), 0.0);
    for (std::size_t p = 0; p < this->Cloths.size(); ++p)
    {
      for (const Indices& loop : this->All.loops[p])
      {
        for (std::size_t k = 0; k < loop.size(); ++k)
        {
          // The cloth lies on the left, between the way on and the way back.
          const Side edge{ loop[k], loop[(k + 1) % loop.size()] };
          wider[edge[0]] -= this->turn(p, edge);
          wider[edge[1]] += this->turn(p, { edge[1], edge[0] });
        }
      }
    }
    return wider;
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

class SeamWalker
{
public:
  /// The source and what is drawn of it stay the caller's.
  SeamWalker(const DrawingSource& all, std::vector<WalkInterval>& walk)
    : All(all)
    , Source(all.source)
    , Scale(all.scale())
    , Drawn(all)
    , Angle(Drawn.widening())
    , Walk(walk)
  {
    const PatternSource& source = all.source;
    for (std::size_t t = 0; t < source.triangles.size(); ++t)
    {
      const Triangle& corners = source.triangles[t];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index v = corners[k];
        const Index next = corners[(k + 1) % 3];
        const Point2 a = source.positions[next] - source.positions[v];
        const Point2 b = source.positions[corners[(k + 2) % 3]] - source.positions[v];
        this->Angle[v] += std::abs(std::atan2(cross(a, b), a.dot(b)));
      }
    }
  }

  Status walk(const SourceWire& wire, const PatternOptions& options)
  {
    const std::vector<double> arc = arcsOnSurface(this->Source, wire.points);
    std::vector<double> stops;
    Status status = stationsOf(wire, arc.back(), options, this->Scale, stops);
    if (!status.ok())
    {
      return status;
    }
    stops.push_back(arc.back());
    auto stop = stops.begin();
    int number = 0;
    bool going = false;
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Side one{ wire.points[k], wire.points[k + 1] };
      const auto partner = this->All.partners.find(edgeKey(one[0], one[1]));
      const bool sewn =
        partner != this->All.partners.end() && this->Done.insert(edgeOf(one)).second;
      if (!sewn)
      {
        going = false;
        continue;
      }
      const std::array<Side, 2> sides{ one, partner->second };
      this->Done.insert(edgeOf(sides[1]));
      const std::array<std::size_t, 2> pieces{ this->pieceOf(sides[0]), this->pieceOf(sides[1]) };
      if (!going || this->Walk.back().piece != pieces)
      {
        stop = std::upper_bound(stops.begin(), std::prev(stops.end()), arc[k]);
        this->start(wire, pieces, ++number, arc[k], this->angleAt(sides, 0));
        going = true;
      }
      double at = arc[k];
      for (; *stop < arc[k + 1]; ++stop)
      {
        this->add(
          sides, (at - arc[k]) / (arc[k + 1] - arc[k]), (*stop - arc[k]) / (arc[k + 1] - arc[k]));
        at = *stop;
        this->end(at, withinEdge);
        this->start(wire, pieces, ++number, at, withinEdge);
      }
      this->add(sides, (at - arc[k]) / (arc[k + 1] - arc[k]), 1.0);
      this->end(arc[k + 1], this->angleAt(sides, 1));
    }
    return {};
  }

private:
  static std::uint64_t edgeOf(const Side& side) { return undirectedKey(side[0], side[1]); }

  std::size_t pieceOf(const Side& side) const
  {
    auto found = this->All.border.find(edgeKey(side[0], side[1]));
    found =
      found != this->All.border.end() ? found : this->All.border.find(edgeKey(side[1], side[0]));
    return found != this->All.border.end() ? static_cast<std::size_t>(found->second) : 0;
  }

  double angleAt(const std::array<Side, 2>& sides, std::size_t end) const
  {
    const Index a = sides[0][end];
    const Index b = sides[1][end];
    return degreesPerRadian * (this->Angle[a] + (a == b ? 0.0 : this->Angle[b]));
  }

  void start(const SourceWire& wire, const std::array<std::size_t, 2>& pieces, int number,
    double from, double angle)
  {
    WalkInterval interval;
    interval.curve = wire.name;
    interval.type = wire.type;
    interval.piece = pieces;
    interval.number = number;
    interval.from = interval.to = this->Scale * from;
    interval.angleSum = { angle, angle };
    this->Walk.push_back(std::move(interval));
  }

  void add(const std::array<Side, 2>& sides, double from, double to)
  {
    WalkInterval& interval = this->Walk.back();
    for (std::size_t s = 0; s < 2; ++s)
    {
      interval.length[s] += this->Drawn.length(interval.piece[s], sides[s], from, to);
    }
  }

  void end(double to, double angle)
  {
    this->Walk.back().to = this->Scale * to;
    this->Walk.back().angleSum[1] = angle;
  }

  const DrawingSource& All;
  const PatternSource& Source;
  const double Scale;
  const DrawnBorders Drawn;
  std::vector<double> Angle; ///< of the cloth around each point
  std::unordered_set<std::uint64_t> Done;
  std::vector<WalkInterval>& Walk;
};

}

Status walkSeams(const PatternSource& source, const PatternOptions& given,
  std::vector<WalkInterval>& walk, FairCache* cache)
{
  walk.clear();
  DrawingSource all(source, completed(given, source));
  Status status = findBorders(all);
  if (!status.ok())
  {
    return status;
  }
  drawFair(all, cache);
  SeamWalker walker(all, walk);
  for (const SourceWire& wire : all.source.wires)
  {
    if (wire.type != WireType::Seam && wire.type != WireType::Dart)
    {
      continue;
    }
    status = walker.walk(wire, all.options);
    if (!status.ok())
    {
      return status;
    }
  }
  return {};
}

std::string makeWalkTable(const std::vector<WalkInterval>& walk, const Pattern& pattern)
{
  std::string table = "curve,type,piece_a,piece_b,interval,from_mm,to_mm,length_a_mm,length_b_mm,"
                      "difference_mm,ease_percent,angle_sum_start_deg,angle_sum_end_deg\n";
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
    table += "\n";
  }
  return table;
}

std::vector<std::vector<std::string>> walkRows(
  const std::vector<WalkInterval>& walk, const Pattern& pattern)
{
  std::vector<std::vector<std::string>> rows{ { "Curve", "Side A", "Side B", "No.", "A mm", "B mm",
    "A - B mm", "Ease %", "Angles" } };
  for (const WalkInterval& row : walk)
  {
    rows.push_back({ cleanText(row.curve), pattern.names[row.piece[0]], pattern.names[row.piece[1]],
      std::to_string(row.number), formatNumber(row.length[0], 1), formatNumber(row.length[1], 1),
      formatNumber(row.length[0] - row.length[1], 2), formatNumber(row.ease(), 2),
      formatNumber(row.angleSum[0], 0) + " / " + formatNumber(row.angleSum[1], 0) });
  }
  return rows;
}
}
