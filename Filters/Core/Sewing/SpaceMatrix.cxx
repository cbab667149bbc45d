// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SpaceMatrix.h"

#include "Base/Memory.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace
{
/// Sorts pairs by their lower vertex, then the higher, full coupling before that of axes.
std::uint64_t pairKey(Index low, Index high, bool axes)
{
  return static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint64_t>(high) << 1U |
    (axes ? 1U : 0U);
}

Index lowOf(std::uint64_t key)
{
  return static_cast<Index>(key >> 32U);
}

Index highOf(std::uint64_t key)
{
  return static_cast<Index>((key & 0xffffffffU) >> 1U);
}
}

void SpaceMatrix::declare(Index a, Index b, bool axes)
{
  if (a != none && b != none && a != b)
  {
    this->Declared.push_back(pairKey(std::min(a, b) / 3, std::max(a, b) / 3, axes));
  }
}

void SpaceMatrix::finish()
{
  std::sort(this->Declared.begin(), this->Declared.end());
  const auto samePair = [](std::uint64_t a, std::uint64_t b) { return a >> 1U == b >> 1U; };
  this->Declared.erase(
    std::unique(this->Declared.begin(), this->Declared.end(), samePair), this->Declared.end());
  const Index vertices = this->Size / 3;
  this->Begin.assign(vertices + 1, 0);
  this->Neighbours.reserve(this->Declared.size());
  std::size_t count = 2 * static_cast<std::size_t>(this->Size);
  auto key = this->Declared.begin();
  for (Index v = 0; v < vertices; ++v)
  {
    Index offset = 0;
    for (; key != this->Declared.end() && lowOf(*key) == v; ++key)
    {
      const bool all = (*key & 1U) == 0;
      this->Neighbours.push_back({ highOf(*key), offset, all });
      offset += all ? 3 : 1;
    }
    this->Begin[v + 1] = static_cast<Index>(this->Neighbours.size());
    count += 3 * static_cast<std::size_t>(offset);
  }
  this->Declared = std::vector<std::uint64_t>();
  if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
  {
    throwOutOfMemory(count * sizeof(double));
  }

  this->Matrix.resize(this->Size, this->Size);
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(count));
  int* row = this->Matrix.innerIndexPtr();
  for (Index column = 0; column < this->Size; ++column)
  {
    const Index v = column / 3;
    this->Matrix.outerIndexPtr()[column] = static_cast<int>(row - this->Matrix.innerIndexPtr());
    for (Index own = column; own < 3 * v + 3; ++own)
    {
      *row++ = own;
    }
    for (Index k = this->Begin[v]; k < this->Begin[v + 1]; ++k)
    {
      const Neighbour& other = this->Neighbours[k];
      for (Index axis = 0; axis < 3; ++axis)
      {
        if (other.all || axis == column % 3)
        {
          *row++ = 3 * other.vertex + axis;
        }
      }
    }
  }
  this->Matrix.outerIndexPtr()[this->Size] = static_cast<int>(count);
  this->clear();
}

void SpaceMatrix::clear()
{
  std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0);
}

const SpaceMatrix::Neighbour& SpaceMatrix::neighbour(Index low, Index high) const
{
  return *std::lower_bound(this->Neighbours.begin() + this->Begin[low],
    this->Neighbours.begin() + this->Begin[low + 1], high,
    [](const Neighbour& n, Index vertex) { return n.vertex < vertex; });
}

/// Where the rows of its neighbours begin in a column of a vertex.
double* SpaceMatrix::column(Index vertex, Index axis)
{
  return this->Matrix.valuePtr() + this->Matrix.outerIndexPtr()[3 * vertex + axis] + 3 - axis;
}

void SpaceMatrix::addOwn(Index a, const Eigen::Matrix3d& block)
{
  for (Index axis = 0; a != none && axis < 3; ++axis)
  {
    double* const diagonal = this->column(a / 3, axis) - 3;
    for (Index row = axis; row < 3; ++row)
    {
      diagonal[row] += block(row, axis);
    }
  }
}

void SpaceMatrix::addPair(Index a, Index b, const Eigen::Matrix3d& block)
{
  if (a == none || b == none)
  {
    return;
  }
  if (a == b)
  {
    this->addOwn(a, block + block.transpose());
    return;
  }
  const Index low = std::min(a, b) / 3;
  const Neighbour& other = this->neighbour(low, std::max(a, b) / 3);
  for (Index axis = 0; axis < 3; ++axis)
  {
    double* const to = this->column(low, axis) + other.offset;
    for (Index row = 0; row < 3; ++row)
    {
      to[row] += a > b ? block(row, axis) : block(axis, row);
    }
  }
}

void SpaceMatrix::addPair(Index a, Index b, double value)
{
  if (a == none || b == none)
  {
    return;
  }
  if (a == b)
  {
    this->addOwn(a, 2.0 * value * Eigen::Matrix3d::Identity());
    return;
  }
  const Index low = std::min(a, b) / 3;
  const Neighbour& other = this->neighbour(low, std::max(a, b) / 3);
  for (Index axis = 0; axis < 3; ++axis)
  {
    this->column(low, axis)[other.offset + (other.all ? axis : 0)] += value;
  }
}

void SpaceMatrix::shift(double value)
{
  for (Index column = 0; column < this->Size; ++column)
  {
    this->Matrix.valuePtr()[this->Matrix.outerIndexPtr()[column]] += value;
  }
}
}
