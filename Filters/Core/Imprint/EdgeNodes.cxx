// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/EdgeNodes.h"

#include <algorithm>

namespace flattening
{
namespace
{
bool before(const NodeOnEdge& node, double fraction)
{
  return node.fraction < fraction;
}
}

Index EdgeNodes::nearest(Index edge, double fraction, double distance) const
{
  const auto found = this->Nodes.find(edge);
  if (found == this->Nodes.end())
  {
    return none;
  }
  const std::vector<NodeOnEdge>& nodes = found->second;
  const auto after = std::lower_bound(nodes.begin(), nodes.end(), fraction, before);
  Index node = none;
  double least = distance;
  if (after != nodes.begin() && fraction - (after - 1)->fraction <= least)
  {
    node = (after - 1)->node;
    least = fraction - (after - 1)->fraction;
  }
  if (after != nodes.end() && after->fraction - fraction <= least)
  {
    node = after->node;
  }
  return node;
}

void EdgeNodes::insert(Index edge, double fraction, Index node)
{
  std::vector<NodeOnEdge>& nodes = this->Nodes[edge];
  nodes.insert(std::lower_bound(nodes.begin(), nodes.end(), fraction, before), { fraction, node });
}

std::vector<NodeOnEdge> EdgeNodes::along(const TriangleMesh& mesh, Index halfedge) const
{
  const Index edge = edgeOf(mesh, halfedge);
  const auto found = this->Nodes.find(edge);
  if (found == this->Nodes.end())
  {
    return {};
  }
  std::vector<NodeOnEdge> nodes = found->second;
  if (edge != halfedge)
  {
    std::reverse(nodes.begin(), nodes.end());
    for (NodeOnEdge& node : nodes)
    {
      node.fraction = 1.0 - node.fraction;
    }
  }
  return nodes;
}
}
