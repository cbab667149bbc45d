// SPDX-License-Identifier: BSD-3-Clause
#include "PreparedPiece.h"

#include "Angles/WireLayout.h"
#include "Embedding/InteriorEmbedding.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace benchmarks
{
using namespace flattening;

namespace
{
void require(const Status& status)
{
  if (!status.ok())
  {
    throw std::runtime_error(status.message);
  }
}
}

PreparedPiece::PreparedPiece(RefinedPiece source, const Execution& execution)
  : surface(std::move(source))
  , cut(cutSurface(this->surface.mesh, this->surface.curves))
{
  require(this->cut.status);
  std::vector<Piece> pieces = extractPieces(this->cut);
  this->piece =
    std::move(*std::max_element(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return a.mesh.triangleCount() < b.mesh.triangleCount();
    }));
  this->network = buildWireNetwork(this->piece);
  require(this->network.status);
  // Key curves are released, as in FlatteningBenchmark.
  NodeLocks locks;
  locks.locked.assign(this->network.nodeCount(), 0);
  locks.angle.assign(this->network.nodeCount(), 0.0);
  this->problem = makeAngleProblem(this->network, std::move(locks));
  this->angles = solveAnglesByNewton(this->problem, {}, execution);
  require(this->angles.status);
  this->wires = layOutWires(this->network, this->angles.theta, this->angles.length);
  this->rigid = this->wires;
  require(embedInterior(this->piece, this->network, {}, execution, this->rigid).status);
}
}
