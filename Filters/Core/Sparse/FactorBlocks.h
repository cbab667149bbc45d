// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LargeArray.h"
#include "Base/Types.h"
#include "Sparse/DenseFront.h"

#include <Eigen/Core>
#include <cstddef>

namespace flattening
{
/// The columns of L of one supernode as they are kept: some together make a panel, and begin at the
/// row of its first.
template <typename Value>
struct FactorColumns
{
  static constexpr Index panelWidth = 4;

  Value* values = nullptr;
  Index size = 0;    ///< rows, those of the diagonal block included
  Index columns = 0; ///< of the diagonal block

  /// The first row that is kept of a column.
  static Index firstRow(Index column) { return column / panelWidth * panelWidth; }
  /// How many numbers the columns before one take.
  static std::size_t begin(Index size, Index column)
  {
    const auto first = std::size_t(firstRow(column));
    const std::size_t before =
      first > 0 ? first * std::size_t(size) - first * (first - panelWidth) / 2 : 0;
    return before + (std::size_t(column) - first) * (std::size_t(size) - first);
  }
  /// Where the panel that begins with a column begins; its columns are size - column apart.
  Value* panel(Index column) const { return this->values + begin(this->size, column); }
};

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
  /// Makes room for numbers, whose values are left open.
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
      visit(FactorColumns<const float>{ this->Singles.data() + place, size, columns });
    }
    else
    {
      visit(FactorColumns<const double>{ this->Doubles.data() + place, size, columns });
    }
  }

private:
  FactorPrecision Precision;
  LargeArray<double> Doubles;
  LargeArray<float> Singles;
};

/// Right-hand sides that are solved together, so that L is read once; each as long as the front.
using FrontVectors = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Solves L x = w in the columns of a front and takes them out of the rows below.
template <typename Value>
void substituteForward(const FactorColumns<const Value>& factor, FrontVectors w);
/// Solves L^T x = w in the columns of a front, the rows below being known. What is kept above the
/// diagonal must be finite.
template <typename Value>
void substituteBackward(const FactorColumns<const Value>& factor, FrontVectors w);
}
