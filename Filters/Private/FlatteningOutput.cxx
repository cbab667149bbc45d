// SPDX-License-Identifier: BSD-3-Clause
#include "FlatteningOutput.h"

#include "StatusOutput.h"
#include "SurfaceOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace flattening
{
namespace bridge
{
namespace
{
void writePieces(const CurvedSurface& source, const FlatteningResult& result, vtkFieldData* field)
{
  const std::vector<PieceReport>& pieces = result.pieces;
  const std::size_t rows = pieces.size();
  auto addIds = [&](const char* name, auto PieceReport::*member) {
    addRows<vtkIdTypeArray>(
      field, name, rows, [&](std::size_t row) { return vtkIdType{ pieces[row].*member }; });
  };
  addIds("Triangles", &PieceReport::triangles);
  addIds("Vertices", &PieceReport::vertices);
  addIds("WirePatches", &PieceReport::wirePatches);
  addIds("WireNodes", &PieceReport::wireNodes);
  addIds("FreeWireNodes", &PieceReport::freeWireNodes);
  addIds("Constraints", &PieceReport::constraints);
  addIds("Iterations", &PieceReport::iterations);
  addRows<vtkIdTypeArray>(field, "Overlaps", rows,
    [&](std::size_t row) { return static_cast<vtkIdType>(pieces[row].overlaps.count); });
  addRows<vtkIntArray>(field, "OverlapsComplete", rows,
    [&](std::size_t row) { return pieces[row].overlaps.complete ? 1 : 0; });
  addRows<vtkDoubleArray>(
    field, "Objective", rows, [&](std::size_t row) { return pieces[row].objective; });
  addRows<vtkDoubleArray>(
    field, "ClosureResidual", rows, [&](std::size_t row) { return pieces[row].closureResidual; });
  addRows<vtkDoubleArray>(
    field, "CutLength", rows, [&](std::size_t row) { return pieces[row].cutLength; });
  addRows<vtkDoubleArray>(
    field, "DistortionEnergy", rows, [&](std::size_t row) { return pieces[row].distortionEnergy; });
  addRows<vtkDoubleArray>(
    field, "AngleEnergy", rows, [&](std::size_t row) { return pieces[row].angleEnergy; });
  addRows<vtkIdTypeArray>(field, "ReleaseFirst", rows, [&](std::size_t row) {
    const Indices& ranking = pieces[row].advice.ranking;
    return ranking.empty() ? none : ranking.front();
  });
  addRows<vtkDoubleArray>(field, "ObjectiveWithoutFirst", rows, [&](std::size_t row) {
    const ReleaseTrial first = pieces[row].advice.first();
    return first.solved ? first.objective : -1.0;
  });
  std::vector<QualitySummary> summaries;
  summaries.reserve(pieces.size());
  for (const PieceReport& piece : pieces)
  {
    summaries.push_back(piece.quality);
  }
  writeSummaries(summaries, field);
  std::vector<Status> statuses;
  for (const PieceReport& piece : pieces)
  {
    statuses.push_back(source.outcomeOfStage(piece.status, result.cut.get()));
  }
  writeStatuses(statuses, field);
}

/// Pieces that cannot be laid flat and were skipped.
void writeLeftOut(
  const CurvedSurface& source, const std::vector<PieceDefect>& leftOut, vtkFieldData* field)
{
  addRows<vtkIdTypeArray>(field, "LeftOutCells", leftOut.size(),
    [&](std::size_t row) { return source.cellOf(leftOut[row].triangle); });
  addRows<vtkIdTypeArray>(field, "LeftOutTriangles", leftOut.size(),
    [&](std::size_t row) { return vtkIdType{ leftOut[row].triangles }; });
  addRows<vtkStringArray>(field, "LeftOutReasons", leftOut.size(),
    [&](std::size_t row) { return statusName(leftOut[row].code()); });
}

/// What was done, for a user who compares it with what was asked for.
void writeWhatWasDone(const std::vector<PieceReport>& pieces, vtkFieldData* field)
{
  const std::size_t rows = pieces.size();
  addRows<vtkStringArray>(field, "SolverUsed", rows, [&](std::size_t row) {
    const std::optional<AngleMethod>& used = pieces[row].solverUsed;
    return !used ? "" : *used == AngleMethod::Newton ? "newton" : "sequential";
  });
  addRows<vtkStringArray>(field, "EnergyUsed", rows, [&](std::size_t row) {
    const std::optional<DistortionEnergyKind>& used = pieces[row].energyUsed;
    return !used                                         ? ""
      : *used == DistortionEnergyKind::AsRigidAsPossible ? "rigid"
                                                         : "symmetric-dirichlet";
  });
  addRows<vtkIntArray>(
    field, "Repaired", rows, [&](std::size_t row) { return pieces[row].repaired ? 1 : 0; });
  addRows<vtkStringArray>(field, "Fallbacks", rows, [&](std::size_t row) {
    std::string all;
    for (const std::string& fallback : pieces[row].fallbacks)
    {
      all += (all.empty() ? "" : "; ") + fallback;
    }
    return all;
  });
}

/// One kind of iterations of all pieces, and the piece of each.
template <class Record>
struct History
{
  std::vector<vtkIdType> piece;
  std::vector<Record> records;

  History(const std::vector<PieceReport>& pieces, std::vector<Record> PieceReport::*member)
  {
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const std::vector<Record>& added = pieces[p].*member;
      this->records.insert(this->records.end(), added.begin(), added.end());
      this->piece.resize(this->records.size(), static_cast<vtkIdType>(p));
    }
  }

  template <class Array, class Value>
  void write(vtkFieldData* field, const char* name, Value value) const
  {
    addRows<Array>(field, name, this->records.size(),
      [&](std::size_t row) { return value(this->records[row]); });
  }
};

void writeHistory(const std::vector<PieceReport>& pieces, vtkFieldData* field)
{
  const History<IterationRecord> angles(pieces, &PieceReport::history);
  addRows<vtkIdTypeArray>(
    field, "HistoryPiece", angles.piece.size(), [&](std::size_t row) { return angles.piece[row]; });
  using Angles = const IterationRecord&;
  angles.write<vtkStringArray>(field, "HistoryPhase", [](Angles r) { return r.phase; });
  angles.write<vtkDoubleArray>(field, "HistoryObjective", [](Angles r) { return r.objective; });
  angles.write<vtkDoubleArray>(field, "HistoryClosure", [](Angles r) { return r.closure; });
  angles.write<vtkDoubleArray>(field, "HistoryOptimality", [](Angles r) { return r.optimality; });
  angles.write<vtkDoubleArray>(field, "HistoryStep", [](Angles r) { return r.step; });

  const History<IsometricIteration> isometric(pieces, &PieceReport::isometricHistory);
  addRows<vtkIdTypeArray>(field, "IsometricHistoryPiece", isometric.piece.size(),
    [&](std::size_t row) { return isometric.piece[row]; });
  using Whole = const IsometricIteration&;
  isometric.write<vtkIntArray>(
    field, "IsometricHistoryExact", [](Whole r) { return r.exact ? 1 : 0; });
  isometric.write<vtkDoubleArray>(
    field, "IsometricHistoryEnergy", [](Whole r) { return r.energy; });
  isometric.write<vtkDoubleArray>(
    field, "IsometricHistoryLengthError", [](Whole r) { return r.constraint; });
  isometric.write<vtkDoubleArray>(
    field, "IsometricHistoryOptimality", [](Whole r) { return r.optimality; });
  isometric.write<vtkDoubleArray>(field, "IsometricHistoryMove", [](Whole r) { return r.step; });
}

/// Per piece the curves to release, the best first.
void writeReleases(const FlatteningResult& result, vtkFieldData* field)
{
  std::vector<vtkIdType> pieceOfRow;
  std::vector<ReleaseTrial> trials;
  std::vector<int> shapes;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    const ReleaseAdvice& advice = result.pieces[p].advice;
    trials.insert(trials.end(), advice.trials.begin(), advice.trials.end());
    pieceOfRow.resize(trials.size(), static_cast<vtkIdType>(p));
    for (const Index c : advice.ranking)
    {
      const Indices& free = result.pieces[p].released;
      const bool released = std::find(free.begin(), free.end(), c) != free.end();
      shapes.push_back(result.curves[c].type == CurveType::Key && !released ? 1 : 0);
    }
  }
  const std::size_t rows = trials.size();
  addRows<vtkIntArray>(field, "ReleaseShape", rows, [&](std::size_t row) { return shapes[row]; });
  addRows<vtkIdTypeArray>(
    field, "ReleasePiece", rows, [&](std::size_t row) { return pieceOfRow[row]; });
  addRows<vtkIdTypeArray>(
    field, "ReleaseCurve", rows, [&](std::size_t row) { return vtkIdType{ trials[row].curve }; });
  addRows<vtkIntArray>(
    field, "ReleaseTried", rows, [&](std::size_t row) { return trials[row].solved ? 1 : 0; });
  const auto add = [&](const char* name, double ReleaseTrial::*member) {
    addRows<vtkDoubleArray>(field, name, rows,
      [&](std::size_t row) { return trials[row].solved ? trials[row].*member : -1.0; });
  };
  add("ReleaseObjective", &ReleaseTrial::objective);
  add("ReleaseAreaError", &ReleaseTrial::areaError);
  add("ReleaseHomogeneity", &ReleaseTrial::homogeneity);
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
  field->AddArray(edges);
}

void writeSeconds(const StageSeconds& seconds, vtkFieldData* field)
{
  auto add = [field](const char* name, double value) {
    addRows<vtkDoubleArray>(field, name, 1, [value](std::size_t) { return value; });
  };
  add("SecondsWires", seconds.wires);
  add("SecondsInterior", seconds.interior);
  add("SecondsQuality", seconds.quality);
  add("SecondsTotal", seconds.total);
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

void writeCurves(const std::vector<CurveReport>& curves, vtkFieldData* field)
{
  const std::size_t rows = curves.size();
  addRows<vtkStringArray>(
    field, "CurveNames", rows, [&](std::size_t row) { return curves[row].name; });
  addRows<vtkIntArray>(
    field, "CurveTypes", rows, [&](std::size_t row) { return static_cast<int>(curves[row].type); });
  addRows<vtkDoubleArray>(
    field, "CurveRestLengths", rows, [&](std::size_t row) { return curves[row].restLength; });
  addRows<vtkDoubleArray>(
    field, "CurveFlatLengths", rows, [&](std::size_t row) { return curves[row].flatLength; });
  addRows<vtkDoubleArray>(
    field, "CurveLengthErrors", rows, [&](std::size_t row) { return curves[row].error; });
  addRows<vtkDoubleArray>(
    field, "CurveTolerances", rows, [&](std::size_t row) { return curves[row].tolerance; });
  addRows<vtkDoubleArray>(
    field, "CurveClosedLengths", rows, [&](std::size_t row) { return curves[row].closedLength; });
  addRows<vtkDoubleArray>(
    field, "CurveSensitivities", rows, [&](std::size_t row) { return curves[row].sensitivity; });
  addRows<vtkIntArray>(
    field, "CurveReleased", rows, [&](std::size_t row) { return curves[row].released ? 1 : 0; });
}

void writeFlatLengths(const std::vector<Wire>& wires, vtkCellData* cells)
{
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
  addRows<vtkDoubleArray>(flat->GetPointData(), "Developability", result.developability.size(),
    [&](std::size_t v) { return result.developability[v]; });

  // In space the same data over the original points.
  cut->SetPoints(makePoints(result.cut->mesh.points()));
  cut->SetPolys(flat->GetPolys());
  cut->GetPointData()->ShallowCopy(flat->GetPointData());
  cut->GetCellData()->ShallowCopy(flat->GetCellData());
  writeTextureCoordinates(result.positions, cut->GetPointData());
  dropDirections(flat->GetPointData());
  dropDirections(flat->GetCellData());

  writeWires(result.wires, source.imprinted.curves, flat, wires);
  writeFlatLengths(result.wires, wires->GetCellData());
  writeCurves(result.curves, wires->GetFieldData());

  vtkFieldData* field = flat->GetFieldData();
  writePieces(source, result, field);
  writeLeftOut(source, result.leftOut, field);
  writeWhatWasDone(result.pieces, field);
  writeHistory(result.pieces, field);
  writeReleases(result, field);
  writeSeamPairs(*result.cut, flat);
  writeClosedSeams(result, field);
  writeOverlapEdges(result, field);
  writeSeconds(result.seconds, field);
}
}
}
