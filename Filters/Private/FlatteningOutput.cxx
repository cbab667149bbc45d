// SPDX-License-Identifier: BSD-3-Clause
#include "FlatteningOutput.h"

#include "Base/Types.h"
#include "FieldArrays.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "SurfaceOutput.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening
{
namespace bridge
{
namespace
{
/// The largest strain of a triangle and its direction: warp, weft, or the bias between them, in
/// which a shear of g draws by about g / 2.
struct Dominant
{
  unsigned char thread = 0;
  double strain = 0.0;
};

Dominant dominantOf(const ThreadStrain& strain)
{
  const double bias = 0.5 * (strain.warp + strain.weft) + std::sin(0.5 * std::abs(strain.shear));
  Dominant dominant{ 0, strain.warp };
  const auto consider = [&dominant](unsigned char thread, double value) {
    if (std::abs(value) > std::abs(dominant.strain))
    {
      dominant = { thread, value };
    }
  };
  consider(1, strain.weft);
  consider(2, bias);
  return dominant;
}

/// Appends the points that healing joined to others: copies of these with their own
/// `vtkOriginalPointIds`, which no cell uses, so that each point of the input has a flat place.
/// \return the vertices that they are copies of
std::vector<vtkIdType> appendJoinedPoints(const CurvedSurface& source, vtkPolyData* flat)
{
  const HealedSurface& healed = source.surface.prepared;
  std::multimap<vtkIdType, vtkIdType> joinedTo;
  for (const Index p : healed.joinedPoints)
  {
    const Index vertex = healed.vertexOfPoint[p];
    if (vertex != none)
    {
      joinedTo.emplace(healed.originalPoint[vertex], p);
    }
  }
  std::vector<vtkIdType> vertices;
  vtkPointData* const data = flat->GetPointData();
  auto* const ids = vtkIdTypeArray::SafeDownCast(data->GetArray("vtkOriginalPointIds"));
  const vtkIdType count = joinedTo.empty() ? 0 : flat->GetNumberOfPoints();
  for (vtkIdType v = 0; v < count; ++v)
  {
    const auto points = joinedTo.equal_range(ids->GetValue(v));
    for (auto joined = points.first; joined != points.second; ++joined)
    {
      vertices.push_back(v);
      const vtkIdType copy = flat->GetPoints()->InsertNextPoint(flat->GetPoint(v));
      for (int k = 0; k < data->GetNumberOfArrays(); ++k)
      {
        vtkAbstractArray* const array = data->GetAbstractArray(k);
        array->InsertNextTuple(v, array);
      }
      ids->SetValue(copy, joined->second);
    }
  }
  return vertices;
}

/// The cell arrays of threads; none where there is no material.
void writeThreads(const FlatteningResult& result, vtkCellData* cells)
{
  const std::vector<ThreadStrain>& threads = result.threads;
  if (threads.empty())
  {
    return;
  }
  const std::size_t count = threads.size();
  addRows<vtkDoubleArray>(
    cells, "StrainWarp", count, [&](std::size_t t) { return threads[t].warp; });
  addRows<vtkDoubleArray>(
    cells, "StrainWeft", count, [&](std::size_t t) { return threads[t].weft; });
  addRows<vtkDoubleArray>(
    cells, "ShearAngle", count, [&](std::size_t t) { return threads[t].shear / degree; });
  std::vector<unsigned char> out(count, 0);
  for (const PieceReport& piece : result.pieces)
  {
    for (Index t : piece.cloth ? piece.cloth->outOfLimit : Indices())
    {
      out[t] = 1;
    }
  }
  addRows<vtkUnsignedCharArray>(cells, "OutOfLimit", count, [&](std::size_t t) { return out[t]; });
  addRows<vtkUnsignedCharArray>(
    cells, "DominantThread", count, [&](std::size_t t) { return dominantOf(threads[t]).thread; });
  addRows<vtkDoubleArray>(cells, "DominantStretch", count,
    [&](std::size_t t) { return 100.0 * (1.0 + dominantOf(threads[t]).strain); });
}

/// `GrainAngle` of each piece, by which patterns know that pieces lie on a material.
void writeGrain(const FlatteningResult& result, vtkFieldData* field)
{
  // Without a material what the field data of the input had is removed: patterns of it would lie on
  // a cloth.
  const std::size_t rows = result.threads.empty() ? 0 : result.pieces.size();
  addRows<vtkDoubleArray>(field, "GrainAngle", rows, [&](std::size_t row) {
    const auto& cloth = result.pieces[row].cloth;
    return cloth ? cloth->grain.angle / degree : 0.0;
  });
}

void writeOverlapEdges(const FlatteningResult& result, vtkFieldData* field)
{
  vtkNew<vtkIdTypeArray> edges;
  edges->SetName("OverlapEdges");
  edges->SetNumberOfComponents(5);
  const TriangleMesh& mesh = result.cut->mesh;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    for (const std::array<Index, 2>& pair : result.pieces[p].overlaps.listed)
    {
      const vtkIdType row[5] = { mesh.from(pair[0]), mesh.to(pair[0]), mesh.from(pair[1]),
        mesh.to(pair[1]), static_cast<vtkIdType>(p) };
      edges->InsertNextTypedTuple(row);
    }
  }
  addUnlessEmpty(field, edges);
}

/// Per wire-patch its place in the order in which its piece was warped.
Indices placesInOrder(const FlatteningResult& result)
{
  Indices place;
  for (const PieceReport& piece : result.pieces)
  {
    for (std::size_t i = 0; i < piece.warpingOrder.size(); ++i)
    {
      const std::size_t patch = static_cast<std::size_t>(piece.warpingOrder[i]);
      place.resize(std::max(place.size(), patch + 1), none);
      place[patch] = static_cast<Index>(i);
    }
  }
  return place;
}

void writePatches(const FlatteningResult& result, vtkCellData* cells)
{
  const Indices& patches = result.patchOfTriangle;
  addRows<vtkIdTypeArray>(
    cells, "WirePatchId", patches.size(), [&](std::size_t t) { return patches[t]; });
  const Indices place = placesInOrder(result);
  if (!place.empty())
  {
    addRows<vtkIdTypeArray>(cells, "WarpingOrder", patches.size(), [&](std::size_t t) {
      const std::size_t patch = static_cast<std::size_t>(patches[t]);
      return patch < place.size() ? place[patch] : none;
    });
  }
}

/// One number that colours wires: the type of the curve, -1 for the boundary, -2 for connectors.
int kindOf(const Wire& wire)
{
  return wire.connector ? -2 : wire.curve == none ? -1 : static_cast<int>(wire.type);
}

void writeFlatLengths(const std::vector<Wire>& wires, vtkCellData* cells)
{
  addRows<vtkIntArray>(
    cells, "WireKind", wires.size(), [&](std::size_t w) { return kindOf(wires[w]); });
  addRows<vtkUnsignedCharArray>(cells, "Connector", wires.size(),
    [&](std::size_t w) { return static_cast<unsigned char>(wires[w].connector); });
  addRows<vtkDoubleArray>(
    cells, "FlatLength", wires.size(), [&](std::size_t w) { return wires[w].flatLength; });
  addRows<vtkDoubleArray>(
    cells, "LengthError", wires.size(), [&](std::size_t w) { return wires[w].maximumEdgeError; });
}

/// Per row of SeamPairs whether the two edges lie on each other because their cut was closed.
void writeClosedSeams(const FlatteningResult& result, vtkFieldData* field)
{
  std::vector<char> closed(result.cut->mesh.halfedgeCount(), 0);
  for (const PieceReport& piece : result.pieces)
  {
    for (Index h : piece.closedEdges)
    {
      closed[h] = 1;
    }
  }
  const std::vector<SeamPair>& pairs = result.cut->seamPairs;
  addRows<vtkUnsignedCharArray>(field, "SeamClosed", pairs.size(),
    [&](std::size_t i) { return static_cast<unsigned char>(closed[pairs[i].first]); });
}

/// The flat positions as active texture coordinates; those of the input stay among the point data.
void writeTextureCoordinates(const Points2& positions, vtkPointData* points)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("FlatPositions");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(positions.size()));
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    coordinates->SetTypedTuple(static_cast<vtkIdType>(v), positions[v].data());
  }
  points->AddArray(coordinates);
  points->SetActiveTCoords(coordinates->GetName());
}

/// What viewers colour by as long as nobody chooses; what the input chose stays.
void setActiveScalars(vtkPolyData* data, const char* name)
{
  if (!data->GetPointData()->GetScalars() && !data->GetCellData()->GetScalars())
  {
    data->GetCellData()->SetActiveScalars(name);
  }
}

/// Normals and tangents of the surface in space, which would shade the flat pieces by its shape.
void dropDirections(vtkDataSetAttributes* arrays)
{
  for (const int attribute : { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TANGENTS })
  {
    int place[vtkDataSetAttributes::NUM_ATTRIBUTES];
    arrays->GetAttributeIndices(place);
    if (place[attribute] >= 0)
    {
      arrays->RemoveArray(place[attribute]);
    }
  }
}
}

void writeWires(const std::vector<Wire>& wires, const std::vector<FeatureCurve>& curves,
  vtkPolyData* surface, vtkPolyData* output)
{
  vtkNew<vtkCellArray> lines;
  for (const Wire& wire : wires)
  {
    lines->InsertNextCell(static_cast<int>(wire.vertices.size()));
    for (const Index v : wire.vertices)
    {
      lines->InsertCellPoint(v);
    }
  }
  output->SetPoints(surface->GetPoints());
  output->SetLines(lines);
  output->GetPointData()->ShallowCopy(surface->GetPointData());

  vtkCellData* cells = output->GetCellData();
  const std::size_t count = wires.size();
  addRows<vtkIntArray>(cells, "CurveType", count,
    [&](std::size_t w) { return wires[w].curve == none ? -1 : static_cast<int>(wires[w].type); });
  addRows<vtkIdTypeArray>(cells, "CurveId", count, [&](std::size_t w) { return wires[w].curve; });
  addRows<vtkStringArray>(cells, "CurveName", count, [&](std::size_t w) {
    return wires[w].curve != none ? curves[wires[w].curve].name
      : wires[w].connector        ? std::string("connector")
                                  : std::string("boundary");
  });
  addRows<vtkIdTypeArray>(cells, "PieceId", count, [&](std::size_t w) { return wires[w].piece; });
  addRows<vtkUnsignedCharArray>(cells, "Boundary", count,
    [&](std::size_t w) { return static_cast<unsigned char>(wires[w].boundary); });
  addRows<vtkDoubleArray>(
    cells, "RestLength", count, [&](std::size_t w) { return wires[w].restLength; });
}

void writeSheetMaterial(const FlatteningOptions& options, vtkPolyData* flat)
{
  const bool sheet = options.cloth && options.cloth->material.sheet;
  addRows<vtkIntArray>(
    flat->GetFieldData(), "SheetMaterial", sheet ? 1 : 0, [](std::size_t) { return 1; });
}

std::string describeLeftOut(const CurvedSurface& source, const FlatteningResult& result)
{
  Indices closed;
  Indices handled;
  for (const PieceDefect& defect : result.leftOut)
  {
    const auto cell = static_cast<Index>(source.cellOf(defect.triangle));
    (defect.closed ? closed : handled).push_back(cell);
  }
  std::string text = std::to_string(result.leftOut.size()) + " of " +
    std::to_string(result.leftOut.size() + result.pieces.size()) +
    " pieces cannot be laid flat and were left out:";
  if (!closed.empty())
  {
    text += " without boundary those of cells " + listIds(closed);
  }
  if (!handled.empty())
  {
    text +=
      std::string(closed.empty() ? "" : ",") + " with handles those of cells " + listIds(handled);
  }
  return text;
}

void writeFlattening(const CurvedSurface& source, const FlatteningResult& result, vtkPolyData* flat,
  vtkPolyData* wires, vtkPolyData* cut)
{
  writeCutSurface(source, *result.cut, makePoints(result.positions), flat);
  writeTriangleQuality(result.triangles, flat);
  writePatches(result, flat->GetCellData());
  writeThreads(result, flat->GetCellData());
  addRows<vtkDoubleArray>(flat->GetPointData(), "Developability", result.developability.size(),
    [&](std::size_t v) { return result.developability[v]; });

  setActiveScalars(flat, "HomogeneityOfDistortion");
  const std::vector<vtkIdType> joined = appendJoinedPoints(source, flat);

  // In space the same data over the original points.
  cut->SetPoints(makePoints(result.cut->mesh.points()));
  Points2 positions = result.positions;
  for (const vtkIdType vertex : joined)
  {
    cut->GetPoints()->InsertNextPoint(cut->GetPoint(vertex));
    positions.push_back(result.positions[vertex]);
  }
  cut->SetPolys(flat->GetPolys());
  cut->GetPointData()->ShallowCopy(flat->GetPointData());
  cut->GetCellData()->ShallowCopy(flat->GetCellData());
  writeTextureCoordinates(positions, cut->GetPointData());
  dropDirections(flat->GetPointData());
  dropDirections(flat->GetCellData());

  writeWires(result.wires, source.imprinted.curves, flat, wires);
  writeFlatLengths(result.wires, wires->GetCellData());
  setActiveScalars(wires, "WireKind");

  vtkFieldData* field = flat->GetFieldData();
  writeGrain(result, field);
  writeSeamPairs(*result.cut, flat);
  writeClosedSeams(result, field);
  writeOverlapEdges(result, field);
}
}
}
