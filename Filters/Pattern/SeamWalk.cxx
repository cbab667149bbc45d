// SPDX-License-Identifier: BSD-3-Clause
#include "SeamWalk.h"

#include "ClosedCuts.h"
#include "FairBorders.h"
#include "Notches.h"
#include "Outline.h"
#include "PatternText.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double degreesPerRadian = 57.295779513082320877;

constexpr double withinEdge = 360.0; ///< both sides are straight there
using Side = std::array<Index, 2>;   // an edge in the direction of its curve

class SeamWalker
{
public:
  SeamWalker(const PatternSource& source, double scale, const FairBorders* fair,
    std::vector<WalkInterval>& walk)
    : Source(source)
    , Fair(fair)
    , Partners(sewnPartners(source))
    , Scale(scale)
    , Angle(source.positions.size(), 0.0)
    , Walk(walk)
  {
    for (std::size_t t = 0; t < source.triangles.size(); ++t)
    {
      const Triangle& corners = source.triangles[t];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index v = corners[k];
        const Index next = corners[(k + 1) % 3];
        const Point2 a = source.positions[next] - source.positions[v];
        const Point2 b = source.positions[corners[(k + 2) % 3]] - source.positions[v];
        this->Angle[v] += std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
        this->PieceOfEdge[edgeKey(v, next)] = static_cast<std::size_t>(source.pieceOfTriangle[t]);
      }
    }
  }

  Status walk(const SourceWire& wire, const PatternOptions& options)
  {
    std::vector<double> arc{ 0.0 };
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      arc.push_back(arc.back() + lengthOnSurface(this->Source, wire.points[k], wire.points[k + 1]));
    }
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
      const auto partner = this->Partners.find(edgeKey(one[0], one[1]));
      const bool sewn = partner != this->Partners.end() && this->Done.insert(edgeOf(one)).second;
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
  static std::uint64_t edgeOf(const Side& side)
  {
    return edgeKey(std::min(side[0], side[1]), std::max(side[0], side[1]));
  }

  std::size_t pieceOf(const Side& side) const
  {
    const auto found = this->PieceOfEdge.find(edgeKey(side[0], side[1]));
    return found != this->PieceOfEdge.end() ? found->second
                                            : this->PieceOfEdge.at(edgeKey(side[1], side[0]));
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
    for (std::size_t s = 0; s < 2; ++s)
    {
      double& length = this->Walk.back().length[s];
      if (this->Fair)
      {
        for (const FairSpan& part : this->Fair->alongEdge(sides[s][0], sides[s][1], from, to))
        {
          length += part.length();
        }
        continue;
      }
      const Point2 edge = this->Source.positions[sides[s][1]] - this->Source.positions[sides[s][0]];
      length += (to - from) * this->Scale * edge.norm();
    }
  }

  void end(double to, double angle)
  {
    this->Walk.back().to = this->Scale * to;
    this->Walk.back().angleSum[1] = angle;
  }

  const PatternSource& Source;
  const FairBorders* const Fair; ///< null: edges are straight
  const SewnPartners Partners;
  const double Scale;
  std::vector<double> Angle; ///< of the cloth around each point
  std::unordered_map<std::uint64_t, std::size_t> PieceOfEdge;
  std::unordered_set<std::uint64_t> Done;
  std::vector<WalkInterval>& Walk;
};

/// A field of a table, in quotes where its characters ask for them.
std::string field(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + "\"";
}
}

Status walkSeams(
  const PatternSource& source, const PatternOptions& options, std::vector<WalkInterval>& walk)
{
  walk.clear();
  const PatternSource whole = withoutClosedCuts(source);
  const double scale = millimetresPer(options.unit);
  DrawingSource all{ whole, options, {}, {}, {}, {}, nullptr, nullptr };
  std::optional<FairBorders> fair;
  if (options.isFair())
  {
    Status status = findBorders(all);
    if (!status.ok())
    {
      return status;
    }
    fair.emplace(all);
  }
  SeamWalker walker(whole, scale, fair ? &*fair : nullptr, walk);
  for (const SourceWire& wire : whole.wires)
  {
    if (wire.type != WireType::Seam && wire.type != WireType::Dart)
    {
      continue;
    }
    Status status = walker.walk(wire, options);
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
    table += field(cleanText(row.curve)) + (row.type == WireType::Dart ? ",dart," : ",seam,") +
      field(pattern.names[row.piece[0]]) + "," + field(pattern.names[row.piece[1]]) + "," +
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
}
