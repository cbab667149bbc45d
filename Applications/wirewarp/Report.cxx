// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "FieldRows.h"
#include "FlagWords.h"
#include "SeamReport.h"
#include "SuggestedCuts.h"

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
    pieces.push_back({ { "piece", piece }, { "triangles", field.integer("Triangles", piece) },
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
      { "fallbacks", field.text("Fallbacks", piece) },
      { "release", releaseAdvice(field, wires, piece) }, { "history", Json::array() },
      { "isometric_history", Json::array() } });
    pieces.back().update(pieceStatus(field, piece));
  }
  addHistory(field, pieces);
  return pieces;
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

/// The proposed cuts, in the order of choice.
Json suggestionReports(const Flattening& result)
{
  Json suggestions = Json::array();
  for (const SuggestedCut& cut : suggestedCuts(result))
  {
    suggestions.push_back({ { "type", curveTypeName(cut.type) }, { "name", cut.name },
      { "length", cut.length }, { "gain_predicted", cut.predictedGain }, { "gain", cut.gain },
      { "opening", cut.opening }, { "strain_p95_before", cut.strainBefore },
      { "strain_p95_after", cut.strainAfter }, { "mirror_of", cut.mirrorOf } });
  }
  return suggestions;
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
  const bool conformal = options.scheme == "lscm"; // it has neither
  const Json report = { { "surface", options.surface }, { "curve_files", options.curves },
    { "scheme", options.scheme }, { "solver", conformal ? Json() : Json(options.solver) },
    { "interior", conformal ? Json() : Json(options.interior) },
    { "release_keys", options.releaseKeys }, { "skip_closed", options.skipClosed },
    { "version", WIREWARP_VERSION }, { "exit_code", result.exitCode }, { "status", result.status },
    { "message", result.message }, { "ids", result.ids }, { "id_kind", result.idKind },
    { "remedies", remedyReports(result.remedies) }, { "warnings", texts(flat, "RunWarnings") },
    { "pieces", pieceReports(flat, wires) }, { "left_out", leftOutReports(flat) },
    { "curves", curveReports(wires) }, { "seams", seamReports(result) },
    { "suggestions", suggestionReports(result) },
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
