// SPDX-License-Identifier: BSD-3-Clause
#include "PointReadout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace editor
{
namespace
{
std::string format(const char* how, double value)
{
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), how, value);
  return text.data();
}

/// The arrays of one cell.
class CellValues
{
public:
  CellValues(vtkPolyData* flat, vtkIdType cell)
    : Flat(flat)
    , Cell(cell)
  {
  }

  bool has(const char* name) const { return this->Flat->GetCellData()->HasArray(name) != 0; }
  double value(const char* name) const
  {
    vtkDataArray* const array = this->Flat->GetCellData()->GetArray(name);
    return array ? array->GetTuple1(this->Cell) : 0.0;
  }

private:
  vtkPolyData* Flat;
  vtkIdType Cell;
};

std::string measures(const CellValues& cell)
{
  return "cell " + format("%.0f", cell.value("vtkOriginalCellIds")) + " of piece " +
    format("%.0f", cell.value("PieceId")) + ": area " +
    format("%.1f %%", 100.0 * cell.value("AreaRatio")) + ", homogeneity " +
    format("%.3f", cell.value("HomogeneityOfDistortion")) + ", aspect ratio " +
    format("%.3f", cell.value("AspectRatio"));
}

std::string threads(const CellValues& cell, double limit)
{
  constexpr std::array<const char*, 3> directions{ "warp", "weft", "bias" };
  const auto dominant = static_cast<std::size_t>(cell.value("DominantThread"));
  const double shear = cell.value("ShearAngle");
  std::string text = "warp " + format("%+.2f %%", 100.0 * cell.value("StrainWarp")) + ", weft " +
    format("%+.2f %%", 100.0 * cell.value("StrainWeft")) + ", shear " +
    format("%+.1f\xC2\xB0", shear) + ", threads at " +
    format("%.1f\xC2\xB0", 90.0 - std::abs(shear));
  if (limit < 90.0)
  {
    text += " (limit at " + format("%.0f\xC2\xB0", 90.0 - limit) + ")";
  }
  text += std::string(", most in the ") + directions[std::min<std::size_t>(dominant, 2)] + ": " +
    format("%.1f %%", cell.value("DominantStretch"));
  return text + (cell.value("OutOfLimit") != 0.0 ? ", beyond the limits" : "");
}
}

//------------------------------------------------------------------------------
void PointReadout::setPiece(const figures::FlatPiece& piece)
{
  this->Piece = piece;
  this->Locator = nullptr;
}

//------------------------------------------------------------------------------
vtkIdType PointReadout::cellAt(vtkRenderer* plane, int x, int y)
{
  // Where the ray through the pixel meets the plane of the pieces.
  std::array<std::array<double, 4>, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    plane->SetDisplayPoint(x, y, static_cast<double>(k));
    plane->DisplayToWorld();
    plane->GetWorldPoint(ends[k].data());
    if (ends[k][3] == 0.0)
    {
      return -1;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      ends[k][i] /= ends[k][3];
    }
  }
  const double depth = ends[0][2] - ends[1][2];
  if (depth == 0.0)
  {
    return -1;
  }
  const double share = ends[0][2] / depth;
  std::array<double, 3> point{ ends[0][0] + share * (ends[1][0] - ends[0][0]),
    ends[0][1] + share * (ends[1][1] - ends[0][1]), 0.0 };
  if (!this->Locator)
  {
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(this->Piece.flat);
    this->Locator->BuildLocator();
  }
  return this->Locator->FindCell(point.data());
}

//------------------------------------------------------------------------------
std::string PointReadout::at(vtkRenderer* plane, int x, int y)
{
  const vtkIdType found =
    this->Piece.flat && this->Piece.flat->GetNumberOfCells() > 0 ? this->cellAt(plane, x, y) : -1;
  if (found < 0)
  {
    return {};
  }
  const CellValues cell(this->Piece.flat, found);
  std::string text = measures(cell);
  if (cell.has("StrainWarp"))
  {
    const double limit =
      this->Piece.number("ShearLimit", static_cast<vtkIdType>(cell.value("PieceId")));
    text += "; " + threads(cell, std::isnan(limit) ? 90.0 : limit);
  }
  return text;
}
}
