// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/ConformalStart.h"

#include "Embedding/LeastSquaresConformalMap.h"

namespace flattening
{
AngleStart conformalStart(
  const Piece& piece, const WireNetwork& network, const Execution& execution)
{
  AngleStart start;
  start.theta = network.alpha;
  for (const WireEdge& edge : network.edges)
  {
    start.length.push_back(edge.length);
  }
  const LeastSquaresConformalMap map = leastSquaresConformalMap(piece.mesh, {}, execution);
  if (!map.status.ok())
  {
    return start;
  }
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    start.length[e] = (map.positions[edge.to] - map.positions[edge.from]).norm();
  }
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    const bool tip = network.edge[i] == network.edge[network.previous[i]];
    start.theta[i] = tip ? 2.0 * pi
                         : interiorAngle(map.positions[network.vertex[network.previous[i]]],
                             map.positions[network.vertex[i]], map.positions[network.endVertex(i)]);
  }
  return start;
}
}
