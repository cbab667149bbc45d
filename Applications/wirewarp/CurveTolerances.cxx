// SPDX-License-Identifier: BSD-3-Clause
#include "CurveTolerances.h"

#include "InputError.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <set>

namespace wirewarp
{
namespace
{
/// The array `LengthTolerance` as doubles, 0 where there was none.
vtkDoubleArray* toleranceArray(vtkPolyData* data)
{
  constexpr const char* name = "LengthTolerance";
  vtkNew<vtkDoubleArray> copy;
  copy->SetName(name);
  copy->SetNumberOfTuples(data->GetNumberOfCells());
  copy->Fill(0.0);
  vtkDataArray* const before = data->GetCellData()->GetArray(name);
  if (before && before->GetNumberOfTuples() == data->GetNumberOfCells())
  {
    copy->DeepCopy(before);
  }
  data->GetCellData()->RemoveArray(name);
  data->GetCellData()->AddArray(copy);
  return copy;
}

std::string listed(const std::set<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "no curve has a name" : "the curves are " + text;
}
}

//------------------------------------------------------------------------------
void applyTolerances(const CurveTolerances& tolerances, const std::vector<vtkPolyData*>& curves)
{
  if (tolerances.empty())
  {
    return;
  }
  std::set<std::string> known;
  for (vtkPolyData* const data : curves)
  {
    auto* const names =
      vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("CurveName"));
    vtkDoubleArray* values = nullptr;
    for (vtkIdType cell = 0; names && cell < names->GetNumberOfValues(); ++cell)
    {
      const std::string name = names->GetValue(cell);
      known.insert(name);
      const auto entry = tolerances.find(name);
      if (entry != tolerances.end() && cell < data->GetNumberOfCells())
      {
        values = values ? values : toleranceArray(data);
        values->SetValue(cell, entry->second);
      }
    }
  }
  known.erase("");
  for (const auto& [name, value] : tolerances)
  {
    if (known.count(name) == 0)
    {
      throw InputError("--tolerance: no curve is named \"" + name + "\"; " + listed(known));
    }
  }
}
}
