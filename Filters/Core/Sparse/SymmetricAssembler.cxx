// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/SymmetricAssembler.h"

#include "Base/Memory.h"

#include <algorithm>
#include <limits>

namespace flattening
{
void SymmetricAssembler::finish()
{
  if (this->Rows.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
  {
    throwOutOfMemory(this->Rows.size() * sizeof(double));
  }
  const auto count = static_cast<Index>(this->Rows.size());
  Indices begin(this->Size + 1, 0);
  for (Index column : this->Columns)
  {
    ++begin[column + 1];
  }
  for (Index k = 0; k < this->Size; ++k)
  {
    begin[k + 1] += begin[k];
  }
  struct Declared
  {
    Index rows; ///< as in Rows
    Index entry;
  };
  LargeArray<Declared> byColumn(count);
  for (Index entry = 0; entry < count; ++entry)
  {
    byColumn[begin[this->Columns[entry]]++] = { this->Rows[entry], entry };
  }
  this->Columns.clear();
  this->Columns.shrink_to_fit();
  this->Rows.clear();
  this->Rows.shrink_to_fit();

  // Each row of a column once, ascending: many entries share a place, and few places are left to
  // sort.
  this->Slots.resize(count);
  LargeArray<Index> rows;
  rows.reserve(count / 2);
  Indices columnBegin(this->Size + 1, 0);
  Indices slotOfRow(this->Size, none);
  for (Index column = 0, first = 0; column < this->Size; ++column)
  {
    const Index last = begin[column]; // where the next column's begin was
    const auto add = [&](Index row) {
      if (slotOfRow[row] < columnBegin[column])
      {
        slotOfRow[row] = columnBegin[column]; // until they are sorted
        rows.push_back(row);
      }
    };
    for (Index k = first; k < last; ++k)
    {
      const Index row = byColumn[k].rows / 2;
      add(row);
      if (byColumn[k].rows % 2 != 0)
      {
        add(row + 1);
      }
    }
    std::sort(rows.begin() + columnBegin[column], rows.end());
    columnBegin[column + 1] = static_cast<Index>(rows.size());
    for (Index slot = columnBegin[column]; slot < columnBegin[column + 1]; ++slot)
    {
      slotOfRow[rows[slot]] = slot;
    }
    for (Index k = first; k < last; ++k)
    {
      this->Slots[byColumn[k].entry] = slotOfRow[byColumn[k].rows / 2];
    }
    first = last;
  }
  this->Matrix.resize(this->Size, this->Size);
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(columnBegin.begin(), columnBegin.end(), this->Matrix.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), this->Matrix.innerIndexPtr());
  this->clear();
}
}
