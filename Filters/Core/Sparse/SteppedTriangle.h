// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstddef>
#include <vector>

namespace flattening
{
/// The lower triangle of a symmetric matrix in steps: some columns at a time have a stride of their
/// own, and no place above the first of them.
class SteppedTriangle
{
public:
  static constexpr Index stepWidth = 64;

  SteppedTriangle() = default;
  /// All 0.
  explicit SteppedTriangle(Index rows)
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
  std::vector<double> Values;
};
}
