// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/NestedDissection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
/// Halves parts by planes across their longest extent, or by their level structure.
class Dissector
{
public:
  /// \param positions per vertex; null: by levels
  Dissector(const Triangles& cliques, Index count, const Points3* positions)
    : Begin(count + 1, 0)
    , Part(count, 0)
    , Level(count, none)
    , Queue(count)
    , Positions(positions)
    , Rank(positions ? count : 0, none)
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

  Dissection run()
  {
    const bool byLevels = !this->Positions && !this->Queue.empty();
    this->pushPart(
      0, static_cast<Index>(this->Part.size()), byLevels ? this->Queue[this->visit(0) - 1] : none);
    while (!this->Steps.empty())
    {
      const Step step = this->Steps.back();
      this->Steps.pop_back();
      if (step.begin == none || step.end - step.begin <= smallPart)
      {
        this->Result.endRange(step.end);
        continue;
      }
      if (this->AnyHub && this->takeHubs(step))
      {
        continue;
      }
      if (this->Positions)
      {
        this->divideByPlane(step);
      }
      else
      {
        this->divideByLevels(step);
      }
    }
    return std::move(this->Result);
  }

private:
  using Iterator = Indices::iterator;

  /// A part that stands at order[begin] .. order[end - 1] and is to be divided from a vertex at one
  /// of its ends, or the end of a range alone.
  struct Step
  {
    Index begin;
    Index end;
    Index start;
  };

  void pushEnd(Index end) { this->Steps.push_back({ none, end, none }); }
  void pushPart(Index begin, Index end, Index start)
  {
    if (begin < end)
    {
      this->Steps.push_back({ begin, end, start });
    }
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

  /// Divides a part by levels where their separator is smaller than another one of it.
  bool divideByFewerLevels(const Step& part, Index cost)
  {
    const auto first = this->Result.order.begin() + part.begin;
    this->assign(first, this->Result.order.begin() + part.end);
    const Index visited = this->visit(*first);
    if (visited < part.end - part.begin)
    {
      this->divideComponents(part);
      return true;
    }
    this->visit(this->Queue[visited - 1]);
    return this->divideQueue(part, cost - 1);
  }

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

  void divideByLevels(const Step& part)
  {
    const Index visited = this->visit(part.start);
    if (visited < part.end - part.begin)
    {
      this->divideComponents(part);
      return;
    }
    this->divideQueue(part, visited);
  }

  /// By the levels of all its vertices in the queue. False where the separator has more vertices
  /// than allowed.
  bool divideQueue(const Step& part, Index most)
  {
    const auto order = this->Result.order.begin();
    const Index visited = part.end - part.begin;
    const auto queue = this->Queue.begin();
    // Beyond the last level is none, so that the one before it is the last that can separate.
    const Index middle =
      std::min(this->Level[queue[visited / 2]], this->Level[queue[visited - 1]] - 1);
    const auto levelBegin = std::partition_point(
      queue, queue + visited, [&](Index v) { return this->Level[v] < middle; });
    const auto levelEnd = std::partition_point(
      levelBegin, queue + visited, [&](Index v) { return this->Level[v] == middle; });
    // A vertex of the middle level that touches none beyond it need not separate.
    const auto separator =
      this->separate(levelBegin, levelEnd, [&](Index n) { return this->Level[n] == middle + 1; });
    if (levelEnd - separator > most)
    {
      return false;
    }
    const Index leftEnd = part.begin + static_cast<Index>(separator - queue);
    const Index rightEnd = part.end - static_cast<Index>(levelEnd - separator);
    this->assign(queue, separator);
    this->assign(levelEnd, queue + visited);
    std::copy(queue, separator, order + part.begin);
    std::copy(levelEnd, queue + visited, order + leftEnd);
    std::copy(separator, levelEnd, order + rightEnd);
    // The last of each half in the queue is the farthest from its first.
    this->pushEnd(part.end);
    this->pushPart(leftEnd, rightEnd, order[rightEnd - 1]);
    this->pushPart(part.begin, leftEnd, leftEnd > part.begin ? order[leftEnd - 1] : none);
    return true;
  }

  /// A part that does not hang together.
  void divideComponents(const Step& whole)
  {
    const auto order = this->Result.order.begin();
    const Indices vertices(order + whole.begin, order + whole.end);
    const Index part = this->Part[vertices.front()];
    Indices ends{ whole.begin };
    for (Index v : vertices)
    {
      if (this->Part[v] == part)
      {
        const Index visited = this->visit(v);
        std::copy(this->Queue.begin(), this->Queue.begin() + visited, order + ends.back());
        this->assign(this->Queue.begin(), this->Queue.begin() + visited);
        ends.push_back(ends.back() + visited);
      }
    }
    for (std::size_t k = ends.size() - 1; k > 0; --k)
    {
      this->pushPart(ends[k - 1], ends[k], order[ends[k] - 1]);
    }
  }

  void divideByPlane(const Step& part)
  {
    const Iterator begin = this->Result.order.begin() + part.begin;
    const Iterator end = this->Result.order.begin() + part.end;
    const Iterator middle = this->sortAcross(begin, end);
    this->assign(begin, middle);
    const Index right = this->assign(middle, end);
    const Iterator separator =
      this->separate(begin, middle, [&](Index n) { return this->Part[n] == right; });
    const Iterator separatorEnd = std::rotate(separator, middle, end);
    // A plane across many long triangles has more next to it than levels, which count edges.
    const auto cost = static_cast<Index>(end - separatorEnd);
    if (cost > manyInSeparator * std::sqrt(static_cast<double>(end - begin)) &&
      this->divideByFewerLevels(part, cost))
    {
      return;
    }
    const auto leftEnd = part.begin + static_cast<Index>(separator - begin);
    const auto rightEnd = part.begin + static_cast<Index>(separatorEnd - begin);
    this->pushEnd(part.end);
    this->pushPart(leftEnd, rightEnd, none);
    this->pushPart(part.begin, leftEnd, none);
  }

  /// Sorts a part along its longest extent. \return where the plane is, among places near the
  /// middle, that has the fewest vertices next to it on its left: those are the separator
  Iterator sortAcross(Iterator begin, Iterator end)
  {
    Eigen::AlignedBox3d box;
    std::for_each(begin, end, [&](Index v) { box.extend((*this->Positions)[v]); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    this->Along.clear();
    std::for_each(
      begin, end, [&](Index v) { this->Along.emplace_back((*this->Positions)[v][axis], v); });
    const auto count = static_cast<Index>(end - begin);
    const auto reach = static_cast<Index>(nearMiddle * count);
    const Index first = count / 2 - reach;
    const Index last = count / 2 + reach + 1;
    const auto along = this->Along.begin();
    std::nth_element(along, along + first, this->Along.end());
    std::nth_element(along + first, along + last, this->Along.end());
    std::sort(along + first, along + last);
    const Index part = this->assign(begin, end);
    for (Index k = 0; k < count; ++k)
    {
      *(begin + k) = this->Along[k].second;
      this->Rank[this->Along[k].second] = std::min(k, last);
    }
    // How many more there are next to a plane than next to the one before.
    this->More.assign(last - first + 2, 0);
    for (Index k = 0; k < last; ++k)
    {
      const Index v = *(begin + k);
      Index farthest = k;
      for (Index a = this->Begin[v]; a < this->Begin[v + 1]; ++a)
      {
        const Index n = this->Neighbours[a];
        farthest = this->Part[n] == part ? std::max(farthest, this->Rank[n]) : farthest;
      }
      if (farthest >= first && farthest > k)
      {
        ++this->More[std::max(k + 1 - first, 0)];
        --this->More[farthest + 1 - first];
      }
    }
    Index fewest = count;
    Index plane = first;
    Index beside = 0;
    for (Index k = first; k < last; ++k)
    {
      beside += this->More[k - first];
      if (k > 0 && (beside < fewest || (beside == fewest && k <= count / 2)))
      {
        fewest = beside;
        plane = k;
      }
    }
    return begin + plane;
  }

  /// How far planes are looked for from the middle, as a share of the part.
  static constexpr double nearMiddle = 0.1;
  /// A separator of more vertices than this multiple of the root of the part's is a bad one.
  static constexpr double manyInSeparator = 2.0;

  /// Parts of so few vertices are not divided: a dense block of them costs less.
  static constexpr Index smallPart = 12;

  Indices Begin; ///< neighbours of each vertex, in flat arrays; inner edges twice
  Indices Neighbours;
  Indices Part; ///< mark of each vertex
  Index NextPart = 1;
  bool AnyHub = false;
  std::vector<Step> Steps;
  Dissection Result;
  Indices Level;
  Index NextLevel = 0;
  Indices Queue;
  const Points3* Positions;
  std::vector<std::pair<double, Index>> Along; ///< coordinate across the plane, vertex
  Indices Rank;                                ///< of each vertex across the planes
  Indices More;
};
}

Dissection dissect(const Triangles& cliques, const Points3& positions)
{
  return Dissector(cliques, static_cast<Index>(positions.size()), &positions).run();
}

Dissection dissect(const Triangles& cliques, Index count)
{
  return Dissector(cliques, count, nullptr).run();
}
}
