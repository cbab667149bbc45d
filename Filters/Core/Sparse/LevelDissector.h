// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/Dissector.h"

namespace flattening
{
/// Halves parts by their level structure.
class LevelDissector : protected Dissector
{
public:
  LevelDissector(const Triangles& cliques, Index count)
    : Dissector(cliques, count)
    , Level(count, none)
    , Queue(count)
  {
  }

  Dissection run()
  {
    return this->divideAll(this->Queue.empty() ? none : this->Queue[this->visit(0) - 1]);
  }

protected:
  /// Divides a part by levels where their separator is smaller than another one of it.
  bool divideByLevels(const Step& part, Index cost)
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

  void divide(const Step& part) override
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

  Indices Level;
  Indices Queue;
  Index NextLevel = 0;
};
}
