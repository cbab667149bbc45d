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
  Index declare(Index i, Index j)
  {
    this->Rows.push_back(std::max(i, j));
    this->Columns.push_back(std::min(i, j));
    return static_cast<Index>(this->Rows.size()) - 1;
  }
  /// Finds the pattern of all declared entries.
  void finish();

  void clear() { std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0); }
  void add(Index entry, double value) { this->Matrix.valuePtr()[this->Slots[entry]] += value; }
  const Eigen::SparseMatrix<double>& matrix() const { return this->Matrix; }

private:
  Index Size;
  Indices Rows;
  Indices Columns;
  Indices Slots;
  Eigen::SparseMatrix<double> Matrix;
};
}
