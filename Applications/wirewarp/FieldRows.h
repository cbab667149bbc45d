// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>

#include <string>

namespace wirewarp
{
/// The field data of one output of vtkWireWarpingFilter as rows. What is missing is 0, or empty.
class FieldRows
{
public:
  explicit FieldRows(vtkPolyData* data)
    : Data(data)
  {
  }
  vtkIdType count(const char* array) const;
  double number(const char* array, vtkIdType row) const;
  long long integer(const char* array, vtkIdType row) const;
  std::string text(const char* array, vtkIdType row) const;

private:
  vtkPolyData* Data; ///< may be null
};
}
