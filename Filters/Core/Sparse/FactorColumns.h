// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstddef>

namespace flattening
{
/// The columns of L of one supernode as they are kept: some together make a panel, and begin at the
/// row of its first.
template <typename Value>
struct FactorColumns
{
  static constexpr Index panelWidth = 4;

  Value* values = nullptr;
  Index size = 0;    ///< rows, those of the diagonal block included
  Index columns = 0; ///< of the diagonal block

  /// The first row that is kept of a column.
  static Index firstRow(Index column) { return column / panelWidth * panelWidth; }
  /// How many numbers the columns before one take.
  static std::size_t begin(Index size, Index column)
  {
    const auto first = std::size_t(firstRow(column));
    const std::size_t before =
      first > 0 ? first * std::size_t(size) - first * (first - panelWidth) / 2 : 0;
    return before + (std::size_t(column) - first) * (std::size_t(size) - first);
  }
  static std::size_t count(Index size, Index columns) { return begin(size, columns); }

  /// Where the panel that begins with a column begins; its columns are size - column apart.
  Value* panel(Index column) const { return this->values + begin(this->size, column); }
};
}
