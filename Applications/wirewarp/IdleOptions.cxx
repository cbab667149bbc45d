// SPDX-License-Identifier: BSD-3-Clause
#include "IdleOptions.h"

#include "Coloring.h"

#include <algorithm>
#include <vector>

namespace wirewarp
{
namespace
{
constexpr const char* leaveOneOut = "; leave one of them out";
constexpr const char* giveThat = "; give that as well, or leave it out";

/// Options that mean something where a condition holds.
struct Scope
{
  std::vector<const char*> options;
  bool holds;
  std::string condition;
  const char* suggested = leaveOneOut;
};

bool ofThreads(const std::string& coloring)
{
  const auto& all = figures::threadColorings;
  return std::any_of(all.begin(), all.end(),
    [&](figures::Coloring thread) { return coloring == figures::nameOf(thread); });
}

std::vector<Scope> scopesOf(const Options& options)
{
  const std::string material = options.values.text("Material");
  return {
    { { "--color-by" }, options.picture.any(), "for --picture FILE", giveThat },
    { { "--allowance", "--curve-allowance", "--mitre-limit", "--notch-spacing", "--curve-notch",
        "--double-notches", "--notch-corners", "--notch-curve-ends", "--cut-darts-out",
        "--cut-on-fold", "--fold", "--dart-tip", "--curve-dart-tip", "--cut-pairs", "--fair",
        "--curve-fair", "--symmetrize", "--piece-quantity", "--piece-name", "--laser-colors" },
      options.pattern.any(), "for patterns: --svg, --pdf, --dxf, --plt, --garmentcode or --walk",
      giveThat },
    { { "--paper", "--page-overlap", "--max-pages" }, options.pattern.pdf, "for --pdf", giveThat },
    { { "--color-by" }, options.picture.coloring != "distance" || options.resewing.any(),
      "for --resew where it is distance", giveThat },
    { { "--color-by" }, !ofThreads(options.picture.coloring) || !material.empty(),
      "for --material where it is " + options.picture.coloring, giveThat },
    { { "--body" }, options.resewing.any() || options.reshaping.any(),
      "for --resew or --flattenable", giveThat },
    { { "--grade" }, options.suggest.empty() && !options.reshaping.any() && !options.priceKeys,
      "for curves that are given, not for --suggest, --price-keys or --flattenable" },
  };
}
}

//------------------------------------------------------------------------------
std::string idleOption(const Options& options, const IsGiven& isGiven)
{
  const std::string idle = describeIdleOption(options.values, flattening::OptionSpelling::Command);
  if (!idle.empty())
  {
    return idle;
  }
  for (const Scope& scope : scopesOf(options))
  {
    for (const char* option : scope.options)
    {
      if (!scope.holds && isGiven(option))
      {
        return std::string(option) + " is " + scope.condition + scope.suggested;
      }
    }
  }
  return "";
}
}
