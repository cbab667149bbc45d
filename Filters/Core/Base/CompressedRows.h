// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
/// Members by group as ranges of one array (compressed rows): those of group g are
/// members[begin[g]] up to members[begin[g + 1] - 1], in the order in which they came.
struct CompressedRows
{
  Indices begin{ 0 };
  Indices members;

  /// The members of a group, to be gone through.
  struct Range
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return this->first; }
    const Index* end() const { return this->last; }
  };
  Range operator[](std::size_t group) const
  {
    return { this->members.data() + this->begin[group],
      this->members.data() + this->begin[group + 1] };
  }
};

/// Groups what a loop visits by counting, without a sort and with two allocations.
/// \param forEach calls its argument as visit(group, member) for every member; it is called twice and
/// must visit the same both times.
template <class ForEach>
CompressedRows groupMembers(std::size_t groups, const ForEach& forEach)
{
  CompressedRows result;
  result.begin.assign(groups + 1, 0);
  forEach([&](Index group, Index) { ++result.begin[group + 1]; });
  for (std::size_t g = 0; g < groups; ++g)
  {
    result.begin[g + 1] += result.begin[g];
  }
  result.members.resize(result.begin.back());
  Indices place(result.begin.begin(), result.begin.end() - 1);
  forEach([&](Index group, Index member) { result.members[place[group]++] = member; });
  return result;
}

/// Groups 0, 1, 2, ... by the group that each is in.
inline CompressedRows groupBy(std::size_t groups, const Indices& groupOf)
{
  return groupMembers(groups, [&groupOf](const auto& visit) {
    for (std::size_t k = 0; k < groupOf.size(); ++k)
    {
      visit(groupOf[k], static_cast<Index>(k));
    }
  });
}

/// Sets of numbers from 0 on that are joined pair by pair; the least member names its set.
class JoinedSets
{
public:
  explicit JoinedSets(Index count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  Index find(Index k)
  {
    while (this->Parent[k] != k)
    {
      k = this->Parent[k] = this->Parent[this->Parent[k]];
    }
    return k;
  }
  void join(Index a, Index b)
  {
    a = this->find(a);
    b = this->find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  Indices Parent;
};
}
