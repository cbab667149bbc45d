// SPDX-License-Identifier: BSD-3-Clause
#include "NestedDissection.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{
constexpr std::ptrdiff_t leafSize = 12;

class Dissector
{
public:
  Dissector(const Triangles& cliques, const Points3& positions)
    : Positions(positions)
    , Begin(positions.size() + 1, 0)
    , Side(positions.size(), none)
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
  }

  Dissection run()
  {
    Indices& order = this->Result.order;
    order.resize(this->Positions.size());
    std::iota(order.begin(), order.end(), 0);
    this->split(order.begin(), order.end());
    return std::move(this->Result);
  }

private:
  using Iterator = Indices::iterator;

  void split(Iterator begin, Iterator end)
  {
    if (end - begin <= leafSize)
    {
      this->endRange(end);
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
    const Iterator separator = std::stable_partition(begin, middle, [&](Index v) {
      return std::none_of(this->Neighbours.begin() + this->Begin[v],
        this->Neighbours.begin() + this->Begin[v + 1],
        [&](Index n) { return this->Side[n] == right; });
    });
    const std::ptrdiff_t leftCount = separator - begin;
    const std::ptrdiff_t separatorCount = middle - separator;
    std::rotate(separator, middle, end);
    this->split(begin, begin + leftCount);
    this->split(begin + leftCount, end - separatorCount);
    this->endRange(end);
  }

  void endRange(Iterator end)
  {
    const auto place = static_cast<Index>(end - this->Result.order.begin());
    const Index last = this->Result.end.empty() ? 0 : this->Result.end.back();
    if (place > last)
    {
      this->Result.end.push_back(place);
    }
  }

  const Points3& Positions;
  Indices Begin;
  Indices Neighbours;
  Indices Side;
  std::vector<std::pair<double, Index>> Along; ///< coordinate across the cut, vertex
  Index NextMark = 0;
  Dissection Result;
};
}

Dissection dissect(const Triangles& cliques, const Points3& positions)
{
  return Dissector(cliques, positions).run();
}
}
