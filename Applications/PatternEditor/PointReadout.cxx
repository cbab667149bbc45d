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

/// Of a cell array; 0 where there is none of the name.
double valueOf(vtkPolyData* flat, vtkIdType cell, const char* name)
{
  vtkDataArray* const array = flat->GetCellData()->GetArray(name);
  return array ? array->GetTuple1(cell) : 0.0;
}

std::string measures(vtkPolyData* flat, vtkIdType cell)
{
  const auto value = [&](const char* name) { return valueOf(flat, cell, name); };
  return "cell " + format("%.0f", value("vtkOriginalCellIds")) + " of piece " +
    format("%.0f", value("PieceId")) + ": area " + format("%.1f %%", 100.0 * value("AreaRatio")) +
    ", homogeneity " + format("%.3f", value("HomogeneityOfDistortion")) + ", aspect ratio " +
    format("%.3f", value("AspectRatio"));
}

std::string threads(vtkPolyData* flat, vtkIdType cell, double limit)
{
  const auto value = [&](const char* name) { return valueOf(flat, cell, name); };
  constexpr std::array<const char*, 3> directions{ "warp", "weft", "bias" };
  const auto dominant = static_cast<std::size_t>(value("DominantThread"));
  const double shear = value("ShearAngle");
  std::string text = "warp " + format("%+.2f %%", 100.0 * value("StrainWarp")) + ", weft " +
    format("%+.2f %%", 100.0 * value("StrainWeft")) + ", shear " + format("%+.1f\xC2\xB0", shear) +
    ", threads at " + format("%.1f\xC2\xB0", 90.0 - std::abs(shear));
  if (limit < 90.0)
  {
    text += " (limit at " + format("%.0f\xC2\xB0", 90.0 - limit) + ")";
  }
  text += std::string(", most in the ") + directions[std::min<std::size_t>(dominant, 2)] + ": " +
    format("%.1f %%", value("DominantStretch"));
  return text + (value("OutOfLimit") != 0.0 ? ", beyond the limits" : "");
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
  vtkPolyData* const flat = this->Piece.flat;
  const vtkIdType cell = flat && flat->GetNumberOfCells() > 0 ? this->cellAt(plane, x, y) : -1;
  if (cell < 0)
  {
    return {};
  }
  std::string text = measures(flat, cell);
  if (flat->GetCellData()->HasArray("StrainWarp"))
  {
    const double limit =
      this->Piece.number("ShearLimit", static_cast<vtkIdType>(valueOf(flat, cell, "PieceId")));
    text += "; " + threads(flat, cell, std::isnan(limit) ? 90.0 : limit);
  }
  return text;
}
}
