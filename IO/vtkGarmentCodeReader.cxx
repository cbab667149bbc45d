// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGarmentCodeReader.h"

#include "Base/Memory.h"
#include "FieldArrays.h"
#include "Formats/GarmentPieces.h"
#include "GarmentCodeFile.h"
#include "Input/StatusWords.h"
#include "Outlines/PatternSource.h"
#include "PanelArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFlatteningAlgorithm.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <utility>

vtkStandardNewMacro(vtkGarmentCodeReader);

namespace flattening
{
namespace bridge
{
namespace
{
using pattern::PatternSource;
using pattern::SewnEdges;
using pattern::SourceWire;
using pattern::WireType;

template <typename PointAt>
vtkSmartPointer<vtkPoints> pointsOf(const PatternSource& source, PointAt&& at)
{
  vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(source.positions.size()));
  for (std::size_t v = 0; v < source.positions.size(); ++v)
  {
    const Point3 point = at(v);
    points->SetPoint(static_cast<vtkIdType>(v), point.data());
  }
  return points;
}

void addTriangles(const PatternSource& source, vtkPolyData* data)
{
  vtkNew<vtkCellArray> cells;
  for (const Triangle& triangle : source.triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  data->SetPolys(cells);
  addRows<vtkIdTypeArray>(data->GetCellData(), "PieceId", source.triangles.size(),
    [&](std::size_t row) { return vtkIdType{ source.pieceOfTriangle[row] }; });
}

int curveType(WireType type)
{
  switch (type)
  {
    case WireType::Boundary:
      return -1;
    case WireType::Key:
      return 1;
    case WireType::Dart:
      return 2;
    case WireType::Seam:
      return 3;
    default:
      return 0;
  }
}

struct WireLengths
{
  double inSpace = 0.0;
  double inPlane = 0.0;
  double error = 0.0; ///< the largest relative one of an edge
};

WireLengths lengthsOf(const PatternSource& source, const SourceWire& wire)
{
  WireLengths lengths;
  for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
  {
    const auto a = static_cast<std::size_t>(wire.points[k]);
    const auto b = static_cast<std::size_t>(wire.points[k + 1]);
    const double inSpace = (source.inSpace[b] - source.inSpace[a]).norm();
    const double inPlane = (source.positions[b] - source.positions[a]).norm();
    lengths.inSpace += inSpace;
    lengths.inPlane += inPlane;
    if (inSpace > 0.0)
    {
      lengths.error = std::max(lengths.error, std::abs(inPlane - inSpace) / inSpace);
    }
  }
  return lengths;
}

void addSeamPairs(const PatternSource& source, vtkPolyData* flat)
{
  std::vector<Index> curveOf; // of each pair, in the order of the banks that hold them
  for (std::size_t w = 0; w + 1 < source.wires.size(); ++w)
  {
    const SourceWire& wire = source.wires[w];
    const bool first = (wire.type == WireType::Seam || wire.type == WireType::Dart) &&
      source.wires[w + 1].curve == wire.curve;
    for (std::size_t k = 0; first && k + 1 < wire.points.size(); ++k)
    {
      curveOf.push_back(wire.curve);
    }
  }
  vtkNew<vtkIdTypeArray> pairs;
  pairs->SetName("SeamPairs");
  pairs->SetNumberOfComponents(5);
  for (std::size_t row = 0; row < source.sewn.size(); ++row)
  {
    const SewnEdges& sewn = source.sewn[row];
    const std::array<vtkIdType, 5> values{ sewn.a[0], sewn.a[1], sewn.b[0], sewn.b[1],
      row < curveOf.size() ? curveOf[row] : none };
    pairs->InsertNextTypedTuple(values.data());
  }
  addUnlessEmpty(flat->GetFieldData(), pairs);
}

void addWires(const PatternSource& source, vtkPolyData* data)
{
  const std::vector<SourceWire>& wires = source.wires;
  vtkNew<vtkCellArray> cells;
  std::vector<std::string> names;
  std::vector<WireLengths> lengths;
  for (const SourceWire& wire : wires)
  {
    const std::vector<vtkIdType> ids(wire.points.begin(), wire.points.end());
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    names.push_back(wire.name);
    lengths.push_back(lengthsOf(source, wire));
  }
  data->SetLines(cells);
  vtkCellData* const cellData = data->GetCellData();
  const auto typeOf = [&](std::size_t row) { return curveType(wires[row].type); };
  addRows<vtkIntArray>(cellData, "CurveType", wires.size(), typeOf);
  addRows<vtkIntArray>(cellData, "WireKind", wires.size(), typeOf);
  addRows<vtkIdTypeArray>(cellData, "CurveId", wires.size(),
    [&](std::size_t row) { return vtkIdType{ wires[row].curve }; });
  addRows<vtkIdTypeArray>(cellData, "PieceId", wires.size(),
    [&](std::size_t row) { return vtkIdType{ wires[row].piece }; });
  addStrings(cellData, "CurveName", names);
  const auto flag = [](unsigned char value) { return [value](std::size_t) { return value; }; };
  addRows<vtkUnsignedCharArray>(cellData, "Boundary", wires.size(), flag(1));
  addRows<vtkUnsignedCharArray>(cellData, "Connector", wires.size(), flag(0));
  const std::array<std::pair<const char*, double WireLengths::*>, 3> columns{
    { { "LengthError", &WireLengths::error }, { "RestLength", &WireLengths::inSpace },
      { "FlatLength", &WireLengths::inPlane } }
  };
  for (const auto& [name, value] : columns)
  {
    addRows<vtkDoubleArray>(cellData, name, wires.size(),
      [&lengths, member = value](std::size_t row) { return lengths[row].*member; });
  }
}

/// Writes pieces as vtkWireWarpingFilter does, so that readPattern() reads them: what
/// vtkGarmentCodeReader documents.
void writePatternSource(
  const PatternSource& source, vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut)
{
  const vtkSmartPointer<vtkPoints> inPlane = pointsOf(source, [&source](std::size_t v) {
    return Point3(source.positions[v].x(), source.positions[v].y(), 0.0);
  });
  const vtkSmartPointer<vtkPoints> inSpace =
    pointsOf(source, [&source](std::size_t v) { return source.inSpace[v]; });
  flat->SetPoints(inPlane);
  wires->SetPoints(inPlane);
  cut->SetPoints(inSpace);
  addTriangles(source, flat);
  addTriangles(source, cut);
  flat->GetCellData()->SetActiveScalars("PieceId");
  cut->GetCellData()->SetActiveScalars("PieceId");
  addSeamPairs(source, flat);
  addWires(source, wires);
  wires->GetCellData()->SetActiveScalars("WireKind");
  writePanels(source.panels, wires->GetFieldData());
}
}
}
}

//------------------------------------------------------------------------------
vtkGarmentCodeReader::vtkGarmentCodeReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkGarmentCodeReader::~vtkGarmentCodeReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkGarmentCodeReader::CanReadFile(const char* name)
{
  if (!name || !*name)
  {
    return 0;
  }
  constexpr std::size_t looked = 1'000'000;
  std::string text(looked, '\0');
  std::ifstream file(name, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(looked));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text.find("\"panels\"") != std::string::npos ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkGarmentCodeReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  using namespace flattening;
  struct Pieces
  {
    Status status;
    pattern::PatternSource source;
  };
  const Pieces pieces = withinMemory([this] {
    Pieces made;
    pattern::Garment garment;
    made.status = this->FileName && *this->FileName
      ? bridge::readGarmentCode(this->FileName, garment)
      : Status{ StatusCode::InvalidPattern, "there is no file name", {},
          { { Remedy::Give, "FileName" } } };
    if (made.status.ok())
    {
      made.status = pattern::makePieces(garment, made.source);
    }
    return made;
  });
  this->StatusName = statusName(pieces.status.code);
  this->ErrorMessage = flattening::inWords(pieces.status);
  if (!pieces.status.ok())
  {
    vtkErrorMacro(<< this->ErrorMessage);
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    return 1; // what failed has been said
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  bridge::writePatternSource(pieces.source, vtkPolyData::GetData(outputVector, 0),
    vtkPolyData::GetData(outputVector, 1), vtkPolyData::GetData(outputVector, 2));
  for (int port = 0; port < 3; ++port)
  {
    vtkFlatteningAlgorithm::SetLengthUnitOf(vtkPolyData::GetData(outputVector, port), "cm");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGarmentCodeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "StatusName: " << this->StatusName << "\n";
}
