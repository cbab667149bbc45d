// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairCache.h"

#include "Fairing/FairBorders.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
template <typename Value, typename Same>
bool sameLists(const std::vector<Value>& a, const std::vector<Value>& b, const Same& same)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool sameWires(const SourceWire& a, const SourceWire& b)
{
  return a.points == b.points && a.type == b.type && a.curve == b.curve && a.piece == b.piece &&
    a.name == b.name;
}

bool sameSeams(const SewnEdges& a, const SewnEdges& b)
{
  return a.a == b.a && a.b == b.b && a.closed == b.closed;
}

bool sameNotches(const NotchPlace& a, const NotchPlace& b)
{
  return a.edge == b.edge && a.fraction == b.fraction && a.isStop == b.isStop;
}
}

bool FairCache::same(const Cause& cause, const DrawingSource& all)
{
  const PatternSource& one = cause.source;
  const PatternSource& other = all.source;
  return cause.unit == all.options.unit &&
    cause.tolerance == all.options.fairToleranceOf(all.source) &&
    cause.toleranceOfCurve == all.options.fairToleranceOfCurve &&
    cause.symmetrize == all.options.symmetrize && one.positions == other.positions &&
    one.inSpace == other.inSpace && one.triangles == other.triangles &&
    one.pieceOfTriangle == other.pieceOfTriangle && sameLists(one.wires, other.wires, sameWires) &&
    sameLists(one.sewn, other.sewn, sameSeams) &&
    sameLists(cause.notches, all.notches, sameNotches);
}

std::shared_ptr<const FairBorders> FairCache::of(const DrawingSource& all)
{
  if (!this->Borders || !same(this->Last, all))
  {
    this->Borders = std::make_shared<const FairBorders>(all);
    this->Last = { all.source, all.options.unit, all.options.fairToleranceOf(all.source),
      all.options.fairToleranceOfCurve, all.options.symmetrize, all.notches };
  }
  return this->Borders;
}

std::shared_ptr<const FairBorders> drawFair(DrawingSource& all, FairCache* cache)
{
  std::shared_ptr<const FairBorders> fair;
  if (all.options.isFair(all.source))
  {
    fair = cache ? cache->of(all) : std::make_shared<const FairBorders>(all);
    all.fair = fair.get();
    all.moved = &fair->positions();
  }
  return fair;
}
}
}
