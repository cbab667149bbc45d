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

/// Rounds numbers from one place on; false where one is too large, or none.
bool roundOneByOne(const double* values, float* to, std::size_t from, std::size_t count)
{
  bool kept = true;
  for (std::size_t k = from; k < count; ++k)
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
  const Vector zero{};
  auto tooLarge = zero < zero;
  std::size_t k = 0;
  for (; k + width <= count; k += width)
  {
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
  return roundOneByOne(values, to, k, count) && kept;
}

bool roundByTwo(const double* values, float* to, std::size_t count)
{
  return roundVectors<TwoNumbers, TwoSingles>(values, to, count);
}
#else
bool roundByTwo(const double* values, float* to, std::size_t count)
{
  return roundOneByOne(values, to, 0, count);
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

double* FactorBlocks::workspace(std::size_t count, std::size_t place, std::vector<double>& buffer)
{
  if (this->Precision == FactorPrecision::Double)
  {
    return this->Doubles.get() + place;
  }
  buffer.resize(std::max(count, buffer.size()));
  return buffer.data();
}

bool FactorBlocks::keep(const double* values, std::size_t count, std::size_t place)
{
  if (this->Precision == FactorPrecision::Double)
  {
    return true;
  }
  static const Round round = widestRound();
  return round(values, this->Singles.get() + place, count);
}
}
