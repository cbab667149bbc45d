// SPDX-License-Identifier: BSD-3-Clause
// The module surfaceflattening._core: surfaces and curves as arrays in, results as arrays out. It
// needs no VTK.
#include "Conversions.h"
#include "Pieces.h"

#ifdef FLATTENING_WITH_COMMAND
#include "Command.h"
#endif

#include "Base/LengthUnit.h"
#include "Design/KeyPrices.h"
#include "Input/DataSet.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Report/FlatteningData.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"
#include "Report/PieceSizes.h"
#include "Report/ReshapingReport.h"
#include "Report/SuggestionReport.h"
#include "Reshaping/FlattenableSurface.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <utility>

namespace flattening::python
{
namespace
{
/// A surface, and data sets of its curves, as front ends have them.
struct Source
{
  DataSet surface;
  CurveInput curves;
  FlatteningRun run; ///< its warnings begin with those of the arrays
  SurfaceArrays arrays;
  std::string unit; ///< empty: none is stated

  Source(const py::dict& given, const py::list& connected)
    : surface(dataSetOf(given))
    , arrays(this->surface, this->run.source.warnings)
  {
    this->read(this->surface, given, 0);
    int number = 0;
    for (const py::handle item : connected)
    {
      const auto data = item.cast<py::dict>();
      this->read(dataSetOf(data), data, ++number);
    }
  }

  SurfaceTriangles triangles() const
  {
    SurfaceTriangles refused;
    refused.outcome = this->defect;
    return this->defect.ok() ? readTriangles(this->surface) : refused;
  }

private:
  Status defect; ///< of cells that do not fit their list of points

  void read(const DataSet& data, const py::dict& given, int number)
  {
    if (given.contains("defect"))
    {
      this->defect = { StatusCode::InvalidPointId, given["defect"].cast<std::string>(), {},
        { Remedy::WriteAgain } };
    }
    if (this->curves.outcome.ok())
    {
      readCurves(data, number, this->curves);
    }
    const Column* const stated = findColumn(data.fieldArrays, "LengthUnit");
    const Unit known =
      stated && stated->rows() > 0 ? unitNamed(stated->text(0)) : Unit::Unspecified;
    if (this->unit.empty() && known != Unit::Unspecified)
    {
      this->unit = unitName(known);
    }
  }
};

/// What Python makes a Flattening of.
struct Flattened
{
  FlatteningData data;
  Columns pieces;
  Columns curves;
  ReportTables tables;
  StageSeconds seconds;
};

void setField(Columns& fields, const char* name, const std::string& text)
{
  setColumn(fields, { name, std::vector<std::string>{ text } });
}

/// \pre the status of the run is that of the result
Flattened reportOf(Source& source, const FlatteningResult& result, const FlatteningOptions& options)
{
  FlatteningRun& run = source.run;
  Flattened flattened;
  FlatteningData& data = flattened.data;
  data = flatteningData(source.arrays, run.source, result, options);
  const Column* const names = findColumn(data.flat.cellArrays, "PieceName");
  flattened.pieces = pieceTable(run.source, result, source.unit,
    names && names->isText() ? std::get<std::vector<std::string>>(names->values)
                             : std::vector<std::string>());
  const std::string size = sizeWarning(pieceSizes(result), source.unit);
  if (!source.unit.empty())
  {
    run.warn(size.empty() ? std::vector<std::string>() : std::vector<std::string>{ size });
    for (DataSet* const part : { &data.flat, &data.wires, &data.cut })
    {
      setField(part->fieldArrays, "LengthUnit", source.unit);
    }
  }
  setField(data.flat.fieldArrays, "RunStatus", statusName(run.status.code));
  setField(data.flat.fieldArrays, "RunStatusMessage", inWords(run.status));
  flattened.curves = curveTable(result.curves);
  flattened.tables = ReportTables(run.source, result);
  flattened.seconds = result.seconds;
  return flattened;
}

py::dict resultOf(Flattened flattened)
{
  const StageSeconds& seconds = flattened.seconds;
  const ReportTables& tables = flattened.tables;
  using pybind11::literals::operator""_a;
  return py::dict("flat"_a = dictOf(std::move(flattened.data.flat)),
    "wires"_a = dictOf(std::move(flattened.data.wires)),
    "cut"_a = dictOf(std::move(flattened.data.cut)),
    "pieces"_a = objectOf({ pieceReports({ flattened.pieces, tables.angleIterations,
      tables.isometricIterations, tables.releaseTrials, tables.pieceRemedies }) }),
    "curves"_a = objectOf({ reportRows(flattened.curves, reportKeys("CurveReport")) }),
    "left_out"_a = objectOf({ reportRows(tables.leftOutPieces, reportKeys("LeftOut")) }),
    "seconds"_a = py::make_tuple(seconds.wires, seconds.interior, seconds.quality, seconds.total));
}

/// Runs work(execution, watched) with the interpreter's lock free, where the surface can be used.
/// \return what Python learns of it
template <class Work>
py::dict runWatched(Source& source, const Settings& settings, py::object progress, const Work& work,
  bool endsEarly = false)
{
  WatchedRun watched(std::move(progress));
  FlatteningRun& run = source.run;
  {
    const py::gil_scoped_release free;
    const Execution execution = watched.execution();
    if (run.load(source.triangles(), std::move(source.curves), settings.structures,
          settings.tolerances, execution))
    {
      work(execution, watched);
    }
  }
  watched.finish(endsEarly && !run.status.refused());
  using pybind11::literals::operator""_a;
  return py::dict("status"_a = tupleOf(run.status), "refused"_a = run.status.refused(),
    "warnings"_a = textsOf(run.warnings));
}

py::dict flatten(const py::dict& surface, const py::list& curves, const std::string& owner,
  const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  const FlatteningOptions& flattening = settings.structures.flattening;
  Source source(surface, curves);
  std::optional<Flattened> flattened;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      if (const auto done = source.run.flatten(flattening, settings.pins, execution))
      {
        flattened = reportOf(source, *done, flattening);
      }
    });
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

py::dict priceKeys(const py::dict& surface, const py::list& curves, const std::string& owner,
  const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  Source source(surface, curves);
  FlatteningRun& run = source.run;
  KeyPrices prices;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      const ImprintedSurface& imprinted = run.source.imprinted;
      prices = flattening::priceKeys(
        imprinted.mesh, imprinted.curves, settings.structures.flattening, execution);
      run.conclude(run.source.outcomeOfStage(prices.status));
    });
  if (run.status.refused())
  {
    return result;
  }
  const std::vector<FeatureCurve>& known = run.source.imprinted.curves;
  py::list keys;
  for (const KeyPrice& key : prices.keys)
  {
    keys.append(py::make_tuple(textOf(known[key.curve].name), key.price,
      trialOf(key.without, known), trialOf(key.alone, known)));
  }
  result["all"] = trialOf(prices.all, known);
  result["none"] = trialOf(prices.none, known);
  result["keys"] = keys;
  return result;
}

/// \param weights a number for each cell of the surface, or None
py::dict suggest(const py::dict& surface, const py::list& curves, const py::object& weights,
  const std::string& owner, const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  const OptionStructures& all = settings.structures;
  SuggestionOptions search;
  search.search = all.search;
  search.imprint = all.imprint;
  search.flattening = all.flattening;
  const auto weightOfCell = weights.is_none() ? Numbers(0) : weights.cast<Numbers>();
  const bool lines = all.search.cuts == SuggestedCuts::Lines;
  Source source(surface, curves);
  CurveSuggestions found;
  std::optional<Flattened> flattened;
  py::dict result = runWatched(
    source, settings, std::move(progress),
    [&](const Execution& execution, WatchedRun& watched) {
      for (const std::int64_t cell : source.run.source.surface.input.cellOfTriangle)
      {
        if (weightOfCell.size() > 0)
        {
          search.weights.push_back(weightOfCell.data()[cell]);
        }
      }
      // Interrupted, the surface is flattened with the cuts found so far.
      if (const auto done = source.run.suggest(
            search, execution, [&watched] { watched.goOn(); }, found))
      {
        flattened = reportOf(source, *done, search.flattening);
      }
    },
    !lines);
  if (flattened)
  {
    py::list places;
    for (const SuggestedCurve& curve : found.curves)
    {
      places.append(arrayOf<double>(Points3(curve.curve.points)));
    }
    result["flattening"] = resultOf(std::move(*flattened));
    result["places"] = places;
    Columns proposed = suggestionArrays(found.curves, 0);
    result["cuts"] = objectOf({ reportRows(proposed, reportKeys("SuggestedCut")) });
    result["curves"] = dictOf(std::move(proposed));
    result["search"] = dictOf(searchTable(found));
    result["left_out"] = objectOf({ reportRows(leftOutTable(found), reportKeys("LeftOutLine")) });
    result["mirror"] = dictOf(mirrorArrays(found));
  }
  return result;
}

py::dict makeFlattenable(const py::dict& surface, const py::list& curves,
  const py::object& bodySurface, const std::string& owner, const py::dict& options,
  py::object progress)
{
  const Settings settings(owner, options);
  FlattenableOptions reshaping = settings.structures.reshaping;
  reshaping.flattening = settings.structures.flattening;
  const LoadedBody body = bodyOf(bodySurface);
  Source source(surface, curves);
  CurvedSurface& shaped = source.run.source;
  std::optional<FlattenableSurface> moved;
  std::optional<Flattened> flattened;
  ImprintData imprint;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      moved = source.run.reshape(settings.keptCurves, body, reshaping, execution);
      if (moved)
      {
        Columns arrays = shiftArrays(shaped.imprinted.mesh, *moved);
        shaped.imprinted.mesh = moved->mesh;
        flattened = reportOf(source, moved->after, reshaping.flattening);
        imprint = imprintData({}, shaped);
        imprint.surface.pointArrays = std::move(arrays);
      }
    });
  if (flattened)
  {
    result["flattening"] = resultOf(std::move(*flattened));
    result["surface"] = dictOf(std::move(imprint.surface));
    result["curves"] = dictOf(std::move(imprint.curves));
    result["measures"] = objectOf({ reportRows(shiftTable(*moved), reportKeys("Flattenable")) });
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

/// By class and property of each option that a filter has, what the command calls it.
std::map<std::pair<std::string, std::string>, std::string> namesOfOptions(const std::string& owner)
{
  std::map<std::pair<std::string, std::string>, std::string> names;
  for (const Option* const option : optionsOf(ownerNamed(owner)))
  {
    names[{ className(option->owner), option->property }] =
      spelled(*option, OptionSpelling::Command);
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

#ifdef FLATTENING_WITH_COMMAND
/// The command with these words; ends the process.
void runCommand(std::vector<std::string> words)
{
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  wirewarp::runCommand(static_cast<int>(words.size()), pointers.data());
}
#endif
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
#ifdef FLATTENING_WITH_COMMAND
  module.def("run_command", &runCommand);
#endif
  definePieces(module);
  defineSurfaces(module);
}
