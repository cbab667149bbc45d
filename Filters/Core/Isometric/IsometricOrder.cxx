// SPDX-License-Identifier: BSD-3-Clause
// The order of elimination of IsometricModel.
#include "Isometric/IsometricModel.h"

#include <algorithm>

namespace flattening
{
/// Per vertex.
std::vector<char> IsometricModel::hubsOfWires() const
{
  const WireNetwork& net = *this->Problem.network;
  Indices valence(this->CoordinateCount / 2, 0);
  for (Index e : this->LengthEdges)
  {
    ++valence[net.edges[e].from];
    ++valence[net.edges[e].to];
  }
  std::vector<char> hub(valence.size());
  std::transform(valence.begin(), valence.end(), hub.begin(),
    [enough = hubValence(this->lengthCount())](Index wires) { return wires > enough; });
  return hub;
}

Dissection dissectVertices(
  const TriangleMesh& mesh, const WireNetwork& network, const Points2& positions)
{
  // The ends of a wire-node's two edges are coupled as if a triangle joined them.
  Triangles cliques = mesh.triangles();
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    cliques.push_back(
      { network.vertex[network.previous[i]], network.vertex[i], network.endVertex(i) });
  }
  Points3 places;
  places.reserve(positions.size());
  for (const Point2& p : positions)
  {
    places.emplace_back(p.x(), p.y(), 0.0);
  }
  return dissect(cliques, places, Separators::Fewest);
}

Dissection IsometricModel::eliminationOrder(const Dissection& dissection) const
{
  const WireNetwork& net = *this->Problem.network;
  const Indices& vertices = dissection.order;
  Indices place(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    place[vertices[k]] = static_cast<Index>(k);
  }
  // Behind a hub of wires they would stand together, all coupled: there they come before it, one
  // after each other end, which has two coordinates to pay for it.
  const std::vector<char> hub = this->hubsOfWires();
  std::vector<char> paid(vertices.size(), 0);
  std::vector<Indices> constraintsAfter(vertices.size());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const WireEdge& edge = net.edges[this->LengthEdges[k]];
    Index after = std::max(place[edge.from], place[edge.to]);
    const Index before = std::min(place[edge.from], place[edge.to]);
    if (hub[vertices[after]] && !hub[vertices[before]] && !paid[before])
    {
      paid[before] = 1;
      after = before;
    }
    constraintsAfter[after].push_back(k);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const Node& node = this->LockedNodes[k];
    const Index ends = std::max(place[node.before], place[node.after]);
    constraintsAfter[hub[node.at] ? ends : std::max(ends, place[node.at])].push_back(
      this->lengthCount() + static_cast<Index>(k));
  }
  Dissection result = dissection.replaced([&](Index k, Indices& order) {
    order.push_back(2 * vertices[k]);
    order.push_back(2 * vertices[k] + 1);
    for (Index constraint : constraintsAfter[k])
    {
      order.push_back(this->unknownCount() + constraint);
    }
  });
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    result.order.push_back(this->CoordinateCount + g);
  }
  if (this->Hold.holds())
  {
    result.order.push_back(
      this->unknownCount() + this->holdRow()); // it couples what lies far apart
  }
  result.endRange(static_cast<Index>(result.order.size()));
  return result;
}
}
