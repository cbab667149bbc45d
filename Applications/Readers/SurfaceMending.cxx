// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMending.h"

#include "BoundaryLoops.h"
#include "FlatTriangles.h"
#include "OuterSide.h"
#include "TriangleList.h"
#include "VtkMessages.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointLocator.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace wirewarp
{
namespace
{
/// Of the surface's diagonal: how near points are that weld.
constexpr double weldDistance = 1e-6;
/// An opening of so few edges and so small a part of the diagonal looks like missing triangles.
constexpr std::size_t fewEdges = 6;
constexpr double smallOpening = 0.05;

std::string number(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// \return how many points were joined to another
std::size_t weld(TriangleList& list)
{
  const vtkIdType count = list.points->GetNumberOfPoints();
  vtkNew<vtkPoints> unique;
  unique->SetDataTypeToDouble();
  vtkNew<vtkPointLocator> locator;
  double bounds[6];
  list.points->GetBounds(bounds);
  double diagonal = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    diagonal = std::max(diagonal, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  locator->SetTolerance(weldDistance * diagonal);
  locator->InitPointInsertion(unique, bounds, count);
  std::vector<vtkIdType> firstOf; // by point of `unique`
  std::vector<vtkIdType> joined(static_cast<std::size_t>(count));
  for (vtkIdType p = 0; p < count; ++p)
  {
    double x[3];
    list.points->GetPoint(p, x);
    vtkIdType id = 0;
    if (locator->InsertUniquePoint(x, id) != 0)
    {
      firstOf.push_back(p);
    }
    joined[static_cast<std::size_t>(p)] = firstOf[static_cast<std::size_t>(id)];
  }
  std::set<vtkIdType> moved;
  for (ListedTriangle& triangle : list.triangles)
  {
    for (vtkIdType& corner : triangle.corners)
    {
      const vtkIdType to = joined[static_cast<std::size_t>(corner)];
      if (to != corner)
      {
        moved.insert(corner);
        corner = to;
      }
    }
  }
  return moved.size();
}

std::string weldNote(std::size_t points, bool asked)
{
  return points == 0
    ? "--weld found no points that lie on each other"
    : counted(points, "point is", "points are") + " joined with one that it lies on, as " +
      (asked ? "--weld asks" : "the format of the file doubles points");
}

void dropFlat(TriangleList& list, std::vector<std::string>& notes)
{
  const std::vector<vtkIdType> polygons = mendFlatTriangles(list);
  if (!polygons.empty())
  {
    notes.push_back(counted(polygons.size(), "triangle", "triangles") +
      " without area taken out, the first at polygon " +
      std::to_string(*std::min_element(polygons.begin(), polygons.end())));
  }
}

/// Triangles that close the loop; none where it cannot be closed.
std::vector<ListedTriangle> cover(const TriangleList& list, const BoundaryLoop& loop)
{
  // Against the boundary, which has the surface on its left.
  const std::vector<vtkIdType> ids(loop.points.rbegin(), loop.points.rend());
  vtkNew<vtkCellArray> polygon;
  polygon->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  vtkNew<vtkPolyData> alone;
  alone->SetPoints(list.points);
  alone->SetPolys(polygon);
  vtkNew<vtkTriangleFilter> filter;
  {
    const VtkMessages messages; // of polygons that it cannot divide
    filter->SetInputData(alone);
    filter->Update();
  }
  TriangleList triangles = listTriangles(filter->GetOutput());
  for (ListedTriangle& triangle : triangles.triangles)
  {
    triangle.polygon = loop.polygon;
  }
  const bool whole = triangles.triangles.size() + 2 == ids.size();
  return whole ? triangles.triangles : std::vector<ListedTriangle>();
}

void fillHoles(TriangleList& list, double across, std::vector<std::string>& notes)
{
  std::size_t filled = 0;
  for (const BoundaryLoop& loop : boundaryLoops(list))
  {
    if (loop.across > across)
    {
      continue;
    }
    const std::vector<ListedTriangle> triangles = cover(list, loop);
    if (triangles.empty())
    {
      notes.push_back("the opening at point " + std::to_string(loop.points.front()) +
        " is too crooked to be filled; it stays open");
    }
    filled += triangles.empty() ? 0 : 1;
    list.triangles.insert(list.triangles.end(), triangles.begin(), triangles.end());
  }
  notes.push_back(filled == 0
      ? "--fill-holes found no opening so small"
      : counted(filled, "opening", "openings") + " filled, as --fill-holes asks");
}

void noteOpenings(
  const TriangleList& list, double diagonal, double millimetres, std::vector<std::string>& notes)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(list);
  std::size_t holes = 0;
  const BoundaryLoop* largest = nullptr;
  for (const BoundaryLoop& loop : loops)
  {
    if (!loop.outermost && loop.points.size() <= fewEdges && loop.across <= smallOpening * diagonal)
    {
      ++holes;
      largest = !largest || loop.across > largest->across ? &loop : largest;
    }
  }
  if (largest)
  {
    notes.push_back("the surface has " + counted(holes, "small opening", "small openings") +
      ", the largest " + number(largest->across * millimetres) + " mm across, at point " +
      std::to_string(largest->points.front()) + (holes == 1 ? ", which stays" : ", which stay") +
      " open; where triangles are missing, --fill-holes " +
      number(std::ceil(1.01 * largest->across * millimetres)) + " closes " +
      (holes == 1 ? "it" : "them"));
  }
  const UnjoinedEdges unjoined = unjoinedEdges(list, loops);
  if (unjoined.count > 0)
  {
    notes.push_back(std::to_string(unjoined.count) +
      " edges of the boundary lie on each other without being joined, the first at point " +
      std::to_string(unjoined.point) +
      "; where these are no cuts but doubled points, as texture seams leave them, --weld joins "
      "them");
  }
}

/// Points of triangles that hang together by coordinates alone, as STL has them, are joined anyway.
bool isSoup(const TriangleList& list)
{
  std::vector<char> used(static_cast<std::size_t>(list.points->GetNumberOfPoints()), 0);
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (const vtkIdType corner : triangle.corners)
    {
      used[static_cast<std::size_t>(corner)] = 1;
    }
  }
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), char{ 1 }));
  return list.triangles.size() > 1 && count >= 2 * list.triangles.size();
}
}

//------------------------------------------------------------------------------
MendedSurface mendSurface(vtkPolyData* surface, const MendingRequest& request)
{
  MendedSurface mended{ surface, {} };
  TriangleList list = listTriangles(surface);
  if (list.triangles.empty())
  {
    return mended;
  }
  const bool soup = isSoup(list);
  const auto joinSoup = [&] {
    if (soup && !request.weld)
    {
      weld(list);
    }
  };
  if (request.weld || (request.doubled && !soup))
  {
    const std::size_t points = weld(list);
    if (request.weld || points > 0)
    {
      mended.notes.push_back(weldNote(points, request.weld));
    }
  }
  dropFlat(list, mended.notes);
  if (request.outerSide || request.fillHoles > 0.0)
  {
    joinSoup();
  }
  if (request.outerSide)
  {
    mended.notes.push_back(takeOuterSide(list));
  }
  if (request.fillHoles > 0.0)
  {
    fillHoles(list, request.fillHoles / request.millimetres, mended.notes);
    dropFlat(list, mended.notes);
  }
  if (!mended.notes.empty())
  {
    mended.surface = withTriangles(surface, list);
  }
  joinSoup();
  noteOpenings(list, surface->GetLength(), request.millimetres, mended.notes);
  return mended;
}
}
