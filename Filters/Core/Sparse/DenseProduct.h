// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstddef>

namespace flattening
{
/// Columns of a matrix in memory of others.
struct DenseColumns
{
  const double* values;
  std::size_t stride; ///< from one column to the next
};

/// to -= left D right^T.
struct DenseProduct
{
  double* to;
  std::size_t stride;
  Index rows;
  Index columns;
  DenseColumns left;      ///< rows x depth
  DenseColumns right;     ///< columns x depth
  const double* diagonal; ///< D, depth entries
  Index depth;
  bool lower = false; ///< entries above the diagonal are not needed, and not right afterwards
};

/// By tiles that stay in registers, as wide as the processor's. Each entry's sum runs over the
/// depth in order, with any number of threads. With AVX-512, and on ARM, the compiler fuses a
/// product with its sum, so that last bits differ between processors.
void subtractProduct(const DenseProduct& product);
}
