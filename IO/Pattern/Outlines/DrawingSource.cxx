// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/DrawingSource.h"

#include "Base/CompressedRows.h"
#include "Outlines/Grainlines.h"

#include <string>
#include <unordered_set>
#include <utility>

namespace flattening::pattern
{
std::pair<std::string, Index> curveSide(const std::string& text)
{
  const std::size_t colon = text.rfind(':');
  const std::string number = colon == std::string::npos ? std::string() : text.substr(colon + 1);
  const bool isSide = !number.empty() && number.size() < 8 && number.front() != '0' &&
    number.find_first_not_of("0123456789") == std::string::npos;
  return isSide ? std::pair(text.substr(0, colon), static_cast<Index>(std::stol(number) - 1))
                : std::pair(text, none);
}

namespace
{
/// The same flattening with cuts that were closed (SewnEdges::closed) taken for whole cloth: the
/// points of their two banks become one, they are sewn nowhere, and of their wires what is still
/// open is left.
PatternSource withoutClosedCuts(const PatternSource& source)
{
  PatternSource whole = source;
  JoinedSets joined(static_cast<Index>(source.positions.size()));
  std::unordered_set<std::uint64_t> closed; // edges of both banks
  for (const SewnEdges& pair : source.sewn)
  {
    if (pair.closed)
    {
      joined.join(pair.a[0], pair.b[0]);
      joined.join(pair.a[1], pair.b[1]);
      closed.insert({ undirectedKey(pair.a[0], pair.a[1]), undirectedKey(pair.b[0], pair.b[1]) });
    }
  }
  const auto joinAll = [&joined](auto& points) {
    for (Index& v : points)
    {
      v = joined.find(v);
    }
  };
  std::for_each(whole.triangles.begin(), whole.triangles.end(), joinAll);
  joinAll(whole.gradePoints);
  eraseIf(whole.sewn, [](const SewnEdges& pair) { return pair.closed; });
  for (SewnEdges& pair : whole.sewn)
  {
    joinAll(pair.a);
    joinAll(pair.b);
  }
  whole.wires.clear();
  for (const SourceWire& wire : source.wires)
  {
    SourceWire part = wire;
    part.points.clear();
    const auto end = [&] {
      if (part.points.size() > 1)
      {
        whole.wires.push_back(part);
      }
      part.points.clear();
    };
    for (std::size_t k = 0; k < wire.points.size(); ++k)
    {
      if (k > 0 && closed.count(undirectedKey(wire.points[k - 1], wire.points[k])) > 0)
      {
        end();
      }
      part.points.push_back(joined.find(wire.points[k]));
    }
    end();
  }
  return whole;
}

/// Makes pieces longer along their grain and across it, as the options say.
void compensate(std::size_t pieces, DrawingSource& all)
{
  PatternSource& source = all.source;
  const Eigen::Vector2d factors(
    1.0 + all.options.weftCompensation / 100.0, 1.0 + all.options.warpCompensation / 100.0);
  if (factors == Eigen::Vector2d::Ones())
  {
    return;
  }
  std::vector<Eigen::Matrix2d> stretches(pieces);
  for (std::size_t p = 0; p < pieces; ++p)
  {
    const Point2 grain = grainOf(source, p, all.options.up);
    Eigen::Matrix2d turn; // the grain becomes upright
    turn << grain.y(), -grain.x(), grain.x(), grain.y();
    stretches[p] = turn.transpose() * factors.asDiagonal() * turn;
  }
  std::vector<char> isDone(source.positions.size(), 0);
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    for (const Index v : source.triangles[t])
    {
      const auto point = static_cast<std::size_t>(v);
      if (isDone[point] == 0)
      {
        const auto piece = static_cast<std::size_t>(source.pieceOfTriangle[t]);
        source.positions[point] = stretches[piece] * source.positions[point];
        isDone[point] = 1;
      }
    }
  }
}
}

DrawingSource::DrawingSource(const PatternSource& given, PatternOptions asked)
  : source(withoutClosedCuts(given))
  , options(std::move(asked))
{
}

Points2 DrawingSource::at(const Indices& points) const
{
  Points2 places;
  for (const Index point : points)
  {
    places.push_back(this->at(point));
  }
  return places;
}

std::string DrawingSource::nameAlong(Index from, Index to) const
{
  const SourceWire* const wire = wireOf(this->source, this->wires, from, to);
  return wire ? wire->name : "boundary";
}

double DrawingSource::valueAlong(
  Index from, Index to, const std::map<std::string, double>& ofCurve, double common) const
{
  const auto found = ofCurve.find(this->nameAlong(from, to));
  return found == ofCurve.end() ? common : found->second;
}

double DrawingSource::allowanceAlong(Index from, Index to) const
{
  if (this->isFoldEdge(from, to))
  {
    return 0.0;
  }
  const std::map<std::string, double>& ofCurve = this->options.allowanceOfCurve;
  const Index piece = pieceOf(this->border, from, to);
  const auto ofSide = ofCurve.find(this->nameAlong(from, to) + ':' + std::to_string(piece + 1));
  if (piece != none && ofSide != ofCurve.end())
  {
    return ofSide->second;
  }
  return this->valueAlong(from, to, ofCurve, this->options.allowance);
}

bool DrawingSource::isFoldEdge(Index from, Index to) const
{
  const SourceWire* const wire =
    this->options.foldsAlong.empty() ? nullptr : wireOf(this->source, this->wires, from, to);
  return wire && this->options.foldsAlong.count(wire->name) > 0;
}

double DrawingSource::fairToleranceAlong(Index from, Index to) const
{
  return this->valueAlong(
    from, to, this->options.fairToleranceOfCurve, this->options.fairToleranceOf(this->source));
}

Status findBorders(DrawingSource& all)
{
  const std::size_t pieces = pieceCount(all.source);
  compensate(pieces, all);
  all.border = bordersOf(all.source);
  Status status = findLoops(all.source, all.border, all.loops);
  for (std::size_t p = 0; status.ok() && p < pieces; ++p)
  {
    if (all.loops[p].empty())
    {
      status =
        invalidPieces("piece " + std::to_string(p + 1) + " of the flat surface has no border");
    }
  }
  if (!status.ok())
  {
    return status;
  }
  all.partners = sewnPartners(all.source);
  all.wires = wiresOfEdges(all.source);
  all.darts.assign(pieces, {});
  for (std::size_t p = 0; !all.options.cutDartsOut && p < pieces; ++p)
  {
    all.darts[p] = findDarts(all.source, all.loops[p], all.wires, all.partners);
  }
  all.joins = findJoins(all.source, all.border, all.partners, all.loops, all.darts);
  return placeNotches(
    all.source, all.border, all.partners, all.joins, all.options, all.stations, all.notches);
}
}
