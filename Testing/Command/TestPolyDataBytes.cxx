// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataBytes.h"

#include <gtest/gtest.h>

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCharArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkVariantArray.h>

#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

namespace
{
using namespace wirewarp;

template <typename Array>
vtkSmartPointer<Array> makeArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
  {
    array->SetVariantValue(k, vtkVariant(static_cast<int>(k % 2)));
  }
  return array;
}

/// Four points, two triangles, a line and arrays of many kinds.
vtkSmartPointer<vtkPolyData> makeData()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 4; ++k)
  {
    points->InsertNextPoint(k % 2 + 1.0 / 3.0, k / 2, std::sqrt(k));
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 3 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 1, 3, 2 });
  data->SetLines(lines);
  data->SetPolys(polygons);
  const auto normals = makeArray<vtkFloatArray>("n", 3, 4);
  normals->SetComponentName(0, "X");
  normals->SetComponentName(2, "Z");
  data->GetPointData()->AddArray(makeArray<vtkBitArray>("bits", 5, 4));
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkStringArray> names;
  names->SetName("CurveName");
  for (const char* name : { "waist", "", "\xC3\xA4\x1B" })
  {
    names->InsertNextValue(name);
  }
  data->GetCellData()->AddArray(names);
  data->GetCellData()->AddArray(makeArray<vtkCharArray>(nullptr, 1, 3));
  data->GetCellData()->AddArray(makeArray<vtkIntArray>("CurveType", 1, 3));
  data->GetFieldData()->AddArray(makeArray<vtkDoubleArray>("time", 1, 7));
  return data;
}

std::string defectOf(std::string_view bytes)
{
  try
  {
    unpackPolyData(bytes);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

void expectEqual(vtkAbstractArray* found, vtkAbstractArray* wanted)
{
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->GetDataType(), wanted->GetDataType());
  EXPECT_EQ(found->GetNumberOfComponents(), wanted->GetNumberOfComponents());
  ASSERT_EQ(found->GetNumberOfValues(), wanted->GetNumberOfValues());
  for (vtkIdType k = 0; k < wanted->GetNumberOfValues(); ++k)
  {
    EXPECT_EQ(found->GetVariantValue(k).ToString(), wanted->GetVariantValue(k).ToString());
  }
}

TEST(PolyDataBytes, AllThatAReaderGivesComesThrough)
{
  const auto data = makeData();
  const auto back = unpackPolyData(packPolyData(data));
  ASSERT_EQ(back->GetNumberOfPoints(), 4);
  EXPECT_EQ(back->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType k = 0; k < 4; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(back->GetPoint(k)[c], data->GetPoint(k)[c]);
    }
  }
  ASSERT_EQ(back->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> ids;
  back->GetCellPoints(2, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 3);
  EXPECT_EQ(ids->GetId(1), 3);
  for (const char* name : { "bits", "n" })
  {
    expectEqual(
      back->GetPointData()->GetAbstractArray(name), data->GetPointData()->GetAbstractArray(name));
  }
  ASSERT_NE(back->GetPointData()->GetNormals(), nullptr);
  EXPECT_STREQ(back->GetPointData()->GetNormals()->GetComponentName(2), "Z");
  ASSERT_EQ(back->GetCellData()->GetNumberOfArrays(), 3);
  for (int k = 0; k < 3; ++k)
  {
    expectEqual(back->GetCellData()->GetAbstractArray(k), data->GetCellData()->GetAbstractArray(k));
  }
  EXPECT_EQ(back->GetCellData()->GetArrayName(1), nullptr);
  expectEqual(
    back->GetFieldData()->GetAbstractArray("time"), data->GetFieldData()->GetAbstractArray("time"));
}

TEST(PolyDataBytes, NothingAtAllComesThrough)
{
  vtkNew<vtkPolyData> nothing;
  const auto back = unpackPolyData(packPolyData(nothing));
  EXPECT_EQ(back->GetNumberOfPoints(), 0);
  EXPECT_EQ(back->GetNumberOfCells(), 0);
}

TEST(PolyDataBytes, ArraysOfOtherKindsBecomeWords)
{
  const auto data = makeData();
  vtkNew<vtkVariantArray> variants;
  variants->SetName("v");
  variants->InsertNextValue(vtkVariant(7));
  data->GetFieldData()->AddArray(variants);
  const auto back = unpackPolyData(packPolyData(data));
  auto* const words = vtkStringArray::SafeDownCast(back->GetFieldData()->GetAbstractArray("v"));
  ASSERT_NE(words, nullptr);
  EXPECT_EQ(words->GetValue(0), "7");
}

TEST(PolyDataBytes, ANameHoldsNoZeroByteAfterwards)
{
  const auto data = makeData();
  auto* const names =
    vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("CurveName"));
  names->SetValue(0, std::string("a\0b", 3));
  const auto back = unpackPolyData(packPolyData(data));
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(back->GetCellData()->GetAbstractArray("CurveName"))->GetValue(0),
    "a b");
}

TEST(PolyDataBytes, NamesOfArraysAreSuchAsXmlCanHold)
{
  const auto data = makeData();
  data->GetFieldData()->GetAbstractArray("time")->SetName("t\x1B\xFFm\u00E4");
  const auto back = unpackPolyData(packPolyData(data));
  EXPECT_STREQ(back->GetFieldData()->GetArrayName(0), "t??m\u00E4");
}

TEST(PolyDataBytes, AnArrayOfAnotherLengthThanItsPointsComesThroughAsItIs)
{
  for (const vtkIdType tuples : { 0, 2, 9 })
  {
    const auto data = makeData();
    const auto heat = makeArray<vtkDoubleArray>("heat", 1, tuples);
    data->GetPointData()->AddArray(heat);
    const auto load = makeArray<vtkDoubleArray>("load", 2, tuples);
    data->GetCellData()->AddArray(load);
    const auto back = unpackPolyData(packPolyData(data));
    expectEqual(back->GetPointData()->GetArray("heat"), heat);
    expectEqual(back->GetCellData()->GetArray("load"), load);
  }
}

TEST(PolyDataBytes, ACellThatNamesAPointThatIsNotThereIsTold)
{
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(4), vtkIdType(1) << 40 })
  {
    const auto data = makeData();
    data->GetPolys()->InsertNextCell({ 0, id, 2 });
    data->GetCellData()->Initialize();
    EXPECT_EQ(defectOf(packPolyData(data)),
      "a cell names point " + std::to_string(id) + " of 4; ids count from 0");
  }
}

TEST(PolyDataBytes, NoBytesThatEndTooEarlyAreTaken)
{
  const std::string bytes = packPolyData(makeData());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    EXPECT_NE(defectOf(std::string_view(bytes).substr(0, size)), "") << size;
  }
  EXPECT_EQ(defectOf(bytes), "");
  EXPECT_NE(defectOf(bytes + "x"), "");
}

TEST(PolyDataBytes, WhateverTheBytesAreTheDataIsSound)
{
  vtkObject::GlobalWarningDisplayOff(); // of arrays that are not what they are marked as
  const std::string sound = packPolyData(makeData());
  std::mt19937 random(7);
  std::size_t taken = 0;
  for (int attempt = 0; attempt < 10000; ++attempt)
  {
    std::string bytes = sound;
    const std::size_t at = random() % bytes.size();
    if (attempt % 2 == 0)
    {
      bytes[at] = static_cast<char>(random());
    }
    else // a whole number, mostly a length or an id
    {
      const std::int64_t value = attempt % 4 == 1 ? static_cast<std::int64_t>(random() % 9)
                                                  : std::int64_t(1) << random() % 64;
      std::memcpy(&bytes[at / 8 * 8 % (bytes.size() - 8)], &value, sizeof value);
    }
    try
    {
      const auto data = unpackPolyData(bytes);
      ++taken;
      EXPECT_LE(data->GetActualMemorySize(), 1000u); // KiB
      for (vtkCellArray* cells :
        { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
      {
        EXPECT_TRUE(cells->IsValid());
        for (vtkIdType k = 0; k < cells->GetNumberOfConnectivityIds(); ++k)
        {
          const vtkIdType id =
            static_cast<vtkIdType>(cells->GetConnectivityArray()->GetComponent(k, 0));
          ASSERT_TRUE(id >= 0 && id < data->GetNumberOfPoints());
        }
      }
    }
    catch (const std::runtime_error&)
    {
    }
  }
  EXPECT_GT(taken, 1000u);
  EXPECT_LT(taken, 9000u);
}
}
