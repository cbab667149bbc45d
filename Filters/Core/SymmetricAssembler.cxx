// SPDX-License-Identifier: BSD-3-Clause
#include "SymmetricAssembler.h"

#include <algorithm>

namespace flattening
{
void SymmetricAssembler::finish()
{
  // Entries by column, then by row within each, through counting sorts.
  const auto count = static_cast<Index>(this->Rows.size());
  auto sorted = [this, count](const Indices& order, const Indices& key) {
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
    for (Index entry : order)
    {
      result[begin[key[entry]]++] = entry;
    }
    return result;
  };
  Indices order(count);
  for (Index k = 0; k < count; ++k)
  {
    order[k] = k;
  }
  order = sorted(sorted(order, this->Rows), this->Columns);

  this->Slots.resize(count);
  Indices rows;
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
  const std::vector<double> values(rows.size(), 0.0);
  this->Matrix = Eigen::Map<const Eigen::SparseMatrix<double>>(this->Size, this->Size,
    static_cast<Eigen::Index>(rows.size()), columnBegin.data(), rows.data(), values.data());
  this->Rows.clear();
  this->Rows.shrink_to_fit();
  this->Columns.clear();
  this->Columns.shrink_to_fit();
}
}
