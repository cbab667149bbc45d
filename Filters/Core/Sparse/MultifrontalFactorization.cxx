// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/MultifrontalFactorization.h"

#include "Base/Memory.h"
#include "Sparse/FactorBlocks.h"

#include <algorithm>
#include <cmath>
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
    std::fill(this->NodeOfColumn.begin() + first, this->NodeOfColumn.begin() + end,
      static_cast<Index>(this->Nodes.size()));
    Supernode& node = this->Nodes.emplace_back();
    node.first = first;
    node.end = first = end;
  }
  this->findRows(matrix);
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
    this->FactorSize += FactorColumns<double>::begin(node.frontSize(), node.columnCount());
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

namespace
{
constexpr std::size_t taskCount = 64; ///< a subtree has no more than its share of the work
constexpr Index worthThreads = 10000; ///< unknowns: fewer are solved for in less than threads take
constexpr std::size_t roundSize = 8;  ///< tasks between two looks at the top
/// Fronts of fewer rows keep threads busy beside each other rather than one by one.
constexpr Index wideFront = 600;

double work(const SupernodalStructure::Supernode& node)
{
  const double front = node.frontSize();
  return front * front * node.columnCount();
}

}

void MultifrontalFactorization::analyze(
  const Eigen::SparseMatrix<double>& matrix, const Dissection& dissection)
{
  this->Structure = SupernodalStructure(matrix, dissection);
  this->Diagonal.resize(this->Structure.size());
  this->chooseTasks();
  this->planTop();
}

/// Takes the subtrees with the most work apart until there is enough to share out.
void MultifrontalFactorization::chooseTasks()
{
  const std::vector<Supernode>& nodes = this->Structure.supernodes();
  std::vector<double> subtree(nodes.size());
  Indices roots;
  double total = 0.0;
  for (std::size_t s = 0; s < nodes.size(); ++s)
  {
    subtree[s] = work(nodes[s]);
    for (Index child : nodes[s].children)
    {
      subtree[s] += subtree[child];
    }
    if (nodes[s].parent == none)
    {
      roots.push_back(static_cast<Index>(s));
      total += subtree[s];
    }
  }
  const auto lighter = [&subtree](Index a, Index b) {
    return subtree[a] != subtree[b] ? subtree[a] < subtree[b] : a > b;
  };
  this->Top.clear();
  std::make_heap(roots.begin(), roots.end(), lighter);
  while (!roots.empty() && subtree[roots.front()] > total / taskCount &&
    !nodes[roots.front()].children.empty())
  {
    std::pop_heap(roots.begin(), roots.end(), lighter);
    const Index node = roots.back();
    roots.pop_back();
    this->Top.push_back(node);
    for (Index child : nodes[node].children)
    {
      roots.push_back(child);
      std::push_heap(roots.begin(), roots.end(), lighter);
    }
  }
  std::sort(this->Top.begin(), this->Top.end());
  // Subtrees one after the other go to one task, so that what they leave is soon taken by the top.
  std::sort(roots.begin(), roots.end());
  const auto add = [&subtree](double sum, Index root) { return sum + subtree[root]; };
  const double share = std::accumulate(roots.begin(), roots.end(), 0.0, add) / double(taskCount);
  Indices taskOf(nodes.size(), none);
  this->FirstRoots.assign(taskCount, static_cast<Index>(nodes.size()));
  double sum = 0.0;
  for (Index root : roots)
  {
    const double middle = share > 0.0 ? (sum + 0.5 * subtree[root]) / share : 0.0;
    const std::size_t task = std::min(static_cast<std::size_t>(middle), taskCount - 1);
    taskOf[root] = static_cast<Index>(task);
    this->FirstRoots[task] = std::min(this->FirstRoots[task], root);
    sum += subtree[root];
  }
  for (auto s = static_cast<Index>(nodes.size()); s-- > 0;)
  {
    if (taskOf[s] == none && nodes[s].parent != none)
    {
      taskOf[s] = taskOf[nodes[s].parent]; // none below the top
    }
  }
  this->Tasks.assign(taskCount, {});
  for (std::size_t s = 0; s < nodes.size(); ++s)
  {
    if (taskOf[s] != none)
    {
      this->Tasks[taskOf[s]].push_back(static_cast<Index>(s));
    }
  }
}

bool MultifrontalFactorization::factorize(
  const Eigen::SparseMatrix<double>& matrix, const Execution& execution)
{
  if (matrix.nonZeros() != this->Structure.storedCount())
  {
    return false;
  }
  const std::size_t bytes = this->Blocks.bytes(this->Structure.factorSize());
  if (bytes > execution.factorMemory)
  {
    throwOutOfMemory(bytes);
  }
  try
  {
    this->Blocks.allocate(this->Structure.factorSize());
  }
  catch (const std::bad_alloc&)
  {
    throwOutOfMemory(bytes);
  }
  this->Updates.assign(this->Structure.supernodes().size(), BlockedLowerTriangle());
  const bool sound = this->eliminateAll(matrix.valuePtr(), execution);
  this->Updates.clear();
  return sound;
}

/// After how many rounds of tasks each supernode of the top has all its children, and how many of
/// the top are below it then.
void MultifrontalFactorization::planTop()
{
  const std::vector<Supernode>& nodes = this->Structure.supernodes();
  this->TopByRound.assign(taskCount / roundSize, {});
  Indices heights(nodes.size(), 0);
  std::size_t round = 0;
  for (Index s : this->Top)
  {
    const auto later = [&] {
      const auto first = this->FirstRoots.begin() + (round + 1) * roundSize;
      return first >= this->FirstRoots.end() ? static_cast<Index>(nodes.size())
                                             : *std::min_element(first, this->FirstRoots.end());
    };
    while (round + 1 < this->TopByRound.size() && s >= later())
    {
      ++round;
      std::fill(heights.begin(), heights.end(), 0);
    }
    Index height = 0;
    for (Index child : nodes[s].children)
    {
      height = std::max(height, heights[child]);
    }
    heights[s] = height + 1;
    std::vector<Indices>& levels = this->TopByRound[round];
    levels.resize(std::max(levels.size(), static_cast<std::size_t>(height + 1)));
    levels[height].push_back(s);
  }
}

/// Some subtrees at a time, and what of the top has all its children by then: fewer updates wait
/// than if the top came last.
bool MultifrontalFactorization::eliminateAll(const double* values, const Execution& execution)
{
  std::vector<char> sound(this->Structure.supernodes().size(), 1);
  const auto all = [&sound] {
    return std::all_of(sound.begin(), sound.end(), [](char good) { return good != 0; });
  };
  const auto eachOf = [&](const Indices& together) {
    execution.parallelFor(static_cast<Index>(together.size()), [&](Index first, Index last) {
      FrontBuffer buffer;
      for (Index k = first; k < last; ++k)
      {
        sound[together[k]] = this->eliminate(together[k], values, buffer, {}) ? 1 : 0;
      }
    });
  };
  FrontBuffer topBuffer;
  for (std::size_t round = 0; round < this->TopByRound.size(); ++round)
  {
    if (execution.cancelled())
    {
      return false;
    }
    execution.parallelFor(roundSize, [&](Index first, Index last) {
      FrontBuffer buffer;
      for (std::size_t task = round * roundSize + first; task < round * roundSize + last; ++task)
      {
        bool going = true;
        for (auto s = this->Tasks[task].begin(); s != this->Tasks[task].end() && going; ++s)
        {
          going = this->eliminate(*s, values, buffer, {});
          sound[*s] = going ? 1 : 0;
        }
      }
    });
    for (const Indices& level : this->TopByRound[round])
    {
      if (!all() || execution.cancelled())
      {
        return false;
      }
      Indices narrow;
      for (Index s : level)
      {
        if (level.size() > 1 && this->Structure.supernodes()[s].frontSize() < wideFront)
        {
          narrow.push_back(s);
        }
        else
        {
          sound[s] = this->eliminate(s, values, topBuffer, execution) ? 1 : 0;
        }
      }
      eachOf(narrow);
    }
  }
  return all();
}

/// Adds what a child left of its rows to the front of its parent.
void MultifrontalFactorization::addChild(
  const DenseFront& front, Index child, BlockedLowerTriangle& update)
{
  const Supernode& below = this->Structure.supernodes()[child];
  const Index size = below.rowCount();
  const Index* const place = this->Structure.placesInParent(below);
  for (Index b = 0; b < size; ++b)
  {
    // The update has the rows below the columns alone.
    double* const to = place[b] < front.columns ? front.column(place[b]) + place[b]
                                                : update.diagonal(place[b] - front.columns);
    const double* const values = this->Updates[child].diagonal(b);
    for (Index a = b; a < size; ++a)
    {
      to[place[a] - place[b]] += values[a - b];
    }
  }
  this->Updates[child] = BlockedLowerTriangle();
}

bool MultifrontalFactorization::eliminate(
  Index s, const double* values, FrontBuffer& buffer, const Execution& execution)
{
  const Supernode& node = this->Structure.supernodes()[s];
  const std::size_t size = node.blockSize();
  const DenseFront front{ buffer.atLeast(size), node.frontSize(), node.columnCount() };
  std::fill_n(front.values, size, 0.0);
  for (Index k = node.entriesBegin; k < node.entriesEnd; ++k)
  {
    const SupernodalStructure::Entry& entry = this->Structure.entries()[k];
    front.values[entry.place] += values[entry.stored];
  }
  BlockedLowerTriangle update(node.rowCount());
  for (Index child : node.children)
  {
    this->addChild(front, child, update);
  }
  const bool sound = eliminateFront(front, update, execution);
  for (Index k = 0; k < front.columns; ++k)
  {
    this->Diagonal[node.first + k] = front.column(k)[k];
  }
  this->Updates[s] = std::move(update);
  return sound && this->Blocks.keep(front, node.block);
}

/// L x = x within one supernode; what is left for the rows below is passed on to its parent.
void MultifrontalFactorization::substituteForward(
  const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& passed, Eigen::MatrixXd& work) const
{
  const Index columns = node.columnCount();
  FrontVectors w(work.data(), node.frontSize(), work.cols(), Eigen::OuterStride<>(work.rows()));
  w.topRows(columns) = x.middleRows(node.first, columns);
  w.bottomRows(node.rowCount()).setZero();
  for (Index child : node.children)
  {
    const Supernode& below = this->Structure.supernodes()[child];
    const Index* const place = this->Structure.placesInParent(below);
    for (Index c = 0; c < x.cols(); ++c)
    {
      for (Index k = 0; k < below.rowCount(); ++k)
      {
        w(place[k], c) += passed(below.rowsBegin + k, c);
      }
    }
  }
  this->Blocks.visit(node.block, node.frontSize(), columns,
    [&w](const auto& factor) { flattening::substituteForward(factor, w); });
  x.middleRows(node.first, columns) = w.topRows(columns);
  passed.middleRows(node.rowsBegin, node.rowCount()) = w.bottomRows(node.rowCount());
}

void MultifrontalFactorization::substituteBackward(
  const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& work) const
{
  const Index columns = node.columnCount();
  const Index* const rows = this->Structure.rows(node);
  FrontVectors w(work.data(), node.frontSize(), work.cols(), Eigen::OuterStride<>(work.rows()));
  w.topRows(columns) = x.middleRows(node.first, columns);
  for (Index c = 0; c < x.cols(); ++c)
  {
    for (Index k = 0; k < node.rowCount(); ++k)
    {
      w(columns + k, c) = x(rows[k], c);
    }
  }
  this->Blocks.visit(node.block, node.frontSize(), columns,
    [&w](const auto& factor) { flattening::substituteBackward(factor, w); });
  x.middleRows(node.first, columns) = w.topRows(columns);
}

void MultifrontalFactorization::substitute(Eigen::MatrixXd& x, const Execution& execution) const
{
  const std::vector<Supernode>& nodes = this->Structure.supernodes();
  Eigen::MatrixXd passed(this->Structure.rowsSize(), x.cols());
  const auto workspace = [&] { return Eigen::MatrixXd(this->Structure.largestFront(), x.cols()); };
  execution.parallelFor(taskCount, [&](Index first, Index last) {
    Eigen::MatrixXd work = workspace();
    for (Index task = first; task < last; ++task)
    {
      for (Index s : this->Tasks[task])
      {
        this->substituteForward(nodes[s], x, passed, work);
      }
    }
  });
  Eigen::MatrixXd work = workspace();
  for (Index s : this->Top)
  {
    this->substituteForward(nodes[s], x, passed, work);
  }
  x.array().colwise() /= this->Diagonal.array();
  for (auto s = this->Top.rbegin(); s != this->Top.rend(); ++s)
  {
    this->substituteBackward(nodes[*s], x, work);
  }
  execution.parallelFor(taskCount, [&](Index first, Index last) {
    Eigen::MatrixXd own = workspace();
    for (Index task = first; task < last; ++task)
    {
      for (auto s = this->Tasks[task].rbegin(); s != this->Tasks[task].rend(); ++s)
      {
        this->substituteBackward(nodes[*s], x, own);
      }
    }
  });
}

Eigen::MatrixXd MultifrontalFactorization::solve(
  const Eigen::MatrixXd& rightHandSide, const Execution& execution) const
{
  const Indices& order = this->Structure.order();
  Eigen::MatrixXd x(rightHandSide.rows(), rightHandSide.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c)
  {
    for (Index k = 0; k < this->Structure.size(); ++k)
    {
      x(k, c) = rightHandSide(order[k], c);
    }
  }
  this->substitute(x, this->Structure.size() < worthThreads ? Execution() : execution);
  Eigen::MatrixXd result(x.rows(), x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c)
  {
    for (Index k = 0; k < this->Structure.size(); ++k)
    {
      result(order[k], c) = x(k, c);
    }
  }
  return result;
}
}
