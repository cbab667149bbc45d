// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/LinearSolver.h"
#include "Surface/TriangleFrame.h"
#include "Wires/WireNetwork.h"

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

/// Matrices sum_edges w (e_i - e_j)(e_i - e_j)^T over the interior vertices of one patch, the
/// weight of an edge being the sum of those that its triangles give it. All have one sparsity
/// pattern.
class PatchMatrix
{
public:
  explicit PatchMatrix(const InteriorPatch& patch);

  /// The lower triangle.
  const SparseMatrix& assemble(const InteriorPatch& patch, const std::vector<EdgeWeights>& weights);

private:
  SparseMatrix Matrix;
  /// Places in Matrix.valuePtr(): of the edge opposite to each corner, none at a wire vertex.
  Triangles EdgePlace;
};
}
