// SPDX-License-Identifier: BSD-3-Clause
#include "SteadyPieces.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace editor
{
namespace
{
constexpr double gap = 0.06;      // between pieces, of the largest side of one
constexpr double rowLength = 1.5; // of the side of a square as large as all boxes

/// The points of a piece, and those among them that are points of the surface.
struct SteadyPiece
{
  std::vector<Eigen::Index> points;
  std::vector<Eigen::Index> known;
};

/// A column for each point.
using Layout = Eigen::Matrix2Xd;

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
      if (!met[static_cast<std::size_t>(corner)])
      {
        met[static_cast<std::size_t>(corner)] = true;
        pieces[id].points.push_back(corner);
        if (original->GetComponent(corner, 0) >= 0.0)
        {
          pieces[id].known.push_back(corner);
        }
      }
    }
  }
  return pieces;
}

Eigen::Vector2d middleOf(const std::vector<Eigen::Index>& points, const Layout& layout)
{
  return points.empty() ? Eigen::Vector2d::Zero()
                        : Eigen::Vector2d(layout(Eigen::all, points).rowwise().mean());
}

/// The angle by which points are turned to lie best on their places in the other layout, by least
/// squares.
double turnBetween(
  const std::vector<Eigen::Index>& points, const Layout& layout, const Layout& other)
{
  const Layout from = layout(Eigen::all, points).colwise() - middleOf(points, layout);
  const Layout to = other(Eigen::all, points).colwise() - middleOf(points, other);
  const Eigen::Matrix2d products = from * to.transpose();
  return std::atan2(products(0, 1) - products(1, 0), products.trace());
}

/// Moves the pieces beside each other.
void layInRows(const std::vector<SteadyPiece>& pieces, Layout& layout)
{
  std::vector<Eigen::AlignedBox2d> boxes;
  double area = 0.0;
  double side = 0.0;
  for (const SteadyPiece& piece : pieces)
  {
    const Layout places = layout(Eigen::all, piece.points);
    boxes.emplace_back(places.rowwise().minCoeff(), places.rowwise().maxCoeff());
    area += boxes.back().volume();
    side = std::max(side, boxes.back().sizes().maxCoeff());
  }
  Eigen::Vector2d next = Eigen::Vector2d::Zero();
  double top = 0.0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    const Eigen::Vector2d size = boxes[k].sizes();
    if (next.x() > 0.0 && next.x() + size.x() > rowLength * std::sqrt(area))
    {
      next = { 0.0, top + gap * side };
    }
    layout(Eigen::all, pieces[k].points).colwise() += next - boxes[k].min();
    top = std::max(top, next.y() + size.y());
    next.x() += size.x() + gap * side;
  }
}
}

void SteadyPieces::start(
  vtkPolyData* surface, const figures::Vector& right, const figures::Vector& up)
{
  this->Shown.resize(2, surface->GetNumberOfPoints());
  for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k)
  {
    double point[3];
    surface->GetPoint(k, point);
    this->Shown.col(k) << vtkMath::Dot(point, right.data()), vtkMath::Dot(point, up.data());
  }
}

figures::FlatPiece SteadyPieces::settle(const figures::FlatPiece& piece)
{
  vtkDataArray* const original = piece.flat->GetPointData()->GetArray("vtkOriginalPointIds");
  if (!original)
  {
    return piece;
  }
  const vtkIdType count = piece.flat->GetNumberOfPoints();
  Layout layout(2, count);
  Layout before = Layout::Zero(2, count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const double* const place = piece.flat->GetPoint(k);
    layout.col(k) << place[0], place[1];
    const auto point = static_cast<vtkIdType>(original->GetComponent(k, 0));
    if (point >= 0)
    {
      before.col(k) = this->Shown.col(point);
    }
  }
  const std::vector<SteadyPiece> pieces = piecesOf(piece.flat, original);
  std::vector<Eigen::Index> known;
  for (const SteadyPiece& one : pieces)
  {
    const Eigen::Rotation2Dd turn(turnBetween(one.known, layout, before));
    layout(Eigen::all, one.points) =
      (turn.toRotationMatrix() * layout(Eigen::all, one.points)).eval();
    known.insert(known.end(), one.known.begin(), one.known.end());
  }
  layInRows(pieces, layout);
  layout.colwise() += middleOf(known, before) - middleOf(known, layout);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType k = 0; k < count; ++k)
  {
    points->InsertNextPoint(layout(0, k), layout(1, k), 0.0);
  }
  for (const Eigen::Index k : known)
  {
    this->Shown.col(static_cast<Eigen::Index>(original->GetComponent(k, 0))) = layout.col(k);
  }
  const figures::PolyData flat = figures::PolyData::New();
  flat->ShallowCopy(piece.flat);
  flat->SetPoints(points);
  return { flat, piece.wiresOn(flat), piece.cut, piece.pieces, piece.curves };
}
}
