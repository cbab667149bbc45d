// SPDX-License-Identifier: BSD-3-Clause
// The module surfaceflattening._core: surfaces and curves as arrays in, results as arrays out. It
// needs no VTK.
#include "Conversions.h"
#include "Pieces.h"

#ifdef FLATTENING_WITH_COMMAND
#include "Command.h"
#endif

#include "Design/KeyPrices.h"
#include "Input/DataSet.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Options/OptionTable.h"
#include "Report/FlatteningData.h"
#include "Report/FlatteningRun.h"
#include "Report/FlatteningTables.h"
#include "Report/SuggestionReport.h"
#include "Report/SurfaceRun.h"
#include "Reshaping/FlattenableSurface.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <utility>

namespace flattening::python
{
namespace
{
/// \param connected data sets of its curves
SurfaceRun runOf(const py::dict& given, const py::list& connected)
{
  std::vector<DataSet> lines;
  Status defect;
  const auto read = [&defect](const py::dict& data) {
    if (data.contains("defect")) // cells that do not fit their list of points
    {
      defect = { StatusCode::InvalidPointId, data["defect"].cast<std::string>(), {},
        { Remedy::WriteAgain } };
    }
    return dataSetOf(data);
  };
  DataSet surface = read(given);
  for (const py::handle item : connected)
  {
    lines.push_back(read(item.cast<py::dict>()));
  }
  return SurfaceRun(std::move(surface), lines, std::move(defect));
}

py::dict resultOf(FlatteningReport flattened)
{
  using pybind11::literals::operator""_a;
  const ReportValue tables{ flattening::objectOf(flattened) };
  return py::dict("flat"_a = dictOf(std::move(flattened.data.flat)),
    "wires"_a = dictOf(std::move(flattened.data.wires)),
    "cut"_a = dictOf(std::move(flattened.data.cut)), "tables"_a = objectOf(tables));
}

/// Runs work(execution, watched) with the interpreter's lock free, where the surface can be used.
/// \return what Python learns of it
template <class Work>
py::dict runWatched(SurfaceRun& source, const Settings& settings, py::object progress,
  const Work& work, bool endsEarly = false)
{
  WatchedRun watched(std::move(progress));
  FlatteningRun& run = source.run;
  {
    const py::gil_scoped_release free;
    const Execution execution = watched.execution();
    if (source.load(settings.structures, settings.tolerances, settings.weights, execution))
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
  SurfaceRun source = runOf(surface, curves);
  std::optional<FlatteningReport> flattened;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      if (const auto done = source.run.flatten(flattening, settings.pins, execution))
      {
        flattened = reportFlattening(source, *done, flattening);
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
  SurfaceRun source = runOf(surface, curves);
  FlatteningRun& run = source.run;
  std::optional<KeyPrices> prices;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      prices = run.price(settings.structures.flattening, execution);
    });
  if (!prices)
  {
    return result;
  }
  const std::vector<FeatureCurve>& known = run.source.imprinted.curves;
  py::list keys;
  for (const KeyPrice& key : prices->keys)
  {
    keys.append(py::make_tuple(textOf(known[key.curve].name), key.price,
      trialOf(key.without, known), trialOf(key.alone, known)));
  }
  result["all"] = trialOf(prices->all, known);
  result["none"] = trialOf(prices->none, known);
  result["keys"] = keys;
  return result;
}

py::dict suggest(const py::dict& surface, const py::list& curves, const std::string& owner,
  const py::dict& options, py::object progress)
{
  const Settings settings(owner, options);
  const OptionStructures& all = settings.structures;
  SurfaceRun source = runOf(surface, curves);
  CurveSuggestions found;
  std::optional<FlatteningReport> flattened;
  py::dict result = runWatched(
    source, settings, std::move(progress),
    [&](const Execution& execution, WatchedRun& watched) {
      // Interrupted, the surface is flattened with the cuts found so far.
      if (const auto done = source.run.suggest(
            all, execution, [&watched] { watched.goOn(); }, found))
      {
        flattened = reportFlattening(source, *done, all.flattening);
      }
    },
    all.search.cuts != SuggestedCuts::Lines);
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
  const LoadedBody body = bodyOf(bodySurface);
  SurfaceRun source = runOf(surface, curves);
  CurvedSurface& shaped = source.run.source;
  std::optional<FlattenableSurface> moved;
  std::optional<FlatteningReport> flattened;
  ImprintData imprint;
  py::dict result =
    runWatched(source, settings, std::move(progress), [&](const Execution& execution, WatchedRun&) {
      moved = source.run.reshape(settings.keptCurves, body, settings.structures, execution);
      if (moved)
      {
        Columns arrays = shiftArrays(shaped.imprinted.mesh, *moved);
        shaped.imprinted.mesh = moved->mesh;
        flattened = reportFlattening(source, moved->after, settings.structures.flattening);
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
  OptionValues values(ownerNamed(owner).value());
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
  for (const Option* const option : optionsOf(ownerNamed(owner).value()))
  {
    names[{ className(option->owner), option->property }] =
      spelled(*option, OptionSpelling::Command);
  }
  return names;
}

/// With the arguments of this package's functions.
std::string argumentOf(const std::string& property, const std::string& value)
{
  return property == "CurveType" ? "type=\"accessory\""
    : property == "vtkFeatureCurveSuggestion"
    ? "suggest()"
    : spelledSetting(property, value, OptionSpelling::Python);
}

/// A defect and its remedies, each a name and what it is to be applied to.
py::object messageOf(
  const std::string& defect, const std::vector<std::pair<std::string, std::string>>& remedies)
{
  std::vector<NamedRemedy> named;
  for (const auto& [name, subject] : remedies)
  {
    named.push_back({ name, subject });
  }
  return textOf(describeDefect(defect, named, argumentOf));
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
  module.def("materials", [] { return dictOf(flattening::materialTable()); });
  module.def("make_message", &messageOf);
#ifdef FLATTENING_WITH_COMMAND
  module.def("run_command", &runCommand);
#endif
  definePieces(module);
  defineSurfaces(module);
}
