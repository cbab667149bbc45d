// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/FactorBlocks.h"

#include "Sparse/VectorNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace flattening
{
namespace
{
/// A factor with larger numbers solves nothing; smaller ones say nothing, and cost processors that
/// take numbers near the least of their kind by another way much time.
constexpr double largestSingle = 1e30;
constexpr double smallestSingle = 1e-30;

/// Rounds numbers; false where one is too large, or none.
bool roundOneByOne(const double* values, float* to, std::size_t count)
{
  bool kept = true;
  for (std::size_t k = 0; k < count; ++k)
  {
    const double size = std::abs(values[k]);
    kept = kept && size <= largestSingle;
    to[k] = size >= smallestSingle && size <= largestSingle ? static_cast<float>(values[k]) : 0.0F;
  }
  return kept;
}

using Round = bool (*)(const double* values, float* to, std::size_t count);

#if defined(__GNUC__)
using TwoSingles = float __attribute__((vector_size(8)));
using FourSingles = float __attribute__((vector_size(16)));

/// A compiler that heeds exceptions of the processor makes no vectors of the loop above.
template <typename Vector, typename Singles>
FLATTENING_INLINE bool roundVectors(const double* values, float* to, std::size_t count)
{
  constexpr std::size_t width = sizeof(Vector) / sizeof(double);
  if (count < width)
  {
    return roundOneByOne(values, to, count);
  }
  const Vector zero{};
  auto tooLarge = zero < zero;
  for (std::size_t next = 0; next < count; next += width)
  {
    const std::size_t k = std::min(next, count - width); // the last ones again where some are left
    Vector value;
    load(values + k, value);
    const Vector size = value < zero ? -value : value;
    tooLarge |= ~(size <= largestSingle);
    const auto counts = (size >= smallestSingle) & (size <= largestSingle);
    const Singles single = __builtin_convertvector(counts ? value : zero, Singles);
    std::memcpy(to + k, &single, sizeof(single));
  }
  bool kept = true;
  for (std::size_t lane = 0; lane < width; ++lane)
  {
    kept = kept && tooLarge[lane] == 0;
  }
  return kept;
}

bool roundByTwo(const double* values, float* to, std::size_t count)
{
  return roundVectors<Double2, TwoSingles>(values, to, count);
}
#else
bool roundByTwo(const double* values, float* to, std::size_t count)
{
  return roundOneByOne(values, to, count);
}
#endif

#if FLATTENING_X86
__attribute__((target("avx2"))) bool roundByFour(const double* values, float* to, std::size_t count)
{
  return roundVectors<FourNumbers, FourSingles>(values, to, count);
}
#endif

Round widestRound()
{
#if FLATTENING_X86
  // Compilers take masks of AVX-512 apart where no more of it than its foundation is allowed.
  return forWidest<Round>(roundByTwo, roundByFour, roundByFour);
#else
  return roundByTwo;
#endif
}
}

void FactorBlocks::allocate(std::size_t count)
{
  const auto renew = [count](auto& values) {
    if (values.size() != count)
    {
      values = {}; // first, so that there are never two
      values.resize(count);
    }
  };
  if (this->Precision == FactorPrecision::Single)
  {
    renew(this->Singles);
  }
  else
  {
    renew(this->Doubles);
  }
}

bool FactorBlocks::keep(const DenseFront& front, std::size_t place)
{
  static const Round round = widestRound();
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
      kept = round(values, this->Singles.data() + to, count) && kept;
    }
    else
    {
      std::copy_n(values, count, this->Doubles.data() + to);
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

#if defined(__GNUC__)
/// As many rows of to -= columns times c, from one on, as whole vectors cover. \return the next row
template <typename Vector, typename Value>
FLATTENING_INLINE Index subtractRows(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index from, Index count)
{
  constexpr Index width = sizeof(Vector) / sizeof(double);
  Index i = from;
  for (; i + width <= count; i += width)
  {
    Vector value;
    Vector rows[columnsOfPanel]; // NOLINT(modernize-avoid-c-arrays): stays in registers
    load(to + i, value);
    for (Index k = 0; k < columnsOfPanel; ++k)
    {
      load(column[k] + i, rows[k]);
    }
    value -= (rows[0] * c[0] + rows[1] * c[1]) + (rows[2] * c[2] + rows[3] * c[3]);
    std::memcpy(to + i, &value, sizeof(Vector));
  }
  return i;
}

/// Adds the products of eight rows to the sums of some columns.
template <typename Vector, Index Columns, typename Value>
FLATTENING_INLINE void addProducts(const Value* const* column, const double* x, Index row,
  Vector (
    &sum)[Columns][lanes * sizeof(double) / sizeof(Vector)]) // NOLINT(modernize-avoid-c-arrays)
{
  constexpr Index width = sizeof(Vector) / sizeof(double);
  for (Index part = 0; part < lanes / width; ++part)
  {
    Vector factor;
    load(x + part * width, factor);
    for (Index k = 0; k < Columns; ++k)
    {
      Vector rows;
      load(column[k] + row + part * width, rows);
      sum[k][part] += rows * factor;
    }
  }
}

/// The dot products of some columns with x. Eight numbers and more are kept up to the end of each
/// column, those of columns before it included.
template <typename Vector, Index Columns, typename Value>
FLATTENING_INLINE void multiply(
  const Value* const* column, const double* x, Index count, double* products)
{
  constexpr Index parts = lanes * sizeof(double) / sizeof(Vector);
  Vector sum[Columns][parts] = {}; // NOLINT(modernize-avoid-c-arrays): stays in registers
  Index i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    addProducts<Vector, Columns>(column, x + i, i, sum);
  }
  if (i < count)
  {
    // The last eight rows, those that have been counted by 0.
    std::array<double, lanes> rest{};
    std::copy(x + i, x + count, rest.end() - (count - i));
    addProducts<Vector, Columns>(column, rest.data(), count - lanes, sum);
  }
  for (Index k = 0; k < Columns; ++k)
  {
    std::array<double, lanes> s{};
    std::memcpy(s.data(), &sum[k], sizeof(s));
    products[k] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  }
}
#endif

template <typename Value>
void subtractOneByOne(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index from, Index count)
{
  for (Index i = from; i < count; ++i)
  {
    to[i] -=
      (column[0][i] * c[0] + column[1][i] * c[1]) + (column[2][i] * c[2] + column[3][i] * c[3]);
  }
}

template <typename Value>
void multiplyOneByOne(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
  products.fill(0.0);
  for (Index i = 0; i < count; ++i)
  {
    for (Index k = 0; k < columnsOfPanel; ++k)
    {
      products[k] += column[k][i] * x[i];
    }
  }
}

template <typename Value>
using Subtract = void (*)(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index count);
template <typename Value>
using Multiply = void (*)(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products);

template <typename Value>
void subtractByTwo(double* to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
#if defined(__GNUC__)
  subtractOneByOne(to, column, c, subtractRows<Double2>(to, column, c, 0, count), count);
#else
  subtractOneByOne(to, column, c, 0, count);
#endif
}

template <typename Value>
void multiplyByTwo(const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
#if defined(__GNUC__)
  multiply<Double2, 2>(column.data(), x, count, products.data());
  multiply<Double2, 2>(column.data() + 2, x, count, products.data() + 2);
#else
  multiplyOneByOne(column, x, count, products);
#endif
}

#if FLATTENING_X86
template <typename Value>
__attribute__((target("avx2"))) void subtractByFour(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
  const Index next = subtractRows<FourNumbers>(to, column, c, 0, count);
  subtractOneByOne(to, column, c, subtractRows<Double2>(to, column, c, next, count), count);
}

template <typename Value>
__attribute__((target("avx2"))) void multiplyByFour(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
  multiply<FourNumbers, columnsOfPanel>(column.data(), x, count, products.data());
}

template <typename Value>
__attribute__((target("avx512f"))) void subtractByEight(
  double* to, const Panel<Value>& column, const PanelNumbers& c, Index count)
{
  Index next = subtractRows<EightNumbers>(to, column, c, 0, count);
  next = subtractRows<FourNumbers>(to, column, c, next, count);
  subtractOneByOne(to, column, c, subtractRows<Double2>(to, column, c, next, count), count);
}

template <typename Value>
__attribute__((target("avx512f"))) void multiplyByEight(
  const Panel<Value>& column, const double* x, Index count, PanelNumbers& products)
{
  multiply<EightNumbers, columnsOfPanel>(column.data(), x, count, products.data());
}
#endif

template <typename Value>
Subtract<Value> widestSubtract()
{
#if FLATTENING_X86
  return forWidest<Subtract<Value>>(
    subtractByTwo<Value>, subtractByFour<Value>, subtractByEight<Value>);
#else
  return subtractByTwo<Value>;
#endif
}

template <typename Value>
Multiply<Value> widestMultiply()
{
#if FLATTENING_X86
  return forWidest<Multiply<Value>>(
    multiplyByTwo<Value>, multiplyByFour<Value>, multiplyByEight<Value>);
#else
  return multiplyByTwo<Value>;
#endif
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

}

template <typename Value>
void substituteForward(const FactorColumns<const Value>& factor, FrontVectors w)
{
  static const Subtract<Value> subtract = widestSubtract<Value>();
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
void substituteBackward(const FactorColumns<const Value>& factor, FrontVectors w)
{
  static const Multiply<Value> widest = widestMultiply<Value>();
  const Multiply<Value> multiply = factor.size < lanes ? multiplyOneByOne<Value> : widest;
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

template void substituteForward(const FactorColumns<const double>& factor, FrontVectors w);
template void substituteForward(const FactorColumns<const float>& factor, FrontVectors w);
template void substituteBackward(const FactorColumns<const double>& factor, FrontVectors w);
template void substituteBackward(const FactorColumns<const float>& factor, FrontVectors w);
}
