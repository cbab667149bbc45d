// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/DenseFront.h"

#include "Sparse/DenseProduct.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{
/// Columns that are taken together, so that what they are subtracted from is loaded once for all.
constexpr Index panelWidth = 4;
constexpr Index blockWidth = 32;
constexpr Index tileWidth = 128; ///< of updates that are worth more than one thread

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

/// Columns [begin, begin + columns) from their diagonal down, less what the columns
/// [first, first + depth) say of them.
DenseProduct trailing(const DenseFront& front, Index begin, Index columns, Index first, Index depth,
  const double* pivots)
{
  const std::size_t size = front.size;
  const DenseColumns factor{ front.column(first) + begin, size };
  return { front.column(begin) + begin, size, front.size - begin, columns, factor, factor,
    pivots + first, depth, true };
}

/// The columns [begin, end), whose earlier ones have been subtracted from them.
bool eliminateBlock(const DenseFront& front, Index begin, Index end, double* pivots)
{
  for (Index panel = begin; panel < end; panel += panelWidth)
  {
    const Index next = std::min(panel + panelWidth, end);
    subtractProduct(trailing(front, panel, next - panel, begin, panel - begin, pivots));
    if (!eliminatePanel(front, panel, next))
    {
      return false;
    }
    for (Index k = panel; k < next; ++k)
    {
      pivots[k] = front.column(k)[k];
    }
  }
  return true;
}

/// Calls subtract(tile) for the tiles of a lower triangle.
template <typename Subtract>
void forEachTile(Index tiles, const Execution& execution, const Subtract& subtract)
{
  if (tiles < 2)
  {
    if (tiles == 1)
    {
      subtract(0);
    }
    return;
  }
  // The first tiles are the longest: pair each with one from the end.
  execution.parallelFor((tiles + 1) / 2, [&](Index first, Index last) {
    for (Index pair = first; pair < last; ++pair)
    {
      subtract(pair);
      if (tiles - 1 - pair != pair)
      {
        subtract(tiles - 1 - pair);
      }
    }
  });
}

/// The columns of a product of which the lower triangle alone is needed, from one on.
DenseProduct tileOf(const DenseProduct& product, Index begin, Index width)
{
  DenseProduct part = product;
  part.rows -= begin;
  part.columns = std::min(width, product.columns - begin);
  part.left.values += begin;
  part.right.values += begin;
  return part;
}

/// A product of which the lower triangle alone is needed, tile by tile.
void subtractTiles(const DenseProduct& product, const Execution& execution)
{
  const Index tiles = (product.columns + tileWidth - 1) / tileWidth;
  forEachTile(tiles, execution, [&](Index tile) {
    const std::size_t begin = std::size_t(tile) * tileWidth;
    DenseProduct part = tileOf(product, tile * tileWidth, tileWidth);
    part.to += begin * product.stride + begin;
    subtractProduct(part);
  });
}

/// What the columns of a front do to the rows below.
void subtractUpdate(const DenseFront& front, const double* pivots, BlockedLowerTriangle& update,
  const Execution& execution)
{
  constexpr Index width = BlockedLowerTriangle::stepWidth;
  const DenseColumns below{ front.column(0) + front.columns, std::size_t(front.size) };
  const DenseProduct product{ nullptr, 0, front.rows(), front.rows(), below, below, pivots,
    front.columns, true };
  forEachTile((front.rows() + width - 1) / width, execution, [&](Index tile) {
    DenseProduct part = tileOf(product, tile * width, width);
    part.to = update.diagonal(tile * width);
    part.stride = update.stride(tile * width);
    subtractProduct(part);
  });
}
}

bool eliminateFront(
  const DenseFront& front, BlockedLowerTriangle& update, const Execution& execution)
{
  std::vector<double> pivots(front.columns);
  for (Index begin = 0; begin < front.columns; begin += blockWidth)
  {
    const Index end = std::min(begin + blockWidth, front.columns);
    if (!eliminateBlock(front, begin, end, pivots.data()))
    {
      return false;
    }
    if (end < front.columns)
    {
      subtractTiles(
        trailing(front, end, front.columns - end, begin, end - begin, pivots.data()), execution);
    }
  }
  subtractUpdate(front, pivots.data(), update, execution);
  return true;
}
}
