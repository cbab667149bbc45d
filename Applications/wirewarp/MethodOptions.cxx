// SPDX-License-Identifier: BSD-3-Clause
#include "MethodOptions.h"

#include "Options.h"
#include "TableOptions.h"
#include "TextFile.h"

#include <vtkFeatureCurveSuggestion.h>
#include <vtkKeyCurvePrices.h>
#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace wirewarp
{
//------------------------------------------------------------------------------
void addMethods(CLI::App& app, Options& options)
{
  for (const char* const group :
    { "Method", "Material", "Ease", "Pieces", "Solver", "Surface and Curves" })
  {
    for (CLI::Option* const option : addOptions(app, { group }, options.values))
    {
      option->group(group);
    }
  }
  app
    .add_flag_callback(
      "--paper-method",
      [&options]() {
        const auto choose = [&options](const char* property, double word) {
          options.values.set(property, word);
          options.values.markGiven(property);
        };
        choose("Scheme", vtkWireWarpingFilter::GLOBAL);
        choose("Interior", vtkWireWarpingFilter::LAPLACIAN);
      },
      "The paper's method: --scheme global --interior laplacian. newton finds the minimum that the "
      "paper defines; --solver sequential approaches it by the paper's steps, where they converge")
    ->excludes("--scheme", "--interior")
    ->group("Method");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkWireWarpingFilter> makeFilter(const Options& options)
{
  vtkSmartPointer<vtkWireWarpingFilter> filter;
  if (options.reshaping.any())
  {
    filter = makeReshapingFilter(options.reshaping);
  }
  else if (options.priceKeys)
  {
    filter = vtkSmartPointer<vtkKeyCurvePrices>::New();
  }
  else if (!options.suggest.empty())
  {
    const auto suggestion = vtkSmartPointer<vtkFeatureCurveSuggestion>::New();
    const flattening::Option& prefer =
      *findOption(flattening::OptionOwner::Suggestion, "Preferences");
    for (const std::string& entry : options.values.list(prefer.property))
    {
      const auto [curve, weight] = namedNumber(entry, prefer);
      suggestion->AddPreference(curve, weight);
    }
    filter = suggestion;
  }
  else
  {
    filter = vtkSmartPointer<vtkWireWarpingFilter>::New();
  }
  return filter;
}

//------------------------------------------------------------------------------
void setOptions(const Options& options, vtkWireWarpingFilter* filter)
{
  filter->SetOptions(options.values);
  const flattening::Option& tolerances =
    *findOption(flattening::OptionOwner::Warping, "CurveTolerances");
  for (const std::string& entry : options.values.list(tolerances.property))
  {
    const auto [curve, tolerance] = namedNumber(entry, tolerances);
    filter->AddCurveTolerance(curve, tolerance);
  }
  for (const std::string& entry : options.values.list("CurveEases"))
  {
    const EaseRequest ease = easeRequest(entry);
    filter->AddCurveEase(ease.curve, ease.piece, ease.fraction);
  }
}

namespace
{
/// Millions of steps on one triangle, each about a third of a second of one processor.
const std::map<std::string, double> workOfEffort{ { "quick", 25.0 }, { "normal", 100.0 },
  { "long", 400.0 } };
}

//------------------------------------------------------------------------------
void addCutting(CLI::App& app, Options& options)
{
  options.values.set("MaximumWork", workOfEffort.at("normal"));
  addOptions(app, { "Suggestions" }, options.values);
  app
    .add_option_function<std::string>(
      "--effort",
      [&options](
        const std::string& effort) { options.values.set("MaximumWork", workOfEffort.at(effort)); },
      "Length of the search: quick (up to some 10 s), normal (40 s), long (3 min). The best cuts "
      "that are found by then are proposed, as after Ctrl+C")
    ->transform(CLI::IsMember({ "quick", "normal", "long" }, CLI::ignore_case).description(""))
    ->type_name("EFFORT")
    ->default_str("normal")
    ->excludes("--max-work");
}
}
