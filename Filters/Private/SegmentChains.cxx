// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentChains.h"

#include <algorithm>
#include <map>

namespace flattening
{
namespace bridge
{
std::vector<SegmentChain> chainSegments(const std::vector<std::array<vtkIdType, 2>>& segments)
{
  std::map<vtkIdType, std::vector<std::size_t>> segmentsAt;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    segmentsAt[segments[s][0]].push_back(s);
    segmentsAt[segments[s][1]].push_back(s);
  }
  std::vector<char> used(segments.size(), 0);
  // Goes on from the last point as long as there is one way.
  auto extend = [&](std::vector<vtkIdType>& points) {
    for (;;)
    {
      const vtkIdType end = points.back();
      const std::vector<std::size_t>& here = segmentsAt[end];
      if (here.size() != 2 || (used[here[0]] && used[here[1]]))
      {
        return;
      }
      const std::size_t s = used[here[0]] ? here[1] : here[0];
      used[s] = 1;
      points.push_back(segments[s][0] == end ? segments[s][1] : segments[s][0]);
    }
  };
  std::vector<SegmentChain> chains;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    if (used[s])
    {
      continue;
    }
    used[s] = 1;
    std::vector<vtkIdType> forward{ segments[s][1] };
    std::vector<vtkIdType> backward{ segments[s][0] };
    extend(forward);
    extend(backward);
    SegmentChain chain;
    chain.firstSegment = s;
    chain.points.assign(backward.rbegin(), backward.rend());
    chain.points.insert(chain.points.end(), forward.begin(), forward.end());
    chains.push_back(std::move(chain));
  }
  return chains;
}
}
}
