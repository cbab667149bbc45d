// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace flattening
{
namespace bridge
{
/// Adds an array with one value a row of a report, made by value(row). Works for the point and the
/// cell data of a data set too.
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
  field->AddArray(array);
}

inline void addStrings(
  vtkFieldData* field, const char* name, const std::vector<std::string>& values)
{
  addRows<vtkStringArray>(
    field, name, values.size(), [&values](std::size_t row) { return values[row]; });
}
}
}
