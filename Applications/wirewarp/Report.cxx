// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "FlagWords.h"
#include "InputError.h"
#include "ReadVtk.h"
#include "Report/ReportRows.h"
#include "Table.h"
#include "TextFile.h"
#include "Units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace wirewarp
{
namespace
{
using flattening::reportKeys;
using Json = nlohmann::ordered_json;

using Kind = flattening::ReportKind;
using flattening::ReportKey;

Json jsonOf(const flattening::ReportValue& value)
{
  return std::visit(
    [](const auto& held) -> Json {
      using Held = std::decay_t<decltype(held)>;
      Json json = nullptr;
      if constexpr (std::is_same_v<Held, flattening::ReportList>)
      {
        json = Json::array();
        for (const flattening::ReportValue& item : held)
        {
          json.push_back(jsonOf(item));
        }
      }
      else if constexpr (std::is_same_v<Held, flattening::ReportObject>)
      {
        json = Json::object();
        for (const auto& [key, item] : held)
        {
          json[key] = jsonOf(item);
        }
      }
      else
      {
        json = held;
      }
      return json;
    },
    value.value);
}

Json rowReports(const Table& table, const std::vector<ReportKey>& keys)
{
  return jsonOf({ flattening::reportRows(table, keys) });
}

/// The two banks of a dart or seam that are sewn together, where both pieces stay the same.
struct SewnBanks
{
  std::string curve;
  long long edges = 0;
  std::array<double, 2> lengths{ 0.0, 0.0 };
  /// Largest difference of two edges that are sewn together, as a fraction of their length.
  double difference = 0.0;
};

/// Per point the piece of one of its triangles; pieces share no points.
std::vector<long long> pieceOfPoint(const DataSet& flat)
{
  std::vector<long long> pieces(flat.points->size(), 0);
  const flattening::Column* const pieceOfCell = findColumn(flat.cellArrays, "PieceId");
  for (std::size_t k = 0; pieceOfCell && k < flat.faces.size(); ++k)
  {
    for (const std::int64_t* id = flat.faces.begin(k); id != flat.faces.end(k); ++id)
    {
      pieces[static_cast<std::size_t>(*id)] =
        static_cast<long long>(pieceOfCell->number(flat.firstFace() + k));
    }
  }
  return pieces;
}

double distance(const DataSet& flat, std::size_t a, std::size_t b)
{
  return ((*flat.points)[a] - (*flat.points)[b]).norm();
}

/// One entry a curve and pair of pieces, in the order of the curves.
Json seamReports(const Flattening& result)
{
  Json seams = Json::array();
  const flattening::Column* const pairs =
    result.flat ? findColumn(result.flat->fieldArrays, "SeamPairs") : nullptr;
  if (!pairs || pairs->isText() || pairs->components != 5)
  {
    return seams;
  }
  const std::vector<long long> pieces = pieceOfPoint(*result.flat);
  std::map<std::array<long long, 3>, SewnBanks> found;
  for (std::size_t row = 0; row < pairs->rows(); ++row)
  {
    const auto point = [&](int k) { return static_cast<std::size_t>(pairs->number(row, k)); };
    const auto curve = static_cast<std::size_t>(std::max(0.0, pairs->number(row, 4)));
    std::array<long long, 2> sides{ pieces[point(0)], pieces[point(2)] };
    std::array<double, 2> lengths{ distance(*result.flat, point(0), point(1)),
      distance(*result.flat, point(2), point(3)) };
    if (sides[1] < sides[0])
    {
      std::swap(sides[0], sides[1]);
      std::swap(lengths[0], lengths[1]);
    }
    SewnBanks& banks = found[{ static_cast<long long>(curve), sides[0], sides[1] }];
    banks.curve = textIn(result.tables.curves, curve, "Name");
    ++banks.edges;
    banks.lengths[0] += lengths[0];
    banks.lengths[1] += lengths[1];
    const double larger = std::max(lengths[0], lengths[1]);
    banks.difference =
      std::max(banks.difference, larger > 0.0 ? std::abs(lengths[0] - lengths[1]) / larger : 0.0);
  }
  for (const auto& [place, banks] : found)
  {
    seams.push_back(
      { { "curve", banks.curve }, { "pieces", { place[1], place[2] } }, { "edges", banks.edges },
        { "lengths", banks.lengths }, { "largest_difference", banks.difference } });
  }
  return seams;
}

/// What proposals keep to: a plane by its normal and offset, or an axis by its ends; null without.
Json mirrorReport(const Flattening& result)
{
  const std::vector<double> plane = mirrorNumbers(result, "MirrorPlane");
  const std::vector<double> axis = mirrorNumbers(result, "MirrorAxis");
  if (!plane.empty())
  {
    return { { "type", "plane" }, { "normal", Json::array({ plane[0], plane[1], plane[2] }) },
      { "offset", plane[3] } };
  }
  if (!axis.empty())
  {
    return { { "type", "axis" },
      { "ends",
        Json::array({ Json::array({ axis[0], axis[1], axis[2] }),
          Json::array({ axis[3], axis[4], axis[5] }) }) } };
  }
  return nullptr;
}

/// The table that rows of a report were made of.
void addColumn(const Json& rows, const ReportKey& column, Table& table)
{
  std::vector<std::string> texts;
  std::vector<double> numbers;
  for (const Json& row : rows)
  {
    const Json& value = row.at(column.key);
    if (column.kind == Kind::Text)
    {
      texts.push_back(value.get<std::string>());
      continue;
    }
    numbers.push_back(value.is_null() ? std::numeric_limits<double>::infinity()
        : value.is_boolean()          ? (value.get<bool>() ? 1.0 : 0.0)
                                      : value.get<double>());
  }
  if (column.kind == Kind::Text)
  {
    setColumn(table, { column.column, std::move(texts) });
  }
  else
  {
    setColumn(table, { column.column, std::move(numbers) });
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

Json pieceJson(const flattening::ReportTables& tables)
{
  Json pieces = jsonOf({ flattening::pieceReports(tables) });
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    Json& message = pieces[piece]["message"];
    message = messageOf(message.get<std::string>(), remediesOf(tables, piece));
  }
  return pieces;
}

Json sizeReports(const Flattening& result)
{
  Json sizes = Json::array();
  const Table& table = result.tables.pieces;
  const double millimetres = millimetresOf(result.unit);
  for (std::size_t piece = 0; piece < rowsOf(table); ++piece)
  {
    sizes.push_back({ { "width_mm", millimetres * numberIn(table, piece, "FlatWidth") },
      { "height_mm", millimetres * numberIn(table, piece, "FlatHeight") },
      { "eased_in", numberIn(table, piece, "AreaEasedIn") },
      { "stretched", numberIn(table, piece, "AreaStretched") },
      { "worst_change", numberIn(table, piece, "WorstAreaChange") },
      { "worst_place", textIn(table, piece, "WorstPlace") } });
  }
  return sizes;
}

/// How the surface was moved, and its pieces before; null where it was not.
Json flattenableReport(const Options& options, const Flattening& result)
{
  const Table& measures = result.shiftMeasures;
  if (rowsOf(measures) == 0)
  {
    return nullptr;
  }
  const auto number = [&measures](const char* name) { return numberIn(measures, 0, name); };
  flattening::ReportTables before;
  before.pieces = result.piecesBefore;
  return { { "bound", options.reshaping.number("Bound") }, { "bound_met", number("BoundMet") != 0 },
    { "keep", options.reshaping.list("KeptCurves") },
    { "keep_boundary", options.reshaping.flag("KeepBoundary") },
    { "outside_bias", options.reshaping.number("OutsideBias") },
    { "strain_p95_before", number("StrainBefore") }, { "strain_p95_after", number("StrainAfter") },
    { "size", number("Size") }, { "shift_mean", number("ShiftMean") },
    { "shift_p95", number("ShiftP95") }, { "shift_max", number("ShiftMax") },
    { "shift_outwards_mean", number("ShiftOutwardsMean") },
    { "shift_inwards_max", number("ShiftInwardsMax") },
    { "shift_mean_relative", number("RelativeShiftMean") },
    { "shift_max_relative", number("RelativeShiftMax") }, { "trials", result.shiftTrials },
    { "pieces_before", pieceJson(before) } };
}

/// What the pieces take of a cloth; null where they were not laid.
Json layReport(const Flattening& result)
{
  if (!(result.layLength > 0.0))
  {
    return nullptr;
  }
  return { { "width_mm", result.layWidth }, { "length_mm", result.layLength },
    { "used", result.layEfficiency } };
}

/// One row per piece, or all that is sewn together; none where nothing was sewn.
Json resewnReports(const Options& options, const Table& table)
{
  const bool cloth = findColumn(table, "StrainWarpRms") != nullptr;
  Json rows = rowReports(table, reportKeys("ResewnShape"));
  const Json threads = rowReports(table, reportKeys("ResewnThreads"));
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    Json& shape = rows[static_cast<std::size_t>(row)];
    shape["test"] = options.resewing.text("Test");
    shape["cloth"] = cloth ? threads[row] : Json();
    if (!options.resewing.flag("SecondStart"))
    {
      shape["second_distance_mean"] = shape["several_shapes"] = nullptr;
    }
  }
  return rows;
}
}

std::string makeReport(const Options& options, const Flattening& result)
{
  if (!result.savedReport.empty())
  {
    Json saved = Json::parse(result.savedReport);
    if (options.command == "nest")
    {
      saved["lay"] = layReport(result);
    }
    else
    {
      saved["resewn"] = resewnReports(options, result.sewnShapes);
    }
    return saved.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  const bool conformal = options.values.text("Scheme") == "lscm"; // it has neither
  const std::string material = options.values.text("Material");
  const Json report = { { "surface", options.surface }, { "curve_files", options.curves },
    { "scheme", options.values.text("Scheme") },
    { "solver", conformal ? Json() : Json(options.values.text("Solver")) },
    { "interior", conformal ? Json() : Json(options.values.text("Interior")) },
    { "material", material.empty() ? Json() : Json(material) },
    { "grain", material.empty() ? Json() : Json(options.values.list("Grain")) },
    { "release_keys", options.values.flag("ReleaseKeys") },
    { "skip_closed", options.values.flag("SkipClosed") }, { "version", WIREWARP_VERSION },
    { "exit_code", result.outcome() }, { "status", result.status }, { "message", result.message },
    { "ids", result.ids }, { "id_kind", result.idKind },
    { "remedies", remedyReports(result.remedies) }, { "warnings", result.warnings },
    { "pattern_notes", result.patternNotes }, { "lay", layReport(result) },
    { "unwritten", result.unwritten }, { "unit", result.unit },
    { "unit_stated", result.unitStated },
    { "curve_distance_mm", result.curveDistance * millimetresOf(result.unit) },
    { "pieces", pieceJson(result.tables) }, { "sizes", sizeReports(result) },
    { "left_out", rowReports(result.tables.leftOutPieces, reportKeys("LeftOut")) },
    { "curves", rowReports(result.tables.curves, reportKeys("CurveReport")) },
    { "seams", seamReports(result) },
    { "suggestions", rowReports(suggestedCuts(result), reportKeys("suggestions")) },
    { "flattenable", flattenableReport(options, result) },
    { "suggestions_left_out", rowReports(result.leftOutLines, reportKeys("suggestions_left_out")) },
    { "suggestions_mirror", mirrorReport(result) },
    { "key_prices", rowReports(result.keyPrices, reportKeys("key_prices")) },
    { "resewn", resewnReports(options, result.sewnShapes) },
    { "seconds",
      { { "read", result.secondsRead }, { "core", result.seconds.total },
        { "wires", result.seconds.wires }, { "interior", result.seconds.interior },
        { "quality", result.seconds.quality }, { "write", result.secondsWrite },
        { "total", result.secondsTotal } } } };
  // File names may hold any bytes; those that are no UTF-8 become replacement characters.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

namespace
{
std::string within(const Options& options, const char* name)
{
  return (std::filesystem::u8path(options.source) / name).string();
}

/// Fills the tables of pieces and curves, and the times, without lists of iterations and releases.
/// Throws an exception of nlohmann::json where it is another one.
void takeReport(const Json& report, Flattening& result)
{
  const Json& pieces = report.at("pieces");
  Table& table = result.tables.pieces;
  for (const ReportKey& column : reportKeys("PieceReport"))
  {
    addColumn(pieces, column, table);
  }
  addColumn(pieces, { "message", "StatusDefect", Kind::Text, "" }, table);
  Json sizes = report.at("sizes");
  Json cloths = Json::array();
  const double millimetres = millimetresOf(report.at("unit").get<std::string>());
  for (std::size_t k = 0; k < sizes.size(); ++k)
  {
    for (const char* const side : { "width_mm", "height_mm" })
    {
      sizes[k][side] = sizes[k][side].get<double>() / millimetres;
    }
    cloths.push_back(pieces.at(k).at("cloth"));
  }
  addColumn(sizes, { "width_mm", "FlatWidth", Kind::Number, "" }, table);
  addColumn(sizes, { "height_mm", "FlatHeight", Kind::Number, "" }, table);
  if (!cloths.empty() && cloths.front().is_object())
  {
    for (const ReportKey& column : reportKeys("ClothReport"))
    {
      addColumn(cloths, column, table);
    }
  }
  for (const ReportKey& column : reportKeys("CurveReport"))
  {
    addColumn(report.at("curves"), column, result.tables.curves);
  }
  const Json& seconds = report.at("seconds");
  result.seconds.wires = seconds.at("wires").get<double>();
  result.seconds.interior = seconds.at("interior").get<double>();
  result.seconds.quality = seconds.at("quality").get<double>();
  result.seconds.total = seconds.at("core").get<double>();
}

[[noreturn]] void refuseReport(const std::string& path)
{
  throw InputError(path, "is not a report of wirewarp; run wirewarp flatten again");
}

Json readReport(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(std::filesystem::u8path(path), ignored))
  {
    throw InputError(std::filesystem::u8path(path).parent_path().string(),
      "holds no result: report.json is missing; name a folder that wirewarp flatten has written");
  }
  Json report = Json::parse(readWholeFile(path), nullptr, false);
  if (!report.is_object())
  {
    refuseReport(path);
  }
  return report;
}
}

void adoptReport(Options& options)
{
  const std::string path = within(options, "report.json");
  const Json report = readReport(path);
  try
  {
    if (report.at("exit_code").get<int>() == InputRefused && report.at("pieces").empty())
    {
      throw InputError(
        options.source, "holds no result: " + report.at("message").get<std::string>());
    }
    options.surface = report.at("surface").get<std::string>();
    options.values.setWord("Scheme", report.at("scheme").get<std::string>());
    if (options.values.text("Material").empty() && report.at("material").is_string())
    {
      options.values.set("Material", report.at("material").get<std::string>());
    }
    if (report.at("grain").is_array())
    {
      options.values.set("Grain", report.at("grain").get<std::vector<std::string>>());
    }
  }
  catch (const Json::exception&)
  {
    refuseReport(path);
  }
}

Flattening readResult(const Options& options)
{
  const std::string path = within(options, "report.json");
  const Json report = readReport(path);
  Flattening result;
  try
  {
    const int exitCode = report.at("exit_code").get<int>();
    result.exitCode = exitCode == Flawed ? Flawed : Done;
    result.status = report.at("status").get<std::string>();
    result.message = report.at("message").get<std::string>();
    result.unit = report.at("unit").get<std::string>();
    result.unitStated = report.at("unit_stated").get<bool>();
    result.savedReport = report.dump();
    takeReport(report, result);
  }
  catch (const Json::exception&)
  {
    refuseReport(path);
  }
  if (result.unitStated && !options.unit.empty() && options.unit != result.unit)
  {
    throw InputError(options.source,
      "is in " + result.unit + ", as was stated; leave --unit out, or flatten anew");
  }
  if (!options.unit.empty())
  {
    result.unit = options.unit;
    result.unitStated = true;
  }
  if (!result.unitStated)
  {
    result.unitNote = unitTaken(options.surface, { result.unit });
  }
  const auto read = [](const std::string& file) {
    return std::make_shared<const DataSet>(readVtk(file));
  };
  result.flat = read(within(options, "flat.vtp"));
  result.wires = read(within(options, "wires.vtp"));
  result.cut = read(within(options, "cut.vtp"));
  const std::string sewn = within(options, "sewn.vtp");
  std::error_code ignored;
  if (options.command != "sew" && std::filesystem::exists(std::filesystem::u8path(sewn), ignored))
  {
    result.sewn = read(sewn);
  }
  return result;
}
}
