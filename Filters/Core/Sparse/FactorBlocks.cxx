// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/FactorBlocks.h"

#include "Sparse/VectorNumbers.h"

#include <algorithm>
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
      kept = round(values, this->Singles.get() + to, count) && kept;
    }
    else
    {
      std::copy_n(values, count, this->Doubles.get() + to);
    }
  }
  return kept;
}
}
