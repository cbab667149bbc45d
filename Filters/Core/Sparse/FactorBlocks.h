// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/DenseFront.h"
#include "Sparse/FactorColumns.h"

#include <memory>

namespace flattening
{
/// How a factor is kept. It is computed in double precision.
enum class FactorPrecision
{
  Double,
  /// Half the memory, and half the time where memory limits solving. What it solves is right to
  /// about six digits of the right-hand side, so that solutions must be refined.
  Single,
};

/// The columns of L of all supernodes.
class FactorBlocks
{
public:
  explicit FactorBlocks(FactorPrecision precision = FactorPrecision::Double)
    : Precision(precision)
  {
  }
  FactorPrecision precision() const { return this->Precision; }
  std::size_t bytes(std::size_t count) const
  {
    return count * (this->Precision == FactorPrecision::Single ? sizeof(float) : sizeof(double));
  }
  /// Makes room for so many numbers, whose values are left open.
  void allocate(std::size_t count);
  /// Keeps the columns of a front from a place on. False where a number is too large for what is
  /// kept.
  bool keep(const DenseFront& front, std::size_t place);
  /// Calls visit(columns) with those of a front that are kept from a place on.
  template <typename Visit>
  void visit(std::size_t place, Index size, Index columns, const Visit& visit) const
  {
    if (this->Precision == FactorPrecision::Single)
    {
      visit(FactorColumns<const float>{ this->Singles.get() + place, size, columns });
    }
    else
    {
      visit(FactorColumns<const double>{ this->Doubles.get() + place, size, columns });
    }
  }

private:
  FactorPrecision Precision;
  std::size_t Count = 0;
  // Arrays, since vectors would write zeros first.
  std::unique_ptr<double[]> Doubles; // NOLINT(modernize-avoid-c-arrays)
  std::unique_ptr<float[]> Singles;  // NOLINT(modernize-avoid-c-arrays)
};
}
