// SPDX-License-Identifier: BSD-3-Clause
#include "MultifrontalFactorization.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
using Block = Eigen::Map<Eigen::MatrixXd>;
using ConstBlock = Eigen::Map<const Eigen::MatrixXd>;

constexpr Index panelWidth = 32;
constexpr Index tileWidth = 128; ///< of updates that are worth more than one thread
constexpr std::size_t taskCount = 16;
constexpr std::size_t roundSize = 4; ///< tasks between two questions whether to go on

double work(const SupernodalStructure::Supernode& node)
{
  const double front = node.frontSize();
  return front * front * node.columnCount();
}

/// L D L^T of the columns [begin, end) of a front, whose earlier columns are done; D on the
/// diagonal. \return whether all pivots are sound.
bool eliminateColumns(Block& front, Index begin, Index end)
{
  for (Index j = begin; j < end; ++j)
  {
    const double pivot = front(j, j);
    if (!std::isfinite(pivot) || pivot == 0.0)
    {
      return false;
    }
    const Index below = end - j - 1;
    if (below > 0)
    {
      const Eigen::VectorXd column = front.col(j).segment(j + 1, below);
      front.col(j).segment(j + 1, below) /= pivot;
      for (Index k = 0; k < below; ++k)
      {
        front.col(j + 1 + k).segment(j + 1 + k, below - k) -=
          column[k] * front.col(j).segment(j + 1 + k, below - k);
      }
    }
  }
  return true;
}

/// matrix -= left * right^T, the lower triangle alone, tile by tile.
void subtractProduct(Eigen::Ref<Eigen::MatrixXd> matrix,
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right,
  const Execution& execution)
{
  const Index size = static_cast<Index>(matrix.rows());
  const Index tiles = (size + tileWidth - 1) / tileWidth;
  const auto subtract = [&](Index first, Index last) {
    for (Index tile = first; tile < last; ++tile)
    {
      const Index begin = tile * tileWidth;
      const Index width = std::min(tileWidth, size - begin);
      matrix.block(begin, begin, width, width).triangularView<Eigen::Lower>() -=
        left.middleRows(begin, width) * right.middleRows(begin, width).transpose();
      const Index below = size - begin - width;
      if (below > 0)
      {
        matrix.block(begin + width, begin, below, width).noalias() -=
          left.bottomRows(below) * right.middleRows(begin, width).transpose();
      }
    }
  };
  if (tiles < 4)
  {
    subtract(0, tiles);
    return;
  }
  // The first tiles are the longest: pair each with one from the end.
  execution.parallelFor((tiles + 1) / 2, [&](Index first, Index last) {
    for (Index pair = first; pair < last; ++pair)
    {
      subtract(pair, pair + 1);
      if (tiles - 1 - pair != pair)
      {
        subtract(tiles - 1 - pair, tiles - pair);
      }
    }
  });
}
}

void MultifrontalFactorization::analyze(
  const Eigen::SparseMatrix<double>& matrix, const Indices& order)
{
  this->Structure = SupernodalStructure(matrix, order);
  this->Diagonal.resize(this->Structure.size());
  this->chooseTasks();
}

/// Takes the subtrees with the most work apart until there is enough to share out.
void MultifrontalFactorization::chooseTasks()
{
  const std::vector<Supernode>& nodes = this->Structure.supernodes();
  std::vector<double> subtree(nodes.size());
  Indices firstDescendant(nodes.size());
  Indices roots;
  double total = 0.0;
  for (std::size_t s = 0; s < nodes.size(); ++s)
  {
    subtree[s] = work(nodes[s]);
    firstDescendant[s] = static_cast<Index>(s);
    for (Index child : nodes[s].children)
    {
      subtree[s] += subtree[child];
      firstDescendant[s] = std::min(firstDescendant[s], firstDescendant[child]);
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
  while (!roots.empty() && subtree[roots.front()] > total / (4.0 * taskCount) &&
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
  // The heaviest subtrees first, each to the task that has least.
  std::sort(roots.begin(), roots.end(), [&](Index a, Index b) { return lighter(b, a); });
  this->Tasks.assign(taskCount, {});
  std::vector<double> load(taskCount, 0.0);
  for (Index root : roots)
  {
    const std::size_t task =
      static_cast<std::size_t>(std::min_element(load.begin(), load.end()) - load.begin());
    load[task] += subtree[root];
    for (Index s = firstDescendant[root]; s <= root; ++s)
    {
      this->Tasks[task].push_back(s);
    }
  }
}

bool MultifrontalFactorization::factorize(
  const Eigen::SparseMatrix<double>& matrix, const Execution& execution)
{
  this->Blocks.assign(this->Structure.blocksSize(), 0.0);
  this->Updates.assign(this->Structure.supernodes().size(), Eigen::MatrixXd());
  const std::vector<std::size_t>& places = this->Structure.entryPlaces();
  std::size_t next = 0;
  for (Index column = 0; column < matrix.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() >= column)
      {
        if (next == places.size())
        {
          return false;
        }
        this->Blocks[places[next++]] += entry.value();
      }
    }
  }
  std::vector<char> sound(this->Tasks.size(), 1);
  for (std::size_t done = 0; done < this->Tasks.size(); done += roundSize)
  {
    if (execution.cancelled())
    {
      return false;
    }
    execution.parallelFor(roundSize, [&](Index first, Index last) {
      for (std::size_t task = done + first; task < done + last; ++task)
      {
        for (Index s : this->Tasks[task])
        {
          sound[task] = sound[task] && this->eliminate(s, {}) ? 1 : 0;
        }
      }
    });
  }
  bool all = next == places.size() &&
    std::all_of(sound.begin(), sound.end(), [](char good) { return good != 0; });
  for (std::size_t k = 0; all && k < this->Top.size(); ++k)
  {
    all = !execution.cancelled() && this->eliminate(this->Top[k], execution);
  }
  this->Updates.clear();
  return all;
}

/// Adds what a child left of its rows to the front of its parent.
void MultifrontalFactorization::addChild(
  const Supernode& node, Index child, Eigen::MatrixXd& update)
{
  const Supernode& below = this->Structure.supernodes()[child];
  const Eigen::MatrixXd& from = this->Updates[child];
  const Index columns = node.columnCount();
  Block front(this->Blocks.data() + node.block, node.frontSize(), columns);
  for (Index b = 0; b < below.rowCount(); ++b)
  {
    const Index column = this->Structure.placeInParent(below.rowsBegin + b);
    double* const to =
      column < columns ? front.col(column).data() : update.col(column - columns).data() - columns;
    const double* const values = from.col(b).data();
    for (Index a = b; a < below.rowCount(); ++a)
    {
      to[this->Structure.placeInParent(below.rowsBegin + a)] += values[a];
    }
  }
  this->Updates[child] = Eigen::MatrixXd();
}

bool MultifrontalFactorization::eliminate(Index s, const Execution& execution)
{
  const Supernode& node = this->Structure.supernodes()[s];
  const Index columns = node.columnCount();
  const Index rows = node.rowCount();
  Block front(this->Blocks.data() + node.block, node.frontSize(), columns);
  Eigen::MatrixXd update = Eigen::MatrixXd::Zero(rows, rows);
  for (Index child : node.children)
  {
    this->addChild(node, child, update);
  }
  for (Index begin = 0; begin < columns; begin += panelWidth)
  {
    const Index end = std::min(columns, begin + panelWidth);
    const Index width = end - begin;
    if (!eliminateColumns(front, begin, end))
    {
      return false;
    }
    const auto pivots = front.diagonal().segment(begin, width);
    const Index below = node.frontSize() - end;
    if (below == 0)
    {
      continue;
    }
    auto lowerRows = front.block(end, begin, below, width);
    front.block(begin, begin, width, width)
      .triangularView<Eigen::UnitLower>()
      .transpose()
      .solveInPlace<Eigen::OnTheRight>(lowerRows);
    const Eigen::MatrixXd scaled = lowerRows; // L D
    lowerRows = scaled * pivots.cwiseInverse().asDiagonal();
    const Index rest = columns - end;
    if (rest > 0)
    {
      front.block(end, end, below, rest).noalias() -= scaled * lowerRows.topRows(rest).transpose();
    }
  }
  this->Diagonal.segment(node.first, columns) = front.diagonal();
  if (rows > 0)
  {
    const auto lowerRows = front.bottomRows(rows);
    const Eigen::MatrixXd scaled = lowerRows * front.diagonal().asDiagonal();
    subtractProduct(update, scaled, lowerRows, execution);
    this->Updates[s] = std::move(update);
  }
  return true;
}

Eigen::MatrixXd MultifrontalFactorization::solve(const Eigen::MatrixXd& rightHandSide) const
{
  const Indices& order = this->Structure.order();
  const std::vector<Supernode>& nodes = this->Structure.supernodes();
  Eigen::MatrixXd x(rightHandSide.rows(), rightHandSide.cols());
  for (Index k = 0; k < this->Structure.size(); ++k)
  {
    x.row(k) = rightHandSide.row(order[k]);
  }
  Eigen::MatrixXd rows;
  for (const Supernode& node : nodes)
  {
    const ConstBlock front(this->Blocks.data() + node.block, node.frontSize(), node.columnCount());
    auto own = x.middleRows(node.first, node.columnCount());
    front.topRows(node.columnCount()).triangularView<Eigen::UnitLower>().solveInPlace(own);
    rows.noalias() = front.bottomRows(node.rowCount()) * own;
    for (Index k = 0; k < node.rowCount(); ++k)
    {
      x.row(this->Structure.row(node.rowsBegin + k)) -= rows.row(k);
    }
  }
  x.array().colwise() /= this->Diagonal.array();
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
  {
    const ConstBlock front(
      this->Blocks.data() + node->block, node->frontSize(), node->columnCount());
    rows.resize(node->rowCount(), x.cols());
    for (Index k = 0; k < node->rowCount(); ++k)
    {
      rows.row(k) = x.row(this->Structure.row(node->rowsBegin + k));
    }
    auto own = x.middleRows(node->first, node->columnCount());
    own.noalias() -= front.bottomRows(node->rowCount()).transpose() * rows;
    front.topRows(node->columnCount())
      .triangularView<Eigen::UnitLower>()
      .transpose()
      .solveInPlace(own);
  }
  Eigen::MatrixXd result(x.rows(), x.cols());
  for (Index k = 0; k < this->Structure.size(); ++k)
  {
    result.row(order[k]) = x.row(k);
  }
  return result;
}
}
