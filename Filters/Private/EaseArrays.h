// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FieldArrays.h"
#include "Surface/FeatureCurve.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

#include <cstddef>

namespace flattening
{
namespace bridge
{
/// Adds the cell arrays LengthEase and EasedPiece of curves, where one of them is eased.
/// \param easeOf the LengthEase of a row
template <class EaseOf>
void addEases(vtkCellData* cells, std::size_t rows, EaseOf&& easeOf)
{
  bool eased = false;
  for (std::size_t row = 0; row < rows; ++row)
  {
    eased = eased || easeOf(row).fraction != 0.0;
  }
  if (eased)
  {
    addRows<vtkDoubleArray>(
      cells, "LengthEase", rows, [&](std::size_t row) { return easeOf(row).fraction; });
    addRows<vtkIntArray>(cells, "EasedPiece", rows,
      [&](std::size_t row) { return static_cast<int>(easeOf(row).piece); });
  }
}
}
}
