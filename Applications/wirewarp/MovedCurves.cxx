// SPDX-License-Identifier: BSD-3-Clause
#include "MovedCurves.h"

#include "InputError.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace wirewarp
{
namespace
{
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p)
{
  std::array<double, 3> point{};
  data->GetPoint(p, point.data());
  return point;
}

/// Whether VTK's locators can be asked about a point: not where the filters refuse it, since VTK
/// 9.6 ends the program where a coordinate is no number.
bool canBeLocated(const std::array<double, 3>& point)
{
  constexpr double largest = 1e60; // beyond which the filters refuse coordinates
  return std::all_of(point.begin(), point.end(),
    [](double x) { return std::isfinite(x) && std::abs(x) <= largest; });
}

/// The triangles of a surface for VTK's locators, polygons divided as the filters do: a quad that
/// is not flat has its middle elsewhere. Null where there are none, or a polygon has an id or a
/// point that the filters refuse.
vtkSmartPointer<vtkPolyData> locatedTriangles(vtkPolyData* surface)
{
  const VtkMessages messages; // of what the flattening refuses
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  vtkFlatteningAlgorithm::Triangulate(surface, triangles);
  return triangles->GetNumberOfCells() > 0 ? triangles : nullptr;
}
}

//------------------------------------------------------------------------------
double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves)
{
  double largest = 0.0;
  vtkSmartPointer<vtkPolyData> triangles;
  vtkNew<vtkStaticCellLocator> locator;
  for (vtkPolyData* data : curves)
  {
    if (!data->GetPoints() || data->GetPoints() == surface->GetPoints())
    {
      continue;
    }
    if (!triangles)
    {
      triangles = locatedTriangles(surface);
      if (!triangles)
      {
        return 0.0;
      }
      locator->SetDataSet(triangles);
      locator->BuildLocator();
    }
    const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
    for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
    {
      const vtkIdType* ids = nullptr;
      vtkIdType count = 0;
      lines->GetCurrentCell(count, ids);
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (ids[k] < 0 || ids[k] >= data->GetNumberOfPoints())
        {
          continue;
        }
        const std::array<double, 3> x = pointOf(data, ids[k]);
        std::array<double, 3> closest{};
        vtkIdType cell = -1;
        int part = 0;
        double square = 0.0;
        if (canBeLocated(x))
        {
          locator->FindClosestPoint(x.data(), closest.data(), cell, part, square);
          largest = cell >= 0 ? std::max(largest, std::sqrt(square)) : largest;
        }
      }
    }
  }
  return largest;
}

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

//------------------------------------------------------------------------------
std::string notesOfNumberNames(vtkPolyData* surface, vtkPolyData* curves)
{
  auto* names = vtkStringArray::SafeDownCast(curves->GetCellData()->GetAbstractArray("CurveName"));
  if (!names || curves->GetPoints() != surface->GetPoints())
  {
    return "";
  }
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k)
  {
    const std::string name = names->GetValue(k);
    if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
    {
      return "the name of a curve is " + inQuotes(name) +
        ", which is not one of its vertices; if it should be, put a name before it";
    }
  }
  return "";
}
}
