// SPDX-License-Identifier: BSD-3-Clause
#include "PieceOutput.h"

#include "StatusOutput.h"
#include "SurfaceOutput.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flattening
{
namespace bridge
{
std::array<vtkIdType, 2> endsOf(
  const CurvedSurface& source, const FlatteningResult& result, const Indices& cut)
{
  if (cut.empty())
  {
    return { -1, -1 };
  }
  const auto end = [&](Index v) { return source.pointOf(result.cut->originalVertex[v]); };
  return { end(cut.front()), end(cut.back()) };
}

namespace
{
std::string wholePercent(double share)
{
  return std::to_string(std::lround(100.0 * share)) + " %";
}

/// Such as "from point 3 to point 7"; empty where an end is no point of the input.
std::string wayOf(const std::array<vtkIdType, 2>& ends)
{
  return ends[0] < 0 || ends[1] < 0
    ? ""
    : "from point " + std::to_string(ends[0]) + " to point " + std::to_string(ends[1]);
}

/// What opens a tube.
std::string openingsInWords(
  const CurvedSurface& source, const FlatteningResult& result, const std::vector<Indices>& openings)
{
  std::string text = "this is a tube with " + std::to_string(openings.size() + 1) +
    " openings, which no plane can hold: cut it open";
  std::string join = " ";
  for (const Indices& cut : openings)
  {
    const std::string way = wayOf(endsOf(source, result, cut));
    text += way.empty() ? "" : join + way;
    join = way.empty() ? join : ", ";
  }
  return text + ", or have seams proposed";
}
}

std::string verdictOf(
  const CurvedSurface& source, const FlatteningResult& result, const PieceReport& piece)
{
  const AreaForecast& area = piece.area;
  std::string text;
  if (area.tube())
  {
    text = openingsInWords(source, result, area.openings);
  }
  if (area.deep())
  {
    text += std::string(text.empty() ? "a plane cannot hold this piece: " : "; ") +
      "with the lengths of its boundary it loses about " + wholePercent(area.loss) + " of its area";
    const std::string way = wayOf(endsOf(source, result, area.cut));
    text += area.tube() ? "" : "; cut it";
    if (!area.tube() && !way.empty())
    {
      text += ", for example along edges " + way + ", which leaves a loss of about " +
        wholePercent(area.lossAfterCut);
    }
  }
  return text.empty() || piece.otherEnergy.empty() ? text : text + "; " + piece.otherEnergy;
}

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
    const std::optional<ClothReport>& cloth = pieces[row].cloth;
    return !used                                         ? ""
      : cloth && cloth->solved                           ? "cloth"
      : *used == DistortionEnergyKind::AsRigidAsPossible ? "rigid"
                                                         : "symmetric-dirichlet";
  });
  addRows<vtkIntArray>(
    field, "Repaired", rows, [&](std::size_t row) { return pieces[row].repaired ? 1 : 0; });
  addRows<vtkStringArray>(field, "Fallbacks", rows, [&](std::size_t row) {
    std::string all;
    for (const std::string& fallback : pieces[row].fallbacks)
    {
      const bool warned = fallback == pieces[row].otherEnergy;
      all += warned ? "" : (all.empty() ? "" : "; ") + fallback;
    }
    return all;
  });
}

void writeVerdicts(const CurvedSurface& source, const FlatteningResult& result, vtkFieldData* field)
{
  const std::vector<PieceReport>& pieces = result.pieces;
  const std::size_t rows = pieces.size();
  addRows<vtkDoubleArray>(
    field, "ForecastAreaLoss", rows, [&](std::size_t row) { return pieces[row].area.loss; });
  addRows<vtkDoubleArray>(field, "ForecastAreaLossAfterCut", rows,
    [&](std::size_t row) { return pieces[row].area.lossAfterCut; });
  addRows<vtkIdTypeArray>(field, "ForecastCutFrom", rows,
    [&](std::size_t row) { return endsOf(source, result, pieces[row].area.cut)[0]; });
  addRows<vtkIdTypeArray>(field, "ForecastCutTo", rows,
    [&](std::size_t row) { return endsOf(source, result, pieces[row].area.cut)[1]; });
  addRows<vtkStringArray>(field, "Verdict", rows,
    [&](std::size_t row) { return verdictOf(source, result, pieces[row]); });
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
}

std::vector<std::string> describeVerdicts(
  const CurvedSurface& source, const FlatteningResult& result)
{
  std::vector<std::string> warnings;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    const PieceReport& piece = result.pieces[p];
    const std::string verdict = verdictOf(source, result, piece);
    const std::string& said = verdict.empty() ? piece.otherEnergy : verdict;
    if (!said.empty())
    {
      warnings.push_back("piece " + std::to_string(p + 1) + ": " + said);
    }
  }
  return warnings;
}

void writePieceReports(
  const CurvedSurface& source, const FlatteningResult& result, vtkFieldData* field)
{
  writePieces(source, result, field);
  writeLeftOut(source, result.leftOut, field);
  writeWhatWasDone(result.pieces, field);
  writeVerdicts(source, result, field);
  writeHistory(result.pieces, field);
  writeReleases(result, field);
}
}
}
