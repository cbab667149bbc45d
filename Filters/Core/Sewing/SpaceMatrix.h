// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace flattening
{
/// The lower triangle of a symmetric sparse matrix of three unknowns a vertex, its x, y and z, that
/// is filled again and again in one pattern.
///
/// Vertices go by the unknown of their x, a multiple of three; what concerns none is left out. The
/// place of an entry follows from its vertices, so that none is stored for what is added.
class SpaceMatrix
{
public:
  /// \param size how many unknowns.
  explicit SpaceMatrix(Index size)
    : Size(size)
  {
  }
  /// Declares that all unknowns of two vertices are coupled; those of one always are.
  void couple(Index a, Index b) { this->declare(a, b, false); }
  /// Declares that x is coupled with x, y with y and z with z.
  void coupleAxes(Index a, Index b) { this->declare(a, b, true); }
  /// Finds the pattern of all that is declared.
  void finish();

  void clear();
  /// Adds a symmetric block of one vertex.
  void addOwn(Index a, const Eigen::Matrix3d& block);
  /// Adds a block in the rows of a and the columns of b and its transpose, where a and b may be the
  /// same vertex.
  /// \pre couple(a, b)
  void addPair(Index a, Index b, const Eigen::Matrix3d& block);
  /// The same of a multiple of the unit matrix.
  /// \pre couple(a, b) or coupleAxes(a, b)
  void addPair(Index a, Index b, double value);
  /// Adds to the diagonal.
  void shift(double value);
  const Eigen::SparseMatrix<double>& matrix() const { return this->Matrix; }

private:
  /// What a vertex is coupled with that has higher unknowns.
  struct Neighbour
  {
    Index vertex;
    Index offset; ///< of its rows behind those of the vertex itself in a column
    bool all;     ///< its three rows are in each column, not one
  };
  void declare(Index a, Index b, bool axes);
  const Neighbour& neighbour(Index low, Index high) const;
  double* column(Index vertex, Index axis);

  Index Size;
  std::vector<std::uint64_t> Declared; ///< pairs of vertices, the lower one first
  Indices Begin;                       ///< per vertex into the neighbours
  std::vector<Neighbour> Neighbours;
  Eigen::SparseMatrix<double> Matrix;
};
}
