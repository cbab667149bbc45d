// SPDX-License-Identifier: BSD-3-Clause
#include "SupernodalStructure.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Calls body(row, column) for each stored entry of the lower triangle in the order of storage.
template <typename Body>
void visitEntries(const SparseMatrix& matrix, Body&& body)
{
  for (Index column = 0; column < matrix.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() >= column)
      {
        body(static_cast<Index>(entry.row()), column);
      }
    }
  }
}

/// Stored entries of a trapezoid of columns, its diagonal included.
double trapezoid(double front, double columns)
{
  return columns * front - 0.5 * columns * (columns - 1.0);
}
}

SupernodalStructure::SupernodalStructure(const SparseMatrix& matrix, const Indices& order)
  : Order(order)
  , Place(order.size())
{
  for (Index k = 0; k < this->size(); ++k)
  {
    this->Place[this->Order[k]] = k;
  }
  Indices parent = this->eliminationTree(this->earlierNeighbours(matrix));
  this->applyPostorder(parent);
  this->findSupernodes(parent, this->columnCounts(this->earlierNeighbours(matrix), parent));
  this->findRows(matrix);
  this->findPlaces(matrix);
}

/// Per column those joined to it that are eliminated before.
SupernodalStructure::Adjacency SupernodalStructure::earlierNeighbours(
  const SparseMatrix& matrix) const
{
  Adjacency earlier;
  earlier.begin.assign(this->Order.size() + 1, 0);
  visitEntries(matrix, [&](Index row, Index column) {
    if (row != column)
    {
      ++earlier.begin[std::max(this->Place[row], this->Place[column]) + 1];
    }
  });
  std::partial_sum(earlier.begin.begin(), earlier.begin.end(), earlier.begin.begin());
  earlier.neighbour.resize(earlier.begin.back());
  Indices next(earlier.begin.begin(), earlier.begin.end() - 1);
  visitEntries(matrix, [&](Index row, Index column) {
    if (row != column)
    {
      const auto [first, last] = std::minmax(this->Place[row], this->Place[column]);
      earlier.neighbour[next[last]++] = first;
    }
  });
  return earlier;
}

Indices SupernodalStructure::eliminationTree(const Adjacency& earlier) const
{
  Indices parent(this->Order.size(), none);
  Indices ancestor(this->Order.size(), none); // with the paths to it shortened
  for (Index j = 0; j < this->size(); ++j)
  {
    for (Index k = earlier.begin[j]; k < earlier.begin[j + 1]; ++k)
    {
      Index i = earlier.neighbour[k];
      while (ancestor[i] != none && ancestor[i] != j)
      {
        i = std::exchange(ancestor[i], j);
      }
      if (ancestor[i] == none)
      {
        ancestor[i] = j;
        parent[i] = j;
      }
    }
  }
  return parent;
}

/// Renumbers so that the descendants of a column are the ones right before it.
void SupernodalStructure::applyPostorder(Indices& parent)
{
  const Index n = this->size();
  Indices firstChild(n, none);
  Indices nextSibling(n, none);
  for (Index j = n; j-- > 0;)
  {
    if (parent[j] != none)
    {
      nextSibling[j] = firstChild[parent[j]];
      firstChild[parent[j]] = j;
    }
  }
  Indices number(n, none);
  Index next = 0;
  for (Index root = 0; root < n; ++root)
  {
    for (Index j = parent[root] == none ? root : none; j != none;)
    {
      if (firstChild[j] != none)
      {
        j = std::exchange(firstChild[j], none);
        continue;
      }
      number[j] = next++;
      const Index sibling = nextSibling[j];
      // After the first child the others are siblings; the parent's list is empty by now.
      j = sibling != none ? sibling : parent[j];
    }
  }
  Indices order(n);
  Indices renumbered(n, none);
  for (Index j = 0; j < n; ++j)
  {
    order[number[j]] = this->Order[j];
    renumbered[number[j]] = parent[j] == none ? none : number[parent[j]];
  }
  this->Order = std::move(order);
  parent = std::move(renumbered);
  for (Index k = 0; k < n; ++k)
  {
    this->Place[this->Order[k]] = k;
  }
}

/// Entries of each column of L, its diagonal included: a row's entries are the paths in the tree
/// from its neighbours up to itself.
Indices SupernodalStructure::columnCounts(const Adjacency& earlier, const Indices& parent) const
{
  Indices count(this->Order.size(), 1);
  Indices seen(this->Order.size(), none);
  for (Index j = 0; j < this->size(); ++j)
  {
    seen[j] = j;
    for (Index k = earlier.begin[j]; k < earlier.begin[j + 1]; ++k)
    {
      for (Index i = earlier.neighbour[k]; seen[i] != j; i = parent[i])
      {
        ++count[i];
        seen[i] = j;
      }
    }
  }
  return count;
}

void SupernodalStructure::findSupernodes(const Indices& parent, const Indices& count)
{
  struct Candidate
  {
    Index first;
    Index end;
    double front;
    double entries; ///< that are not zero
  };
  std::vector<Candidate> found;
  // A child whose columns come right before its parent's joins it if few zeros are stored for it.
  const auto absorb = [&found, &parent](Candidate& node) {
    while (!found.empty() && found.back().end == node.first && parent[node.first - 1] != none &&
      parent[node.first - 1] < node.end)
    {
      const Candidate& child = found.back();
      const double columns = node.end - child.first;
      const double front = (child.end - child.first) + node.front;
      const double stored = trapezoid(front, columns);
      const double entries = child.entries + node.entries;
      const double zeros = (stored - entries) / stored;
      const bool few = columns <= 8 || (columns <= 24 && zeros < 0.4) ||
        (columns <= 64 && zeros < 0.15) || zeros < 0.05;
      if (!few)
      {
        break;
      }
      node = { child.first, node.end, front, entries };
      found.pop_back();
    }
  };
  for (Index first = 0; first < this->size();)
  {
    Index end = first + 1;
    while (end < this->size() && parent[end - 1] == end && count[end - 1] == count[end] + 1)
    {
      ++end;
    }
    Candidate node{ first, end, double(count[first]),
      trapezoid(count[first], double(end - first)) };
    absorb(node);
    found.push_back(node);
    first = end;
  }
  this->NodeOfColumn.resize(this->Order.size());
  for (const Candidate& candidate : found)
  {
    Supernode node;
    node.first = candidate.first;
    node.end = candidate.end;
    std::fill(this->NodeOfColumn.begin() + node.first, this->NodeOfColumn.begin() + node.end,
      static_cast<Index>(this->Nodes.size()));
    this->Nodes.push_back(std::move(node));
  }
}

void SupernodalStructure::findRows(const SparseMatrix& matrix)
{
  Indices begin(this->Order.size() + 1, 0);
  visitEntries(matrix,
    [&](Index row, Index column) { ++begin[std::min(this->Place[row], this->Place[column]) + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Indices later(begin.back());
  Indices next(begin.begin(), begin.end() - 1);
  visitEntries(matrix, [&](Index row, Index column) {
    const auto [first, last] = std::minmax(this->Place[row], this->Place[column]);
    later[next[first]++] = last;
  });

  Indices seen(this->Order.size(), none);
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
    std::for_each(later.begin() + begin[node.first], later.begin() + begin[node.end], add);
    for (Index child : node.children)
    {
      for (Index k = this->Nodes[child].rowsBegin; k < this->Nodes[child].rowsEnd; ++k)
      {
        add(this->Rows[k]);
      }
    }
    node.rowsEnd = static_cast<Index>(this->Rows.size());
    std::sort(this->Rows.begin() + node.rowsBegin, this->Rows.end());
    node.block = this->BlocksSize;
    this->BlocksSize +=
      static_cast<std::size_t>(node.frontSize()) * static_cast<std::size_t>(node.columnCount());
    if (node.rowCount() > 0)
    {
      node.parent = this->NodeOfColumn[this->Rows[node.rowsBegin]];
      this->Nodes[node.parent].children.push_back(s);
    }
  }
}

Index SupernodalStructure::placeInFront(const Supernode& node, Index row) const
{
  if (row < node.end)
  {
    return row - node.first;
  }
  const auto begin = this->Rows.begin() + node.rowsBegin;
  const auto at = std::lower_bound(begin, this->Rows.begin() + node.rowsEnd, row);
  return node.columnCount() + static_cast<Index>(at - begin);
}

void SupernodalStructure::findPlaces(const SparseMatrix& matrix)
{
  this->Places.resize(this->Rows.size());
  for (const Supernode& node : this->Nodes)
  {
    for (Index k = node.rowsBegin; k < node.rowsEnd; ++k)
    {
      this->Places[k] = this->placeInFront(this->Nodes[node.parent], this->Rows[k]);
    }
  }
  this->EntryPlaces.reserve(static_cast<std::size_t>(matrix.nonZeros()));
  visitEntries(matrix, [&](Index row, Index column) {
    const auto [first, last] = std::minmax(this->Place[row], this->Place[column]);
    const Supernode& node = this->Nodes[this->NodeOfColumn[first]];
    this->EntryPlaces.push_back(node.block +
      static_cast<std::size_t>(first - node.first) * static_cast<std::size_t>(node.frontSize()) +
      static_cast<std::size_t>(this->placeInFront(node, last)));
  });
}
}
