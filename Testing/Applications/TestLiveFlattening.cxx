// SPDX-License-Identifier: BSD-3-Clause
// The thread that flattens for the window, asked again and again while it works.
#include "Sheet.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

using editor::Care;
using editor::LiveFlattening;
using sheets::sheet;

namespace
{
constexpr int large = 200; // squares on a side: 80,000 triangles
constexpr int small = 20;

/// A curve across the sheet along a row of its vertices.
figures::PolyData curveAlong(int squares, int row)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(squares + 1);
  for (int i = 0; i <= squares; ++i)
  {
    const double x = static_cast<double>(i) / squares;
    const double y = static_cast<double>(row) / squares;
    line->InsertCellPoint(points->InsertNextPoint(x, y, sheets::bulge(x, y)));
  }
  figures::PolyData data = figures::PolyData::New();
  data->SetPoints(points);
  data->SetLines(line);
  return data;
}

std::vector<double> placesOf(const LiveFlattening& live)
{
  std::vector<double> places;
  vtkPolyData* const flat = live.result().flat;
  for (vtkIdType k = 0; k < flat->GetNumberOfPoints(); ++k)
  {
    places.insert(places.end(), flat->GetPoint(k), flat->GetPoint(k) + 3);
  }
  return places;
}

/// Takes until nothing more comes. \return how many there were
int takeAll(LiveFlattening& live)
{
  int count = 0;
  while (live.isBusy())
  {
    count += live.take() ? 1 : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return count;
}
}

TEST(LiveFlattening, WhatIsAskedLastIsFoundAtLast)
{
  LiveFlattening live;
  live.setSurface(sheet(small));
  constexpr int orders = 300;
  int taken = 0;
  for (int k = 0; k < orders; ++k)
  {
    live.ask(curveAlong(small, 1 + k % (small - 1)), k % 3 == 0 ? Care::Full : Care::Draft);
    taken += live.take() ? 1 : 0;
    if (k % 10 == 0) // sometimes a run ends in between, mostly several orders wait for one
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
    }
  }
  live.ask(curveAlong(small, 7), Care::Full);
  taken += takeAll(live);
  EXPECT_GT(taken, 0);
  EXPECT_EQ(live.care(), Care::Full);
  EXPECT_EQ(live.message(), "");

  LiveFlattening alone;
  alone.setSurface(sheet(small));
  ASSERT_TRUE(sheets::run(alone, curveAlong(small, 7)));
  EXPECT_EQ(placesOf(live), placesOf(alone));
}

TEST(LiveFlattening, ALongRunGivesWayToWhatIsAskedLater)
{
  std::atomic<int> told{ 0 };
  LiveFlattening live([&told] { ++told; });
  live.setSurface(sheet(large));
  live.ask(curveAlong(large, 30), Care::Full);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  live.ask(curveAlong(large, 31), Care::Draft);
  EXPECT_EQ(takeAll(live), 1);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(live.care(), Care::Draft);
  EXPECT_GT(live.seconds(Care::Draft), 0.0);
  EXPECT_EQ(live.seconds(Care::Full), 0.0); // it has not come to its end
}

TEST(LiveFlattening, OfAnEarlierSurfaceNothingIsFound)
{
  LiveFlattening live;
  live.setSurface(sheet(large));
  live.ask(curveAlong(large, 30), Care::Full);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  const figures::PolyData other = sheet(small);
  live.setSurface(other);
  EXPECT_FALSE(live.isBusy());
  live.ask(curveAlong(small, 5), Care::Draft);
  takeAll(live);
  ASSERT_TRUE(live.hasResult());
  EXPECT_EQ(live.result().flat->GetNumberOfCells(), other->GetNumberOfCells());
}

TEST(LiveFlattening, EndsWithARunUnderWay)
{
  std::atomic<int> told{ 0 };
  auto live = std::make_unique<LiveFlattening>([&told] { ++told; });
  live->setSurface(sheet(large));
  live->ask(curveAlong(large, 30), Care::Full);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  live->ask(curveAlong(large, 40), Care::Full);
  live.reset();
  EXPECT_EQ(told, 0);
}

TEST(LiveFlattening, ChangesOfWhatWasGivenDoNotReachIt)
{
  const figures::PolyData surface = sheet(small);
  const figures::PolyData curves = curveAlong(small, 9);
  LiveFlattening live;
  live.setSurface(surface);
  live.ask(curves, Care::Full);
  for (const figures::PolyData& data : { surface, curves })
  {
    for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k)
    {
      data->GetPoints()->SetPoint(k, 0.0, 0.0, 0.0);
    }
  }
  takeAll(live);
  ASSERT_TRUE(live.hasResult()) << live.message();
  LiveFlattening alone;
  alone.setSurface(sheet(small));
  ASSERT_TRUE(sheets::run(alone, curveAlong(small, 9)));
  EXPECT_EQ(placesOf(live), placesOf(alone));
}

TEST(LiveFlattening, ARefusalIsSaidAndKeepsThePiece)
{
  LiveFlattening live;
  live.setSurface(sheet(small));
  ASSERT_TRUE(sheets::run(live, curveAlong(small, 9)));
  const std::vector<double> before = placesOf(live);
  const figures::PolyData off = curveAlong(small, 9);
  off->GetPoints()->SetPoint(3, 0.3, 0.3, 5.0);
  EXPECT_FALSE(sheets::run(live, off));
  EXPECT_NE(live.message().find("curve"), std::string::npos) << live.message();
  EXPECT_EQ(placesOf(live), before);
  EXPECT_TRUE(sheets::run(live, curveAlong(small, 9)));
  EXPECT_EQ(live.message(), "");
}
