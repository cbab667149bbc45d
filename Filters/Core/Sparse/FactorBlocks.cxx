// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/FactorBlocks.h"

#include "Sparse/InstructionSets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flattening
{
namespace
{
/// A factor with larger numbers solves nothing; smaller ones say nothing, and cost processors that
/// take numbers near the least of their kind by another way much time.
constexpr double largestSingle = 1e30;
constexpr double smallestSingle = 1e-30;

/// Rounds numbers; false where one is too large, or none. Without a branch, so that compilers make
/// vectors of the loop.
FLATTENING_INLINE bool roundNumbers(
  const double* __restrict values, float* __restrict to, std::size_t count)
{
  std::size_t tooLarge = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double size = std::abs(values[k]);
    tooLarge += size <= largestSingle ? 0 : 1;
    to[k] = static_cast<float>(size >= smallestSingle && size <= largestSingle ? values[k] : 0.0);
  }
  return tooLarge == 0;
}

using Round = bool (*)(const double* values, float* to, std::size_t count);

bool roundByTwo(const double* values, float* to, std::size_t count)
{
  return roundNumbers(values, to, count);
}
FLATTENING_FOR_AVX2 bool roundByFour(const double* values, float* to, std::size_t count)
{
  return roundNumbers(values, to, count);
}
}

void FactorBlocks::allocate(std::size_t count)
{
  if (count == this->Count)
  {
    return;
  }
  this->Doubles.reset();
  this->Singles.reset();
  this->Count = 0;
  if (this->Precision == FactorPrecision::Single)
  {
    this->Singles.reset(new float[count]);
  }
  else
  {
    this->Doubles.reset(new double[count]);
  }
  this->Count = count;
}

bool FactorBlocks::keep(const DenseFront& front, std::size_t place)
{
  static const auto round = forWidest<Round>(roundByTwo, roundByFour, roundByFour);
  bool kept = true;
  std::size_t to = place;
  std::size_t count = 0;
  for (Index k = 0; k < front.columns; ++k, to += count)
  {
    const Index first = FactorColumns<double>::firstRow(k);
    const double* const values = front.column(k) + first;
    count = std::size_t(front.size - first);
    if (this->Precision == FactorPrecision::Single)
    {
      kept = round(values, this->Singles.get() + to, count) && kept;
    }
    else
    {
      std::copy_n(values, count, this->Doubles.get() + to);
    }
  }
  return kept;
}

namespace
{
/// Columns that are taken together, so that what they meet is loaded once for all.
constexpr Index columnsOfPanel = FactorColumns<double>::panelWidth;
/// Sums of a dot product, of every eighth row each: the same for every width of instructions.
constexpr Index lanes = 8;

/// Columns, each from its first row below the panel.
template <typename Value>
using Panel = std::array<const Value*, columnsOfPanel>;
using PanelNumbers = std::array<double, columnsOfPanel>;

template <typename Value>
FLATTENING_INLINE void subtractRows(
  double* __restrict to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
  const Value* const __restrict first = column[0];
  const Value* const __restrict second = column[1];
  const Value* const __restrict third = column[2];
  const Value* const __restrict fourth = column[3];
  for (Index i = 0; i < count; ++i)
  {
    to[i] -= (first[i] * c[0] + second[i] * c[1]) + (third[i] * c[2] + fourth[i] * c[3]);
  }
}

/// The dot products of the columns with x.
template <typename Value>
FLATTENING_INLINE void multiplyRows(
  const Panel<Value>& column, const double* __restrict x, Index count, PanelNumbers& products)
{
  for (Index k = 0; k < columnsOfPanel; ++k)
  {
    const Value* const __restrict values = column[k];
    std::array<double, lanes> s{};
    Index i = 0;
    for (; i + lanes <= count; i += lanes)
    {
      for (Index lane = 0; lane < lanes; ++lane)
      {
        s[lane] += values[i + lane] * x[i + lane];
      }
    }
    for (Index lane = lanes - (count - i); i < count; ++i, ++lane)
    {
      s[lane] += values[i] * x[i];
    }
    products[k] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  }
}

template <typename Value>
using Subtract = void (*)(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index count);
template <typename Value>
using Multiply = void (*)(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products);

// Memory limits both: eight numbers at a time are no faster than four.
template <typename Value>
void subtractByTwo(double* to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
  subtractRows(to, column, c, count);
}
template <typename Value>
FLATTENING_FOR_AVX2 void subtractByFour(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
  subtractRows(to, column, c, count);
}

template <typename Value>
void multiplyByTwo(const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
  multiplyRows(column, x, count, products);
}
template <typename Value>
FLATTENING_FOR_AVX2 void multiplyByFour(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
  multiplyRows(column, x, count, products);
}

/// Of a panel that begins with a column and ends before another.
template <typename Value>
struct PanelColumns
{
  PanelColumns(const FactorColumns<const Value>& factor, Index first, Index last)
    : begin(first)
    , end(last)
    , stride(factor.size - first)
    , values(factor.panel(first))
  {
  }
  Value operator()(Index row, Index column) const
  {
    return this->values[(column - this->begin) * this->stride + row - this->begin];
  }
  /// What is below its last row; where it is not as wide as others, its last column stands for
  /// those that lack.
  Panel<Value> below() const
  {
    Panel<Value> columns{};
    for (Index k = 0; k < columnsOfPanel; ++k)
    {
      const Index column = std::min(k, this->end - 1 - this->begin);
      columns[k] = this->values + column * this->stride + (this->end - this->begin);
    }
    return columns;
  }

  Index begin;
  Index end;
  Index stride;
  const Value* values;
};

template <typename Value>
void forward(const FactorColumns<const Value>& factor, FrontVectors& w)
{
  static const auto subtract =
    forWidest<Subtract<Value>>(subtractByTwo<Value>, subtractByFour<Value>, subtractByFour<Value>);
  for (Index begin = 0; begin < factor.columns; begin += columnsOfPanel)
  {
    const Index end = std::min(begin + columnsOfPanel, factor.columns);
    const PanelColumns<Value> l(factor, begin, end);
    const Panel<Value> below = l.below();
    for (Index c = 0; c < w.cols(); ++c)
    {
      double* const x = w.col(c).data();
      PanelNumbers known{};
      for (Index k = begin; k < end; ++k)
      {
        known[k - begin] = x[k];
        for (Index i = k + 1; i < end; ++i)
        {
          x[i] -= l(i, k) * x[k];
        }
      }
      subtract(x + end, below, known, factor.size - end);
    }
  }
}

template <typename Value>
void backward(const FactorColumns<const Value>& factor, FrontVectors& w)
{
  static const auto multiply =
    forWidest<Multiply<Value>>(multiplyByTwo<Value>, multiplyByFour<Value>, multiplyByFour<Value>);
  for (Index end = factor.columns; end > 0;)
  {
    const Index begin = FactorColumns<Value>::firstRow(end - 1);
    const PanelColumns<Value> l(factor, begin, end);
    const Panel<Value> below = l.below();
    for (Index c = 0; c < w.cols(); ++c)
    {
      double* const x = w.col(c).data();
      PanelNumbers products{};
      multiply(below, x + end, factor.size - end, products);
      for (Index k = end; k-- > begin;)
      {
        x[k] -= products[k - begin];
        for (Index i = k + 1; i < end; ++i)
        {
          x[k] -= l(i, k) * x[i];
        }
      }
    }
    end = begin;
  }
}
}

void substituteForward(const FactorColumns<const double>& factor, FrontVectors w)
{
  forward(factor, w);
}

void substituteForward(const FactorColumns<const float>& factor, FrontVectors w)
{
  forward(factor, w);
}

void substituteBackward(const FactorColumns<const double>& factor, FrontVectors w)
{
  backward(factor, w);
}

void substituteBackward(const FactorColumns<const float>& factor, FrontVectors w)
{
  backward(factor, w);
}
}
