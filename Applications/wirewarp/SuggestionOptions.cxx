// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestionOptions.h"

#include "NumberOptions.h"
#include "Options.h"
#include "TextFile.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>

namespace wirewarp
{
namespace
{
void addPreference(const std::string& entry, std::map<std::string, double>& preferences)
{
  std::string name;
  double value = 0.0;
  if (!splitNameAndNumber(entry, name, value) || !std::isfinite(value) || value < 0.0)
  {
    throw CLI::ValidationError(
      "--prefer", inQuotes(entry) + " is not NAME=WEIGHT with a weight from 0");
  }
  preferences[name] = value;
}
}

//------------------------------------------------------------------------------
void addSuggestionOptions(CLI::App& app, Options& options)
{
  const std::string group = "Suggestions";
  CLI::Option* const suggest = app.add_option("--suggest", options.suggest,
    "Propose cuts with which the surface lies flat: darts, seams, or all; or lines: centre and "
    "grain lines, girths and style lines, each with what it costs. Writes curves.vtp, all curves "
    "ready to be edited. Scheme and options are those of the flattening to come");
  suggest->transform(CLI::IsMember({ "darts", "seams", "all", "lines" }, CLI::ignore_case))
    ->group(group);
  app
    .add_option("--bound", options.bound,
      "The strain that is good enough, on 95 % of each piece's area; 0: cut until --max-cuts or "
      "--max-cut-length are used up. One that is given and missed by more than half of it ends in "
      "exit code 4")
    ->each([&options](const std::string&) { options.boundGiven = true; })
    ->check(number(0.0, 0.99, "[0, 0.99]"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app.add_option("--max-cuts", options.maximumCuts, "Most cuts to propose; a mirror image counts")
    ->check(wholeNumber(1, std::numeric_limits<int>::max(), "from 1"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--max-cut-length", options.maximumCutLength,
      "Greatest length of all proposed cuts together, in the unit of SURFACE; 0: no limit")
    ->check(number(0.0, std::numeric_limits<double>::max(), "[0, inf)"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--max-work", options.maximumWork,
      "Most work of the search, in millions of steps on one triangle, each about a third of a "
      "second of one processor; the best cuts that are found by then are proposed, as after "
      "Ctrl+C; 0: no limit")
    ->check(number(0.0, std::numeric_limits<double>::max(), "[0, inf)"))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--symmetric", options.symmetric,
      "auto: where the surface is its own mirror image so are the cuts")
    ->transform(CLI::IsMember({ "auto", "off" }, CLI::ignore_case))
    ->capture_default_str()
    ->needs(suggest)
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--prefer",
      [&options](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          addPreference(entry, options.preferences);
        }
      },
      "How gladly a cut may begin or end on a curve: its price is divided by the weight; 0 forbids "
      "it; may be given several times")
    ->type_name("NAME=WEIGHT")
    ->allow_extra_args(false)
    ->needs(suggest)
    ->group(group);
  app
    .add_option("--weights", options.weights,
      "Cell array of SURFACE that says how much distortion matters there; 0: not at all. Only "
      "ratios count")
    ->type_name("ARRAY")
    ->needs(suggest)
    ->group(group);
}

//------------------------------------------------------------------------------
void addKeyPriceOptions(CLI::App& app, Options& options)
{
  app
    .add_flag("--price-keys", options.priceKeys,
      "Tell what the planar shape of each key curve costs, by flattenings without each and with "
      "each "
      "alone")
    ->excludes("--suggest")
    ->excludes("--flattenable")
    ->group("Suggestions");
}
}
