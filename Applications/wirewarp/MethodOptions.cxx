// SPDX-License-Identifier: BSD-3-Clause
#include "MethodOptions.h"

#include "Options.h"
#include "Reshaping.h"
#include "TableOptions.h"
#include "TextFile.h"

#include <vtkFeatureCurveSuggestion.h>
#include <vtkKeyCurvePrices.h>
#include <vtkLeastSquaresConformalFilter.h>
#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace wirewarp
{
//------------------------------------------------------------------------------
void addMethods(CLI::App& app, Options& options)
{
  options.values.setWord("DartLegs", "mirrored"); // as darts are sewn, leg on leg
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
vtkSmartPointer<vtkFlatPieceAlgorithm> makeFilter(const Options& options)
{
  vtkSmartPointer<vtkFlatPieceAlgorithm> filter;
  if (options.command == "reshape")
  {
    filter = makeReshapingFilter(options.reshaping);
  }
  else if (options.command == "prices")
  {
    filter = vtkSmartPointer<vtkKeyCurvePrices>::New();
  }
  else if (options.command == "cut")
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
  else if (options.values.text("Scheme") == "lscm")
  {
    filter = vtkSmartPointer<vtkLeastSquaresConformalFilter>::New();
  }
  else
  {
    filter = vtkSmartPointer<vtkWireWarpingFilter>::New();
  }
  return filter;
}

//------------------------------------------------------------------------------
void setOptions(const Options& options, vtkFlatPieceAlgorithm* filter)
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
    vtkWireWarpingFilter::SafeDownCast(filter)->AddCurveEase(ease.curve, ease.piece, ease.fraction);
  }
}

namespace
{
/// Of the default of MaximumWork, which takes some 15 s of one processor.
const std::map<std::string, double> shareOfEffort{ { "quick", 0.25 }, { "normal", 1.0 },
  { "long", 4.0 } };
}

//------------------------------------------------------------------------------
void addCutting(CLI::App& app, Options& options)
{
  const double work = options.values.number("MaximumWork");
  addOptions(app, { "Suggestions" }, options.values);
  app
    .add_option_function<std::string>(
      "--effort",
      [&options, work](const std::string& effort) {
        options.values.set("MaximumWork", work * shareOfEffort.at(effort));
      },
      "Length of the search: quick (up to some 5 s), normal (15 s), long (1 min). The best cuts "
      "that are found by then are proposed, as after Ctrl+C")
    ->transform(CLI::IsMember({ "quick", "normal", "long" }, CLI::ignore_case).description(""))
    ->type_name("EFFORT")
    ->default_str("normal")
    ->excludes("--max-work");
}
}
