// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/Dissection.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
/// What both ways of halving have in common.
class Dissector
{
public:
  Dissector(const Triangles& cliques, Index count)
    : Begin(count + 1, 0)
    , Part(count, 0)
  {
    for (const Triangle& t : cliques)
    {
      for (Index v : t)
      {
        this->Begin[v + 1] += 2;
      }
    }
    this->AnyHub =
      *std::max_element(this->Begin.begin(), this->Begin.end()) / 2 > hubValence(smallPart);
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Neighbours.resize(this->Begin.back());
    Indices next(this->Begin.begin(), this->Begin.end() - 1);
    for (const Triangle& t : cliques)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Neighbours[next[t[k]]++] = t[(k + 1) % 3];
        this->Neighbours[next[t[k]]++] = t[(k + 2) % 3];
      }
    }
    this->Result.order.resize(count);
    std::iota(this->Result.order.begin(), this->Result.order.end(), 0);
  }
  virtual ~Dissector() = default;
  Dissector(const Dissector&) = delete;
  Dissector& operator=(const Dissector&) = delete;

protected:
  using Iterator = Indices::iterator;

  /// A part that stands at order[begin] .. order[end - 1] and is to be divided from a vertex at one
  /// of its ends, or the end of a range alone.
  struct Step
  {
    Index begin;
    Index end;
    Index start;
  };

  /// Divides a part into others that come next, by pushPart() from the last to the first.
  virtual void divide(const Step& part) = 0;

  void pushEnd(Index end) { this->Steps.push_back({ none, end, none }); }
  void pushPart(Index begin, Index end, Index start)
  {
    if (begin < end)
    {
      this->Steps.push_back({ begin, end, start });
    }
  }

  Dissection divideAll(Index start)
  {
    this->pushPart(0, static_cast<Index>(this->Part.size()), start);
    while (!this->Steps.empty())
    {
      const Step step = this->Steps.back();
      this->Steps.pop_back();
      if (step.begin == none || step.end - step.begin <= smallPart)
      {
        this->Result.endRange(step.end);
      }
      else if (!this->AnyHub || !this->takeHubs(step))
      {
        this->divide(step);
      }
    }
    return std::move(this->Result);
  }

  /// Moves those behind that have a neighbour for which this holds, the separator. \return its
  /// begin.
  template <typename Beyond>
  Iterator separate(Iterator first, Iterator last, const Beyond& beyond) const
  {
    return std::stable_partition(first, last, [&](Index v) {
      return std::none_of(this->Neighbours.begin() + this->Begin[v],
        this->Neighbours.begin() + this->Begin[v + 1], beyond);
    });
  }

  /// Gives vertices a mark that no other has had.
  Index assign(Iterator first, Iterator last)
  {
    const Index part = this->NextPart++;
    std::for_each(first, last, [&](Index v) { this->Part[v] = part; });
    return part;
  }

  /// Parts of so few vertices are not divided: a dense block of them costs less.
  static constexpr Index smallPart = 12;

  Indices Begin; ///< neighbours of each vertex, in flat arrays; inner edges twice
  Indices Neighbours;
  Indices Part; ///< mark of each vertex
  Dissection Result;

private:
  /// Makes the hubs of a part its separator. False where it has none.
  bool takeHubs(const Step& step)
  {
    const Index enough = hubValence(step.end - step.begin);
    const Iterator first = this->Result.order.begin() + step.begin;
    const Iterator last = this->Result.order.begin() + step.end;
    const auto high = [&](Index v) { return (this->Begin[v + 1] - this->Begin[v]) / 2 > enough; };
    if (std::none_of(first, last, high))
    {
      return false;
    }
    const Index part = this->assign(first, last);
    const Iterator hubs = std::stable_partition(first, last, [&](Index v) {
      return !high(v) ||
        std::count_if(this->Neighbours.begin() + this->Begin[v],
          this->Neighbours.begin() + this->Begin[v + 1],
          [&](Index n) { return this->Part[n] == part; }) /
          2 <=
        enough;
    });
    if (hubs == last)
    {
      return false;
    }
    this->assign(first, hubs);
    this->pushEnd(step.end);
    if (hubs != first)
    {
      this->pushPart(step.begin, step.end - static_cast<Index>(last - hubs), *(hubs - 1));
    }
    return true;
  }

  std::vector<Step> Steps;
  Index NextPart = 1;
  bool AnyHub = false;
};
}
