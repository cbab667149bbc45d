// SPDX-License-Identifier: BSD-3-Clause
#include "IdleOptions.h"

#include <vector>

namespace wirewarp
{
namespace
{
/// Options that mean something where a condition holds.
struct Scope
{
  std::vector<const char*> options;
  bool holds;
  std::string condition;
};

std::vector<Scope> scopesOf(const Options& options)
{
  const bool isometric = options.scheme == "isometric";
  const bool conformal = options.scheme == "lscm";
  const std::string wires = "for a scheme that keeps lengths, not for --scheme lscm";
  return {
    { { "--solver", "--interior", "--tolerance", "--max-iterations", "--closure-tolerance",
        "--optimality-tolerance", "--max-length-error" },
      !conformal, wires },
    { { "--no-release-trials" }, isometric || options.scheme == "global",
      "for --scheme isometric and global, not for --scheme " + options.scheme },
    { { "--energy", "--area-bias", "--angle-weight", "--isometric-tolerance",
        "--isometric-iterations" },
      isometric, "for --scheme isometric, not for --scheme " + options.scheme },
    { { "--area-bias" }, options.energy == "rigid",
      "for --energy rigid, not for --energy dirichlet" },
    { { "--pins" }, conformal, "for --scheme lscm, not for --scheme " + options.scheme },
    { { "--relaxation-factor", "--relaxation-movement", "--relaxation-min-iterations",
        "--relaxation-max-iterations" },
      !conformal && options.interior == "relaxation",
      conformal ? wires : "for --interior relaxation, not for --interior " + options.interior },
    { { "--rigid-tolerance", "--rigid-iterations" }, !conformal && options.interior == "arap",
      conformal ? wires : "for --interior arap, not for --interior " + options.interior },
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
        return std::string(option) + " is " + scope.condition + "; leave one of them out";
      }
    }
  }
  return "";
}
}
