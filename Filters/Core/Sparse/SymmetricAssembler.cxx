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
    refuseMemory(this->Rows.size() * sizeof(double));
  }
  // Entries by column, then by row within each, through counting sorts.
  const auto count = static_cast<Index>(this->Rows.size());
  // An empty order is that of the numbers.
  auto sorted = [this, count](Indices order, const Indices& key) {
    Indices begin(this->Size + 1, 0);
    for (Index k : key)
    {
      ++begin[k + 1];
    }
    for (Index k = 0; k < this->Size; ++k)
    {
      begin[k + 1] += begin[k];
    }
    Indices result(count);
    for (Index k = 0; k < count; ++k)
    {
      const Index entry = order.empty() ? k : order[k];
      result[begin[key[entry]]++] = entry;
    }
    return result;
  };
  const Indices order = sorted(sorted({}, this->Rows), this->Columns);

  this->Slots.resize(count);
  Indices rows;
  rows.reserve(count);
  Indices columnBegin(this->Size + 1, 0);
  Index lastRow = none;
  Index lastColumn = none;
  for (Index entry : order)
  {
    if (this->Rows[entry] != lastRow || this->Columns[entry] != lastColumn)
    {
      lastRow = this->Rows[entry];
      lastColumn = this->Columns[entry];
      rows.push_back(lastRow);
      ++columnBegin[lastColumn + 1];
    }
    this->Slots[entry] = static_cast<Index>(rows.size()) - 1;
  }
  for (Index k = 0; k < this->Size; ++k)
  {
    columnBegin[k + 1] += columnBegin[k];
  }
  this->Matrix.resize(this->Size, this->Size);
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(columnBegin.begin(), columnBegin.end(), this->Matrix.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), this->Matrix.innerIndexPtr());
  this->clear();
  this->Rows.clear();
  this->Rows.shrink_to_fit();
  this->Columns.clear();
  this->Columns.shrink_to_fit();
}
}
