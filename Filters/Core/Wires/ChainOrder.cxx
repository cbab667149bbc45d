// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/ChainOrder.h"

#include <algorithm>

namespace flattening
{
ChainOrder::ChainOrder(const WireNetwork& network)
{
  this->degree.assign(network.hostVertices.size(), 0);
  for (const WireEdge& edge : network.edges)
  {
    ++this->degree[network.hostOfVertex[edge.from]];
    ++this->degree[network.hostOfVertex[edge.to]];
  }
  std::vector<char> junction;
  for (Index d : this->degree)
  {
    junction.push_back(d == 2 ? 0 : 1);
  }
  for (const WireEdge& edge : network.edges)
  {
    this->atJunction.push_back(
      junction[network.hostOfVertex[edge.from]] | junction[network.hostOfVertex[edge.to]]);
  }
  this->hostsAlong = static_cast<Index>(std::count(junction.begin(), junction.end(), 0));
  this->edgesAlong =
    static_cast<Index>(std::count(this->atJunction.begin(), this->atJunction.end(), 0));
  this->rankOfHost = markedLast(junction);
  this->rankOfEdge = markedLast(this->atJunction);
}

Indices markedLast(const std::vector<char>& marked)
{
  Indices rank(marked.size());
  Index next = 0;
  for (char mark : { 0, 1 })
  {
    for (std::size_t i = 0; i < marked.size(); ++i)
    {
      if (marked[i] == mark)
      {
        rank[i] = next++;
      }
    }
  }
  return rank;
}
}
