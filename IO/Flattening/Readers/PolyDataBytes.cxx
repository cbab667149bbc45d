// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataBytes.h"

#include "PlainText.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkVariant.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace wirewarp
{
namespace
{
constexpr int noAttribute = -1;
constexpr std::int64_t mostComponents = 1 << 16;
constexpr std::size_t lengthSize = sizeof(std::int64_t); ///< of a text or an array

bool isNumeric(int type)
{
  static constexpr std::array<int, 15> types{ VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR,
    VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG,
    VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE };
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// Bytes of so many values.
std::uint64_t sizeOf(vtkDataArray* array, std::uint64_t values)
{
  return array->GetDataType() == VTK_BIT
    ? (values + 7) / 8
    : values * static_cast<std::uint64_t>(array->GetDataTypeSize());
}

std::string wordOf(const char* text)
{
  return text ? text : "";
}

//------------------------------------------------------------------------------
class Packer
{
public:
  std::string Bytes;

  void add(vtkPolyData* data)
  {
    vtkPoints* const points = data->GetPoints();
    this->number(points ? 1 : 0);
    if (points)
    {
      this->array(points->GetData());
    }
    for (vtkCellArray* cells :
      { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
    {
      cells->ConvertTo64BitStorage();
      this->integers(cells->GetOffsetsArray());
      this->integers(cells->GetConnectivityArray());
    }
    this->attributes(data->GetPointData());
    this->attributes(data->GetCellData());
    this->fields(data->GetFieldData());
  }

private:
  void number(std::int64_t value)
  {
    this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void text(const std::string& value)
  {
    this->number(static_cast<std::int64_t>(value.size()));
    this->Bytes.append(value);
  }

  void integers(vtkDataArray* array)
  {
    // Since VTK 9.6 offsets may be a rule in place of values in memory.
    vtkSmartPointer<vtkTypeInt64Array> values = vtkArrayDownCast<vtkTypeInt64Array>(array);
    if (!values)
    {
      values = vtkSmartPointer<vtkTypeInt64Array>::New();
      values->DeepCopy(array);
    }
    this->number(values->GetNumberOfValues());
    this->Bytes.append(reinterpret_cast<const char*>(values->GetPointer(0)),
      sizeof(vtkTypeInt64) * static_cast<std::size_t>(values->GetNumberOfValues()));
  }

  void head(vtkAbstractArray* array, int type)
  {
    this->number(type);
    this->text(wordOf(array->GetName()));
    this->number(array->GetNumberOfComponents());
    this->number(array->GetNumberOfTuples());
    const bool named = array->HasAComponentName();
    this->number(named ? 1 : 0);
    for (int c = 0; named && c < array->GetNumberOfComponents(); ++c)
    {
      this->text(wordOf(array->GetComponentName(c)));
    }
  }

  void array(vtkAbstractArray* array)
  {
    vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
    if (!numbers || !isNumeric(numbers->GetDataType()))
    {
      this->head(array, VTK_STRING); // any other kind in words
      for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
      {
        this->text(array->GetVariantValue(k).ToString());
      }
      return;
    }
    this->head(numbers, numbers->GetDataType());
    const auto values = static_cast<std::uint64_t>(numbers->GetNumberOfValues());
    this->Bytes.append(
      static_cast<const char*>(numbers->GetVoidPointer(0)), sizeOf(numbers, values));
  }

  void fields(vtkFieldData* data)
  {
    this->number(data->GetNumberOfArrays());
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      this->array(data->GetAbstractArray(k));
    }
  }

  void attributes(vtkDataSetAttributes* data)
  {
    this->fields(data);
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      this->number(data->IsArrayAnAttribute(k));
    }
  }
};

//------------------------------------------------------------------------------
class Unpacker
{
public:
  explicit Unpacker(std::string_view bytes)
    : Rest(bytes)
  {
  }

  vtkSmartPointer<vtkPolyData> take()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkIdType pointCount = 0;
    if (this->number() == 1)
    {
      data->SetPoints(this->points());
      pointCount = data->GetNumberOfPoints();
    }
    data->SetVerts(this->cells(pointCount));
    data->SetLines(this->cells(pointCount));
    data->SetPolys(this->cells(pointCount));
    data->SetStrips(this->cells(pointCount));
    this->attributes(data->GetPointData());
    this->attributes(data->GetCellData());
    this->fields(data->GetFieldData());
    check(this->Rest.empty(), "has more data than it announces");
    return data;
  }

private:
  static void check(bool sound, const char* text)
  {
    if (!sound)
    {
      throw std::runtime_error(text);
    }
  }

  std::string_view bytes(std::uint64_t size)
  {
    check(size <= this->Rest.size(), "ends too early");
    const std::string_view taken = this->Rest.substr(0, size);
    this->Rest.remove_prefix(size);
    return taken;
  }

  std::int64_t number()
  {
    std::int64_t value = 0;
    std::memcpy(&value, this->bytes(sizeof value).data(), sizeof value);
    return value;
  }

  /// How many things follow that take at least so many bytes each.
  std::uint64_t count(std::size_t bytesEach)
  {
    const std::int64_t value = this->number();
    check(value >= 0 && static_cast<std::uint64_t>(value) <= this->Rest.size() / bytesEach,
      "ends too early");
    return static_cast<std::uint64_t>(value);
  }

  std::string text() { return std::string(this->bytes(this->count(1))); }

  vtkSmartPointer<vtkPoints> points()
  {
    const vtkSmartPointer<vtkDataArray> values =
      vtkDataArray::SafeDownCast(this->array(this->number()));
    check(values && values->GetNumberOfComponents() == 3 && values->GetDataType() != VTK_BIT,
      "has points without three coordinates");
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(values);
    return points;
  }

  vtkSmartPointer<vtkTypeInt64Array> integers()
  {
    const std::uint64_t size = this->count(sizeof(vtkTypeInt64));
    auto values = vtkSmartPointer<vtkTypeInt64Array>::New();
    values->SetNumberOfValues(static_cast<vtkIdType>(size));
    const std::string_view from = this->bytes(size * sizeof(vtkTypeInt64));
    if (size > 0)
    {
      std::memcpy(values->GetPointer(0), from.data(), from.size());
    }
    return values;
  }

  vtkSmartPointer<vtkCellArray> cells(vtkIdType pointCount)
  {
    const vtkSmartPointer<vtkTypeInt64Array> offsets = this->integers();
    const vtkSmartPointer<vtkTypeInt64Array> ids = this->integers();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (offsets->GetNumberOfValues() == 0)
    {
      check(ids->GetNumberOfValues() == 0, "has damaged cells");
      return cells;
    }
    vtkTypeInt64 last = 0;
    check(offsets->GetValue(0) == 0, "has damaged cells");
    for (vtkIdType k = 0; k < offsets->GetNumberOfValues(); ++k)
    {
      check(offsets->GetValue(k) >= last, "has damaged cells");
      last = offsets->GetValue(k);
    }
    check(last == ids->GetNumberOfValues(), "has damaged cells");
    for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
    {
      const vtkTypeInt64 id = ids->GetValue(k);
      if (id < 0 || id >= pointCount)
      {
        throw std::runtime_error("a cell names point " + std::to_string(id) + " of " +
          std::to_string(pointCount) + "; ids count from 0");
      }
    }
    cells->SetData(offsets, ids);
    return cells;
  }

  vtkSmartPointer<vtkAbstractArray> array(std::int64_t type)
  {
    const std::string name = plainText(this->text()); // as XML can hold it
    const std::int64_t components = this->number();
    const std::int64_t tuples = this->number();
    // VTK takes memory for one tuple before there is any.
    check(components >= 1 && components <= mostComponents && tuples >= 0 &&
        tuples <= std::numeric_limits<vtkIdType>::max() / components,
      "has a damaged array");
    const auto values = static_cast<std::uint64_t>(components * tuples);
    const bool words = type == VTK_STRING;
    check(words || (type > 0 && type < 1000 && isNumeric(static_cast<int>(type))),
      "has an array of an unknown type");
    vtkSmartPointer<vtkAbstractArray> array;
    if (words)
    {
      array = vtkSmartPointer<vtkStringArray>::New();
    }
    else
    {
      array.TakeReference(vtkDataArray::CreateDataArray(static_cast<int>(type)));
    }
    array->SetName(name.empty() ? nullptr : name.c_str());
    array->SetNumberOfComponents(static_cast<int>(components));
    if (this->number() == 1)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponentName(c, plainText(this->text()).c_str());
      }
    }
    words ? this->fill(vtkStringArray::SafeDownCast(array), tuples)
          : this->fill(vtkDataArray::SafeDownCast(array), tuples, values);
    return array;
  }

  // Both take memory only where there are bytes for it.

  void fill(vtkStringArray* array, vtkIdType tuples)
  {
    const auto components = static_cast<std::uint64_t>(array->GetNumberOfComponents());
    check(static_cast<std::uint64_t>(tuples) <= this->Rest.size() / lengthSize / components,
      "ends too early");
    array->SetNumberOfTuples(tuples);
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
    {
      std::string text = this->text();
      // VTK ends a text there when it writes it.
      std::replace(text.begin(), text.end(), '\0', ' ');
      array->SetValue(k, text);
    }
  }

  void fill(vtkDataArray* array, vtkIdType tuples, std::uint64_t values)
  {
    check(values <= 8 * this->Rest.size(), "ends too early"); // bits are the smallest
    const std::string_view from = this->bytes(sizeOf(array, values));
    array->SetNumberOfTuples(tuples);
    if (!from.empty())
    {
      std::memcpy(array->GetVoidPointer(0), from.data(), from.size());
    }
  }

  void fields(vtkFieldData* data)
  {
    const std::uint64_t arrays = this->count(lengthSize);
    for (std::uint64_t k = 0; k < arrays; ++k)
    {
      data->AddArray(this->array(this->number()));
    }
  }

  void attributes(vtkDataSetAttributes* data)
  {
    std::vector<vtkSmartPointer<vtkAbstractArray>> arrays(this->count(lengthSize));
    for (auto& array : arrays)
    {
      array = this->array(this->number());
    }
    for (const auto& array : arrays)
    {
      const int index = data->AddArray(array);
      const std::int64_t role = this->number();
      if (role > noAttribute && role < vtkDataSetAttributes::NUM_ATTRIBUTES)
      {
        data->SetActiveAttribute(index, static_cast<int>(role));
      }
    }
  }

  std::string_view Rest;
};
}

//------------------------------------------------------------------------------
std::string packPolyData(vtkPolyData* data)
{
  Packer packer;
  packer.add(data);
  return std::move(packer.Bytes);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> unpackPolyData(std::string_view bytes)
{
  return Unpacker(bytes).take();
}
}
