// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/LinearSolver.h"
#include "Sparse/SymmetricAssembler.h"
#include "Surface/TriangleFrame.h"
#include "Wires/WireNetwork.h"

#include <array>
#include <memory>
#include <vector>

namespace flattening
{
/// The part of a wire-patch that its interior vertices take part in, in ids of its own: the first
/// freeCount vertices are interior, the others stand on wires.
struct InteriorPatch
{
  Index patch = none;
  Index freeCount = 0;
  /// Piece vertex of each, first the interior ones, then all of the wire-patch's wires, ascending.
  Indices vertices;
  Triangles triangles; ///< those with an interior corner
};

/// The wire-patches that have interior vertices.
std::vector<InteriorPatch> collectInteriorPatches(const Piece& piece, const WireNetwork& network);

/// The same with only those of the interior vertices free that are marked; the others beside them
/// are held like those on wires.
/// \param marked per vertex of the patch.
InteriorPatch restrictedTo(const InteriorPatch& patch, const std::vector<char>& marked);

/// Weight of the edge opposite to each corner.
using EdgeWeights = std::array<double, 3>;

/// Weights of a patch's edges.
enum class InteriorWeights
{
  InverseLength, ///< of Eq. 11
  Cotangent,     ///< half the cotangents of the angles opposite to an edge: the harmonic map
};

/// The linear systems of one wire-patch's inside, which depend on the surface alone. They outlive a
/// run, so that the next one takes over what has not changed: the factors where the vertices are
/// where they were, the symbolic part where only the triangles are the same. Either way the
/// solutions are the same to the last bit.
class InteriorSystem
{
public:
  /// Takes the patch of another run over.
  void update(InteriorPatch patch, const TriangleMesh& mesh);

  const InteriorPatch& patch() const { return this->Patch; }
  const TriangleFrames& frames();

  /// The factored matrix; null where it is not definite, or the run is cancelled.
  const LinearSolver* factor(InteriorWeights weights, const Execution& execution);
  /// Puts each interior vertex into the weighted mean of its neighbours; one factorization for x
  /// and y. False, with nothing moved, where there is no factor.
  /// \param positions of the patch's vertices, in and out.
  bool solve(InteriorWeights weights, const Execution& execution, Eigen::MatrixXd& positions);
  /// Weights of the edge opposite to each corner.
  std::vector<EdgeWeights> edgeWeights(InteriorWeights weights);

  /// Gives the memory of all factors back.
  void forgetFactors();

private:
  struct Factor
  {
    std::unique_ptr<LinearSolver> solver;
    std::vector<EdgeWeights> edges;
    bool current = false; ///< of the vertices where they are
  };

  InteriorPatch Patch;
  Points3 Points;                                ///< of the patch's vertices on the surface
  TriangleFrames Frames;                         ///< empty until they are asked for
  std::unique_ptr<SymmetricAssembler> Assembler; ///< null until a matrix is asked for
  std::array<Factor, 2> Factors;                 ///< by weights

  const SparseMatrix& assemble(const std::vector<EdgeWeights>& weights);
  Factor& factorOf(InteriorWeights weights)
  {
    return this->Factors[weights == InteriorWeights::Cotangent ? 1 : 0];
  }
};

/// Those of one piece, by wire-patch.
struct InteriorSystems
{
  std::vector<InteriorSystem> patches;
  /// They are those of the piece and the network that they are used with. Whoever changes one of
  /// the two says so here; what the systems can take over then they find out themselves.
  bool current = false;
};
}
