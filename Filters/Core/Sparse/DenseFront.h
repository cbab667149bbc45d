// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Base/LargeArray.h"
#include "Base/Types.h"

#include <Eigen/Core>
#include <cstddef>

namespace flattening
{
/// Columns of a matrix in memory of others.
struct DenseColumns
{
  const double* values;
  std::size_t stride; ///< from one column to the next
};

/// to -= left D right^T.
struct DenseProduct
{
  double* to;
  std::size_t stride;
  Index rows;
  Index columns;
  DenseColumns left;      ///< rows x depth
  DenseColumns right;     ///< columns x depth
  const double* diagonal; ///< D, depth entries
  Index depth;
  bool lower = false; ///< entries above the diagonal are not needed, and not right afterwards
};

/// By tiles that stay in registers, as wide as the processor's. Each entry's sum runs over the
/// depth in order, with any number of threads. With AVX-512, and on ARM, the compiler fuses a
/// product with its sum, so that last bits differ between processors.
void subtractProduct(const DenseProduct& product);

/// The lower triangle of a symmetric matrix in steps: some columns at a time have a stride of their
/// own, and no place above the first of them.
class BlockedLowerTriangle
{
public:
  static constexpr Index stepWidth = 64;

  BlockedLowerTriangle() = default;
  /// All 0.
  explicit BlockedLowerTriangle(Index rows)
    : Rows(rows)
    , Values(rows > 0 ? begin(rows - 1) + std::size_t(stride(rows - 1)) : 0, 0.0)
  {
  }
  std::size_t size() const { return this->Values.size(); }
  /// How far the columns of the same step are apart.
  Index stride(Index column) const { return this->Rows - column / stepWidth * stepWidth; }
  /// Where the diagonal entry of a column is; those below follow.
  double* diagonal(Index column) { return this->Values.data() + this->place(column); }
  const double* diagonal(Index column) const { return this->Values.data() + this->place(column); }

private:
  /// Of a column's first entry, that of the row in which its step begins.
  std::size_t begin(Index column) const
  {
    const std::size_t first = std::size_t(column / stepWidth) * stepWidth;
    const std::size_t before =
      first > 0 ? first * std::size_t(this->Rows) - first * (first - stepWidth) / 2 : 0;
    return before + (column - first) * std::size_t(this->stride(column));
  }
  std::size_t place(Index column) const
  {
    return this->begin(column) + std::size_t(column % stepWidth);
  }

  Index Rows = 0;
  LargeArray<double> Values;
};

/// The columns of one supernode, one after the other, of which the lower triangle counts.
template <typename Value>
struct FrontColumns
{
  Value* values = nullptr;
  Index size = 0;    ///< rows, those of the diagonal block included
  Index columns = 0; ///< of the diagonal block

  Index rows() const { return this->size - this->columns; } ///< below the diagonal block
  Value* column(Index k) const { return this->values + std::size_t(k) * std::size_t(this->size); }
};
using DenseFront = FrontColumns<double>;

/// Memory for the columns of one front after the other.
class FrontBuffer
{
public:
  /// What was there before is lost where it grows.
  double* atLeast(std::size_t count)
  {
    if (count > this->Values.size())
    {
      this->Values = {};
      this->Values.resize(count);
    }
    return this->Values.data();
  }

private:
  LargeArray<double> Values;
};

/// L D L^T of the columns of a front in place, D on the diagonal, and what they do to the rows
/// below, which is subtracted from `update`. False where a pivot is zero or not finite.
bool eliminateFront(
  const DenseFront& front, BlockedLowerTriangle& update, const Execution& execution);
}
