// SPDX-License-Identifier: BSD-3-Clause
#include "FieldRows.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

namespace wirewarp
{
//------------------------------------------------------------------------------
vtkIdType FieldRows::count(const char* array) const
{
  vtkAbstractArray* const found =
    this->Data ? this->Data->GetFieldData()->GetAbstractArray(array) : nullptr;
  return found ? found->GetNumberOfTuples() : 0;
}

double FieldRows::number(const char* array, vtkIdType row) const
{
  if (row >= this->count(array))
  {
    return 0.0;
  }
  vtkDataArray* const found = this->Data->GetFieldData()->GetArray(array);
  return found ? found->GetComponent(row, 0) : 0.0;
}

long long FieldRows::integer(const char* array, vtkIdType row) const
{
  return static_cast<long long>(this->number(array, row));
}

std::string FieldRows::text(const char* array, vtkIdType row) const
{
  if (row >= this->count(array))
  {
    return "";
  }
  auto* const found =
    vtkStringArray::SafeDownCast(this->Data->GetFieldData()->GetAbstractArray(array));
  return found ? std::string(found->GetValue(row)) : "";
}
}
