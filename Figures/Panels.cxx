// SPDX-License-Identifier: BSD-3-Clause
#include "Panels.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

namespace figures
{
std::vector<FlatPiece> flattenAll(
  const std::vector<Piece>& pieces, Method method, Interior interior)
{
  std::vector<FlatPiece> flat;
  flat.reserve(pieces.size());
  for (const Piece& piece : pieces)
  {
    flat.push_back(flatten(piece, method, interior));
  }
  layBeside(flat);
  return flat;
}

void drawSpace(Drawing& drawing, const std::vector<Piece>& pieces, const Vector& direction)
{
  drawing.lookFrom(direction);
  for (const Piece& piece : pieces)
  {
    drawing.addSurface(piece.surface);
    drawing.addBoundary(piece.surface);
    drawing.addWires(piece.curves);
  }
}

double drawDevelopability(
  Drawing& drawing, const std::vector<Piece>& pieces, const Vector& direction)
{
  drawing.lookFrom(direction);
  std::vector<PolyData> measured;
  double largest = 0.0;
  for (const Piece& piece : pieces)
  {
    measured.push_back(measureDevelopability(piece.surface));
    largest =
      std::max(largest, measured.back()->GetPointData()->GetArray("Developability")->GetRange()[1]);
  }
  for (const PolyData& surface : measured)
  {
    drawing.addPointMap(surface, "Developability", { 0.0, std::max(largest, developable) });
    drawing.addBoundary(surface);
  }
  return largest;
}

void drawFlat(Drawing& drawing, const std::vector<FlatPiece>& pieces)
{
  for (const FlatPiece& piece : pieces)
  {
    drawing.addSurface(piece.flat);
    drawing.addWires(piece.wires);
  }
}

void drawIndex(Drawing& drawing, const std::vector<FlatPiece>& pieces, const char* array)
{
  for (const FlatPiece& piece : pieces)
  {
    drawing.addCellMap(piece.flat, array, indexRange);
    drawing.addWires(piece.wires);
  }
}
}
