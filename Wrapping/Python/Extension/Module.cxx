// SPDX-License-Identifier: BSD-3-Clause
// The module surfaceflattening._core: surfaces and curves as arrays in, results as arrays out. It
// needs no VTK.
#include "Conversions.h"
#include "Pieces.h"

#include "Design/KeyPrices.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Report/FlatteningArrays.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"
#include "Report/ReshapingReport.h"
#include "Report/SuggestionReport.h"
#include "Reshaping/FlattenableSurface.h"

#include <pybind11/stl.h>

#include <array>
#include <optional>

namespace flattening::python
{
namespace
{
/// What Python makes a Flattening of.
struct Flattened
{
  FlatteningArrays arrays;
  Triangles triangles;
  std::vector<Indices> wires;
  Columns pieces;
  Columns curves;
  ReportTables tables;
  StageSeconds seconds;
};

/// \pre the status of the run is that of the result
Flattened reportOf(
  const FlatteningRun& run, const FlatteningResult& result, const FlatteningOptions& options)
{
  const CurvedSurface& source = run.source;
  Flattened flattened;
  flattened.arrays = flatteningArrays(source, result, options);
  addRows<std::string>(flattened.arrays.fieldArrays, "RunStatus", 1,
    [&](std::size_t) { return statusName(run.status.code); });
  addRows<std::string>(flattened.arrays.fieldArrays, "RunStatusMessage", 1,
    [&](std::size_t) { return inWords(run.status); });
  flattened.triangles = result.cut->mesh.triangles();
  for (const Wire& wire : result.wires)
  {
    flattened.wires.push_back(wire.vertices);
  }
  flattened.pieces = pieceTable(source, result, "", {});
  flattened.curves = curveTable(result.curves);
  flattened.tables = ReportTables(source, result);
  flattened.seconds = result.seconds;
  return flattened;
}

py::dict resultOf(Flattened flattened)
{
  py::list wires;
  for (const Indices& vertices : flattened.wires)
  {
    wires.append(
      arrayOf<std::int64_t>(std::vector<std::int64_t>(vertices.begin(), vertices.end())));
  }
  const StageSeconds& seconds = flattened.seconds;
  ReportTables& tables = flattened.tables;
  using pybind11::literals::operator""_a;
  return py::dict("positions"_a = arrayOf<double>(std::move(flattened.arrays.positions)),
    "points"_a = arrayOf<double>(std::move(flattened.arrays.points)),
    "triangles"_a = rowsOf(flattened.triangles),
    "point_arrays"_a = dictOf(std::move(flattened.arrays.pointArrays)),
    "cell_arrays"_a = dictOf(std::move(flattened.arrays.cellArrays)),
    "field_arrays"_a = dictOf(std::move(flattened.arrays.fieldArrays)),
    "wire_arrays"_a = dictOf(std::move(flattened.arrays.wireArrays)), "wires"_a = wires,
    "tables"_a = py::dict("pieces"_a = dictOf(std::move(flattened.pieces)),
      "curves"_a = dictOf(std::move(flattened.curves)),
      "angle_iterations"_a = dictOf(std::move(tables.angleIterations)),
      "isometric_iterations"_a = dictOf(std::move(tables.isometricIterations)),
      "releases"_a = dictOf(std::move(tables.releaseTrials)),
      "piece_remedies"_a = dictOf(std::move(tables.pieceRemedies)),
      "left_out"_a = dictOf(std::move(tables.leftOutPieces))),
    "seconds"_a = py::make_tuple(seconds.wires, seconds.interior, seconds.quality, seconds.total));
}

py::dict outcomeOf(const FlatteningRun& run)
{
  py::list warnings;
  for (const std::string& sentence : run.warnings)
  {
    warnings.append(textOf(sentence));
  }
  using pybind11::literals::operator""_a;
  return py::dict(
    "status"_a = tupleOf(run.status), "refused"_a = run.status.refused(), "warnings"_a = warnings);
}

/// Points, corners, offsets or None, and curves, as readSurface() and readCurves() take them.
struct Input
{
  SurfaceTriangles surface;
  CurveInput curves;

  Input(const Numbers& points, const Ids& corners, const py::object& offsets, const py::list& given)
    : surface(readSurface(points, corners, offsets))
    , curves(readCurves(given))
  {
  }
};

/// Runs work(execution, run) with the interpreter's lock free. \return whether it gave a result
template <class Work>
FlatteningRun runWatched(Input input, const Settings& settings, py::object progress,
  const Work& work, bool endsEarly = false)
{
  WatchedRun watched(std::move(progress));
  FlatteningRun run;
  {
    const py::gil_scoped_release free;
    const Execution execution = watched.execution();
    if (run.load(std::move(input.surface), std::move(input.curves), settings.structures,
          settings.tolerances, execution))
    {
      work(execution, run, watched);
    }
  }
  watched.finish(endsEarly && !run.status.refused());
  return run;
}

py::dict flatten(const Numbers& points, const Ids& corners, const py::object& offsets,
  const py::list& curves, const std::string& owner, const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  const FlatteningOptions& flattening = settings.structures.flattening;
  std::optional<Flattened> flattened;
  const FlatteningRun run = runWatched({ points, corners, offsets, curves }, settings,
    std::move(progress), [&](const Execution& execution, FlatteningRun& running, WatchedRun&) {
      if (const auto result = running.flatten(flattening, settings.pins, execution))
      {
        flattened = reportOf(running, *result, flattening);
      }
    });
  py::dict result = outcomeOf(run);
  if (flattened)
  {
    result["flattening"] = resultOf(std::move(*flattened));
  }
  return result;
}

py::tuple trialOf(const KeyTrial& trial, const std::vector<FeatureCurve>& curves)
{
  py::list released;
  for (const Index curve : trial.released)
  {
    released.append(textOf(curves[curve].name));
  }
  return py::make_tuple(statusName(trial.status), trial.areaError, trial.strainP95, released);
}

py::dict priceKeys(const Numbers& points, const Ids& corners, const py::object& offsets,
  const py::list& curves, const std::string& owner, const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  KeyPrices prices;
  const FlatteningRun run = runWatched({ points, corners, offsets, curves }, settings,
    std::move(progress), [&](const Execution& execution, FlatteningRun& running, WatchedRun&) {
      const ImprintedSurface& surface = running.source.imprinted;
      prices = flattening::priceKeys(
        surface.mesh, surface.curves, settings.structures.flattening, execution);
      running.conclude(running.source.outcomeOfStage(prices.status));
    });
  py::dict result = outcomeOf(run);
  if (run.status.refused())
  {
    return result;
  }
  const std::vector<FeatureCurve>& known = run.source.imprinted.curves;
  py::list keys;
  for (const KeyPrice& key : prices.keys)
  {
    keys.append(
      py::make_tuple(key.curve, key.price, trialOf(key.without, known), trialOf(key.alone, known)));
  }
  result["all"] = trialOf(prices.all, known);
  result["none"] = trialOf(prices.none, known);
  result["keys"] = keys;
  return result;
}

py::dict suggest(const Numbers& points, const Ids& corners, const py::object& offsets,
  const py::list& curves, const py::object& weights, const std::string& owner,
  const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  const OptionStructures& all = settings.structures;
  SuggestionOptions search;
  search.search = all.search;
  search.imprint = all.imprint;
  search.flattening = all.flattening;
  std::vector<double> weightOfCell;
  if (!weights.is_none())
  {
    const auto given = weights.cast<Numbers>();
    weightOfCell.assign(given.data(), given.data() + given.size());
  }
  const bool lines = all.search.cuts == SuggestedCuts::Lines;
  CurveSuggestions found;
  std::optional<Flattened> flattened;
  const FlatteningRun run = runWatched(
    { points, corners, offsets, curves }, settings, std::move(progress),
    [&](const Execution& execution, FlatteningRun& running, WatchedRun& watched) {
      for (const std::int64_t cell : weightOfCell.empty()
          ? std::vector<std::int64_t>()
          : running.source.surface.input.cellOfTriangle)
      {
        search.weights.push_back(weightOfCell[static_cast<std::size_t>(cell)]);
      }
      // Interrupted, the surface is flattened with the cuts found so far.
      if (const auto result = running.suggest(
            search, execution, [&watched] { watched.goOn(); }, found))
      {
        flattened = reportOf(running, *result, search.flattening);
      }
    },
    !lines);
  py::dict result = outcomeOf(run);
  if (flattened)
  {
    py::list places;
    for (const SuggestedCurve& curve : found.curves)
    {
      places.append(arrayOf<double>(Points3(curve.curve.points)));
    }
    result["flattening"] = resultOf(std::move(*flattened));
    result["places"] = places;
    result["curves"] = dictOf(suggestionArrays(found.curves, 0));
    result["search"] = dictOf(searchTable(found));
    result["left_out"] = dictOf(leftOutTable(found));
    result["mirror"] = dictOf(mirrorArrays(found));
  }
  return result;
}

py::dict makeFlattenable(const Numbers& points, const Ids& corners, const py::object& offsets,
  const py::list& curves, const py::object& bodySurface, const std::string& owner,
  const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  FlattenableOptions reshaping = settings.structures.reshaping;
  reshaping.flattening = settings.structures.flattening;
  LoadedBody body;
  if (!bodySurface.is_none())
  {
    const auto given = bodySurface.cast<py::tuple>();
    body = loadBody(readSurface(given[0].cast<Numbers>(), given[1].cast<Ids>(), given[2]));
  }
  std::optional<FlattenableSurface> moved;
  std::optional<Flattened> flattened;
  Columns arrays;
  const FlatteningRun run = runWatched({ points, corners, offsets, curves }, settings,
    std::move(progress), [&](const Execution& execution, FlatteningRun& running, WatchedRun&) {
      moved = running.reshape(settings.keptCurves, body, reshaping, execution);
      if (moved)
      {
        arrays = shiftArrays(running.source.imprinted.mesh, *moved);
        running.source.imprinted.mesh = moved->mesh;
        flattened = reportOf(running, moved->after, reshaping.flattening);
      }
    });
  py::dict result = outcomeOf(run);
  if (flattened)
  {
    py::list chains;
    for (const FeatureCurve& curve : run.source.imprinted.curves)
    {
      chains.append(py::make_tuple(arrayOf<std::int64_t>(std::vector<std::int64_t>(
                                     curve.vertices.begin(), curve.vertices.end())),
        static_cast<int>(curve.type), textOf(curve.name), curve.keyShape == KeyShape::Straight,
        curve.tolerance,
        curve.keyShape == KeyShape::Planar ? py::object(arrayOf<double>(Points2(curve.planarShape)))
                                           : py::none()));
    }
    result["flattening"] = resultOf(std::move(*flattened));
    result["points"] = arrayOf<double>(Points3(moved->mesh.points()));
    result["triangles"] = rowsOf(moved->mesh.triangles());
    result["arrays"] = dictOf(std::move(arrays));
    result["measures"] = dictOf(shiftTable(*moved));
    result["curves"] = chains;
  }
  return result;
}

/// What is wrong with an option that is given although it has no effect; empty: nothing.
std::string describeIdle(
  const std::string& owner, const py::dict& options, const std::vector<std::string>& given)
{
  OptionValues values(ownerNamed(owner));
  for (const Option* const option : values.options())
  {
    if (option->type != OptionType::List && options.contains(option->property.c_str()))
    {
      values.set(option->property, valueOf(*option, options[option->property.c_str()]));
    }
  }
  for (const std::string& property : given)
  {
    values.markGiven(property);
  }
  return describeIdleOption(values, OptionSpelling::Python);
}

/// Class and property of each option that a filter has.
std::vector<std::pair<std::string, std::string>> namesOfOptions(const std::string& owner)
{
  std::vector<std::pair<std::string, std::string>> names;
  for (const Option* const option : optionsOf(ownerNamed(owner)))
  {
    names.emplace_back(className(option->owner), option->property);
  }
  return names;
}

py::dict materials()
{
  return dictOf(materialTable());
}

std::string remedySentenceOf(const std::string& name)
{
  for (int k = 0; k < remedyCount; ++k)
  {
    const auto remedy = static_cast<Remedy>(k);
    if (name == remedyName(remedy))
    {
      return remedySentence(remedy);
    }
  }
  return {};
}
}
}

PYBIND11_MODULE(_core, module)
{
  using namespace flattening::python;
  module.def("flatten", &flatten);
  module.def("price_keys", &priceKeys);
  module.def("suggest", &suggest);
  module.def("make_flattenable", &makeFlattenable);
  module.def("describe_idle", &describeIdle);
  module.def("options_of", &namesOfOptions);
  module.def("materials", &materials);
  module.def("remedy_sentence", &remedySentenceOf);
  definePieces(module);
}
