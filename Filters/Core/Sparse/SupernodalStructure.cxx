// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/SupernodalStructure.h"

#include "Base/Memory.h"
#include "Sparse/FactorBlocks.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Calls body(row, column, stored) for each entry of the lower triangle in the order of storage.
template <typename Body>
void visitEntries(const SparseMatrix& matrix, Body&& body)
{
  for (Index column = 0; column < matrix.outerSize(); ++column)
  {
    for (Index stored = matrix.outerIndexPtr()[column]; stored < matrix.outerIndexPtr()[column + 1];
         ++stored)
    {
      const Index row = matrix.innerIndexPtr()[stored];
      if (row >= column)
      {
        body(row, column, stored);
      }
    }
  }
}
}

SupernodalStructure::SupernodalStructure(const SparseMatrix& matrix, const Dissection& dissection)
  : Order(dissection.order)
  , Place(dissection.order.size())
  , NodeOfColumn(dissection.order.size())
{
  for (Index k = 0; k < this->size(); ++k)
  {
    this->Place[this->Order[k]] = k;
  }
  Index first = 0;
  for (Index end : dissection.end)
  {
    this->addSupernode(first, end);
    first = end;
  }
  this->findRows(matrix);
}

void SupernodalStructure::addSupernode(Index first, Index end)
{
  Supernode node;
  node.first = first;
  node.end = end;
  std::fill(this->NodeOfColumn.begin() + first, this->NodeOfColumn.begin() + end,
    static_cast<Index>(this->Nodes.size()));
  this->Nodes.push_back(std::move(node));
}

/// Stored entries of the matrix by the column of L in which they are, each with its row of L.
SupernodalStructure::ColumnEntries SupernodalStructure::entriesByColumn(
  const SparseMatrix& matrix) const
{
  ColumnEntries entries;
  entries.begin.assign(this->Order.size() + 1, 0);
  visitEntries(matrix, [&](Index row, Index column, Index) {
    ++entries.begin[std::min(this->Place[row], this->Place[column]) + 1];
  });
  std::partial_sum(entries.begin.begin(), entries.begin.end(), entries.begin.begin());
  entries.row.resize(entries.begin.back());
  entries.stored.resize(entries.begin.back());
  Indices next(entries.begin.begin(), entries.begin.end() - 1);
  visitEntries(matrix, [&](Index row, Index column, Index stored) {
    const auto [first, last] = std::minmax(this->Place[row], this->Place[column]);
    entries.row[next[first]] = last;
    entries.stored[next[first]++] = stored;
  });
  return entries;
}

void SupernodalStructure::findRows(const SparseMatrix& matrix)
{
  const ColumnEntries entries = this->entriesByColumn(matrix);
  this->Entries.resize(entries.row.size());
  this->StoredCount = matrix.nonZeros();
  Indices seen(this->Order.size(), none);
  Indices place(this->Order.size(), none); // in the front of the supernode at hand
  for (Index s = 0; s < static_cast<Index>(this->Nodes.size()); ++s)
  {
    Supernode& node = this->Nodes[s];
    node.rowsBegin = static_cast<Index>(this->Rows.size());
    const auto add = [&](Index row) {
      if (row >= node.end && seen[row] != s)
      {
        seen[row] = s;
        this->Rows.push_back(row);
      }
    };
    std::for_each(entries.row.begin() + entries.begin[node.first],
      entries.row.begin() + entries.begin[node.end], add);
    for (Index child : node.children)
    {
      for (Index k = this->Nodes[child].rowsBegin; k < this->Nodes[child].rowsEnd; ++k)
      {
        add(this->Rows[k]);
      }
    }
    if (this->Rows.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    {
      throwOutOfMemory(this->FactorSize * sizeof(double));
    }
    node.rowsEnd = static_cast<Index>(this->Rows.size());
    std::sort(this->Rows.begin() + node.rowsBegin, this->Rows.end());
    node.block = this->FactorSize;
    this->FactorSize += FactorColumns<double>::count(node.frontSize(), node.columnCount());
    if (node.blockSize() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    {
      throwOutOfMemory(this->FactorSize * sizeof(double));
    }
    this->LargestFront = std::max(this->LargestFront, node.frontSize());
    if (node.rowCount() > 0)
    {
      node.parent = this->NodeOfColumn[this->Rows[node.rowsBegin]];
      this->Nodes[node.parent].children.push_back(s);
    }

    std::iota(place.begin() + node.first, place.begin() + node.end, 0);
    for (Index k = node.rowsBegin; k < node.rowsEnd; ++k)
    {
      place[this->Rows[k]] = node.columnCount() + k - node.rowsBegin;
    }
    this->Places.resize(this->Rows.size());
    for (Index child : node.children)
    {
      for (Index k = this->Nodes[child].rowsBegin; k < this->Nodes[child].rowsEnd; ++k)
      {
        this->Places[k] = place[this->Rows[k]];
      }
    }
    node.entriesBegin = entries.begin[node.first];
    node.entriesEnd = entries.begin[node.end];
    for (Index column = node.first; column < node.end; ++column)
    {
      const Index begin = (column - node.first) * node.frontSize();
      for (Index k = entries.begin[column]; k < entries.begin[column + 1]; ++k)
      {
        this->Entries[k] = { entries.stored[k], begin + place[entries.row[k]] };
      }
    }
  }
}
}
