// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMending.h"

#include "BoundaryWeld.h"
#include "InputError.h"
#include "OuterSide.h"
#include "Surface/PolygonTriangulation.h"
#include "TriangleList.h"

#include <algorithm>
#include <cmath>

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

using flattening::shortNumber;

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// The largest side of the box around the triangles.
double sizeOf(const TriangleList& list)
{
  return boxOf(list).sizes().maxCoeff();
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
    throw InputError("--weld " + shortNumber(*request.weld) +
      " is more than a tenth of the surface, which is " + shortNumber(size * request.millimetres) +
      " mm large; give less, or check --unit");
  }
  const WeldedPoints welded = weldBoundary(list, weldDistance * size, distance);
  if (request.weld || welded.count > 0)
  {
    notes.push_back(welded.count == 0
        ? std::string("--weld found no points of the boundary that lie on each other")
        : counted(welded.count, "point is", "points are") + " joined with one that it lies " +
          (distance > 0.0
              ? "at most " + shortNumber(welded.farthest * request.millimetres) + " mm off"
              : std::string("on")) +
          (request.weld         ? ", as --weld asks"
              : request.doubled ? ", as the format of the file doubles points"
                                : ", as most of the boundary does; --no-weld keeps it open"));
  }
}

void takeFaces(TriangleList& list, const MendingRequest& request, std::vector<std::string>& notes)
{
  if (const std::size_t count = takeOneOfTwoFaces(list))
  {
    notes.push_back(
      counted(count, "triangle that lies on another is", "triangles that lie on others are") +
      " left out, as the back of two-sided faces; " +
      (request.outerSide ? "--outer-side takes one side" : "--no-outer-side keeps both sides"));
  }
}

void takeSide(TriangleList& list, const MendingRequest& request, std::vector<std::string>& notes)
{
  const std::size_t count = list.triangles.size();
  if (const std::optional<double> thickness = takeOuterSide(list, !request.outerSide))
  {
    notes.push_back("of " + std::to_string(count) + " triangles the " +
      std::to_string(list.triangles.size()) + " of the outer side are kept, " +
      (request.outerSide
          ? "as --outer-side asks"
          : "since the surface is a sheet " + shortNumber(*thickness * request.millimetres) +
            " mm thick; --no-outer-side keeps both sides"));
  }
  else if (request.outerSide)
  {
    notes.emplace_back("--outer-side found no closed sheet with two sides");
  }
}

/// Whether most edges of the boundary lie on each other, as where texture seams double points.
bool isMostlyUnjoined(const TriangleList& list, double size)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(list);
  std::size_t edges = 0;
  for (const BoundaryLoop& loop : loops)
  {
    edges += loop.points.size();
  }
  return 2 * unjoinedEdges(list, loops, weldDistance * size, 0.0).coincident.count > edges;
}

/// Triangles that close the loop; none where it cannot be closed.
std::vector<ListedTriangle> cover(const TriangleList& list, const BoundaryLoop& loop)
{
  // Against the boundary, which has the surface on its left.
  const flattening::Indices corners(loop.points.rbegin(), loop.points.rend());
  const flattening::Triangles divided = flattening::triangulatePolygon(*list.points, corners);
  std::vector<ListedTriangle> triangles;
  if (flattening::isTriangulationOf(divided, *list.points, corners))
  {
    for (const flattening::Triangle& t : divided)
    {
      triangles.push_back({ { t[0], t[1], t[2] }, loop.polygon });
    }
  }
  return triangles;
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
      ", the largest " + shortNumber(largest->across * millimetres) + " mm across, at point " +
      std::to_string(largest->points.front()) + (holes == 1 ? ", which stays" : ", which stay") +
      " open; where triangles are missing, --fill-holes " +
      shortNumber(std::ceil(1.01 * largest->across * millimetres)) + " closes " +
      (holes == 1 ? "it" : "them"));
  }
  const UnjoinedBoundary unjoined =
    unjoinedEdges(list, loops, weldDistance * size, nearDistance * size);
  if (unjoined.coincident.count > 0)
  {
    notes.push_back(std::to_string(unjoined.coincident.count) +
      " edges of the boundary lie on each other without being joined, the first at point " +
      std::to_string(unjoined.coincident.point) +
      "; where these are not cuts but doubled points, as texture seams leave them, --weld joins "
      "them");
  }
  if (unjoined.near.count > 0)
  {
    const double gap = unjoined.near.gap * millimetres;
    notes.push_back(std::to_string(unjoined.near.count) + " edges of the boundary run up to " +
      shortNumber(gap) + " mm beside another one without being joined, the first at point " +
      std::to_string(unjoined.near.point) + "; where the surface is to be whole there, --weld " +
      shortNumber(roundedUp(1.01 * gap)) + " joins them");
  }
}

/// Points of triangles that hang together by coordinates alone, as STL has them, are joined anyway.
bool isSoup(const TriangleList& list)
{
  std::vector<char> used(list.points->size(), 0);
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (const std::int64_t corner : triangle.corners)
    {
      used[static_cast<std::size_t>(corner)] = 1;
    }
  }
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), char{ 1 }));
  return list.triangles.size() > 1 && count >= 2 * list.triangles.size();
}
}

MendedSurface mendSurface(const DataSet& surface, const MendingRequest& request)
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
  if (request.outerSide || request.likelySide)
  {
    takeFaces(list, request, mended.notes);
  }
  if (request.weld || (request.doubled && !soup) ||
    (request.likely && !soup && isMostlyUnjoined(list, size)))
  {
    weld(list, size, request, mended.notes);
  }
  if (request.outerSide || request.fillHoles > 0.0)
  {
    joinSoup();
  }
  if (request.outerSide || request.likelySide)
  {
    takeSide(list, request, mended.notes);
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
  noteOpenings(
    list, boxOf(*surface.points).diagonal().norm(), size, request.millimetres, mended.notes);
  return mended;
}
}
