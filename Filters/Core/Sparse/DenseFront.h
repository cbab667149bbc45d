// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Sparse/SteppedTriangle.h"

#include <Eigen/Core>

namespace flattening
{
/// The columns of one supernode, one after the other, of which the lower triangle counts.
template <typename Value>
struct FrontColumns
{
  Value* values = nullptr;
  Index size = 0;    ///< rows, those of the diagonal block included
  Index columns = 0; ///< of the diagonal block

  Index rows() const { return this->size - this->columns; } ///< below the diagonal block
  Value* column(Index k) const { return this->values + std::size_t(k) * std::size_t(this->size); }
};
using DenseFront = FrontColumns<double>;

/// L D L^T of the columns of a front in place, D on the diagonal, and what they do to the rows
/// below, which is subtracted from `update`. False where a pivot is zero or not finite.
bool eliminateFront(const DenseFront& front, SteppedTriangle& update, const Execution& execution);
}
