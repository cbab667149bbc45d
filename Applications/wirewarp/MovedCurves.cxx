// SPDX-License-Identifier: BSD-3-Clause
#include "MovedCurves.h"

#include "InputError.h"
#include "LocatedSurface.h"
#include "TextFile.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace wirewarp
{
namespace
{
bool sameCells(vtkCellArray* one, vtkCellArray* other)
{
  if (one->GetNumberOfCells() != other->GetNumberOfCells())
  {
    return false;
  }
  const auto mine = vtk::TakeSmartPointer(one->NewIterator());
  const auto theirs = vtk::TakeSmartPointer(other->NewIterator());
  theirs->GoToFirstCell();
  for (mine->GoToFirstCell(); !mine->IsDoneWithTraversal(); mine->GoToNextCell())
  {
    vtkIdType count = 0;
    vtkIdType otherCount = 0;
    const vtkIdType* ids = nullptr;
    const vtkIdType* otherIds = nullptr;
    mine->GetCurrentCell(count, ids);
    theirs->GetCurrentCell(otherCount, otherIds);
    if (!std::equal(ids, ids + count, otherIds, otherIds + otherCount))
    {
      return false;
    }
    theirs->GoToNextCell();
  }
  return true;
}
}

//------------------------------------------------------------------------------
void checkConnectivity(
  vtkPolyData* base, const std::string& basePath, vtkPolyData* surface, const std::string& path)
{
  if (base->GetNumberOfPoints() == surface->GetNumberOfPoints() &&
    sameCells(base->GetPolys(), surface->GetPolys()))
  {
    return;
  }
  const auto counts = [](vtkPolyData* data) {
    return std::to_string(data->GetNumberOfPoints()) + " vertices and " +
      std::to_string(data->GetNumberOfPolys()) + " faces";
  };
  const std::string here = counts(surface);
  const std::string there = counts(base);
  throw InputError(path,
    "has another connectivity than " + inQuotes(basePath) +
      (here == there ? ": the corners of its faces differ" : " (" + here + ", not " + there + ")") +
      "; sizes are one mesh with its vertices in other places");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> movedCurves(vtkPolyData* curves, vtkPolyData* from, vtkPolyData* to)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(curves);
  if (!curves->GetPoints() || curves->GetPoints() == from->GetPoints())
  {
    moved->SetPoints(to->GetPoints());
    return moved;
  }
  const vtkSmartPointer<vtkPolyData> faces = locatedTriangles(from);
  if (!faces)
  {
    return moved; // the base's own flattening says what is wrong with it
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(faces);
  locator->BuildLocator();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType p = 0; p < curves->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x = pointOf(curves, p);
    std::array<double, 3> closest{};
    vtkIdType id = -1;
    int part = 0;
    double square = 0.0;
    if (canBeLocated(x))
    {
      locator->FindClosestPoint(x.data(), closest.data(), cell, id, part, square);
    }
    std::array<double, 3> parameters{};
    std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    if (id < 0 ||
      cell->EvaluatePosition(
        closest.data(), x.data(), part, parameters.data(), square, weights.data()) < 0)
    {
      points->InsertNextPoint(x.data()); // the flattening says what is wrong with the face
      continue;
    }
    std::array<double, 3> place{};
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      std::array<double, 3> corner{};
      to->GetPoint(cell->GetPointId(k), corner.data());
      for (std::size_t c = 0; c < 3; ++c)
      {
        place[c] += weights[static_cast<std::size_t>(k)] * corner[c];
      }
    }
    points->InsertNextPoint(place.data());
  }
  moved->SetPoints(points);
  return moved;
}
}
