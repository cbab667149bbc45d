// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingSource.h"

#include "FairBorders.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
void DrawingSource::addAlong(Index from, Index to, Points2& points) const
{
  const std::size_t before = points.size();
  if (this->fair)
  {
    for (const FairSpan& span : this->fair->alongEdge(from, to))
    {
      sampleSpan(span, sampleDistance, points);
    }
  }
  if (points.size() == before)
  {
    points.push_back(this->at(from));
  }
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
  Status status = findLoops(all.source, pieces, all.loops);
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
  return placeNotches(all.source, all.loops, all.partners, all.options, all.notches);
}

Point2 DrawingSource::onEdge(Index from, Index to, double fraction, Point2& outward) const
{
  Point2 along = this->at(to) - this->at(from);
  Point2 place = this->at(from) + fraction * along;
  if (this->fair)
  {
    const std::vector<FairSpan> parts = this->fair->alongEdge(from, to, 0.0, fraction);
    const std::vector<FairSpan> whole = this->fair->alongEdge(from, to);
    if (!whole.empty())
    {
      const FairSpan& last = parts.empty() ? whole.front() : parts.back();
      const double at = parts.empty() ? last.from : last.to;
      place = last.at(at);
      // A part that runs back has its slope by descending length.
      along = (last.to > last.from ? 1.0 : -1.0) * last.slope(at);
    }
  }
  outward = Point2(along.y(), -along.x()).normalized();
  return place;
}
}
}
