// SPDX-License-Identifier: BSD-3-Clause
#include "Cutting.h"

#include "Options.h"
#include "TableOptions.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace wirewarp
{
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
