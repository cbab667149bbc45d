// SPDX-License-Identifier: BSD-3-Clause
#include "NumberNames.h"

#include "TextFile.h"

#include <vtkCellData.h>
#include <vtkStringArray.h>

namespace wirewarp
{
//------------------------------------------------------------------------------
std::string notesOfNumberNames(vtkPolyData* surface, vtkPolyData* curves)
{
  auto* names = vtkStringArray::SafeDownCast(curves->GetCellData()->GetAbstractArray("CurveName"));
  if (!names || curves->GetPoints() != surface->GetPoints())
  {
    return "";
  }
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k)
  {
    const std::string name = names->GetValue(k);
    if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
    {
      return "the name of a curve is " + inQuotes(name) +
        ", which is not one of its vertices; if it should be, put a name before it";
    }
  }
  return "";
}
}
