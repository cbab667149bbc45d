// SPDX-License-Identifier: BSD-3-Clause
#include "PatternInput.h"

#include "Base/Types.h"
#include "PanelArrays.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

namespace flattening
{
namespace bridge
{
namespace
{
using flattening::Status;
using flattening::StatusCode;
using pattern::PatternSource;
using pattern::SewnEdges;
using pattern::SourceWire;
using pattern::WireType;

/// How far points of flat pieces may differ in z, as a share of their width.
constexpr double flatness = 1e-6;

Status invalidPieces(const std::string& message)
{
  return { StatusCode::InvalidPattern, message, {}, { Remedy::GiveFlatPieces } };
}

/// Whether each array that is there has a value of its own for each of a number of rows.
Status checkRows(
  std::initializer_list<vtkAbstractArray*> arrays, vtkIdType rows, const std::string& owner)
{
  for (vtkAbstractArray* array : arrays)
  {
    if (array && (array->GetNumberOfTuples() < rows || array->GetNumberOfComponents() != 1))
    {
      return invalidPieces(std::string("the array ") + array->GetName() + " of " + owner + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values of " +
        std::to_string(array->GetNumberOfComponents()) + " components for " + std::to_string(rows) +
        " rows");
    }
  }
  return {};
}

/// A whole number that a value stands for; none where it stands for none, or for a negative one.
Index indexOf(double value)
{
  const bool fits = value >= 0.0 && value <= std::numeric_limits<Index>::max();
  return fits ? static_cast<Index>(value) : none;
}

/// A surface that was not flattened would be drawn as it is seen from above, not as it is cut.
Status checkFlatness(vtkPolyData* flat)
{
  double box[6];
  flat->GetBounds(box);
  const double height = box[5] - box[4];
  const double size = std::max(box[1] - box[0], box[3] - box[2]);
  if (flat->GetNumberOfPoints() > 0 && !(height <= flatness * size))
  {
    return invalidPieces("the surface is not flat: it is " + std::to_string(height) +
      " high in z and " + std::to_string(size) + " wide");
  }
  return {};
}

Status readSurface(vtkPolyData* flat, PatternSource& source)
{
  const vtkIdType points = flat->GetNumberOfPoints();
  if (points > std::numeric_limits<Index>::max())
  {
    return invalidPieces("the flat surface has more points than 2^31 - 1");
  }
  Status status = checkFlatness(flat);
  if (!status.ok())
  {
    return status;
  }
  for (vtkIdType v = 0; v < points; ++v)
  {
    const double* p = flat->GetPoint(v);
    source.positions.emplace_back(p[0], p[1]);
  }
  vtkDataArray* pieces = flat->GetCellData()->GetArray("PieceId");
  status = checkRows({ pieces }, flat->GetNumberOfCells(), "the flat surface");
  if (!status.ok())
  {
    return status;
  }
  auto* const names =
    vtkStringArray::SafeDownCast(flat->GetCellData()->GetAbstractArray("PieceName"));
  std::vector<std::optional<std::string>> nameOfPiece;
  const auto name = [&](vtkIdType cell) {
    const Index piece = source.pieceOfTriangle.back();
    if (!names || cell >= names->GetNumberOfTuples() || piece < 0 ||
      piece >= flat->GetNumberOfCells())
    {
      return;
    }
    nameOfPiece.resize(std::max(nameOfPiece.size(), static_cast<std::size_t>(piece) + 1));
    std::optional<std::string>& one = nameOfPiece[static_cast<std::size_t>(piece)];
    const std::string own = names->GetValue(cell);
    one = !one || *one == own ? own : std::string(); // cloth of two names has neither
  };
  if (!flat->GetPolys()->IsValid())
  {
    return invalidPieces("the cells of the flat surface do not fit the list of their corners");
  }
  // Cell data starts with vertices and lines.
  const vtkIdType before = flat->GetNumberOfVerts() + flat->GetNumberOfLines();
  auto cells = vtk::TakeSmartPointer(flat->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    const vtkIdType cell = before + cells->GetCurrentCellId();
    if (count != 3)
    {
      return invalidPieces("cell " + std::to_string(cell) + " of the flat surface is no triangle");
    }
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (ids[k] < 0 || ids[k] >= points)
      {
        return invalidPieces("cell " + std::to_string(cell) + " of the flat surface uses point " +
          std::to_string(ids[k]) + ", which is not there");
      }
      triangle[k] = static_cast<Index>(ids[k]);
    }
    source.triangles.push_back(triangle);
    source.pieceOfTriangle.push_back(pieces ? indexOf(pieces->GetComponent(cell, 0)) : 0);
    name(cell);
  }
  for (const std::optional<std::string>& one : nameOfPiece)
  {
    source.pieceNames.push_back(one.value_or(""));
  }
  return {};
}

WireType typeOf(vtkDataArray* types, vtkIdType row)
{
  const double type = types ? types->GetComponent(row, 0) : 0.0;
  if (type == -1.0)
  {
    return WireType::Boundary;
  }
  switch (indexOf(type))
  {
    case 1:
      return WireType::Key;
    case 2:
      return WireType::Dart;
    case 3:
      return WireType::Seam;
    default:
      return WireType::Accessory;
  }
}

Status readWires(vtkPolyData* wires, PatternSource& source)
{
  if (wires->GetNumberOfPoints() != static_cast<vtkIdType>(source.positions.size()))
  {
    return invalidPieces("the wires have " + std::to_string(wires->GetNumberOfPoints()) +
      " points and the flat surface " + std::to_string(source.positions.size()) + "");
  }
  vtkCellData* data = wires->GetCellData();
  vtkDataArray* types = data->GetArray("CurveType");
  vtkDataArray* curves = data->GetArray("CurveId");
  vtkDataArray* pieces = data->GetArray("PieceId");
  vtkDataArray* connectors = data->GetArray("Connector");
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("CurveName"));
  Status status =
    checkRows({ types, curves, pieces, connectors, names }, wires->GetNumberOfCells(), "the wires");
  if (!status.ok())
  {
    return status;
  }
  if (!wires->GetLines()->IsValid())
  {
    return invalidPieces("the cells of the wires do not fit the list of their points");
  }
  auto lines = vtk::TakeSmartPointer(wires->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    const vtkIdType row = wires->GetNumberOfVerts() + lines->GetCurrentCellId();
    if (connectors && connectors->GetComponent(row, 0) != 0.0)
    {
      continue; // an aid of the flattening, whose length is free
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(count, ids);
    SourceWire wire;
    wire.type = typeOf(types, row);
    wire.curve = curves ? indexOf(curves->GetComponent(row, 0)) : none;
    wire.piece = pieces ? indexOf(pieces->GetComponent(row, 0)) : 0;
    wire.name = wire.type == WireType::Boundary ? std::string("boundary")
      : names                                   ? std::string(names->GetValue(row))
                                                : "curve " + std::to_string(row);
    for (vtkIdType k = 0; k < count; ++k)
    {
      if (ids[k] < 0 || ids[k] >= wires->GetNumberOfPoints())
      {
        return invalidPieces("wire " + std::to_string(row) + " uses point " +
          std::to_string(ids[k]) + ", which is not there");
      }
      wire.points.push_back(static_cast<Index>(ids[k]));
    }
    source.wires.push_back(std::move(wire));
  }
  return {};
}

Status readSewnEdges(vtkPolyData* flat, PatternSource& source)
{
  vtkDataArray* pairs = flat->GetFieldData()->GetArray("SeamPairs");
  if (!pairs)
  {
    return {};
  }
  if (pairs->GetNumberOfComponents() < 4)
  {
    return invalidPieces("the array SeamPairs of the flat surface has fewer than 4 components");
  }
  vtkDataArray* closed = flat->GetFieldData()->GetArray("SeamClosed");
  Status status = checkRows({ closed }, pairs->GetNumberOfTuples(), "the flat surface");
  if (!status.ok())
  {
    return status;
  }
  for (vtkIdType row = 0; row < pairs->GetNumberOfTuples(); ++row)
  {
    std::array<Index, 4> ids{};
    for (int k = 0; k < 4; ++k)
    {
      const double id = pairs->GetComponent(row, k);
      if (!(id >= 0.0 && id < static_cast<double>(source.positions.size())))
      {
        return invalidPieces(
          "row " + std::to_string(row) + " of SeamPairs uses a point that is not there");
      }
      ids[static_cast<std::size_t>(k)] = static_cast<Index>(id);
    }
    const bool isClosed = closed && closed->GetComponent(row, 0) != 0.0;
    source.sewn.push_back({ { ids[0], ids[1] }, { ids[2], ids[3] }, isClosed });
  }
  return {};
}

Status readCutSurface(vtkPolyData* cut, PatternSource& source)
{
  if (cut->GetNumberOfPoints() != static_cast<vtkIdType>(source.positions.size()))
  {
    return invalidPieces("the cut surface has " + std::to_string(cut->GetNumberOfPoints()) +
      " points and the flat surface " + std::to_string(source.positions.size()) + "");
  }
  for (vtkIdType v = 0; v < cut->GetNumberOfPoints(); ++v)
  {
    source.inSpace.emplace_back(cut->GetPoint(v));
    if (!isFinite(source.inSpace.back()))
    {
      return invalidPieces("point " + std::to_string(v) + " of the cut surface is not finite");
    }
  }
  return {};
}
}

Status readPattern(vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, PatternSource& source)
{
  source = PatternSource();
  Status status = readSurface(flat, source);
  if (status.ok() && wires)
  {
    status = readWires(wires, source);
  }
  if (status.ok() && wires)
  {
    status = readPanels(wires->GetFieldData(), source);
  }
  if (status.ok())
  {
    source.onCloth = flat->GetFieldData()->GetArray("GrainAngle") != nullptr;
    source.isSheet = flat->GetFieldData()->GetArray("SheetMaterial") != nullptr;
    status = readSewnEdges(flat, source);
  }
  if (status.ok() && cut)
  {
    status = readCutSurface(cut, source);
  }
  return status;
}
}
}
