// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/DrawingSource.h"

#include "Outlines/ClosedCuts.h"

#include <algorithm>
#include <utility>

namespace flattening::pattern
{
DrawingSource::DrawingSource(const PatternSource& given, PatternOptions asked)
  : source(withoutClosedCuts(given))
  , options(std::move(asked))
{
}

bool DrawingSource::isOnBorder(const SourceWire& wire) const
{
  for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
  {
    if (!this->isOnBorder(wire.points[k], wire.points[k + 1]))
    {
      return false;
    }
  }
  return true;
}

std::string DrawingSource::nameAlong(Index from, Index to) const
{
  const std::size_t wire = wireOf(this->source, this->wires, from, to);
  return wire < this->source.wires.size() ? this->source.wires[wire].name : "boundary";
}

double DrawingSource::valueAlong(
  Index from, Index to, const std::map<std::string, double>& ofCurve, double common) const
{
  const auto found = ofCurve.find(this->nameAlong(from, to));
  return found == ofCurve.end() ? common : found->second;
}

bool DrawingSource::isFoldEdge(Index from, Index to) const
{
  if (this->options.foldsAlong.empty())
  {
    return false;
  }
  const std::size_t wire = wireOf(this->source, this->wires, from, to);
  return wire < this->source.wires.size() &&
    this->options.foldsAlong.count(this->source.wires[wire].name) > 0;
}

double DrawingSource::fairToleranceAlong(Index from, Index to) const
{
  return this->valueAlong(
    from, to, this->options.fairToleranceOfCurve, this->options.fairToleranceOf(this->source));
}

Status findBorders(DrawingSource& all)
{
  std::size_t pieces = 0;
  for (const Index piece : all.source.pieceOfTriangle)
  {
    pieces = std::max(pieces, static_cast<std::size_t>(piece) + 1);
  }
  all.border = bordersOf(all.source);
  Status status = findLoops(all.source, all.border, pieces, all.loops);
  for (std::size_t p = 0; status.ok() && p < pieces; ++p)
  {
    if (all.loops[p].empty())
    {
      status = { StatusCode::InvalidPattern,
        "piece " + std::to_string(p + 1) + " of the flat surface has no border", {},
        { Remedy::GiveFlatPieces } };
    }
  }
  if (!status.ok())
  {
    return status;
  }
  all.partners = sewnPartners(all.source);
  all.wires = wiresOfEdges(all.source);
  std::vector<std::vector<Dart>> folded;
  for (std::size_t p = 0; all.options.darts == DartStyle::Folded && p < pieces; ++p)
  {
    folded.push_back(findDarts(all.source, all.loops[p], all.wires, all.partners));
  }
  all.joins = findJoins(all.source, all.border, all.partners, all.loops, folded);
  return placeNotches(all.source, all.border, all.partners, all.joins, all.options, all.notches);
}
}
