// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/FactorBlocks.h"
#include "Sparse/SupernodalStructure.h"

namespace flattening
{
/// L D L^T of a sparse symmetric matrix without pivoting, by dense blocks: the multifrontal method
/// (J. W. H. Liu, "The multifrontal method for sparse matrix solution", SIAM Review 34(1), 1992).
///
/// For quasi-definite matrices, such as KKT matrices with a small -delta I block, where any order
/// of elimination works. Subtrees of the elimination run in parallel; the result does not depend on
/// the number of threads.
class MultifrontalFactorization
{
public:
  explicit MultifrontalFactorization(FactorPrecision precision = FactorPrecision::Double)
    : Blocks(precision)
  {
  }
  FactorPrecision precision() const { return this->Blocks.precision(); }
  /// Keeps the next factors in this way. There is none until then.
  void setPrecision(FactorPrecision precision) { this->Blocks = FactorBlocks(precision); }
  /// Finds the structure for the pattern of a symmetric matrix; the lower triangle is read.
  /// \param dissection of its columns.
  void analyze(const Eigen::SparseMatrix<double>& matrix, const Dissection& dissection);
  /// Factors a matrix of that pattern. False where it is of another, a pivot is zero or not finite,
  /// or the run is cancelled.
  bool factorize(const Eigen::SparseMatrix<double>& matrix, const Execution& execution);
  Eigen::MatrixXd solve(
    const Eigen::MatrixXd& rightHandSide, const Execution& execution = {}) const;
  /// Entries of D in the order of elimination.
  const Eigen::VectorXd& diagonal() const { return this->Diagonal; }

private:
  using Supernode = SupernodalStructure::Supernode;

  void chooseTasks();
  void planTop();
  bool eliminateAll(const double* values, const Execution& execution);
  bool eliminate(
    Index s, const double* values, std::vector<double>& work, const Execution& execution);
  void addChild(const DenseFront& front, Index child, BlockedLowerTriangle& update);
  void substitute(Eigen::MatrixXd& x, const Execution& execution) const;
  void substituteForward(const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& passed,
    Eigen::MatrixXd& work) const;
  void substituteBackward(const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& work) const;

  SupernodalStructure Structure;
  std::vector<Indices> Tasks; ///< supernodes of subtrees that are independent of each other
  Indices FirstRoots;         ///< of each task the root of its first subtree
  Indices Top;                ///< the others
  /// The same by the round of tasks after which they can be eliminated, and by height: those of one
  /// height do not depend on each other.
  std::vector<std::vector<Indices>> TopByRound;
  FactorBlocks Blocks;                       ///< L below the diagonal, by supernodes
  std::vector<BlockedLowerTriangle> Updates; ///< of supernodes whose parent has not taken them yet
  Eigen::VectorXd Diagonal;
};
}
