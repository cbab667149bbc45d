// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleList.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace wirewarp
{
namespace
{
using Place = std::array<double, 3>;
using Corners = std::array<vtkIdType, 3>;

/// As the preparation of surfaces has it: height over longest edge, and the least size.
constexpr double flatTriangle = 1e-12;
constexpr double leastSize = 1e-60;
constexpr int mostRounds = 32;

Place minus(const Place& a, const Place& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double normOf(const Place& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

Place crossOf(const Place& u, const Place& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

double squareOf(const Place& a)
{
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

/// Most triangles are far from having no area, and from where squares underflow.
bool isWellShaped(const std::array<Place, 3>& x)
{
  const Place u = minus(x[1], x[0]);
  const Place v = minus(x[2], x[0]);
  const double longest = std::max({ squareOf(u), squareOf(v), squareOf(minus(x[2], x[1])) });
  return longest > 1e-100 && longest < 1e100 && squareOf(crossOf(u, v)) > 1e-20 * longest * longest;
}

struct Shape
{
  bool flat = false;
  int coincident = -1; ///< the corner that lies on the next one
  int middle = -1;     ///< the corner between the others, where none coincide
};

Shape shapeOf(vtkPoints* points, const Corners& corners)
{
  std::array<Place, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
  {
    points->GetPoint(corners[k], x[k].data());
  }
  std::array<double, 3> side{}; // from corner k to the next
  Shape shape;
  if (isWellShaped(x))
  {
    return shape;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    side[k] = normOf(minus(x[(k + 1) % 3], x[k]));
  }
  const auto longest =
    static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
  const double length = side[longest];
  if (length < leastSize) // nothing to compute with
  {
    shape.flat = true;
    shape.coincident = 0;
    return shape;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (corners[k] == corners[(k + 1) % 3] || side[k] <= flatTriangle * length)
    {
      shape.flat = true;
      shape.coincident = static_cast<int>(k);
      return shape;
    }
  }
  const Place u = minus(x[1], x[0]);
  const Place v = minus(x[2], x[0]);
  shape.flat =
    normOf(crossOf({ u[0] / length, u[1] / length, u[2] / length }, v)) <= flatTriangle * length;
  shape.middle = shape.flat ? static_cast<int>((longest + 2) % 3) : -1;
  return shape;
}

std::vector<std::size_t> findFlat(const TriangleList& list)
{
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < list.triangles.size(); ++t)
  {
    if (shapeOf(list.points, list.triangles[t].corners).flat)
    {
      flat.push_back(t);
    }
  }
  return flat;
}

/// One round: each point is touched by one mend at most, so that all of them are of the same list.
class Round
{
public:
  Round(TriangleList& list, const std::vector<std::size_t>& flat)
    : List(list)
    , Taken(list.triangles.size(), 0)
  {
    std::set<vtkIdType> corners;
    for (const std::size_t t : flat)
    {
      corners.insert(list.triangles[t].corners.begin(), list.triangles[t].corners.end());
    }
    for (std::size_t t = 0; t < list.triangles.size(); ++t)
    {
      const Corners& c = list.triangles[t].corners;
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (corners.count(c[k]) > 0 && corners.count(c[(k + 1) % 3]) > 0)
        {
          this->AtEdge[std::minmax(c[k], c[(k + 1) % 3])].push_back(t);
        }
      }
    }
  }

  void run(const std::vector<std::size_t>& flat)
  {
    for (const std::size_t t : flat)
    {
      this->mend(t);
    }
    this->finish();
  }

private:
  bool isFree(const Corners& corners) const
  {
    return std::none_of(
      corners.begin(), corners.end(), [this](vtkIdType p) { return this->Touched.count(p) > 0; });
  }

  void touch(const Corners& corners) { this->Touched.insert(corners.begin(), corners.end()); }

  void mend(std::size_t t)
  {
    const Corners c = this->List.triangles[t].corners;
    if (!this->isFree(c))
    {
      return; // in a later round
    }
    const Shape shape = shapeOf(this->List.points, c);
    if (shape.coincident >= 0)
    {
      const auto k = static_cast<std::size_t>(shape.coincident);
      const vtkIdType kept = std::min(c[k], c[(k + 1) % 3]);
      const vtkIdType joined = std::max(c[k], c[(k + 1) % 3]);
      this->Taken[t] = 1;
      if (joined != kept)
      {
        this->Joined[joined] = kept;
      }
      this->touch(c);
      return;
    }
    const auto m = static_cast<std::size_t>(shape.middle);
    const vtkIdType from = c[(m + 1) % 3];
    const vtkIdType to = c[(m + 2) % 3];
    const std::vector<std::size_t>& behind = this->AtEdge[std::minmax(from, to)];
    if (behind.size() > 2)
    {
      return;
    }
    this->Taken[t] = 1;
    for (const std::size_t other : behind)
    {
      if (other != t)
      {
        this->divide(other, c[m], from, to, t);
      }
    }
    this->touch(c);
  }

  /// The triangle `other` at the edge, on both sides of the point in its middle.
  void divide(std::size_t other, vtkIdType middle, vtkIdType from, vtkIdType to, std::size_t flat)
  {
    const ListedTriangle whole = this->List.triangles[other];
    if (!this->isFree(whole.corners) || this->Taken[other] != 0)
    {
      this->Taken[flat] = 0;
      return;
    }
    ListedTriangle first = whole;
    ListedTriangle second = whole;
    std::replace(first.corners.begin(), first.corners.end(), to, middle);
    std::replace(second.corners.begin(), second.corners.end(), from, middle);
    this->List.triangles[other] = first;
    this->Added.push_back(second);
    this->touch(whole.corners);
  }

  void finish()
  {
    std::vector<ListedTriangle> kept;
    kept.reserve(this->List.triangles.size());
    for (std::size_t t = 0; t < this->List.triangles.size(); ++t)
    {
      if (this->Taken[t] == 0)
      {
        kept.push_back(this->List.triangles[t]);
      }
    }
    kept.insert(kept.end(), this->Added.begin(), this->Added.end());
    if (!this->Joined.empty())
    {
      for (ListedTriangle& triangle : kept)
      {
        for (vtkIdType& corner : triangle.corners)
        {
          const auto at = this->Joined.find(corner);
          corner = at == this->Joined.end() ? corner : at->second;
        }
      }
    }
    this->List.triangles = std::move(kept);
  }

  TriangleList& List;
  std::vector<char> Taken;
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<std::size_t>> AtEdge;
  std::set<vtkIdType> Touched;
  std::map<vtkIdType, vtkIdType> Joined;
  std::vector<ListedTriangle> Added;
};
}

//------------------------------------------------------------------------------
TriangleList listTriangles(vtkPolyData* surface)
{
  TriangleList list;
  list.points = surface->GetPoints();
  vtkNew<vtkPolyData> divided;
  vtkFlatteningAlgorithm::Triangulate(surface, divided);
  vtkDataArray* const origin = divided->GetCellData()->GetArray("vtkOriginalCellIds");
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  list.triangles.reserve(static_cast<std::size_t>(divided->GetNumberOfPolys()));
  const auto cells = vtk::TakeSmartPointer(divided->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    const vtkIdType* ids = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, ids);
    const auto cell = static_cast<vtkIdType>(origin->GetComponent(cells->GetCurrentCellId(), 0));
    list.triangles.push_back({ { ids[0], ids[1], ids[2] }, cell - before });
  }
  return list;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> withTriangles(vtkPolyData* surface, const TriangleList& list)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(list.points);
  result->GetPointData()->ShallowCopy(surface->GetPointData());
  result->GetFieldData()->ShallowCopy(surface->GetFieldData());
  result->SetVerts(surface->GetVerts());
  result->SetLines(surface->GetLines());
  vtkNew<vtkCellArray> polygons;
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkCellData* const from = surface->GetCellData();
  vtkCellData* const to = result->GetCellData();
  to->CopyAllOn();
  to->CopyAllocate(from, before + static_cast<vtkIdType>(list.triangles.size()));
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    to->CopyData(from, cell, cell);
  }
  for (const ListedTriangle& triangle : list.triangles)
  {
    const vtkIdType cell = before + polygons->InsertNextCell(3, triangle.corners.data());
    to->CopyData(from, before + triangle.polygon, cell);
  }
  result->SetPolys(polygons);
  return result;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> mendFlatTriangles(TriangleList& list)
{
  std::vector<std::size_t> flat = findFlat(list);
  if (flat.empty() || flat.size() * 2 >= list.triangles.size())
  {
    return {};
  }
  std::vector<vtkIdType> polygons;
  for (const std::size_t t : flat)
  {
    polygons.push_back(list.triangles[t].polygon);
  }
  const TriangleList before = list;
  // A chain of triangles in one line is mended from its ends.
  for (int rounds = mostRounds; rounds > 0 && !flat.empty(); --rounds)
  {
    Round(list, flat).run(flat);
    flat = findFlat(list);
  }
  if (!flat.empty())
  {
    list = before;
    return {};
  }
  return polygons;
}
}
