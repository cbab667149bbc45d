// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/MultifrontalFactorization.h"

#include "Base/Memory.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
constexpr std::size_t taskCount = 64; ///< a subtree has no more than its share of the work
constexpr Index worthThreads = 10000; ///< unknowns: fewer are solved for in less than threads take
constexpr std::size_t roundSize = 8;  ///< tasks between two looks at the top

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
  const std::size_t bytes = this->Structure.blocksSize() * sizeof(double);
  if (bytes > execution.factorMemory)
  {
    refuseMemory(bytes);
  }
  try
  {
    this->Blocks.assign(this->Structure.blocksSize(), 0.0);
  }
  catch (const std::bad_alloc&)
  {
    refuseMemory(bytes);
  }
  this->Updates.assign(this->Structure.supernodes().size(), SteppedTriangle());
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
  const bool sound = next == places.size() && this->eliminateAll(execution);
  this->Updates.clear();
  return sound;
}

/// Some subtrees at a time, and what of the top has all its children by then: fewer updates wait
/// than if the top came last.
bool MultifrontalFactorization::eliminateAll(const Execution& execution)
{
  std::vector<char> sound(this->Tasks.size(), 1);
  auto top = this->Top.begin();
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
    bool all = std::all_of(sound.begin(), sound.end(), [](char good) { return good != 0; });
    const auto later = this->FirstRoots.begin() + static_cast<std::ptrdiff_t>(done + roundSize);
    const Index next = later == this->FirstRoots.end()
      ? static_cast<Index>(this->Structure.supernodes().size())
      : *std::min_element(later, this->FirstRoots.end());
    for (; all && top != this->Top.end() && *top < next; ++top)
    {
      all = !execution.cancelled() && this->eliminate(*top, execution);
    }
    if (!all)
    {
      return false;
    }
  }
  return true;
}

DenseFront MultifrontalFactorization::front(const Supernode& node)
{
  return { this->Blocks.data() + node.block, node.frontSize(), node.columnCount() };
}

ConstDenseFront MultifrontalFactorization::front(const Supernode& node) const
{
  return { this->Blocks.data() + node.block, node.frontSize(), node.columnCount() };
}

/// Adds what a child left of its rows to the front of its parent.
void MultifrontalFactorization::addChild(
  const Supernode& node, Index child, SteppedTriangle& update)
{
  const Supernode& below = this->Structure.supernodes()[child];
  const DenseFront own = this->front(node);
  const Index size = below.rowCount();
  const Index* const place = this->Structure.placesInParent(below);
  for (Index b = 0; b < size; ++b)
  {
    // The update has the rows below the columns alone.
    double* const to = place[b] < own.columns ? own.column(place[b]) + place[b]
                                              : update.diagonal(place[b] - own.columns);
    const double* const values = this->Updates[child].diagonal(b);
    for (Index a = b; a < size; ++a)
    {
      to[place[a] - place[b]] += values[a - b];
    }
  }
  this->Updates[child] = SteppedTriangle();
}

bool MultifrontalFactorization::eliminate(Index s, const Execution& execution)
{
  const Supernode& node = this->Structure.supernodes()[s];
  SteppedTriangle update(node.rowCount());
  for (Index child : node.children)
  {
    this->addChild(node, child, update);
  }
  const DenseFront own = this->front(node);
  const bool sound = eliminateFront(own, update, execution);
  for (Index k = 0; k < own.columns; ++k)
  {
    this->Diagonal[node.first + k] = own.column(k)[k];
  }
  this->Updates[s] = std::move(update);
  return sound;
}

/// L x = x within one supernode; what is left for the rows below is passed on to its parent.
void MultifrontalFactorization::substituteForward(
  const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& passed, Eigen::MatrixXd& work) const
{
  const ConstDenseFront front = this->front(node);
  FrontVectors w(work.data(), front.size, work.cols(), Eigen::OuterStride<>(work.rows()));
  w.topRows(front.columns) = x.middleRows(node.first, front.columns);
  w.bottomRows(front.rows()).setZero();
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
  flattening::substituteForward(front, w);
  x.middleRows(node.first, front.columns) = w.topRows(front.columns);
  passed.middleRows(node.rowsBegin, front.rows()) = w.bottomRows(front.rows());
}

void MultifrontalFactorization::substituteBackward(
  const Supernode& node, Eigen::MatrixXd& x, Eigen::MatrixXd& work) const
{
  const ConstDenseFront front = this->front(node);
  const Index* const rows = this->Structure.rows(node);
  FrontVectors w(work.data(), front.size, work.cols(), Eigen::OuterStride<>(work.rows()));
  w.topRows(front.columns) = x.middleRows(node.first, front.columns);
  for (Index c = 0; c < x.cols(); ++c)
  {
    for (Index k = 0; k < front.rows(); ++k)
    {
      w(front.columns + k, c) = x(rows[k], c);
    }
  }
  flattening::substituteBackward(front, w);
  x.middleRows(node.first, front.columns) = w.topRows(front.columns);
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
