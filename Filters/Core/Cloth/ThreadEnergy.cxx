// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ThreadEnergy.h"

namespace flattening
{
namespace
{
/// The strain over half of which its stiffness changes.
constexpr double bendOfThread = 1e-3;
}

Curve2 threadEnergy(double strain, double compression)
{
  Curve2 sum{ 0.5 * compression * strain * strain, compression * strain, compression };
  if (compression < 1.0)
  {
    // Zero with its derivative where nothing is strained.
    const Curve2 atRest = smoothRamp(bendOfThread, 2.0 * bendOfThread);
    const Curve2 drawn = smoothRamp(strain + bendOfThread, 2.0 * bendOfThread);
    const double soft = 1.0 - compression;
    sum.value += soft * (drawn.value - atRest.value - atRest.first * strain);
    sum.first += soft * (drawn.first - atRest.first);
    sum.second += soft * drawn.second;
  }
  return sum;
}
}
