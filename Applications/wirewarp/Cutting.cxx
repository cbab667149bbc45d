// SPDX-License-Identifier: BSD-3-Clause
#include "Cutting.h"

#include "NumberOptions.h"
#include "Options.h"
#include "PlainText.h"
#include "SuggestionOptions.h"
#include "TextFile.h"

#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

namespace wirewarp
{
namespace
{
/// Millions of steps on one triangle, each about a third of a second of one processor.
const std::map<std::string, double> workOfEffort{ { "quick", 25.0 }, { "normal", 100.0 },
  { "long", 400.0 } };
}

//------------------------------------------------------------------------------
CLI::Validator percentage(double least, double most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      const bool percent = !text.empty() && text.back() == '%';
      double value = 0.0;
      if (!parseNumber(percent ? text.substr(0, text.size() - 1) : text, value))
      {
        return inQuotes(text) + " is not a number in " + range + " or as much in %";
      }
      value = percent ? value / 100.0 : value;
      if (!(value >= least && value <= most))
      {
        return inQuotes(text) + " is not a number in " + range + " or as much in %";
      }
      std::ostringstream fraction;
      fraction << std::setprecision(17) << value;
      text = fraction.str();
      return std::string();
    },
    "");
}

//------------------------------------------------------------------------------
void addCutting(CLI::App& app, Options& options)
{
  options.maximumWork = workOfEffort.at("normal");
  addSuggestionOptions(app, options);
  for (const char* const renamed : { "--suggest", "--bound", "--max-cut-length" })
  {
    app.remove_option(app.get_option(renamed));
  }
  app
    .add_option("--kind", options.suggest,
      "What to propose: darts, seams, all (both), or lines (center and grain lines, girths and "
      "style lines, each with what it costs)")
    ->transform(
      CLI::IsMember({ "darts", "seams", "all", "lines" }, CLI::ignore_case).description(""))
    ->type_name("darts|seams|all|lines")
    ->default_str("all");
  app
    .add_option("--max-strain", options.bound,
      "The strain that is good enough, as 0.05 or 5%. On 95 % of each piece's area; 0: cut until "
      "--max-cuts or --max-length are used up. Where one that is given is missed by more than "
      "half of it, the exit code is 4")
    ->each([&options](const std::string&) { options.boundGiven = true; })
    ->transform(percentage(0.0, 0.99, "[0, 0.99]"))
    ->type_name("STRAIN")
    ->capture_default_str();
  app
    .add_option("--max-length", options.maximumCutLength,
      "Greatest length of all proposed cuts together, in the unit of SURFACE; 0: no limit")
    ->check(number(0.0, std::numeric_limits<double>::max(), "[0, inf)"))
    ->type_name("LENGTH")
    ->capture_default_str();
  app
    .add_option_function<std::string>(
      "--effort",
      [&options](const std::string& effort) { options.maximumWork = workOfEffort.at(effort); },
      "Length of the search: quick (up to some 10 s), normal (40 s), long (3 min). The best cuts "
      "that are found by then are proposed, as after Ctrl+C")
    ->transform(CLI::IsMember({ "quick", "normal", "long" }, CLI::ignore_case).description(""))
    ->type_name("EFFORT")
    ->default_str("normal")
    ->excludes("--max-work");
}
}
