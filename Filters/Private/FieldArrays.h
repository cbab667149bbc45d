// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flattening
{
namespace bridge
{
/// Adds an array to the field data of a data set, and to its point or cell data. Field data is
/// lists of their own lengths: one without rows is left out, as it would only clutter tables and
/// panels.
inline void addUnlessEmpty(vtkFieldData* field, vtkAbstractArray* array)
{
  if (array->GetNumberOfTuples() == 0 && !vtkDataSetAttributes::SafeDownCast(field))
  {
    field->RemoveArray(array->GetName()); // what the input may have had
    return;
  }
  field->AddArray(array);
}

/// Adds an array with one value a row of a report, made by value(row), in the same way.
template <class Array, class Value>
void addRows(vtkFieldData* field, const char* name, std::size_t rows, Value&& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(rows));
  for (std::size_t row = 0; row < rows; ++row)
  {
    array->SetValue(static_cast<vtkIdType>(row), value(row));
  }
  addUnlessEmpty(field, array);
}

inline void addStrings(
  vtkFieldData* field, const char* name, const std::vector<std::string>& values)
{
  addRows<vtkStringArray>(
    field, name, values.size(), [&values](std::size_t row) { return values[row]; });
}
}
}
