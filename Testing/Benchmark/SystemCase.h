// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PreparedPiece.h"

#include "Sparse/LinearSolver.h"

#include <string>

namespace benchmarks
{
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
