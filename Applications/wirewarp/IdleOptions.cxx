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
  const bool isometric = options.scheme == "isometric";
  const bool conformal = options.scheme == "lscm";
  const std::string wires = "for a scheme that keeps lengths, not for --scheme lscm";
  return {
    { { "--solver", "--interior", "--tolerance", "--ease", "--dart-legs", "--max-iterations",
        "--closure-tolerance", "--optimality-tolerance", "--max-length-error" },
      !conformal, wires },
    { { "--no-release-trials" }, isometric || options.scheme == "global",
      "for --scheme isometric and global, not for --scheme " + options.scheme },
    { { "--energy", "--area-bias", "--angle-weight", "--isometric-tolerance",
        "--isometric-iterations" },
      isometric, "for --scheme isometric, not for --scheme " + options.scheme },
    { { "--energy", "--area-bias" }, options.material.empty() || options.material == "isotropic",
      "for a sheet without --material, not for --material " + options.material },
    { { "--area-bias" }, options.energy == "rigid",
      "for --energy rigid, not for --energy dirichlet" },
    { { "--pins" }, conformal, "for --scheme lscm, not for --scheme " + options.scheme },
    { { "--relaxation-factor", "--relaxation-movement", "--relaxation-min-iterations",
        "--relaxation-max-iterations" },
      !conformal && options.interior == "relaxation",
      conformal ? wires : "for --interior relaxation, not for --interior " + options.interior },
    { { "--rigid-tolerance", "--rigid-iterations" }, !conformal && options.interior == "arap",
      conformal ? wires : "for --interior arap, not for --interior " + options.interior },
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
    { { "--color-by" }, !ofThreads(options.picture.coloring) || !options.material.empty(),
      "for --material where it is " + options.picture.coloring, giveThat },
    { { "--body" }, options.resewing.any() || options.reshaping.any(),
      "for --resew or --flattenable", giveThat },
    { { "--grade" }, options.suggest.empty() && !options.reshaping.any() && !options.priceKeys,
      "for curves that are given, not for --suggest, --price-keys or --flattenable" },
    { { "--bound", "--max-cuts", "--max-cut-length", "--max-work", "--prefer", "--weights" },
      options.suggest != "lines", "for cuts, not for --suggest lines" },
    { { "--spacing" }, options.arrange,
      "for pieces that are laid side by side, not for --no-arrange" },
  };
}
}

//------------------------------------------------------------------------------
std::string idleOption(const Options& options, const IsGiven& isGiven)
{
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
