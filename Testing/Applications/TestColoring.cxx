// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

namespace
{
/// 100 triangles of equal area on two pieces, with a cell array.
figures::FlatPiece pieceWith(const char* name, const std::function<double(int)>& valueOf)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(10, 5);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  vtkNew<vtkIdTypeArray> pieces;
  pieces->SetName("PieceId");
  for (int k = 0; k < 100; ++k)
  {
    values->InsertNextValue(valueOf(k));
    pieces->InsertNextValue(k / 50);
  }
  figures::FlatPiece piece;
  piece.flat = triangles->GetOutput();
  piece.cut = piece.flat;
  piece.flat->GetCellData()->AddArray(values);
  piece.flat->GetCellData()->AddArray(pieces);
  return piece;
}

TEST(Coloring, ReachesAsFarAsMostOfTheTriangles)
{
  // 4 of 100 triangles are far out.
  const auto piece =
    pieceWith("AreaRatio", [](int k) { return k < 4 ? 30.0 : 1.0 + 0.015 * (k % 2); });
  const auto map = figures::makeColorMap(figures::Coloring::Area, piece);
  EXPECT_NEAR(map.colors->GetTableRange()[0], 0.98, 1e-12);
  EXPECT_NEAR(map.colors->GetTableRange()[1], 1.02, 1e-12);
  const auto drawn = pieceWith("StrainWeft", [](int k) { return k < 10 ? -0.4 : 0.0; });
  const auto threads = figures::makeColorMap(figures::Coloring::Weft, drawn);
  EXPECT_NEAR(threads.colors->GetTableRange()[0], -0.5, 1e-12);
  EXPECT_NEAR(threads.colors->GetTableRange()[1], 0.5, 1e-12);
  const auto stated = figures::makeColorMap(figures::Coloring::Area, piece, { 0.5, 1.5 });
  EXPECT_EQ(stated.colors->GetTableRange()[1], 1.5);
}

TEST(Coloring, ExtremesHavePieceAndPlace)
{
  const auto piece = pieceWith("Strain", [](int k) { return k == 99 ? 8.0 : k == 3 ? -2.0 : 1.0; });
  const auto map = figures::makeColorMap(figures::Coloring::Strain, piece);
  const std::string words = figures::extremesOf(piece, map);
  double place[3];
  piece.cut->GetPoint(piece.cut->GetCell(99)->GetPointId(0), place);
  char wanted[200];
  std::snprintf(wanted, sizeof wanted,
    "largest 8 on piece 2 at %.4g, %.4g, %.4g; least -2 on piece 1; mean 1.04", place[0], place[1],
    place[2]);
  EXPECT_EQ(words, wanted);
}
}
