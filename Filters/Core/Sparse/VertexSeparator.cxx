// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/VertexSeparator.h"

namespace flattening
{
namespace
{
/// In the place of a vertex: where ways begin and end.
constexpr Index atLeft = -2;
constexpr Index atRight = -3;
/// No state, but there may be others.
constexpr Index closed = -4;

constexpr Index entering(Index place)
{
  return 2 * place;
}
constexpr Index leaving(Index place)
{
  return 2 * place + 1;
}
}

VertexSeparator::VertexSeparator(const Indices& begin, const Indices& neighbours)
  : Begin(begin)
  , Neighbours(neighbours)
  , Sides(begin.size() - 1, Side::Outside)
  , Place(begin.size() - 1, none)
{
}

void VertexSeparator::build(const Indices& between)
{
  const auto count = static_cast<Index>(between.size());
  for (Index k = 0; k < count; ++k)
  {
    this->Place[between[k]] = k;
  }
  this->AtLeft.clear();
  this->AtRight.assign(count, 0);
  this->FirstBeside.assign(count + 1, 0);
  for (Index k = 0; k < count; ++k)
  {
    bool left = false;
    Index beside = 0;
    for (Index a = this->Begin[between[k]]; a < this->Begin[between[k] + 1]; ++a)
    {
      const Side side = this->Sides[this->Neighbours[a]];
      left = left || side == Side::Left;
      this->AtRight[k] = this->AtRight[k] || side == Side::Right ? 1 : 0;
      beside += side == Side::Between ? 1 : 0;
    }
    if (left)
    {
      this->AtLeft.push_back(k);
    }
    this->FirstBeside[k + 1] = this->FirstBeside[k] + beside;
  }
  this->Beside.resize(this->FirstBeside.back());
  this->Arc.assign(this->FirstBeside.begin(), this->FirstBeside.end());
  for (Index k = count; k-- > 0;)
  {
    for (Index a = this->Begin[between[k]]; a < this->Begin[between[k] + 1]; ++a)
    {
      if (this->Sides[this->Neighbours[a]] == Side::Between)
      {
        this->Beside[this->Arc[this->Place[this->Neighbours[a]]]++] = k;
      }
    }
  }
  this->Previous.assign(count, none);
  this->Next.assign(count, none);
}

/// The a-th state that may follow one; none after the last.
Index VertexSeparator::following(Index state, Index a) const
{
  const Index k = state / 2;
  if (state == entering(k))
  {
    // Through the vertex, or, where a way goes there, back along that.
    const Index back = this->Previous[k] == atLeft ? closed : leaving(this->Previous[k]);
    return a > 0 ? none : this->Next[k] == none ? leaving(k) : back;
  }
  if (a == 0)
  {
    return this->AtRight[k] ? atRight : closed;
  }
  if (a == 1)
  {
    return this->Next[k] == none ? closed : entering(k);
  }
  const Index at = this->FirstBeside[k] + a - 2;
  if (at >= this->FirstBeside[k + 1])
  {
    return none;
  }
  return this->Next[k] == this->Beside[at] ? closed : entering(this->Beside[at]);
}

/// Looks for a way among states that no earlier one has tried.
bool VertexSeparator::addWay(Index start)
{
  const auto enter = [this](Index state) {
    this->Tried[state] = 1;
    this->Way.push_back(state);
  };
  this->Way.clear();
  enter(entering(start));
  while (!this->Way.empty())
  {
    const Index state = this->Way.back();
    const Index next = this->following(state, this->Arc[state]);
    if (next == none)
    {
      this->Way.pop_back();
      continue;
    }
    ++this->Arc[state];
    if (next == atRight)
    {
      this->takeWay();
      return true;
    }
    if (next != closed && !this->Tried[next])
    {
      enter(next);
    }
  }
  return false;
}

/// Where it runs back along another way, the two change their ends.
void VertexSeparator::takeWay()
{
  this->Previous[this->Way.front() / 2] = atLeft;
  for (std::size_t at = 0; at + 1 < this->Way.size(); ++at)
  {
    const Index from = this->Way[at] / 2;
    const Index to = this->Way[at + 1] / 2;
    if (this->Way[at] == leaving(from))
    {
      this->Next[from] = from == to ? none : to;
      this->Previous[to] = from == to ? none : from;
    }
  }
  this->Next[this->Way.back() / 2] = atRight;
}

bool VertexSeparator::separate(const Indices& between, Index most)
{
  this->build(between);
  Index ways = 0;
  for (bool found = true; found && ways <= most;)
  {
    found = false;
    this->Tried.assign(2 * between.size(), 0);
    this->Arc.assign(2 * between.size(), 0);
    for (Index k : this->AtLeft)
    {
      if (this->Previous[k] == atLeft)
      {
        this->Tried[entering(k)] = 1;
      }
      else if (!this->Tried[entering(k)] && this->addWay(k))
      {
        found = true;
        ++ways;
      }
    }
  }
  for (std::size_t k = 0; k < between.size() && ways <= most; ++k)
  {
    const auto place = static_cast<Index>(k);
    this->Sides[between[k]] = this->Tried[leaving(place)] ? Side::Left
      : this->Tried[entering(place)]                      ? Side::Between
                                                          : Side::Right;
  }
  return ways <= most;
}
}
