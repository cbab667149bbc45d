// SPDX-License-Identifier: BSD-3-Clause
#include "SystemCase.h"

#include "Angles/WireLayout.h"
#include "Base/Execution.h"
#include "Embedding/InteriorEmbedding.h"
#include "Isometric/IsometricModel.h"
#include "Isometric/IsometricWarping.h"
#include "Sparse/SymmetricAssembler.h"
#include "Surface/TriangleFrame.h"

#include <algorithm>
#include <limits>
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

/// As small as the Newton iteration takes it.
constexpr double regularization = 1e-8;
/// Of finding the order, of which the least counts.
constexpr int repeats = 3;

template <class Find>
void findOrder(SystemCase& system, const Find& find)
{
  system.orderSeconds = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repeats; ++k)
  {
    const Stopwatch watch;
    system.order = find();
    system.orderSeconds = std::min(system.orderSeconds, watch.seconds());
  }
}

/// Numbers the vertices off the wires; none on them.
Indices interiorNumbers(const PreparedPiece& p, Points3& positions)
{
  Indices number(p.piece.mesh.vertexCount(), 0);
  for (const WireEdge& edge : p.network.edges)
  {
    number[edge.from] = none;
    number[edge.to] = none;
  }
  for (Index v = 0; v < p.piece.mesh.vertexCount(); ++v)
  {
    if (number[v] != none)
    {
      number[v] = static_cast<Index>(positions.size());
      positions.push_back(p.piece.mesh.point(v));
    }
  }
  return number;
}

/// The corners that are free, one of them again where there are fewer than three.
Triangles couplings(const Triangles& cells, const Indices& number)
{
  Triangles result;
  for (const Triangle& cell : cells)
  {
    Triangle clique{ number[cell[0]], number[cell[1]], number[cell[2]] };
    const Index some = *std::max_element(clique.begin(), clique.end());
    if (some != none)
    {
      std::replace(clique.begin(), clique.end(), none, some);
      result.push_back(clique);
    }
  }
  return result;
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

SystemCase interiorSystem(const PreparedPiece& p)
{
  Points3 positions;
  const Indices number = interiorNumbers(p, positions);
  const Triangles cells = p.piece.mesh.triangles();
  const auto size = static_cast<Index>(positions.size());
  SymmetricAssembler assembler(size);
  const auto forEntries = [&](const auto& visit) {
    for (const Triangle& cell : cells)
    {
      const TriangleFrame frame(
        p.piece.mesh.point(cell[0]), p.piece.mesh.point(cell[1]), p.piece.mesh.point(cell[2]));
      for (int a = 0; a < 3; ++a)
      {
        for (int b = 0; b <= a; ++b)
        {
          if (number[cell[a]] != none && number[cell[b]] != none)
          {
            visit(number[cell[a]], number[cell[b]],
              4.0 * frame.area * (std::conj(frame.gradient[a]) * frame.gradient[b]).real());
          }
        }
      }
    }
  };
  forEntries([&](Index i, Index j, double) { assembler.declare(i, j); });
  assembler.finish();
  assembler.clear();
  Index entry = 0;
  forEntries([&](Index, Index, double value) { assembler.add(entry++, value); });
  SystemCase system{ "interior, Laplacian", assembler.matrix(), {}, 0.0, true,
    Eigen::MatrixXd::Random(size, 2) };
  findOrder(system, [&] { return dissect(couplings(cells, number), positions); });
  return system;
}

SystemCase isometricSystem(const PreparedPiece& p, const Execution& execution)
{
  const IsometricOptions options;
  IsometricModel model(p.piece, p.problem, options.energy, options.angleWeight);
  const Eigen::VectorXd x = model.unknowns(p.rigid, p.angles.stretch);
  model.linearize(x, Eigen::VectorXd::Zero(model.constraintCount()), Curvature::Convex,
    regularization, execution);
  SystemCase system{ "isometric, KKT", model.kkt(), {}, 0.0, false,
    Eigen::MatrixXd::Random(model.kkt().rows(), 1) };
  findOrder(system, [&] {
    return model.eliminationOrder(dissectVertices(p.piece.mesh.triangles(), p.network, p.rigid));
  });
  return system;
}
}
