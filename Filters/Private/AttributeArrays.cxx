// SPDX-License-Identifier: BSD-3-Clause
#include "AttributeArrays.h"

#include "Input/DataSet.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <type_traits>
#include <variant>

namespace flattening::bridge
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

void addColumns(vtkFieldData* field, const Columns& columns)
{
  for (const Column& column : columns)
  {
    const auto add = [&](const auto& array, const auto& values) {
      array->SetName(column.name.empty() ? nullptr : column.name.c_str());
      array->SetNumberOfComponents(column.components);
      array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / column.components);
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        array->SetValue(static_cast<vtkIdType>(k), values[k]);
      }
      if (values.empty() && !vtkDataSetAttributes::SafeDownCast(field))
      {
        field->RemoveArray(column.name.c_str()); // what the input may have had
        return;
      }
      field->AddArray(array);
    };
    std::visit(
      [&add](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        using Array = std::conditional_t<std::is_same_v<Value, double>, vtkDoubleArray,
          std::conditional_t<std::is_same_v<Value, std::int64_t>, vtkIdTypeArray,
            std::conditional_t<std::is_same_v<Value, int>, vtkIntArray,
              std::conditional_t<std::is_same_v<Value, unsigned char>, vtkUnsignedCharArray,
                vtkStringArray>>>>;
        add(vtkNew<Array>(), values);
      },
      column.values);
  }
}

void writeTable(const Columns& columns, vtkTable* table)
{
  table->Initialize();
  addColumns(table->GetRowData(), columns);
}

vtkSmartPointer<vtkTable> makeTable(const Columns& columns)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  writeTable(columns, table);
  return table;
}

std::vector<std::string> textsOfCells(vtkPolyData* data, const char* array)
{
  std::vector<std::string> texts;
  auto* const values = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray(array));
  for (vtkIdType k = 0; values && k < values->GetNumberOfValues(); ++k)
  {
    texts.push_back(values->GetValue(k));
  }
  return texts;
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
