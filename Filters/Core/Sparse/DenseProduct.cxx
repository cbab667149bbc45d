// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/DenseProduct.h"

#include "Sparse/VectorNumbers.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace flattening
{
namespace
{
constexpr Index tileRows = 8;
constexpr Index tileColumns = 4;
/// Of left and right together what the second cache holds, and of a strip of right what the first
/// does.
constexpr Index blockRows = 64;
constexpr Index blockColumns = 64;
constexpr Index blockDepth = 96;
/// Fewer columns do not pay for copying the left factor into strips.
constexpr Index packedFrom = 24;

/// to -= sum over p of left[p][rows] right[p][columns], for the rows of so many vectors.
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
}
