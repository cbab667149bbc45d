// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/DenseFront.h"

#include "Sparse/VectorNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace flattening
{
namespace
{
/// Sums of a tile fill half of the registers of AVX2 and leave the others for the factors.
constexpr Index tileRows = 8;
constexpr Index tileColumns = 4;
/// Of left and right together what the second cache holds, and of a strip of right what the first
/// does.
constexpr Index blockRows = 64;
constexpr Index blockColumns = 64;
constexpr Index blockDepth = 96;
/// Fewer columns do not pay for copying the left factor into strips.
constexpr Index packedFrom = 24;

/// to -= sum over p of left[p][rows] right[p][columns], for the rows of Wide vectors.
template <typename Vector, int Wide>
FLATTENING_INLINE void subtractTile(const double* left, std::size_t leftStride, const double* right,
  Index depth, double* to, std::size_t stride)
{
  constexpr int count = sizeof(Vector) / sizeof(double);
#if defined(__GNUC__)
  Vector sum[tileColumns][Wide] = {}; // NOLINT(modernize-avoid-c-arrays): stays in registers
  for (Index p = 0; p < depth; ++p, left += leftStride, right += tileColumns)
  {
    Vector column[Wide]; // NOLINT(modernize-avoid-c-arrays)
    for (int i = 0; i < Wide; ++i)
    {
      std::memcpy(&column[i], left + i * count, sizeof(Vector));
    }
    for (Index j = 0; j < tileColumns; ++j)
    {
      const Vector factor = right[j] - Vector{};
      for (int i = 0; i < Wide; ++i)
      {
        sum[j][i] += column[i] * factor;
      }
    }
  }
  for (Index j = 0; j < tileColumns; ++j)
  {
    for (int i = 0; i < Wide; ++i)
    {
      double* const place = to + j * stride + i * count;
      Vector value;
      std::memcpy(&value, place, sizeof(Vector));
      value -= sum[j][i];
      std::memcpy(place, &value, sizeof(Vector));
    }
  }
#else
  for (Index j = 0; j < tileColumns; ++j)
  {
    for (int i = 0; i < count * Wide; ++i)
    {
      double sum = 0.0;
      for (Index p = 0; p < depth; ++p)
      {
        sum += left[p * leftStride + i] * right[p * tileColumns + j];
      }
      to[j * stride + i] -= sum;
    }
  }
#endif
}

using Tile = void (*)(const double* left, std::size_t leftStride, const double* right, Index depth,
  double* to, std::size_t stride);

void tileOfTwo(const double* left, std::size_t leftStride, const double* right, Index depth,
  double* to, std::size_t stride)
{
  subtractTile<Double2, 2>(left, leftStride, right, depth, to, stride);
  subtractTile<Double2, 2>(left + 4, leftStride, right, depth, to + 4, stride);
}

#if FLATTENING_X86
__attribute__((target("avx2"))) void tileOfFour(const double* left, std::size_t leftStride,
  const double* right, Index depth, double* to, std::size_t stride)
{
  subtractTile<FourNumbers, 2>(left, leftStride, right, depth, to, stride);
}

__attribute__((target("avx512f"))) void tileOfEight(const double* left, std::size_t leftStride,
  const double* right, Index depth, double* to, std::size_t stride)
{
  subtractTile<EightNumbers, 1>(left, leftStride, right, depth, to, stride);
}
#else
constexpr Tile tileOfFour = tileOfTwo;
constexpr Tile tileOfEight = tileOfTwo;
#endif

/// A tile that is cut off by the matrix's edge.
void subtractPartOfTile(Tile tile, const double* left, std::size_t leftStride, const double* right,
  Index depth, double* to, std::size_t stride, Index rows, Index columns)
{
  std::array<double, tileRows * tileColumns> negative{};
  tile(left, leftStride, right, depth, negative.data(), tileRows);
  for (Index j = 0; j < columns; ++j)
  {
    for (Index i = 0; i < rows; ++i)
    {
      to[j * stride + i] += negative[j * tileRows + i];
    }
  }
}

/// One block of rows, columns and depth.
class BlockProduct
{
public:
  explicit BlockProduct(Tile tile)
    : Subtract(tile)
  {
  }

  /// Takes rows [begin, begin + count) of the right factor, times D.
  void takeRight(const DenseProduct& product, Index begin, Index count, Index first, Index depth)
  {
    this->Depth = depth;
    for (Index strip = 0; strip < count; strip += tileColumns)
    {
      double* to = this->Right.data() + strip * depth;
      const Index width = std::min(tileColumns, count - strip);
      const double* from = product.right.values + first * product.right.stride + begin + strip;
      for (Index p = 0; p < depth; ++p, to += tileColumns, from += product.right.stride)
      {
        for (Index j = 0; j < tileColumns; ++j)
        {
          to[j] = j < width ? from[j] * product.diagonal[first + p] : 0.0;
        }
      }
    }
  }

  /// Takes rows of the left factor; all of them by copies in strips, or only those of a strip that
  /// is cut off.
  void takeLeft(const double* left, std::size_t stride, Index count, bool copied)
  {
    this->LeftInPlace = copied ? nullptr : left;
    this->Stride = stride;
    const Index whole = count / tileRows * tileRows;
    for (Index strip = copied ? 0 : whole; strip < count; strip += tileRows)
    {
      double* to = this->Left.data() + strip * this->Depth;
      const Index height = std::min(tileRows, count - strip);
      const double* from = left + strip;
      for (Index p = 0; p < this->Depth; ++p, to += tileRows, from += stride)
      {
        std::copy(from, from + height, to);
        std::fill(to + height, to + tileRows, 0.0);
      }
    }
  }

  /// \param below how many rows above the first the diagonal of the first column is; tiles above
  /// the diagonal are left out
  void subtract(double* to, std::size_t stride, Index rows, Index columns, Index below) const
  {
    for (Index j = 0; j < columns; j += tileColumns)
    {
      const double* const right = this->Right.data() + j * this->Depth;
      const Index width = std::min(tileColumns, columns - j);
      const Index start = std::max<Index>(0, j - below) / tileRows * tileRows;
      for (Index i = start; i < rows; i += tileRows)
      {
        const bool whole = i + tileRows <= rows;
        const bool inPlace = this->LeftInPlace && whole;
        const double* const left =
          inPlace ? this->LeftInPlace + i : this->Left.data() + i * this->Depth;
        const std::size_t leftStride = inPlace ? this->Stride : tileRows;
        double* const place = to + j * stride + i;
        if (whole && width == tileColumns)
        {
          this->Subtract(left, leftStride, right, this->Depth, place, stride);
        }
        else
        {
          subtractPartOfTile(this->Subtract, left, leftStride, right, this->Depth, place, stride,
            std::min(tileRows, rows - i), width);
        }
      }
    }
  }

private:
  Tile Subtract;
  Index Depth = 0;
  const double* LeftInPlace = nullptr;
  std::size_t Stride = 0;
  alignas(64) std::array<double, blockRows * blockDepth> Left;
  alignas(64) std::array<double, blockColumns * blockDepth> Right;
};
}

void subtractProduct(const DenseProduct& product)
{
  static const auto tile = forWidest<Tile>(tileOfTwo, tileOfFour, tileOfEight);
  BlockProduct block(tile);
  for (Index first = 0; first < product.depth; first += blockDepth)
  {
    const Index depth = std::min(blockDepth, product.depth - first);
    for (Index column = 0; column < product.columns; column += blockColumns)
    {
      const Index columns = std::min(blockColumns, product.columns - column);
      block.takeRight(product, column, columns, first, depth);
      const Index top = product.lower ? column / blockRows * blockRows : 0;
      for (Index row = top; row < product.rows; row += blockRows)
      {
        const Index rows = std::min(blockRows, product.rows - row);
        block.takeLeft(product.left.values + first * product.left.stride + row, product.left.stride,
          rows, columns >= packedFrom);
        block.subtract(product.to + column * product.stride + row, product.stride, rows, columns,
          product.lower ? row - column : columns);
      }
    }
  }
}

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
  execution.forEachTask((tiles + 1) / 2, [&](Index pair) {
    subtract(pair);
    if (tiles - 1 - pair != pair)
    {
      subtract(tiles - 1 - pair);
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
