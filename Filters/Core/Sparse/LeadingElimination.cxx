// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LeadingElimination.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{
using Entries = std::vector<Eigen::Triplet<double>>;

/// Eliminates the first columns of the graph; what becomes coupled of the others goes to `rest`.
void eliminateLeading(const Eigen::SparseMatrix<double>& lower, Index leading, Entries& rest)
{
  // What a column is coupled with when its turn comes: by the matrix, and by the columns before it
  // whose first neighbour it is.
  std::vector<std::vector<Indices>> passedOn(leading);
  for (Index column = 0; column < leading; ++column)
  {
    Indices coupled;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry)
    {
      coupled.push_back(static_cast<Index>(entry.row()));
    }
    for (const Indices& others : passedOn[column])
    {
      coupled.insert(coupled.end(), others.begin(), others.end());
    }
    passedOn[column] = {};
    std::sort(coupled.begin(), coupled.end());
    coupled.erase(std::unique(coupled.begin(), coupled.end()), coupled.end());
    coupled.erase(coupled.begin(), std::upper_bound(coupled.begin(), coupled.end(), column));
    if (!coupled.empty() && coupled.front() < leading)
    {
      passedOn[coupled.front()].push_back(std::move(coupled));
      continue;
    }
    for (Index a : coupled)
    {
      for (Index b : coupled)
      {
        rest.emplace_back(a - leading, b - leading, 1.0);
      }
    }
  }
}
}

Indices leadingColumnsFirst(const Eigen::SparseMatrix<double>& lower, Index leading)
{
  const auto size = static_cast<Index>(lower.cols());
  Indices order(size);
  std::iota(order.begin(), order.end(), 0);
  if (leading >= size)
  {
    return order;
  }
  Entries entries;
  eliminateLeading(lower, leading, entries);
  for (Index column = leading; column < size; ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry)
    {
      const Index row = static_cast<Index>(entry.row());
      if (row >= column)
      {
        entries.emplace_back(row - leading, column - leading, 1.0);
        entries.emplace_back(column - leading, row - leading, 1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> rest(size - leading, size - leading);
  rest.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(rest, permutation);
  for (Index k = leading; k < size; ++k)
  {
    order[k] = leading + permutation.indices()[k - leading];
  }
  return order;
}
}
