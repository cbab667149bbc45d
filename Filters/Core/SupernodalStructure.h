// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Types.h"

#include <Eigen/SparseCore>

#include <cstdint>

namespace flattening
{
/// The symbolic part of a sparse symmetric factorization: which columns of L are eliminated
/// together, and which rows they have (T. A. Davis, "Direct Methods for Sparse Linear Systems",
/// 2006, chapter 4; Ashcraft and Grimes, "The influence of relaxed supernode partitions on the
/// multifrontal method", 1989).
///
/// Columns are numbered anew, by a postorder of the elimination tree of the given order, so that a
/// supernode is a range of them and its descendants come right before it.
class SupernodalStructure
{
public:
  struct Supernode
  {
    Index first = 0; ///< columns [first, end)
    Index end = 0;
    Index rowsBegin = 0; ///< into rows(): those below the diagonal block, ascending
    Index rowsEnd = 0;
    Index parent = none;
    std::size_t block = 0; ///< where its (columns + rows) x columns block begins
    Indices children;

    Index columnCount() const { return this->end - this->first; }
    Index rowCount() const { return this->rowsEnd - this->rowsBegin; }
    Index frontSize() const { return this->columnCount() + this->rowCount(); }
  };

  SupernodalStructure() = default;
  /// \param matrix symmetric; only the pattern of its lower triangle counts. \param order column of
  /// the matrix that is eliminated first, second, ...; a permutation.
  SupernodalStructure(const Eigen::SparseMatrix<double>& matrix, const Indices& order);

  Index size() const { return static_cast<Index>(this->Order.size()); }
  /// Column of the matrix at each place of the elimination.
  const Indices& order() const { return this->Order; }
  const std::vector<Supernode>& supernodes() const { return this->Nodes; }
  /// Row of the matrix, in the new numbers.
  Index row(Index k) const { return this->Rows[k]; }
  /// The same as a place in the front of the parent: its columns first, then its rows.
  Index placeInParent(Index k) const { return this->Places[k]; }
  /// Where each stored entry of the lower triangle, in the order of storage, goes in the blocks.
  const std::vector<std::size_t>& entryPlaces() const { return this->EntryPlaces; }
  std::size_t blocksSize() const { return this->BlocksSize; }

private:
  struct Adjacency
  {
    Indices begin;
    Indices neighbour;
  };

  Adjacency earlierNeighbours(const Eigen::SparseMatrix<double>& matrix) const;
  Indices eliminationTree(const Adjacency& earlier) const;
  void applyPostorder(Indices& parent);
  Indices columnCounts(const Adjacency& earlier, const Indices& parent) const;
  void findSupernodes(const Indices& parent, const Indices& count);
  void findRows(const Eigen::SparseMatrix<double>& matrix);
  void findPlaces(const Eigen::SparseMatrix<double>& matrix);
  Index placeInFront(const Supernode& node, Index row) const;

  Indices Order;
  Indices Place; ///< of each column of the matrix in the elimination
  std::vector<Supernode> Nodes;
  Indices NodeOfColumn;
  Indices Rows;
  Indices Places;
  std::vector<std::size_t> EntryPlaces;
  std::size_t BlocksSize = 0;
};
}
