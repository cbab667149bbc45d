// SPDX-License-Identifier: BSD-3-Clause
#include "WeightInput.h"

#include "vtkDataArray.h"

namespace flattening
{
namespace bridge
{
namespace
{
/// The cell arrays that could be meant.
std::string candidates(vtkCellData* cells)
{
  std::string names;
  for (int k = 0; k < cells->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const array = cells->GetArray(k);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1)
    {
      names += (names.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  return names.empty() ? "a cell array with a number for each cell" : "one of " + names;
}
}

Status readWeights(const CurvedSurface& source, const std::string& array, RegionWeights& weights)
{
  weights.clear();
  if (array.empty())
  {
    return {};
  }
  vtkDataArray* const values = source.cellArrays->GetArray(array.c_str());
  if (!values || values->GetNumberOfComponents() != 1)
  {
    const std::string what = values
      ? "the cell array \"" + array + "\" has " + std::to_string(values->GetNumberOfComponents()) +
        " numbers a cell"
      : "the surface has no cell array of numbers named \"" + array + "\"";
    return { StatusCode::InvalidOption, what, {},
      { { Remedy::Give, candidates(source.cellArrays) } } };
  }
  for (const vtkIdType cell : source.surface.input.cellOfTriangle)
  {
    weights.push_back(values->GetComponent(cell, 0));
  }
  return {};
}
}
}
