// SPDX-License-Identifier: BSD-3-Clause
#include "DataSetBytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

namespace
{
using namespace wirewarp;
using flattening::Column;
using flattening::DataSet;
using flattening::Points3;

/// Four points, two triangles, a line and arrays of all kinds.
DataSet makeData()
{
  DataSet data;
  Points3 points;
  for (int k = 0; k < 4; ++k)
  {
    points.emplace_back(k % 2 + 1.0 / 3.0, k / 2, std::sqrt(k));
  }
  data.points = std::make_shared<const Points3>(points);
  data.vertexCells = 2;
  data.lines.add(std::vector<std::int64_t>{ 0, 1, 3 });
  data.faces.add(std::vector<std::int64_t>{ 0, 1, 2 });
  data.faces.add(std::vector<std::int64_t>{ 1, 3, 2 });
  data.pointArrays = { { "bits", std::vector<unsigned char>{ 0, 1, 1, 0 } },
    { "n", std::vector<double>(12, 0.1), 3, flattening::ArrayRole::Normals },
    { "short", std::vector<double>{ 1.0 } } };
  data.cellArrays = { { "CurveName", std::vector<std::string>{ "waist", "", "\xC3\xA4\x1B" } },
    { "CurveType", std::vector<int>{ 3, -1, 2 } } };
  data.fieldArrays = { { "time", std::vector<std::int64_t>{ std::int64_t(1) << 60, -7 } } };
  return data;
}

std::string defectOf(std::string_view bytes)
{
  try
  {
    unpackDataSet(bytes);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

TEST(DataSetBytes, AllThatAReaderGivesComesThrough)
{
  for (const DataSet& data : { makeData(), DataSet() })
  {
    const DataSet back = unpackDataSet(packDataSet(data));
    EXPECT_EQ(*back.points, *data.points);
    EXPECT_EQ(back.vertexCells, data.vertexCells);
    EXPECT_TRUE(back.lines == data.lines && back.faces == data.faces && back.strips == data.strips);
    for (const auto arrays : { &DataSet::pointArrays, &DataSet::cellArrays, &DataSet::fieldArrays })
    {
      ASSERT_EQ((back.*arrays).size(), (data.*arrays).size());
      for (std::size_t k = 0; k < (data.*arrays).size(); ++k)
      {
        const Column& found = (back.*arrays)[k];
        const Column& wanted = (data.*arrays)[k];
        EXPECT_EQ(found.name, wanted.name);
        EXPECT_EQ(found.values, wanted.values);
        EXPECT_EQ(found.components, wanted.components);
        EXPECT_EQ(found.role, wanted.role);
      }
    }
  }
}

TEST(DataSetBytes, NamesAndTextsAreSuchAsFilesCanHold)
{
  DataSet data = makeData();
  data.fieldArrays[0].name = "t\x1B\xFFm\u00E4";
  data.cellArrays[0].values = std::vector<std::string>{ std::string("a\0b", 3), "", "" };
  const DataSet back = unpackDataSet(packDataSet(data));
  EXPECT_EQ(back.fieldArrays[0].name, "t??m\u00E4");
  EXPECT_EQ(back.cellArrays[0].text(0), "a b");
}

TEST(DataSetBytes, ACellThatNamesAPointThatIsNotThereIsTold)
{
  for (const std::int64_t id : { std::int64_t(-1), std::int64_t(4), std::int64_t(1) << 40 })
  {
    DataSet data = makeData();
    data.faces.add(std::vector<std::int64_t>{ 0, id, 2 });
    EXPECT_EQ(defectOf(packDataSet(data)),
      "a cell names point " + std::to_string(id) + " of 4; ids count from 0");
  }
}

TEST(DataSetBytes, NoBytesThatEndTooEarlyAreTaken)
{
  const std::string bytes = packDataSet(makeData());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    EXPECT_NE(defectOf(std::string_view(bytes).substr(0, size)), "") << size;
  }
  EXPECT_EQ(defectOf(bytes), "");
  EXPECT_NE(defectOf(bytes + "x"), "");
}

TEST(DataSetBytes, WhateverTheBytesAreTheDataIsSound)
{
  const std::string sound = packDataSet(makeData());
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
      const DataSet data = unpackDataSet(bytes);
      ++taken;
      for (const auto* cells : { &data.lines, &data.faces, &data.strips })
      {
        for (std::size_t k = 0; k < cells->size(); ++k)
        {
          for (const std::int64_t* id = cells->begin(k); id != cells->end(k); ++id)
          {
            ASSERT_TRUE(*id >= 0 && *id < static_cast<std::int64_t>(data.points->size()));
          }
        }
      }
    }
    catch (const std::runtime_error&)
    {
    }
  }
  EXPECT_GT(taken, 1000U);
  EXPECT_LT(taken, 9000U);
}
}
