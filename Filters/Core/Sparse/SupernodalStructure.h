// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  const std::vector<Entry>& entries() const { return this->Entries; }
  /// How many the matrix has, those above the diagonal included.
  Eigen::Index storedCount() const { return this->StoredCount; }
  /// How many numbers the columns of L of all supernodes are.
  std::size_t factorSize() const { return this->FactorSize; }

private:
  struct ColumnEntries
  {
    Indices begin;
    Indices row;
    Indices stored; ///< into the matrix's values
  };

  void addSupernode(Index first, Index end);
  ColumnEntries entriesByColumn(const Eigen::SparseMatrix<double>& matrix) const;
  void findRows(const Eigen::SparseMatrix<double>& matrix);

  Indices Order;
  Indices Place; ///< of each column of the matrix in the elimination
  std::vector<Supernode> Nodes;
  Indices NodeOfColumn;
  Indices Rows;
  Indices Places;
  std::vector<Entry> Entries;
  Eigen::Index StoredCount = 0;
  std::size_t FactorSize = 0;
  Index LargestFront = 0;
};
}
