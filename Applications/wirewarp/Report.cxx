// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "FieldRows.h"
#include "FlagWords.h"
#include "KeyPriceTable.h"
#include "SeamReport.h"
#include "SuggestionReport.h"
#include "Units.h"

#include <nlohmann/json.hpp>

#include <array>

namespace wirewarp
{
namespace
{
using Json = nlohmann::ordered_json;

Json texts(const FieldRows& field, const char* array)
{
  Json rows = Json::array();
  for (vtkIdType row = 0; row < field.count(array); ++row)
  {
    rows.push_back(field.text(array, row));
  }
  return rows;
}

/// Curves to release, the best first, and what that would bring; null where there is none.
Json releaseAdvice(const FieldRows& field, const FieldRows& wires, vtkIdType piece)
{
  const vtkIdType curve = field.integer("ReleaseFirst", piece);
  if (field.count("ReleaseFirst") == 0 || curve < 0)
  {
    return nullptr;
  }
  const double first = field.number("ObjectiveWithoutFirst", piece);
  Json ranking = Json::array();
  for (vtkIdType row = 0; row < field.count("ReleasePiece"); ++row)
  {
    if (field.integer("ReleasePiece", row) == piece)
    {
      const vtkIdType id = field.integer("ReleaseCurve", row);
      const bool tried = field.integer("ReleaseTried", row) != 0;
      const auto without = [&](const char* name) {
        return tried ? Json(field.number(name, row)) : Json(nullptr);
      };
      ranking.push_back({ { "curve", wires.text("CurveNames", id) },
        { "release", field.integer("ReleaseShape", row) != 0 ? "shape" : "curve" },
        { "objective_without", without("ReleaseObjective") },
        { "E_area_without", without("ReleaseAreaError") },
        { "E_h_without", without("ReleaseHomogeneity") } });
    }
  }
  return { { "first", wires.text("CurveNames", curve) },
    { "objective_without_first", first >= 0.0 ? Json(first) : Json(nullptr) },
    { "ranking", ranking } };
}

Json seamReports(const Flattening& result)
{
  Json seams = Json::array();
  for (const SewnBanks& banks : sewnBanks(result))
  {
    seams.push_back(
      { { "curve", banks.curve }, { "pieces", banks.pieces }, { "edges", banks.edges },
        { "lengths", banks.lengths }, { "largest_difference", banks.difference } });
  }
  return seams;
}

/// The rows of all iterations to their pieces.
void addHistory(const FieldRows& field, Json& pieces)
{
  for (vtkIdType row = 0; row < field.count("HistoryPiece"); ++row)
  {
    const auto piece = static_cast<std::size_t>(field.integer("HistoryPiece", row));
    pieces.at(piece)["history"].push_back({ { "phase", field.text("HistoryPhase", row) },
      { "objective", field.number("HistoryObjective", row) },
      { "closure", field.number("HistoryClosure", row) },
      { "optimality", field.number("HistoryOptimality", row) },
      { "step", field.number("HistoryStep", row) } });
  }
  for (vtkIdType row = 0; row < field.count("IsometricHistoryPiece"); ++row)
  {
    const auto piece = static_cast<std::size_t>(field.integer("IsometricHistoryPiece", row));
    pieces.at(piece)["isometric_history"].push_back(
      { { "exact", field.integer("IsometricHistoryExact", row) != 0 },
        { "energy", field.number("IsometricHistoryEnergy", row) },
        { "length_error", field.number("IsometricHistoryLengthError", row) },
        { "optimality", field.number("IsometricHistoryOptimality", row) },
        { "move", field.number("IsometricHistoryMove", row) } });
  }
}

Json remedyReports(const std::vector<Remedy>& remedies)
{
  Json list = Json::array();
  for (const Remedy& remedy : remedies)
  {
    list.push_back({ { "name", remedy.name }, { "subject", remedy.subject } });
  }
  return list;
}

/// What the threads of a piece have to do; null without a material.
Json clothReport(const FieldRows& field, vtkIdType piece)
{
  if (field.count("StrainWarpRms") == 0)
  {
    return nullptr;
  }
  return { { "strain_warp_rms", field.number("StrainWarpRms", piece) },
    { "strain_weft_rms", field.number("StrainWeftRms", piece) },
    { "shear_rms", field.number("ShearRms", piece) },
    { "share_out_of_limit", field.number("ShareOutOfLimit", piece) },
    { "share_over_5_percent", field.number("ShareOver5Percent", piece) },
    { "share_locked", field.number("ShareLocked", piece) },
    { "shear_limit", field.number("ShearLimit", piece) }, // infinite: null
    { "grain_angle", field.number("GrainAngle", piece) },
    { "grain_curve", field.text("GrainCurve", piece) },
    { "one_way", field.integer("OneWay", piece) != 0 } };
}

/// How a piece ended, in the keys that the report has for all of them.
Json pieceStatus(const FieldRows& field, vtkIdType piece)
{
  const std::vector<Remedy> remedies = remediesOf(field, piece);
  Json ids = Json::array();
  for (vtkIdType row = 0; row < field.count("StatusIdPiece"); ++row)
  {
    if (field.integer("StatusIdPiece", row) == piece)
    {
      ids.push_back(field.integer("StatusId", row));
    }
  }
  return { { "status", field.text("Status", piece) },
    { "message", messageOf(field.text("StatusDefect", piece), remedies) }, { "ids", ids },
    { "id_kind", field.text("StatusIdKind", piece) }, { "remedies", remedyReports(remedies) } };
}

Json pieceReports(const FieldRows& field, const FieldRows& wires)
{
  Json pieces = Json::array();
  for (vtkIdType piece = 0; piece < field.count("Triangles"); ++piece)
  {
    pieces.push_back({ { "piece", piece }, { "name", field.text("PieceNames", piece) },
      { "size", field.text("SizeInWords", piece) }, { "ease", field.text("EaseInWords", piece) },
      { "triangles", field.integer("Triangles", piece) },
      { "vertices", field.integer("Vertices", piece) },
      { "wire_patches", field.integer("WirePatches", piece) },
      { "wire_nodes", field.integer("WireNodes", piece) },
      { "free_wire_nodes", field.integer("FreeWireNodes", piece) },
      { "constraints", field.integer("Constraints", piece) },
      { "iterations", field.integer("Iterations", piece) },
      { "objective", field.number("Objective", piece) },
      { "closure_residual", field.number("ClosureResidual", piece) },
      { "E_len", field.number("EdgeLengthError", piece) },
      { "E_len_max", field.number("MaxEdgeLengthError", piece) },
      { "E_ang", field.number("AngleErrorMean", piece) },
      { "E_h", field.number("GlobalHomogeneity", piece) },
      { "E_r", field.number("GlobalAspectRatio", piece) },
      { "E_area", field.number("AreaError", piece) },
      { "strain_p95", field.number("StrainP95", piece) },
      { "energy_rigid", field.number("RigidEnergy", piece) },
      { "cut_length", field.number("CutLength", piece) },
      { "flipped", field.integer("FlippedTriangles", piece) },
      { "overlaps", field.integer("Overlaps", piece) },
      { "overlaps_complete", field.integer("OverlapsComplete", piece) != 0 },
      { "solver_used", field.text("SolverUsed", piece) },
      { "energy_used", field.text("EnergyUsed", piece) },
      { "repaired", field.integer("Repaired", piece) != 0 },
      { "fallbacks", field.text("Fallbacks", piece) }, { "verdict", field.text("Verdict", piece) },
      { "forecast_area_loss", field.number("ForecastAreaLoss", piece) },
      { "forecast_area_loss_after_cut", field.number("ForecastAreaLossAfterCut", piece) },
      { "forecast_cut_from", field.integer("ForecastCutFrom", piece) },
      { "forecast_cut_to", field.integer("ForecastCutTo", piece) },
      { "release", releaseAdvice(field, wires, piece) }, { "history", Json::array() },
      { "isometric_history", Json::array() } });
    pieces.back().update(pieceStatus(field, piece));
    pieces.back()["cloth"] = clothReport(field, piece);
  }
  addHistory(field, pieces);
  return pieces;
}

Json warningReports(const Flattening& result)
{
  Json warnings = texts(FieldRows(result.flat), "RunWarnings");
  for (const std::string& note : result.notes)
  {
    warnings.push_back(note);
  }
  return warnings;
}

Json sizeReports(const Flattening& result)
{
  Json sizes = Json::array();
  const FieldRows field(result.flat);
  const double millimetres = millimetresOf(result.unit);
  for (vtkIdType piece = 0; piece < field.count("FlatWidth"); ++piece)
  {
    sizes.push_back({ { "width_mm", millimetres * field.number("FlatWidth", piece) },
      { "height_mm", millimetres * field.number("FlatHeight", piece) },
      { "eased_in", field.number("AreaEasedIn", piece) },
      { "stretched", field.number("AreaStretched", piece) },
      { "worst_change", field.number("WorstAreaChange", piece) },
      { "worst_place", field.text("WorstPlace", piece) } });
  }
  return sizes;
}

/// Pieces that --skip-closed left out.
Json leftOutReports(const FieldRows& field)
{
  Json pieces = Json::array();
  for (vtkIdType row = 0; row < field.count("LeftOutCells"); ++row)
  {
    pieces.push_back({ { "reason", field.text("LeftOutReasons", row) },
      { "cell", field.integer("LeftOutCells", row) },
      { "triangles", field.integer("LeftOutTriangles", row) } });
  }
  return pieces;
}

/// How the surface was moved, and its pieces before; null without --flattenable.
Json flattenableReport(const Options& options, const Flattening& result)
{
  vtkTable* const measures = result.shiftMeasures;
  if (measures->GetNumberOfRows() == 0)
  {
    return nullptr;
  }
  const auto number = [measures](const char* name) { return numberIn(measures, 0, name); };
  return { { "bound", options.reshaping.values.number("Bound") },
    { "bound_met", number("BoundMet") != 0 },
    { "keep", options.reshaping.values.list("KeptCurves") },
    { "keep_boundary", options.reshaping.values.flag("KeepBoundary") },
    { "outside_bias", options.reshaping.values.number("OutsideBias") },
    { "strain_p95_before", number("StrainBefore") }, { "strain_p95_after", number("StrainAfter") },
    { "size", number("Size") }, { "shift_mean", number("ShiftMean") },
    { "shift_p95", number("ShiftP95") }, { "shift_max", number("ShiftMax") },
    { "shift_outwards_mean", number("ShiftOutwardsMean") },
    { "shift_inwards_max", number("ShiftInwardsMax") },
    { "shift_mean_relative", number("RelativeShiftMean") },
    { "shift_max_relative", number("RelativeShiftMax") }, { "trials", result.shiftTrials },
    { "pieces_before", pieceReports(FieldRows(result.flatBefore), FieldRows(result.wires)) } };
}

Json keyPriceReports(const Flattening& result)
{
  Json trials = Json::array();
  for (const KeyTrialRow& row : keyTrials(result))
  {
    trials.push_back({ { "trial", row.what }, { "price", row.price }, { "E_area", row.areaError },
      { "strain_p95", row.strainP95 }, { "status", row.status }, { "released", row.released } });
  }
  return trials;
}

/// Of sewn cloth; null without a material.
Json sewnThreads(const FieldRows& field, vtkIdType row)
{
  if (field.count("StrainWarpRms") == 0)
  {
    return nullptr;
  }
  return { { "strain_warp_rms", field.number("StrainWarpRms", row) },
    { "strain_weft_rms", field.number("StrainWeftRms", row) },
    { "shear_rms", field.number("ShearRms", row) } };
}

/// One row a piece, or all that is sewn together; none without --resew.
Json resewnReports(const Options& options, const FieldRows& field)
{
  Json rows = Json::array();
  for (vtkIdType row = 0; row < field.count("DistanceMean"); ++row)
  {
    rows.push_back({ { "test", options.resewing.test }, { "pieces", field.integer("Pieces", row) },
      { "triangles", field.integer("Triangles", row) }, { "size", field.number("Size", row) },
      { "distance_mean", field.number("DistanceMean", row) },
      { "distance_rms", field.number("DistanceRMS", row) },
      { "distance_p95", field.number("DistanceP95", row) },
      { "distance_max", field.number("DistanceMax", row) },
      { "distance_mean_relative", field.number("RelativeDistanceMean", row) },
      { "distance_max_relative", field.number("RelativeDistanceMax", row) },
      { "normal_deviation_mean", field.number("NormalDeviationMean", row) },
      { "strain_mean", field.number("StrainMean", row) },
      { "strain_p95", field.number("StrainP95", row) },
      { "strain_max", field.number("StrainMax", row) },
      { "compressed_area", field.number("CompressedArea", row) },
      { "cloth", sewnThreads(field, row) },
      { "energy_membrane", field.number("MembraneEnergy", row) },
      { "energy_bending", field.number("BendingEnergy", row) },
      { "body_depth", field.number("BodyDepth", row) },
      { "second_distance_mean",
        options.resewing.values.flag("SecondStart") ? Json(field.number("SecondDistanceMean", row))
                                                    : nullptr },
      { "several_shapes",
        options.resewing.values.flag("SecondStart") ? Json(field.integer("SeveralShapes", row) != 0)
                                                    : nullptr },
      { "iterations", field.integer("Iterations", row) },
      { "converged", field.integer("Converged", row) != 0 } });
  }
  return rows;
}

Json curveReports(const FieldRows& field)
{
  Json curves = Json::array();
  for (vtkIdType curve = 0; curve < field.count("CurveNames"); ++curve)
  {
    curves.push_back({ { "name", field.text("CurveNames", curve) },
      { "type", curveTypeName(field.integer("CurveTypes", curve)) },
      { "length_3d", field.number("CurveRestLengths", curve) },
      { "length_2d", field.number("CurveFlatLengths", curve) },
      { "error", field.number("CurveLengthErrors", curve) },
      { "tolerance", field.number("CurveTolerances", curve) },
      { "closed_length", field.number("CurveClosedLengths", curve) },
      { "sensitivity", field.number("CurveSensitivities", curve) },
      { "released", field.integer("CurveReleased", curve) != 0 } });
  }
  return curves;
}
}

//------------------------------------------------------------------------------
std::string curveTypeName(long long type)
{
  static constexpr std::array<const char*, 4> names{ "accessory", "key", "dart", "seam" };
  return type >= 0 && type < 4 ? names[static_cast<std::size_t>(type)] : "unknown";
}

//------------------------------------------------------------------------------
std::string makeReport(const Options& options, const Flattening& result)
{
  const FieldRows flat(result.flat);
  const FieldRows wires(result.wires);
  if (!result.savedReport.empty())
  {
    Json saved = Json::parse(result.savedReport);
    saved["resewn"] = resewnReports(options, FieldRows(result.sewn));
    return saved.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  const bool conformal = options.values.text("Scheme") == "lscm"; // it has neither
  const std::string material = options.values.text("Material");
  const Json report = { { "surface", options.surface }, { "curve_files", options.curves },
    { "scheme", options.values.text("Scheme") },
    { "solver", conformal ? Json() : Json(options.values.text("Solver")) },
    { "interior", conformal ? Json() : Json(options.values.text("Interior")) },
    { "material", material.empty() ? Json() : Json(material) },
    { "grain", material.empty() ? Json() : Json(options.values.text("Grain")) },
    { "release_keys", options.values.flag("ReleaseKeys") },
    { "skip_closed", options.values.flag("SkipClosed") }, { "version", WIREWARP_VERSION },
    { "exit_code", result.outcome() }, { "status", result.status }, { "message", result.message },
    { "ids", result.ids }, { "id_kind", result.idKind },
    { "remedies", remedyReports(result.remedies) }, { "warnings", warningReports(result) },
    { "pattern_notes", result.patternNotes }, { "unwritten", result.unwritten },
    { "unit", result.unit }, { "unit_stated", result.unitStated },
    { "curve_distance_mm", result.curveDistance * millimetresOf(result.unit) },
    { "pieces", pieceReports(flat, wires) }, { "sizes", sizeReports(result) },
    { "left_out", leftOutReports(flat) }, { "curves", curveReports(wires) },
    { "seams", seamReports(result) }, { "suggestions", suggestionReports(result) },
    { "flattenable", flattenableReport(options, result) },
    { "suggestions_left_out", leftOutLineReports(result) },
    { "suggestions_mirror", mirrorReport(result) }, { "key_prices", keyPriceReports(result) },
    { "resewn", resewnReports(options, FieldRows(result.sewn)) },
    { "seconds",
      { { "read", result.secondsRead }, { "core", flat.number("SecondsTotal", 0) },
        { "wires", flat.number("SecondsWires", 0) },
        { "interior", flat.number("SecondsInterior", 0) },
        { "quality", flat.number("SecondsQuality", 0) }, { "write", result.secondsWrite },
        { "total", result.secondsTotal } } } };
  // File names may hold any bytes; those that are no UTF-8 become replacement characters.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}
}
