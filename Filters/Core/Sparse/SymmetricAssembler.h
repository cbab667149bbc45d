// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <Eigen/SparseCore>

#include <algorithm>

namespace flattening
{
/// Fills the lower triangle of a symmetric sparse matrix again and again in one pattern.
///
/// Entries are declared once, in the order in which their values come later; values of entries at
/// one place add up.
class SymmetricAssembler
{
public:
  explicit SymmetricAssembler(Index size)
    : Size(size)
  {
  }
  /// Makes room for so many entries.
  void reserve(std::size_t count)
  {
    this->Rows.reserve(count);
    this->Columns.reserve(count);
  }
  /// Declares an entry; the larger index is its row. Returns its number.
  Index declare(Index i, Index j) { return this->declareRows(std::max(i, j), 1, std::min(i, j)); }
  /// Declares the entries of two rows, which follow each other, in a column that is none after
  /// them, as one.
  Index declarePair(Index row, Index column) { return this->declareRows(row, 2, column); }
  /// Finds the pattern of all declared entries.
  void finish();

  void clear() { std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0); }
  void add(Index entry, double value) { this->Matrix.valuePtr()[this->Slots[entry]] += value; }
  void addPair(Index entry, double first, double second)
  {
    double* const values = this->Matrix.valuePtr() + this->Slots[entry];
    values[0] += first;
    values[1] += second;
  }
  const Eigen::SparseMatrix<double>& matrix() const { return this->Matrix; }

private:
  Index declareRows(Index first, Index count, Index column)
  {
    this->Rows.push_back(2 * first + count - 1);
    this->Columns.push_back(column);
    return static_cast<Index>(this->Rows.size()) - 1;
  }

  Index Size;
  Indices Rows; ///< twice the first, and 1 where a second one follows
  Indices Columns;
  Indices Slots;
  Eigen::SparseMatrix<double> Matrix;
};
}
