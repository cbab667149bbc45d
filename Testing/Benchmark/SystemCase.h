// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"
#include "Base/Execution.h"
#include "Cut/SurfaceCut.h"
#include "RefinedPiece.h"
#include "Sparse/LinearSolver.h"

#include <string>

namespace benchmarks
{
/// What each stage is fed with: the result of the stages before it, on the largest piece.
class PreparedPiece
{
public:
  /// Throws std::runtime_error where a stage refuses its input.
  PreparedPiece(RefinedPiece source, const flattening::Execution& execution);
  PreparedPiece(const PreparedPiece&) = delete; // the problem refers to the network
  PreparedPiece& operator=(const PreparedPiece&) = delete;

  RefinedPiece surface;
  flattening::CutSurface cut;
  flattening::Piece piece;
  flattening::WireNetwork network;
  flattening::AngleProblem problem;
  flattening::AngleSolution angles;
  flattening::Points2 wires; ///< positions of the wires, zero between them
  flattening::Points2 rigid; ///< positions with the interior as rigid as possible
};

/// A linear system as flattening solves it, with the order of elimination that it takes.
struct SystemCase
{
  std::string name;
  flattening::SparseMatrix lower; ///< triangle of the symmetric matrix
  flattening::Dissection order;
  double orderSeconds = 0.0; ///< what finding it took
  bool definite = false;     ///< positive definite; otherwise quasi-definite
  Eigen::MatrixXd rightHandSide;
};

/// The cotangent Laplacian of all vertices off the wires, with a column each for x and y.
SystemCase interiorSystem(const PreparedPiece& piece);

/// The first Newton step of the isometric scheme: all coordinates and the wires' lengths.
SystemCase isometricSystem(const PreparedPiece& piece, const flattening::Execution& execution);
}
