// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/FactorBlocks.h"
#include "Sparse/NestedDissection.h"

#include <Eigen/SparseCore>
#include <cstdint>

namespace flattening
{
/// The symbolic part of a sparse symmetric factorization: which columns of L are eliminated
/// together, and which rows they have (T. A. Davis, "Direct Methods for Sparse Linear Systems",
/// 2006, chapter 4). The ranges of a dissection are the supernodes: their columns have nearly the
/// same rows, and the zeros that are stored where they do not cost less than finding them.
///
/// Columns are numbered anew, in the order of elimination, so that a supernode is a range of them.
class SupernodalStructure
{
public:
  struct Supernode
  {
    Index first = 0; ///< columns [first, end)
    Index end = 0;
    Index rowsBegin = 0; ///< into rows(): those below the diagonal block, ascending
    Index rowsEnd = 0;
    Index entriesBegin = 0; ///< into entries()
    Index entriesEnd = 0;
    Index parent = none;
    std::size_t block = 0; ///< where its columns of L begin
    Indices children;

    Index columnCount() const { return this->end - this->first; }
    Index rowCount() const { return this->rowsEnd - this->rowsBegin; }
    Index frontSize() const { return this->columnCount() + this->rowCount(); }
    /// Of its (columns + rows) x columns block.
    std::size_t blockSize() const
    {
      return std::size_t(this->frontSize()) * std::size_t(this->columnCount());
    }
  };
  /// A stored entry of the matrix, and where it goes in the block of its supernode.
  struct Entry
  {
    Index stored; ///< into the matrix's values
    Index place;
  };

  SupernodalStructure() = default;
  /// \param matrix symmetric and compressed; only the pattern of its lower triangle counts. \param dissection of its
  /// columns, each of them once.
  SupernodalStructure(const Eigen::SparseMatrix<double>& matrix, const Dissection& dissection);

  Index size() const { return static_cast<Index>(this->Order.size()); }
  /// Column of the matrix at each place of the elimination.
  const Indices& order() const { return this->Order; }
  const std::vector<Supernode>& supernodes() const { return this->Nodes; }
  /// Rows of a supernode below its diagonal block, in the new numbers.
  const Index* rows(const Supernode& node) const { return this->Rows.data() + node.rowsBegin; }
  /// The same as places in the front of the parent: its columns first, then its rows.
  const Index* placesInParent(const Supernode& node) const
  {
    return this->Places.data() + node.rowsBegin;
  }
  /// Of all supernodes together.
  Index rowsSize() const { return static_cast<Index>(this->Rows.size()); }
  Index largestFront() const { return this->LargestFront; }
  /// Those of all supernodes.
  const LargeArray<Entry>& entries() const { return this->Entries; }
  /// How many the matrix has, those above the diagonal included.
  Eigen::Index storedCount() const { return this->StoredCount; }
  /// How many numbers the columns of L of all supernodes are.
  std::size_t factorSize() const { return this->FactorSize; }

private:
  struct ColumnEntries
  {
    Indices begin;
    LargeArray<Index> row;
    LargeArray<Index> stored; ///< into the matrix's values
  };

  ColumnEntries entriesByColumn(const Eigen::SparseMatrix<double>& matrix) const;
  void findRows(const Eigen::SparseMatrix<double>& matrix);

  Indices Order;
  Indices Place; ///< of each column of the matrix in the elimination
  std::vector<Supernode> Nodes;
  Indices NodeOfColumn;
  Indices Rows;
  Indices Places;
  LargeArray<Entry> Entries;
  Eigen::Index StoredCount = 0;
  std::size_t FactorSize = 0;
  Index LargestFront = 0;
};

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
  /// Finds the structure for the pattern of a symmetric, compressed matrix; the lower triangle is
  /// read.
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
  bool eliminate(Index s, const double* values, FrontBuffer& buffer, const Execution& execution);
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
