// SPDX-License-Identifier: BSD-3-Clause
#include "SteadyPieces.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace editor
{
namespace
{
constexpr double gap = 0.06;      // between pieces, of the largest side of one
constexpr double rowLength = 1.5; // of the side of a square as large as all boxes

using Place = std::array<double, 2>;

/// The points of a piece, and those among them that are points of the surface.
struct SteadyPiece
{
  std::vector<std::size_t> points;
  std::vector<std::size_t> known;
};

/// Places of points in the plane.
using Layout = std::vector<Place>;

struct Box
{
  Place low{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  Place high{ -low[0], -low[1] };

  Place size() const { return { this->high[0] - this->low[0], this->high[1] - this->low[1] }; }
};

std::vector<SteadyPiece> piecesOf(vtkPolyData* flat, vtkDataArray* original)
{
  vtkDataArray* const ids = flat->GetCellData()->GetArray("PieceId");
  std::vector<SteadyPiece> pieces;
  std::vector<bool> met(static_cast<std::size_t>(flat->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < flat->GetNumberOfCells(); ++cell)
  {
    const auto id = static_cast<std::size_t>(ids ? ids->GetComponent(cell, 0) : 0.0);
    pieces.resize(std::max(pieces.size(), id + 1));
    flat->GetCellPoints(cell, corners);
    for (const vtkIdType corner : *corners)
    {
      const auto point = static_cast<std::size_t>(corner);
      if (!met[point])
      {
        met[point] = true;
        pieces[id].points.push_back(point);
        if (original->GetComponent(corner, 0) >= 0.0)
        {
          pieces[id].known.push_back(point);
        }
      }
    }
  }
  return pieces;
}

Place middleOf(const std::vector<Place>& places)
{
  Place sum{};
  for (const Place& place : places)
  {
    sum[0] += place[0];
    sum[1] += place[1];
  }
  const double count = std::max<double>(1.0, static_cast<double>(places.size()));
  return { sum[0] / count, sum[1] / count };
}

/// The angle by which the first points are turned to lie best on the second ones, by least squares.
double turnBetween(const std::vector<Place>& from, const std::vector<Place>& to)
{
  const Place a = middleOf(from);
  const Place b = middleOf(to);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    const Place p{ from[k][0] - a[0], from[k][1] - a[1] };
    const Place q{ to[k][0] - b[0], to[k][1] - b[1] };
    along += p[0] * q[0] + p[1] * q[1];
    across += p[0] * q[1] - p[1] * q[0];
  }
  return std::atan2(across, along);
}

void turn(double angle, const std::vector<std::size_t>& points, Layout& layout)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (const std::size_t k : points)
  {
    const auto [x, y] = layout[k];
    layout[k] = { c * x - s * y, s * x + c * y };
  }
}

void shift(const Place& by, const std::vector<std::size_t>& points, Layout& layout)
{
  for (const std::size_t k : points)
  {
    layout[k][0] += by[0];
    layout[k][1] += by[1];
  }
}

Box boxOf(const std::vector<std::size_t>& points, const Layout& layout)
{
  Box box;
  for (const std::size_t k : points)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      box.low[axis] = std::min(box.low[axis], layout[k][axis]);
      box.high[axis] = std::max(box.high[axis], layout[k][axis]);
    }
  }
  return box;
}

/// Moves the pieces beside each other.
void layInRows(const std::vector<SteadyPiece>& pieces, Layout& layout)
{
  std::vector<Box> boxes;
  double area = 0.0;
  double side = 0.0;
  for (const SteadyPiece& piece : pieces)
  {
    boxes.push_back(boxOf(piece.points, layout));
    const Place size = boxes.back().size();
    area += size[0] * size[1];
    side = std::max({ side, size[0], size[1] });
  }
  Place next{ 0.0, 0.0 };
  double top = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    const Place size = boxes[k].size();
    if (next[0] > 0.0 && next[0] + size[0] > rowLength * std::sqrt(area))
    {
      next = { 0.0, top + gap * side };
    }
    shift({ next[0] - boxes[k].low[0], next[1] - boxes[k].low[1] }, pieces[k].points, layout);
    top = std::max(top, next[1] + size[1]);
    next[0] += size[0] + gap * side;
  }
}

std::vector<Place> placesOf(const std::vector<std::size_t>& points, const Layout& layout)
{
  std::vector<Place> places;
  for (const std::size_t k : points)
  {
    places.push_back(layout[k]);
  }
  return places;
}
}

//------------------------------------------------------------------------------
void SteadyPieces::start(
  vtkPolyData* surface, const figures::Vector& right, const figures::Vector& up)
{
  this->Shown.clear();
  for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k)
  {
    double point[3];
    surface->GetPoint(k, point);
    this->Shown.push_back({ vtkMath::Dot(point, right.data()), vtkMath::Dot(point, up.data()) });
  }
}

//------------------------------------------------------------------------------
figures::FlatPiece SteadyPieces::settle(const figures::FlatPiece& piece)
{
  vtkDataArray* const original = piece.flat->GetPointData()->GetArray("vtkOriginalPointIds");
  if (!original)
  {
    return piece;
  }
  const auto count = static_cast<std::size_t>(piece.flat->GetNumberOfPoints());
  Layout layout(count);
  Layout before(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto id = static_cast<vtkIdType>(k);
    const double* const place = piece.flat->GetPoint(id);
    layout[k] = { place[0], place[1] };
    const auto point = static_cast<vtkIdType>(original->GetComponent(id, 0));
    before[k] = point < 0 ? Place{} : this->Shown[static_cast<std::size_t>(point)];
  }
  const std::vector<SteadyPiece> pieces = piecesOf(piece.flat, original);
  std::vector<std::size_t> all;
  std::vector<std::size_t> known;
  for (const SteadyPiece& one : pieces)
  {
    const double angle = turnBetween(placesOf(one.known, layout), placesOf(one.known, before));
    turn(angle, one.points, layout);
    all.insert(all.end(), one.points.begin(), one.points.end());
    known.insert(known.end(), one.known.begin(), one.known.end());
  }
  layInRows(pieces, layout);
  const Place was = middleOf(placesOf(known, before));
  const Place is = middleOf(placesOf(known, layout));
  shift({ was[0] - is[0], was[1] - is[1] }, all, layout);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t k = 0; k < count; ++k)
  {
    points->InsertNextPoint(layout[k][0], layout[k][1], 0.0);
  }
  for (const std::size_t k : known)
  {
    const double point = original->GetComponent(static_cast<vtkIdType>(k), 0);
    this->Shown[static_cast<std::size_t>(point)] = layout[k];
  }
  figures::FlatPiece settled{ figures::PolyData::New(), figures::PolyData::New(), piece.cut,
    piece.pieces, piece.curves };
  settled.flat->ShallowCopy(piece.flat);
  settled.wires->ShallowCopy(piece.wires);
  settled.flat->SetPoints(points);
  settled.wires->SetPoints(points); // its ids are those of the flat piece
  return settled;
}
}
