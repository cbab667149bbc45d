// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/DenseFront.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flattening
{
namespace
{
/// Columns that are taken together, so that what they are subtracted from is loaded once for all.
constexpr Index panelWidth = 4;
/// Larger fronts gain more from Eigen's blocked product than they pay for packing.
constexpr Index smallFront = 160;
constexpr Index blockWidth = 32;
constexpr Index tileWidth = 128; ///< of updates that are worth more than one thread

using Block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

Block blockOf(const DenseFront& front, Index row, Index column, Index rows, Index columns)
{
  return { front.column(column) + row, rows, columns, Eigen::OuterStride<>(front.size) };
}

/// to -= sum of c[k] times column k, for up to four columns.
void subtractColumns(double* __restrict to, const std::array<const double*, panelWidth>& column,
  const std::array<double, panelWidth>& c, Index width, Index count)
{
  const double* __restrict a = column[0];
  if (width == panelWidth)
  {
    const double* __restrict b = column[1];
    const double* __restrict d = column[2];
    const double* __restrict e = column[3];
    for (Index i = 0; i < count; ++i)
    {
      to[i] -= (a[i] * c[0] + b[i] * c[1]) + (d[i] * c[2] + e[i] * c[3]);
    }
    return;
  }
  for (Index k = 0; k < width; ++k)
  {
    const double* __restrict b = column[k];
    for (Index i = 0; i < count; ++i)
    {
      to[i] -= b[i] * c[k];
    }
  }
}

/// to -= the columns [begin, begin + width) from the given row down, each times its entry in that
/// row of L D.
void subtractPanel(const DenseFront& front, Index begin, Index width, Index row, double* to)
{
  std::array<const double*, panelWidth> column{};
  std::array<double, panelWidth> c{};
  for (Index k = 0; k < width; ++k)
  {
    const double* const values = front.column(begin + k);
    column[k] = values + row;
    c[k] = values[row] * values[begin + k];
  }
  subtractColumns(to, column, c, width, front.size - row);
}

/// Columns [begin, end), whose earlier ones have been subtracted from them.
bool eliminatePanel(const DenseFront& front, Index begin, Index end)
{
  for (Index j = begin; j < end; ++j)
  {
    double* const values = front.column(j);
    if (j > begin)
    {
      subtractPanel(front, begin, j - begin, j, values + j);
    }
    const double pivot = values[j];
    if (!std::isfinite(pivot) || pivot == 0.0)
    {
      return false;
    }
    const double inverse = 1.0 / pivot;
    for (Index i = j + 1; i < front.size; ++i)
    {
      values[i] *= inverse;
    }
  }
  return true;
}

/// The columns [begin, end) by panels.
bool eliminateColumns(const DenseFront& front, Index begin, Index end)
{
  for (Index panel = begin; panel < end; panel += panelWidth)
  {
    const Index next = std::min(panel + panelWidth, end);
    if (!eliminatePanel(front, panel, next))
    {
      return false;
    }
    for (Index k = next; k < end; ++k)
    {
      subtractPanel(front, panel, next - panel, k, front.column(k) + k);
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

bool eliminateSmall(const DenseFront& front, double* update)
{
  if (!eliminateColumns(front, 0, front.columns))
  {
    return false;
  }
  const Index rows = front.rows();
  for (Index k = 0; k < rows; ++k)
  {
    double* const to = update + std::size_t(k) * std::size_t(rows) + k;
    for (Index panel = 0; panel < front.columns; panel += panelWidth)
    {
      subtractPanel(
        front, panel, std::min(panelWidth, front.columns - panel), front.columns + k, to);
    }
  }
  return true;
}

bool eliminateLarge(const DenseFront& front, double* update, const Execution& execution)
{
  for (Index begin = 0; begin < front.columns; begin += blockWidth)
  {
    const Index end = std::min(begin + blockWidth, front.columns);
    if (!eliminateColumns(front, begin, end))
    {
      return false;
    }
    const Index rest = front.columns - end;
    if (rest > 0)
    {
      const Index width = end - begin;
      const Block lower = blockOf(front, end, begin, front.size - end, width);
      const Eigen::MatrixXd scaled =
        lower.topRows(rest) * blockOf(front, begin, begin, width, width).diagonal().asDiagonal();
      blockOf(front, end, end, front.size - end, rest).noalias() -= lower * scaled.transpose();
    }
  }
  const Index rows = front.rows();
  if (rows > 0)
  {
    const Block lower = blockOf(front, front.columns, 0, rows, front.columns);
    const Eigen::MatrixXd scaled =
      lower * blockOf(front, 0, 0, front.columns, front.columns).diagonal().asDiagonal();
    subtractProduct(Eigen::Map<Eigen::MatrixXd>(update, rows, rows), scaled, lower, execution);
  }
  return true;
}

double dot(const double* a, const double* b, Index count)
{
  // Four sums, so that one does not wait for the other.
  std::array<double, 4> sum{};
  Index i = 0;
  for (; i + 4 <= count; i += 4)
  {
    for (Index k = 0; k < 4; ++k)
    {
      sum[k] += a[i + k] * b[i + k];
    }
  }
  for (; i < count; ++i)
  {
    sum[0] += a[i] * b[i];
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}
}

bool eliminateFront(const DenseFront& front, double* update, const Execution& execution)
{
  return front.size <= smallFront ? eliminateSmall(front, update)
                                  : eliminateLarge(front, update, execution);
}

void substituteForward(const ConstDenseFront& front, FrontVectors w)
{
  for (Index begin = 0; begin < front.columns; begin += panelWidth)
  {
    const Index width = std::min(panelWidth, front.columns - begin);
    const Index end = begin + width;
    std::array<const double*, panelWidth> below{};
    for (Index k = 0; k < width; ++k)
    {
      below[k] = front.column(begin + k) + end;
    }
    for (Index c = 0; c < w.cols(); ++c)
    {
      double* const x = w.col(c).data();
      std::array<double, panelWidth> known{};
      for (Index k = 0; k < width; ++k)
      {
        known[k] = x[begin + k];
        for (Index i = begin + k + 1; i < end; ++i)
        {
          x[i] -= front.column(begin + k)[i] * known[k];
        }
      }
      subtractColumns(x + end, below, known, width, front.size - end);
    }
  }
}

void substituteBackward(const ConstDenseFront& front, FrontVectors w)
{
  for (Index j = front.columns; j-- > 0;)
  {
    const double* const below = front.column(j) + j + 1;
    for (Index c = 0; c < w.cols(); ++c)
    {
      double* const x = w.col(c).data();
      x[j] -= dot(below, x + j + 1, front.size - j - 1);
    }
  }
}
}
