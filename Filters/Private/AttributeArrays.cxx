// SPDX-License-Identifier: BSD-3-Clause
#include "AttributeArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace flattening
{
namespace bridge
{
namespace
{
std::string quoted(vtkAbstractArray* array)
{
  return array->GetName() ? '"' + std::string(array->GetName()) + '"' : "without a name";
}

/// Replaces texts in an array that is k-th of some by such without NUL.
void mendTexts(vtkFieldData* arrays, int k, const char* element, std::vector<std::string>& warnings)
{
  auto* texts = vtkStringArray::SafeDownCast(arrays->GetAbstractArray(k));
  bool sound = true;
  for (vtkIdType i = 0; texts && i < texts->GetNumberOfValues(); ++i)
  {
    sound = sound && texts->GetValue(i).find('\0') == std::string::npos;
  }
  if (sound)
  {
    return;
  }
  vtkNew<vtkStringArray> mended;
  mended->DeepCopy(texts);
  for (vtkIdType i = 0; i < mended->GetNumberOfValues(); ++i)
  {
    mended->SetValue(i, withoutNul(mended->GetValue(i)));
  }
  warnings.push_back(std::string("the ") + element + " array " + quoted(texts) +
    " has texts with the character NUL, which no file of VTK can hold; they are written with \\0");
  if (!texts->GetName())
  {
    arrays->RemoveArray(k);
  }
  arrays->AddArray(mended); // in the place of one of its name
}

template <class Attributes>
vtkSmartPointer<Attributes> wholeArrays(
  Attributes* all, vtkIdType count, const char* element, std::vector<std::string>& warnings)
{
  auto whole = vtkSmartPointer<Attributes>::New();
  whole->ShallowCopy(all);
  for (int k = 0; k < whole->GetNumberOfArrays();)
  {
    vtkAbstractArray* array = whole->GetAbstractArray(k);
    const vtkIdType tuples = array->GetNumberOfTuples();
    if (tuples >= count)
    {
      mendTexts(whole, k++, element, warnings);
    }
    else
    {
      warnings.push_back(std::string("the ") + element + " array " + quoted(array) + " has " +
        std::to_string(tuples) + (tuples == 1 ? " value for " : " values for ") +
        std::to_string(count) + " " + element + "s and is left out; give it one for each");
      whole->RemoveArray(k);
    }
  }
  return whole;
}
}

std::string withoutNul(std::string text)
{
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
  {
    text.replace(at, 1, "\\0");
  }
  return text;
}

vtkSmartPointer<vtkFieldData> fieldArrays(vtkPolyData* data, std::vector<std::string>& warnings)
{
  auto arrays = vtkSmartPointer<vtkFieldData>::New();
  arrays->ShallowCopy(data->GetFieldData());
  for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
  {
    mendTexts(arrays, k, "field", warnings);
  }
  return arrays;
}

vtkSmartPointer<vtkPointData> wholePointArrays(
  vtkPolyData* data, std::vector<std::string>& warnings)
{
  return wholeArrays(data->GetPointData(), data->GetNumberOfPoints(), "point", warnings);
}

vtkSmartPointer<vtkCellData> wholeCellArrays(vtkPolyData* data, std::vector<std::string>& warnings)
{
  return wholeArrays(data->GetCellData(), data->GetNumberOfCells(), "cell", warnings);
}
}
}
