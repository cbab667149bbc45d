// SPDX-License-Identifier: BSD-3-Clause
// Flat pieces stay as they were shown, whatever the filter turns them to.
#include "SteadyPieces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr figures::Vector right{ 1.0, 0.0, 0.0 };
constexpr figures::Vector up{ 0.0, 1.0, 0.0 };

/// Two triangles that share no point, 3 wide and 1 high each, as a surface and as flat pieces.
figures::PolyData twoTriangles(double turnOfFirst, double turnOfSecond, bool twoPieces)
{
  const double corners[6][2] = { { 0, 0 }, { 3, 0 }, { 0, 1 }, { 0, 5 }, { 3, 5 }, { 3, 6 } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> original;
  original->SetName("vtkOriginalPointIds");
  for (int k = 0; k < 6; ++k)
  {
    const double angle = k < 3 ? turnOfFirst : turnOfSecond;
    const double* const p = corners[k];
    points->InsertNextPoint(std::cos(angle) * p[0] - std::sin(angle) * p[1],
      std::sin(angle) * p[0] + std::cos(angle) * p[1], 0.0);
    original->InsertNextValue(k);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 3, 4, 5 });
  vtkNew<vtkIdTypeArray> pieces;
  pieces->SetName("PieceId");
  pieces->InsertNextValue(0);
  pieces->InsertNextValue(twoPieces ? 1 : 0);
  figures::PolyData data = figures::PolyData::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetPointData()->AddArray(original);
  data->GetCellData()->AddArray(pieces);
  return data;
}

figures::FlatPiece pieceOf(const figures::PolyData& flat)
{
  figures::PolyData wires = figures::PolyData::New();
  wires->SetPoints(flat->GetPoints());
  return { flat, wires, flat };
}

double direction(vtkPolyData* flat, vtkIdType from, vtkIdType to)
{
  double a[3];
  double b[3];
  flat->GetPoint(from, a);
  flat->GetPoint(to, b);
  return std::atan2(b[1] - a[1], b[0] - a[0]);
}
}

TEST(SteadyPieces, APieceLiesAtFirstAsItsSurfaceIsSeen)
{
  editor::SteadyPieces steady;
  steady.start(twoTriangles(0.0, 0.0, false), up, { -1.0, 0.0, 0.0 }); // seen turned by a quarter
  const figures::FlatPiece shown = steady.settle(pieceOf(twoTriangles(2.0, 2.0, false)));
  EXPECT_NEAR(direction(shown.flat, 0, 1), -0.5 * pi, 1e-12);
  EXPECT_EQ(shown.wires->GetPoints(), shown.flat->GetPoints());
}

TEST(SteadyPieces, ATurnedPieceComesBackToWhereItWasShown)
{
  editor::SteadyPieces steady;
  steady.start(twoTriangles(0.0, 0.0, false), right, up);
  const figures::FlatPiece first = steady.settle(pieceOf(twoTriangles(0.3, 0.3, false)));
  for (const double angle : { 0.5 * pi, 3.0, -1.0 })
  {
    const figures::FlatPiece next = steady.settle(pieceOf(twoTriangles(angle, angle, false)));
    for (vtkIdType k = 0; k < 6; ++k)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        EXPECT_NEAR(next.flat->GetPoint(k)[axis], first.flat->GetPoint(k)[axis], 1e-12);
      }
    }
  }
}

TEST(SteadyPieces, EachOfSeveralPiecesIsTurnedByItselfAndLiesBesideTheOthers)
{
  editor::SteadyPieces steady;
  steady.start(twoTriangles(0.0, 0.0, false), right, up);
  const figures::FlatPiece shown = steady.settle(pieceOf(twoTriangles(1.0, -2.0, true)));
  EXPECT_NEAR(direction(shown.flat, 0, 1), 0.0, 1e-12);
  EXPECT_NEAR(direction(shown.flat, 3, 4), 0.0, 1e-12);
  // Boxes of 3 by 1, in rows of one.
  const double top = shown.flat->GetPoint(2)[1];
  EXPECT_GT(shown.flat->GetPoint(3)[1], top);
}

TEST(SteadyPieces, PointsThatTheSurfaceDoesNotHaveMoveWithTheOthers)
{
  editor::SteadyPieces steady;
  steady.start(twoTriangles(0.0, 0.0, false), right, up);
  const figures::PolyData flat = twoTriangles(0.5, 0.5, false);
  flat->GetPointData()->GetArray("vtkOriginalPointIds")->SetComponent(4, 0, -1.0);
  const figures::FlatPiece shown = steady.settle(pieceOf(flat));
  EXPECT_NEAR(direction(shown.flat, 3, 4), 0.0, 1e-12);
}
