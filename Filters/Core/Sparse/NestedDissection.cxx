// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NestedDissection.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// Parts of so few vertices are not divided: a dense block of them costs less.
constexpr Index smallPart = 12;

/// What both ways of halving have in common.
class Dissector
{
public:
  Dissector(const Triangles& cliques, Index count)
    : Begin(count + 1, 0)
  {
    for (const Triangle& t : cliques)
    {
      for (Index v : t)
      {
        this->Begin[v + 1] += 2;
      }
    }
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

protected:
  using Iterator = Indices::iterator;

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

  Indices Begin; ///< neighbours of each vertex, in flat arrays
  Indices Neighbours;
  Dissection Result;
};

class PlaneDissector : Dissector
{
public:
  PlaneDissector(const Triangles& cliques, const Points3& positions)
    : Dissector(cliques, static_cast<Index>(positions.size()))
    , Positions(positions)
    , Side(positions.size(), none)
  {
  }

  Dissection run()
  {
    this->split(this->Result.order.begin(), this->Result.order.end());
    return std::move(this->Result);
  }

private:
  void split(Iterator begin, Iterator end)
  {
    if (end - begin <= smallPart)
    {
      this->Result.endRange(this->placeOf(end));
      return;
    }
    Eigen::AlignedBox3d box;
    std::for_each(begin, end, [&](Index v) { box.extend(this->Positions[v]); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    this->Along.clear();
    std::for_each(
      begin, end, [&](Index v) { this->Along.emplace_back(this->Positions[v][axis], v); });
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(
      this->Along.begin(), this->Along.begin() + (middle - begin), this->Along.end());
    std::transform(this->Along.begin(), this->Along.end(), begin,
      [](const std::pair<double, Index>& item) { return item.second; });
    // Marks are the depth-first number of the split, so that none has to be taken back.
    const Index left = this->NextMark++;
    const Index right = this->NextMark++;
    std::for_each(begin, middle, [&](Index v) { this->Side[v] = left; });
    std::for_each(middle, end, [&](Index v) { this->Side[v] = right; });
    const Iterator separator =
      this->separate(begin, middle, [&](Index n) { return this->Side[n] == right; });
    const std::ptrdiff_t leftCount = separator - begin;
    const std::ptrdiff_t separatorCount = middle - separator;
    std::rotate(separator, middle, end);
    this->split(begin, begin + leftCount);
    this->split(begin + leftCount, end - separatorCount);
    this->Result.endRange(this->placeOf(end));
  }

  Index placeOf(Iterator place) { return static_cast<Index>(place - this->Result.order.begin()); }

  const Points3& Positions;
  Indices Side;
  std::vector<std::pair<double, Index>> Along; ///< coordinate across the plane, vertex
  Index NextMark = 0;
};

class LevelDissector : Dissector
{
public:
  LevelDissector(const Triangles& cliques, Index count)
    : Dissector(cliques, count)
    , Part(count, 0)
    , Level(count, none)
    , Queue(count)
  {
  }

  Dissection run()
  {
    const auto count = static_cast<Index>(this->Part.size());
    if (count > 0)
    {
      const Index visited = this->visit(0);
      this->split(0, count, this->Queue[visited - 1]);
    }
    return std::move(this->Result);
  }

private:
  /// Queues the part of a vertex breadth first from it, each with its distance as level. Levels of
  /// later visits are higher, so that none has to be taken back. \return how many are queued.
  Index visit(Index start)
  {
    const Index part = this->Part[start];
    const Index first = this->NextLevel;
    Index end = 0;
    this->Queue[end++] = start;
    this->Level[start] = first;
    for (Index at = 0; at < end; ++at)
    {
      const Index v = this->Queue[at];
      for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
      {
        const Index other = this->Neighbours[k];
        if (this->Part[other] == part && this->Level[other] < first)
        {
          this->Level[other] = this->Level[v] + 1;
          this->Queue[end++] = other;
        }
      }
    }
    this->NextLevel = this->Level[this->Queue[end - 1]] + 1;
    return end;
  }

  /// \param start a vertex at an end of the part that stands at order[begin] .. order[end - 1].
  void split(Index begin, Index end, Index start)
  {
    if (end - begin <= smallPart)
    {
      this->Result.endRange(end);
      return;
    }
    const auto order = this->Result.order.begin();
    const Index visited = this->visit(start);
    if (visited < end - begin)
    {
      this->splitComponents(begin, end);
      return;
    }
    const auto queue = this->Queue.begin();
    const Index middle = this->Level[queue[visited / 2]];
    const auto levelBegin = std::partition_point(
      queue, queue + visited, [&](Index v) { return this->Level[v] < middle; });
    const auto levelEnd = std::partition_point(
      levelBegin, queue + visited, [&](Index v) { return this->Level[v] == middle; });
    // A vertex of the middle level that touches none beyond it need not separate.
    const auto separator =
      this->separate(levelBegin, levelEnd, [&](Index n) { return this->Level[n] == middle + 1; });
    const Index leftEnd = begin + static_cast<Index>(separator - queue);
    const Index rightEnd = end - static_cast<Index>(levelEnd - separator);
    this->assign(queue, separator);
    this->assign(levelEnd, queue + visited);
    std::copy(queue, separator, order + begin);
    std::copy(levelEnd, queue + visited, order + leftEnd);
    std::copy(separator, levelEnd, order + rightEnd);
    // The last of each half in the queue is the farthest from its first.
    if (leftEnd > begin)
    {
      this->split(begin, leftEnd, order[leftEnd - 1]);
    }
    if (rightEnd > leftEnd)
    {
      this->split(leftEnd, rightEnd, order[rightEnd - 1]);
    }
    this->Result.endRange(end);
  }

  /// A part that does not hang together.
  void splitComponents(Index begin, Index end)
  {
    const auto order = this->Result.order.begin();
    const Indices vertices(order + begin, order + end);
    const Index part = this->Part[vertices.front()];
    Indices ends;
    Index place = begin;
    for (Index v : vertices)
    {
      if (this->Part[v] == part)
      {
        const Index visited = this->visit(v);
        std::copy(this->Queue.begin(), this->Queue.begin() + visited, order + place);
        this->assign(this->Queue.begin(), this->Queue.begin() + visited);
        place += visited;
        ends.push_back(place);
      }
    }
    for (Index next : ends)
    {
      this->split(begin, next, order[next - 1]);
      begin = next;
    }
  }

  void assign(Indices::iterator first, Indices::iterator last)
  {
    std::for_each(first, last, [this](Index v) { this->Part[v] = this->NextPart; });
    ++this->NextPart;
  }

  Indices Part;
  Indices Level;
  Indices Queue;
  Index NextLevel = 0;
  Index NextPart = 1;
};
}

Dissection dissect(const Triangles& cliques, const Points3& positions)
{
  return PlaneDissector(cliques, positions).run();
}

Dissection dissect(const Triangles& cliques, Index count)
{
  return LevelDissector(cliques, count).run();
}
}
