// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/FactorBlocks.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// A factor with larger numbers solves nothing; smaller ones say nothing, and cost processors that
/// take numbers near the least of their kind by another way much time.
constexpr double largestSingle = 1e30;
constexpr double smallestSingle = 1e-30;
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
  // Loops that are compiled to vectors.
  float* const to = this->Singles.get() + place;
  for (std::size_t k = 0; k < count; ++k)
  {
    double kept = std::abs(values[k]) < smallestSingle ? 0.0 : values[k];
    kept = kept > largestSingle ? largestSingle : kept;
    kept = kept < -largestSingle ? -largestSingle : kept;
    to[k] = static_cast<float>(kept);
  }
  constexpr auto largest = static_cast<float>(largestSingle);
  int tooLarge = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    tooLarge |= std::abs(to[k]) >= largest ? 1 : 0;
  }
  return tooLarge == 0;
}
}
