// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMending.h"

#include "BoundaryWeld.h"
#include "InputError.h"
#include "OuterSide.h"
#include "TriangleList.h"
#include "VtkMessages.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wirewarp
{
namespace
{
/// Of the surface's largest side: how near points are that lie on each other, how near boundaries
/// run that are named, and how far points may be joined.
constexpr double weldDistance = 1e-6;
constexpr double nearDistance = 1e-3;
constexpr double largestWeld = 0.1;
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

/// The largest side of the box around the triangles.
double sizeOf(const TriangleList& list)
{
  vtkBoundingBox box;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (const vtkIdType corner : triangle.corners)
    {
      box.AddPoint(list.points->GetPoint(corner));
    }
  }
  return box.GetMaxLength();
}

/// The next larger number of two digits.
double roundedUp(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit * (1.0 - 1e-9)) * unit;
}

void weld(
  TriangleList& list, double size, const MendingRequest& request, std::vector<std::string>& notes)
{
  const double distance = request.weld.value_or(0.0) / request.millimetres;
  if (distance > largestWeld * size)
  {
    throw InputError("--weld " + number(*request.weld) +
      " is more than a tenth of the surface, which is " + number(size * request.millimetres) +
      " mm large; give less, or check --unit");
  }
  const WeldedPoints welded = weldBoundary(list, weldDistance * size, distance);
  if (request.weld || welded.count > 0)
  {
    notes.push_back(welded.count == 0
        ? std::string("--weld found no points of the boundary that lie on each other")
        : counted(welded.count, "point is", "points are") + " joined with one that it lies " +
          (distance > 0.0 ? "at most " + number(welded.farthest * request.millimetres) + " mm off"
                          : std::string("on")) +
          ", as " + (request.weld ? "--weld asks" : "the format of the file doubles points"));
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

void noteOpenings(const TriangleList& list, double diagonal, double size, double millimetres,
  std::vector<std::string>& notes)
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
  const UnjoinedBoundary unjoined =
    unjoinedEdges(list, loops, weldDistance * size, nearDistance * size);
  if (unjoined.coincident.count > 0)
  {
    notes.push_back(std::to_string(unjoined.coincident.count) +
      " edges of the boundary lie on each other without being joined, the first at point " +
      std::to_string(unjoined.coincident.point) +
      "; where these are no cuts but doubled points, as texture seams leave them, --weld joins "
      "them");
  }
  if (unjoined.near.count > 0)
  {
    const double gap = unjoined.near.gap * millimetres;
    notes.push_back(std::to_string(unjoined.near.count) + " edges of the boundary run up to " +
      number(gap) + " mm beside another one without being joined, the first at point " +
      std::to_string(unjoined.near.point) + "; where the surface is to be whole there, --weld " +
      number(roundedUp(1.01 * gap)) + " joins them");
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
  const double size = sizeOf(list);
  const auto joinSoup = [&] {
    if (soup && !request.weld)
    {
      weldBoundary(list, weldDistance * size, 0.0);
    }
  };
  if (request.weld || (request.doubled && !soup))
  {
    weld(list, size, request, mended.notes);
  }
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
  }
  if (!mended.notes.empty())
  {
    mended.surface = withTriangles(surface, list);
  }
  joinSoup();
  noteOpenings(list, surface->GetLength(), size, request.millimetres, mended.notes);
  return mended;
}
}
