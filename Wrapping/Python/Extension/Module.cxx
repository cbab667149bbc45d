// SPDX-License-Identifier: BSD-3-Clause
// The module surfaceflattening._core: surfaces and curves as arrays in, results as arrays out. It
// needs no VTK.
#include "Conversions.h"

#include "Design/KeyPrices.h"
#include "Design/LineSuggestion.h"
#include "Flattening/SurfaceFlattening.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Report/FlatteningArrays.h"
#include "Report/FlatteningTables.h"
#include "Report/ReshapingReport.h"
#include "Report/SuggestionReport.h"
#include "Reshaping/FlattenableSurface.h"
#include "Suggestion/CurveSuggestion.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace flattening::python
{
namespace
{
/// A surface with its curves, and what is to be said of it. The last status counts.
struct Run
{
  CurvedSurface source;
  Status status;
  std::vector<std::string> warnings;

  /// \return whether there is a result up to here
  bool conclude(const Status& outcome)
  {
    this->status = outcome;
    return !outcome.refused();
  }

  void warn(const std::vector<std::string>& sentences)
  {
    for (const std::string& sentence : sentences)
    {
      const bool known =
        std::find(this->warnings.begin(), this->warnings.end(), sentence) != this->warnings.end();
      if (!known)
      {
        this->warnings.push_back(sentence);
      }
    }
  }
};

/// Heals the surface and imprints the curves. \return whether that could be done
bool load(SurfaceTriangles surface, CurveInput curves, const Settings& settings,
  const Execution& execution, Run& run)
{
  CurvedSurface& source = run.source;
  const OptionStructures& options = settings.structures;
  source.surface = surface.outcome.ok() ? loadSurface(std::move(surface), options.coincidentPoints,
                                            options.healSurface ? Defects::Heal : Defects::Refuse)
                                        : LoadedSurface{ {}, {}, surface.outcome, {} };
  source.warnings = source.surface.mendings;
  source.outcome = source.surface.outcome;
  if (source.outcome.ok())
  {
    imprintInput(std::move(curves), options.imprint, execution, source);
  }
  const std::map<std::string, double> tolerances(
    settings.tolerances.begin(), settings.tolerances.end());
  const bool loaded =
    run.conclude(source.outcome) && run.conclude(applyTolerances(tolerances, source));
  run.warn(loaded ? source.warnings : std::vector<std::string>());
  return loaded;
}

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
Flattened reportOf(const CurvedSurface& source, const FlatteningResult& result,
  const FlatteningOptions& options, const Run& run)
{
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

std::optional<Flattened> flattenSource(
  const Settings& settings, const Execution& execution, Run& run)
{
  const CurvedSurface& source = run.source;
  FlatteningOptions options = settings.structures.flattening;
  if (!run.conclude(source.pinVertices(settings.pins, options.conformal.pins)))
  {
    return {};
  }
  run.warn(describeShortEnds(source));
  const FlatteningResult result =
    flattenSurface(source.imprinted.mesh, source.imprinted.curves, options, execution);
  if (!run.conclude(
        source.outcomeOfStage(result.status, result.status.refused() ? nullptr : result.cut.get())))
  {
    return {};
  }
  if (!result.leftOut.empty())
  {
    run.warn({ describeLeftOut(source, result) });
  }
  run.warn(describeVerdicts(source, result));
  return reportOf(source, result, options, run);
}

py::array rowsOf(const Triangles& triangles)
{
  std::vector<std::array<std::int64_t, 3>> rows;
  rows.reserve(triangles.size());
  for (const Triangle& t : triangles)
  {
    rows.push_back({ t[0], t[1], t[2] });
  }
  return arrayOf<std::int64_t>(std::move(rows));
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

py::dict outcomeOf(const Run& run)
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
Run runWatched(Input input, const Settings& settings, py::object progress, const Work& work,
  bool endsEarly = false)
{
  WatchedRun watched(std::move(progress));
  Run run;
  {
    const py::gil_scoped_release free;
    const Execution execution = watched.execution();
    if (load(std::move(input.surface), std::move(input.curves), settings, execution, run))
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
  std::optional<Flattened> flattened;
  const Run run = runWatched({ points, corners, offsets, curves }, settings, std::move(progress),
    [&](const Execution& execution, Run& running, WatchedRun&) {
      flattened = flattenSource(settings, execution, running);
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
  const Run run = runWatched({ points, corners, offsets, curves }, settings, std::move(progress),
    [&](const Execution& execution, Run& running, WatchedRun&) {
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

/// The curves of the input with those proposed behind them, of a source of their own.
CurveInput withProposed(CurveInput curves, const std::vector<SuggestedCurve>& proposed)
{
  Index point = 0;
  for (std::size_t k = 0; k < proposed.size(); ++k)
  {
    Polyline curve = proposed[k].curve;
    curve.pointIds.clear();
    while (curve.pointIds.size() < curve.points.size())
    {
      curve.pointIds.push_back(point++);
    }
    curves.polylines.push_back(std::move(curve));
    curves.cellOfPolyline.push_back(static_cast<std::int64_t>(k));
    curves.sourceOfPolyline.push_back(2);
  }
  return curves;
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
  const Run run = runWatched(
    { points, corners, offsets, curves }, settings, std::move(progress),
    [&](const Execution& execution, Run& running, WatchedRun& watched) {
      CurvedSurface& source = running.source;
      for (const std::int64_t cell :
        weightOfCell.empty() ? std::vector<std::int64_t>() : source.surface.input.cellOfTriangle)
      {
        search.weights.push_back(weightOfCell[static_cast<std::size_t>(cell)]);
      }
      found = (lines ? suggestLines : suggestCurves)(
        source.surface.prepared.mesh, source.curves.polylines, search, execution);
      if (!running.conclude(source.outcomeOfStage(found.status)))
      {
        return;
      }
      const std::vector<Polyline> given = source.curves.polylines;
      if (found.end == SearchEnd::Interrupted)
      {
        watched.goOn(); // the surface is flattened with the cuts found so far
      }
      imprintInput(withProposed(source.curves, found.curves), all.imprint, execution, source);
      if (running.conclude(source.outcome))
      {
        flattened = flattenSource(settings, execution, running);
      }
      const std::string shortfall = flattened && !lines
        ? describeShortfall(found, all.search.bound, all.search.maximumWidth, given)
        : std::string();
      if (!shortfall.empty())
      {
        running.warn({ shortfall });
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
  reshaping.body = body.get();
  FlattenableSurface moved;
  std::optional<Flattened> flattened;
  Columns arrays;
  const Run run = runWatched({ points, corners, offsets, curves }, settings, std::move(progress),
    [&](const Execution& execution, Run& running, WatchedRun&) {
      CurvedSurface& source = running.source;
      if (!running.conclude(body.outcome) ||
        !running.conclude(findCurves(settings.keptCurves, source, reshaping.kept)))
      {
        return;
      }
      running.warn(describeShortEnds(source));
      moved = flattening::makeFlattenable(
        source.imprinted.mesh, source.imprinted.curves, reshaping, execution);
      if (!running.conclude(source.outcomeOfStage(
            moved.status, moved.status.refused() ? nullptr : moved.after.cut.get())))
      {
        return;
      }
      if (!moved.after.leftOut.empty())
      {
        running.warn({ describeLeftOut(source, moved.after) });
      }
      if (!moved.boundMet)
      {
        running.warn({ describeShortfall(moved, reshaping) });
      }
      arrays = shiftArrays(source.imprinted.mesh, moved);
      source.imprinted.mesh = moved.mesh;
      flattened = reportOf(source, moved.after, reshaping.flattening, running);
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
    result["points"] = arrayOf<double>(Points3(moved.mesh.points()));
    result["triangles"] = rowsOf(moved.mesh.triangles());
    result["arrays"] = dictOf(std::move(arrays));
    result["measures"] = dictOf(shiftTable(moved));
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
}
