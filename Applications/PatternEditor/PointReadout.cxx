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

void PointReadout::setPiece(const figures::FlatPiece& piece)
{
  this->Piece = piece;
  this->Locator = nullptr;
}

vtkIdType PointReadout::cellAt(vtkRenderer* plane, int x, int y)
{
  plane->SetDisplayPoint(x, y, 0.0); // at any depth: the view is parallel, and along z
  plane->DisplayToWorld();
  const double* const world = plane->GetWorldPoint();
  if (world[3] == 0.0)
  {
    return -1;
  }
  std::array<double, 3> point{ world[0] / world[3], world[1] / world[3], 0.0 };
  if (!this->Locator)
  {
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(this->Piece.flat);
    this->Locator->BuildLocator();
  }
  return this->Locator->FindCell(point.data());
}

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
