// SPDX-License-Identifier: BSD-3-Clause
#include "Report/FlatteningTables.h"

#include "Base/LengthUnit.h"
#include "Base/Types.h"
#include "Cloth/ClothMaterial.h"
#include "Input/StatusWords.h"
#include "Report/PieceSizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace flattening
{
namespace
{
/// The ends of a cut along edges as points of the input; -1 where one has none there.
std::array<std::int64_t, 2> endsOf(
  const CurvedSurface& source, const FlatteningResult& result, const Indices& cut)
{
  if (cut.empty())
  {
    return { -1, -1 };
  }
  const auto end = [&](Index v) { return source.pointOf(result.cut->originalVertex[v]); };
  return { end(cut.front()), end(cut.back()) };
}

std::string wholePercent(double share)
{
  return std::to_string(std::lround(100.0 * share)) + " %";
}

/// Such as "from point 3 to point 7"; empty where an end is not a point of the input.
std::string wayOf(const std::array<std::int64_t, 2>& ends)
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

/// That the plane has no room for a piece, what would make some, and by which energy it is
/// flattened then; empty where it has.
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

struct PieceRow
{
  const PieceReport& report;
  const PieceSize& size;
  std::string name;
  std::string verdict;
  Status status; ///< in ids of the input
  std::array<std::int64_t, 2> cutEnds;
};

using PieceColumns = TableColumns<PieceRow>;

/// Columns of parts of a row.
template <class Part, class Value>
void addOf(const PieceColumns& columns, const char* name, Part part, Value value)
{
  columns.add(name, [part, value](const PieceRow& row) { return std::invoke(value, part(row)); });
}

std::string listed(const std::vector<std::int64_t>& ids)
{
  std::string text;
  for (const std::int64_t id : ids)
  {
    text += (text.empty() ? "" : " ") + std::to_string(id);
  }
  return text;
}

const char* energyName(const PieceReport& piece)
{
  return !piece.energyUsed                                         ? ""
    : piece.cloth && piece.cloth->solved                           ? "cloth"
    : *piece.energyUsed == DistortionEnergyKind::AsRigidAsPossible ? "rigid"
                                                                   : "symmetric-dirichlet";
}

/// What was done instead of what was requested; another energy is a warning and not listed here.
std::string fallbacksOf(const PieceReport& piece)
{
  std::string all;
  for (const std::string& fallback : piece.fallbacks)
  {
    all += fallback == piece.otherEnergy ? "" : (all.empty() ? "" : "; ") + fallback;
  }
  return all;
}

void addStatus(const PieceColumns& columns)
{
  columns.add("StatusMessage", [](const PieceRow& row) { return inWords(row.status); });
  columns.add("StatusDefect", [](const PieceRow& row) { return row.status.message; });
  columns.add("StatusIdKind", [](const PieceRow& row) { return kindName(row.status.ids.kind); });
  columns.add("StatusIds", [](const PieceRow& row) { return listed(row.status.ids.values); });
}

void addSizes(const PieceColumns& columns, double millimetres)
{
  const auto add = [&columns](const char* name, auto value) {
    addOf(
      columns, name, [](const PieceRow& row) -> const PieceSize& { return row.size; }, value);
  };
  add("FlatWidth", [](const PieceSize& size) { return size.extent.x(); });
  add("FlatHeight", [](const PieceSize& size) { return size.extent.y(); });
  add("AreaEasedIn", &PieceSize::easedIn);
  add("AreaStretched", &PieceSize::stretched);
  add("WorstAreaChange", &PieceSize::worst);
  add("WorstPlace", &PieceSize::place);
  add(
    "SizeInWords", [millimetres](const PieceSize& size) { return sizeInWords(size, millimetres); });
  add("EaseInWords", easeInWords);
}

void addReport(const PieceColumns& columns, const std::vector<CurveReport>& curves)
{
  const auto add = [&columns](const char* name, auto value) {
    addOf(
      columns, name, [](const PieceRow& row) -> const PieceReport& { return row.report; }, value);
  };
  using Piece = const PieceReport&;
  add("Overlaps", [](Piece piece) { return piece.overlaps.count; });
  add("OverlapsComplete", [](Piece piece) { return piece.overlaps.complete; });
  add("Triangles", &PieceReport::triangles);
  add("Vertices", &PieceReport::vertices);
  add("WirePatches", &PieceReport::wirePatches);
  add("WireNodes", &PieceReport::wireNodes);
  add("FreeWireNodes", &PieceReport::freeWireNodes);
  add("Constraints", &PieceReport::constraints);
  add("Iterations", &PieceReport::iterations);
  add("Objective", &PieceReport::objective);
  add("ClosureResidual", &PieceReport::closureResidual);
  add("CutLength", &PieceReport::cutLength);
  add("DistortionEnergy", &PieceReport::distortionEnergy);
  add("AngleEnergy", &PieceReport::angleEnergy);
  add("SolverUsed", [](Piece piece) {
    return !piece.solverUsed                     ? ""
      : *piece.solverUsed == AngleMethod::Newton ? "newton"
                                                 : "sequential";
  });
  add("EnergyUsed", energyName);
  add("Repaired", &PieceReport::repaired);
  add("Fallbacks", fallbacksOf);
  columns.add("Verdict", &PieceRow::verdict);
  add("ForecastAreaLoss", [](Piece piece) { return piece.area.loss; });
  add("ForecastAreaLossAfterCut", [](Piece piece) { return piece.area.lossAfterCut; });
  columns.add("ForecastCutFrom", [](const PieceRow& row) { return row.cutEnds[0]; });
  columns.add("ForecastCutTo", [](const PieceRow& row) { return row.cutEnds[1]; });
  add("ReleaseFirst", [&curves](Piece piece) {
    const Indices& ranking = piece.advice.ranking;
    return ranking.empty() ? std::string() : curves[ranking.front()].name;
  });
  add("ObjectiveWithoutFirst", [](Piece piece) {
    const ReleaseTrial first = piece.advice.first();
    return first.solved ? first.objective : -1.0;
  });
}

void addCloth(const PieceColumns& columns, const std::vector<CurveReport>& curves)
{
  static const ClothReport no;
  const auto add = [&columns](const char* name, auto value) {
    addOf(
      columns, name,
      [](const PieceRow& row) -> const ClothReport& {
        return row.report.cloth ? *row.report.cloth : no;
      },
      value);
  };
  using Cloth = const ClothReport&;
  add("StrainWarpRms", [](Cloth cloth) { return cloth.threads.warpRms; });
  add("StrainWeftRms", [](Cloth cloth) { return cloth.threads.weftRms; });
  add("ShearRms", [](Cloth cloth) { return cloth.threads.shearRms / degree; });
  add("ShareOutOfLimit", [](Cloth cloth) { return cloth.threads.shareOutOfLimit; });
  add("ShareOver5Percent", [](Cloth cloth) { return cloth.threads.shareOver5Percent; });
  add("ShareLocked", [](Cloth cloth) { return cloth.threads.shareLocked; });
  add("ShearLimit", [](Cloth cloth) { return cloth.shearLimit / degree; });
  add("GrainAngle", [](Cloth cloth) { return cloth.grain.angle / degree; });
  add("GrainCurve", [&curves](Cloth cloth) {
    return cloth.grain.curve == none ? std::string() : curves[cloth.grain.curve].name;
  });
  add("OneWay", &ClothReport::oneWay);
}

/// A curve of the ranking of a piece.
struct Release
{
  std::size_t piece;
  Index curve;
  bool shape; ///< of a key curve its shape alone
  ReleaseTrial trial;
};

std::vector<Release> releasesOf(const FlatteningResult& result)
{
  std::vector<Release> releases;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    const PieceReport& piece = result.pieces[p];
    for (std::size_t k = 0; k < piece.advice.ranking.size(); ++k)
    {
      const Index curve = piece.advice.ranking[k];
      const bool released =
        std::find(piece.released.begin(), piece.released.end(), curve) != piece.released.end();
      releases.push_back({ p, curve, result.curves[curve].type == CurveType::Key && !released,
        piece.advice.trials[k] });
    }
  }
  return releases;
}

void writeReleases(const FlatteningResult& result, Columns& table)
{
  const std::vector<Release> releases = releasesOf(result);
  const TableColumns<Release> columns(table, releases);
  columns.add("Piece", &Release::piece);
  columns.add("Name", [&result](const Release& r) { return result.curves[r.curve].name; });
  columns.add("Curve", &Release::curve);
  columns.add("Shape", &Release::shape);
  columns.add("Tried", [](const Release& r) { return r.trial.solved; });
  const auto add = [&columns](const char* name, double ReleaseTrial::*value) {
    columns.add(name, [value](const Release& r) { return r.trial.solved ? r.trial.*value : -1.0; });
  };
  add("Objective", &ReleaseTrial::objective);
  add("AreaError", &ReleaseTrial::areaError);
  add("Homogeneity", &ReleaseTrial::homogeneity);
}

/// A table of lists of the pieces, with the column Piece.
template <class Element>
class ListColumns
{
public:
  ListColumns(Columns& table, std::vector<std::pair<std::size_t, Element>> elements)
    : Elements(std::move(elements))
    , Written(table, this->Elements)
  {
    this->Written.add("Piece", [](const auto& element) { return element.first; });
  }

  template <class Value>
  void add(const char* name, Value value) const
  {
    this->Written.add(
      name, [value](const auto& element) { return std::invoke(value, element.second); });
  }

private:
  std::vector<std::pair<std::size_t, Element>> Elements;
  TableColumns<std::pair<std::size_t, Element>> Written;
};

void writeIterations(const std::vector<PieceReport>& pieces, Columns& ofAngles, Columns& ofSheet)
{
  const ListColumns<IterationRecord> angles(
    ofAngles, numberedElements(pieces, &PieceReport::history));
  angles.add("Phase", &IterationRecord::phase);
  angles.add("Objective", &IterationRecord::objective);
  angles.add("Closure", &IterationRecord::closure);
  angles.add("Optimality", &IterationRecord::optimality);
  angles.add("Step", &IterationRecord::step);

  const ListColumns<IsometricIteration> sheet(
    ofSheet, numberedElements(pieces, &PieceReport::isometricHistory));
  sheet.add("Exact", &IsometricIteration::exact);
  sheet.add("Energy", &IsometricIteration::energy);
  sheet.add("LengthError", &IsometricIteration::constraint);
  sheet.add("Optimality", &IsometricIteration::optimality);
  sheet.add("Move", &IsometricIteration::step);
}

void writeRemedies(const CurvedSurface& source, const FlatteningResult& result, Columns& table)
{
  std::vector<Status> statuses;
  for (const PieceReport& piece : result.pieces)
  {
    statuses.push_back(source.outcomeOfStage(piece.status, result.cut.get()));
  }
  const ListColumns<SuggestedRemedy> columns(table, numberedElements(statuses, &Status::remedies));
  columns.add(
    "Remedy", [](const SuggestedRemedy& suggested) { return remedyName(suggested.remedy); });
  columns.add("Subject", &SuggestedRemedy::subject);
}

Columns curveTable(const std::vector<CurveReport>& curves)
{
  Columns table;
  const TableColumns<CurveReport> columns(table, curves);
  columns.addNumbers("Curve");
  columns.add("Name", &CurveReport::name);
  columns.add("Type", [](const CurveReport& curve) { return curveTypeName(curve.type); });
  columns.add("RestLength", &CurveReport::restLength);
  columns.add("FlatLength", &CurveReport::flatLength);
  columns.add("LengthError", &CurveReport::error);
  columns.add("Tolerance", &CurveReport::tolerance);
  columns.add("ClosedLength", &CurveReport::closedLength);
  columns.add("Sensitivity", &CurveReport::sensitivity);
  columns.add("Released", &CurveReport::released);
  return table;
}

void writeLeftOut(
  const CurvedSurface& source, const std::vector<PieceDefect>& leftOut, Columns& table)
{
  const TableColumns<PieceDefect> columns(table, leftOut);
  columns.add("Reason", [](const PieceDefect& defect) { return statusName(defect.code()); });
  columns.add(
    "Cell", [&source](const PieceDefect& defect) { return source.cellOf(defect.triangle); });
  columns.add("Triangles", &PieceDefect::triangles);
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

ReportTables::ReportTables(const CurvedSurface& source, const FlatteningResult& result,
  const std::string& unit, const std::vector<std::string>& cellNames)
  : pieces(pieceTable(source, result, unit, cellNames))
  , curves(curveTable(result.curves))
{
  writeIterations(result.pieces, this->angleIterations, this->isometricIterations);
  writeReleases(result, this->releaseTrials);
  writeRemedies(source, result, this->pieceRemedies);
  writeLeftOut(source, result.leftOut, this->leftOutPieces);
}

Columns pieceTable(const CurvedSurface& source, const FlatteningResult& result,
  const std::string& unit, const std::vector<std::string>& cellNames)
{
  const std::vector<PieceSize> sizes = pieceSizes(result);
  const std::vector<std::string> names =
    pieceNames(cellNames, result.cut->pieceOfTriangle, sizes.size());
  std::vector<PieceRow> rows;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    const PieceReport& piece = result.pieces[p];
    rows.push_back({ piece, sizes[p], names[p], verdictOf(source, result, piece),
      source.outcomeOfStage(piece.status, result.cut.get()),
      endsOf(source, result, piece.area.cut) });
  }
  Columns table;
  const PieceColumns columns(table, rows);
  columns.addNumbers("Piece");
  columns.add("Status", [](const PieceRow& row) { return statusName(row.status.code); });
  columns.add("Name", &PieceRow::name);
  addSizes(columns, millimetresPer(unitNamed(unit)));
  addSummaries(
    columns, [](const PieceRow& row) -> const QualitySummary& { return row.report.quality; });
  addReport(columns, result.curves);
  if (!result.threads.empty())
  {
    addCloth(columns, result.curves);
  }
  addStatus(columns);
  return table;
}

Columns refusalTable(const std::string& status, const std::string& message)
{
  Columns table;
  const std::vector<int> rows{ -1 };
  const TableColumns<int> columns(table, rows);
  columns.add("Piece", [](int piece) { return piece; });
  columns.add("Status", [&status](int) { return status; });
  columns.add("Name", [](int) { return ""; });
  columns.add("StatusMessage", [&message](int) { return message; });
  return table;
}

Columns materialTable()
{
  Columns table;
  const TableColumns<ClothMaterial> columns(table, materialPresets());
  using Material = const ClothMaterial&;
  columns.add("Name", &ClothMaterial::name);
  columns.add("Description", &ClothMaterial::description);
  columns.add("Warp", &ClothMaterial::warp);
  columns.add("Weft", &ClothMaterial::weft);
  columns.add("Shear", &ClothMaterial::shear);
  columns.add("Compression", &ClothMaterial::compression);
  columns.add("WarpLeast", [](Material m) { return 100.0 * m.warpLimits.least; });
  columns.add("WarpGreatest", [](Material m) { return 100.0 * m.warpLimits.greatest; });
  columns.add("WeftLeast", [](Material m) { return 100.0 * m.weftLimits.least; });
  columns.add("WeftGreatest", [](Material m) { return 100.0 * m.weftLimits.greatest; });
  columns.add("ShearLimit", [](Material m) { return m.shearLimit / degree; });
  columns.add("OneWay", &ClothMaterial::oneWay);
  columns.add("Sheet", &ClothMaterial::sheet);
  columns.add("Source", &ClothMaterial::source);
  return table;
}

namespace
{
struct KeyPriceRow
{
  std::string what;
  Index curve = none;
  double price = std::numeric_limits<double>::quiet_NaN();
  KeyTrial trial;
};

std::string namesOf(const std::vector<FeatureCurve>& curves, const Indices& ids)
{
  std::string names;
  for (const Index id : ids)
  {
    names += (names.empty() ? "" : ", ") + curves[id].name;
  }
  return names;
}
}

Columns keyPriceTable(const std::vector<FeatureCurve>& curves, const KeyPrices& prices)
{
  constexpr double no = std::numeric_limits<double>::quiet_NaN();
  std::vector<KeyPriceRow> rows{ { "all keys", none, no, prices.all } };
  for (const KeyPrice& key : prices.keys)
  {
    const std::string& name = curves[key.curve].name;
    rows.push_back({ "without " + name, key.curve, key.price, key.without });
    rows.push_back({ name + " alone", key.curve, no, key.alone });
  }
  rows.push_back({ "no key", none, no, prices.none });

  Columns table;
  const TableColumns<KeyPriceRow> columns(table, rows);
  columns.add("Trial", &KeyPriceRow::what);
  columns.add("Status", [](const KeyPriceRow& row) { return statusName(row.trial.status); });
  columns.add("Curve", &KeyPriceRow::curve);
  columns.add("Price", &KeyPriceRow::price);
  columns.add("AreaError", [](const KeyPriceRow& row) { return row.trial.areaError; });
  columns.add("StrainP95", [](const KeyPriceRow& row) { return row.trial.strainP95; });
  columns.add(
    "Released", [&curves](const KeyPriceRow& row) { return namesOf(curves, row.trial.released); });
  return table;
}

Columns shiftArrays(const TriangleMesh& design, const FlattenableSurface& result)
{
  std::vector<double> shift;
  for (Index v = 0; v < design.vertexCount(); ++v)
  {
    const Point3 moved = result.mesh.point(v) - design.point(v);
    shift.insert(shift.end(), moved.data(), moved.data() + 3);
  }
  return { { "Shift", std::move(shift), 3 }, { "ShiftDistance", result.shift.ofVertex },
    { "ShiftOutwards", result.shift.outwardsOfVertex },
    { "Kept", std::vector<unsigned char>(result.kept.begin(), result.kept.end()) } };
}

Columns shiftTable(const FlattenableSurface& result)
{
  Columns table;
  const std::vector<SurfaceShift> rows{ result.shift };
  const TableColumns<SurfaceShift> columns(table, rows);
  using Shift = const SurfaceShift&;
  columns.add("BoundMet", [&result](Shift) { return result.boundMet; });
  columns.add("StrainBefore", [&result](Shift) { return result.strainBefore; });
  columns.add("StrainAfter", [&result](Shift) { return result.strainAfter; });
  columns.add("Size", &SurfaceShift::size);
  columns.add("ShiftMean", &SurfaceShift::mean);
  columns.add("ShiftP95", &SurfaceShift::p95);
  columns.add("ShiftMax", &SurfaceShift::max);
  columns.add("ShiftOutwardsMean", &SurfaceShift::outwardsMean);
  columns.add("ShiftInwardsMax", &SurfaceShift::inwardsMax);
  columns.add("RelativeShiftMean", [](Shift shift) { return shift.mean / shift.size; });
  columns.add("RelativeShiftP95", [](Shift shift) { return shift.p95 / shift.size; });
  columns.add("RelativeShiftMax", [](Shift shift) { return shift.max / shift.size; });
  return table;
}

Columns shiftTrialTable(const std::vector<FlattenableTrial>& trials)
{
  Columns table;
  const TableColumns<FlattenableTrial> columns(table, trials);
  columns.add("Anchor", &FlattenableTrial::anchor);
  columns.add("Share", &FlattenableTrial::share);
  columns.add("Strain", &FlattenableTrial::strain);
  columns.add("Shift", &FlattenableTrial::shift);
  return table;
}
}
