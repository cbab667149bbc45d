// SPDX-License-Identifier: BSD-3-Clause
#include "OuterSide.h"

#include "BoundaryLoops.h"

#include <vtkCellData.h>
#include <vtkConnectivityFilter.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangle.h>

#include <map>
#include <set>

namespace wirewarp
{
namespace
{
/// Degrees between triangles at the rim of a sheet; that of a square one has 90.
constexpr double rimAngle = 60.0;

double areaOf(const TriangleList& list, const ListedTriangle& triangle)
{
  std::array<std::array<double, 3>, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
  {
    list.points->GetPoint(triangle.corners[k], x[k].data());
  }
  return vtkTriangle::TriangleArea(x[0].data(), x[1].data(), x[2].data());
}

/// Per triangle its region, of those that hang together by points.
std::vector<vtkIdType> regionsOf(vtkPolyData* triangles, std::size_t count)
{
  vtkNew<vtkConnectivityFilter> connectivity;
  connectivity->SetInputData(triangles);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->ColorRegionsOn();
  connectivity->Update();
  vtkCellData* const cells = connectivity->GetPolyDataOutput()->GetCellData();
  vtkDataArray* const regions = cells->GetArray("RegionId");
  vtkDataArray* const places = cells->GetArray("place");
  std::vector<vtkIdType> result(count, -1);
  for (vtkIdType cell = 0; cell < regions->GetNumberOfTuples(); ++cell)
  {
    result[static_cast<std::size_t>(places->GetComponent(cell, 0))] =
      static_cast<vtkIdType>(regions->GetComponent(cell, 0));
  }
  return result;
}

vtkSmartPointer<vtkPolyData> numbered(const TriangleList& list)
{
  vtkNew<vtkPolyData> nothing;
  TriangleList bare = list;
  vtkSmartPointer<vtkPolyData> surface = withTriangles(nothing, bare);
  vtkNew<vtkIdTypeArray> places;
  places->SetName("place");
  for (std::size_t t = 0; t < list.triangles.size(); ++t)
  {
    places->InsertNextValue(static_cast<vtkIdType>(t));
  }
  surface->GetCellData()->AddArray(places);
  return surface;
}
}

//------------------------------------------------------------------------------
std::string takeOuterSide(TriangleList& list)
{
  const vtkSmartPointer<vtkPolyData> whole = numbered(list);
  const std::size_t count = list.triangles.size();
  const std::vector<vtkIdType> part = regionsOf(whole, count);
  vtkNew<vtkPolyDataNormals> split;
  split->SetInputData(whole);
  split->SetFeatureAngle(rimAngle);
  split->SplittingOn();
  split->ConsistencyOn();
  split->Update();
  const std::vector<vtkIdType> side = regionsOf(split->GetOutput(), count);

  std::set<vtkIdType> open;
  std::map<vtkIdType, vtkIdType> partOfPolygon;
  for (std::size_t t = 0; t < count; ++t)
  {
    partOfPolygon[list.triangles[t].polygon] = part[t];
  }
  for (const BoundaryLoop& loop : boundaryLoops(list))
  {
    open.insert(partOfPolygon[loop.polygon]);
  }
  std::map<vtkIdType, std::map<vtkIdType, double>> areas; // by part, by side
  for (std::size_t t = 0; t < count; ++t)
  {
    areas[part[t]][side[t]] += areaOf(list, list.triangles[t]);
  }
  std::map<vtkIdType, vtkIdType> outer;
  for (const auto& [region, sides] : areas)
  {
    for (const auto& [candidate, area] : sides)
    {
      if (sides.size() > 1 && open.count(region) == 0 &&
        (outer.count(region) == 0 || area > sides.at(outer[region])))
      {
        outer[region] = candidate;
      }
    }
  }
  if (outer.empty())
  {
    return "--outer-side found no closed sheet with a sharp rim";
  }
  std::vector<ListedTriangle> kept;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (outer.count(part[t]) == 0 || outer[part[t]] == side[t])
    {
      kept.push_back(list.triangles[t]);
    }
  }
  list.triangles = std::move(kept);
  return "of " + std::to_string(count) + " triangles the " + std::to_string(list.triangles.size()) +
    " of the outer side are kept, as --outer-side asks";
}
}
