// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/FlatteningOptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace flattening
{
FlatteningOptions withEnergy(FlatteningOptions options)
{
  DistortionEnergyKind& kind = options.isometric.energy.kind;
  if (kind == DistortionEnergyKind::Automatic)
  {
    kind = options.boundary == BoundaryMode::Free ? DistortionEnergyKind::SymmetricDirichlet
                                                  : DistortionEnergyKind::AsRigidAsPossible;
  }
  return options;
}

Status checkOptions(const FlatteningOptions& options)
{
  constexpr double large = std::numeric_limits<double>::max();
  const std::vector<std::tuple<const char*, double, double>> ranges{
    { "closure tolerance", options.angles.closureTolerance, large },
    { "optimality tolerance", options.angles.optimalityTolerance, large },
    { "number of iterations", static_cast<double>(options.angles.maximumIterations), large },
    { "number of isometric iterations", static_cast<double>(options.isometric.maximumIterations),
      large },
    { "isometric tolerance", options.isometric.tolerance, large },
    { "angle weight", options.isometric.angleWeight, 100.0 },
    { "length tolerance", options.lengthTolerance, large },
    { "spacing", options.spacing, 1e6 },
  };
  for (const auto& [name, value, maximum] : ranges)
  {
    if (!std::isfinite(value) || value < 0.0 || value > maximum)
    {
      return invalidOption(std::string("the ") + name + " is " + shortNumber(value),
        "a number from 0" + (maximum < large ? " to " + shortNumber(maximum) : std::string()));
    }
  }
  if (const double bias = options.isometric.energy.bias; !(std::abs(bias) < 1.0))
  {
    return invalidOption("the area bias is " + shortNumber(bias), "a number between -1 and 1");
  }
  if (options.preventOverlap && (options.boundary != BoundaryMode::Free || options.cloth))
  {
    return invalidOption(options.cloth
        ? "threads are relaid whether the boundary crosses itself or not"
        : "the boundary keeps its length, whether it crosses itself or not",
      "a free boundary without a material, or let pieces overlap");
  }
  if (options.boundary == BoundaryMode::Free)
  {
    if (options.scheme != Scheme::Isometric)
    {
      return invalidOption("the boundary is free, and the scheme is not isometric",
        "the isometric scheme, or an exact boundary");
    }
    if (options.boundaryTolerance > 0.0)
    {
      return invalidOption("a free boundary may have any length, and it has a tolerance",
        "an exact boundary, or no tolerance");
    }
    if (options.isometric.energy.kind == DistortionEnergyKind::Automatic &&
      options.isometric.energy.bias != 0.0)
    {
      return invalidOption(
        "an area bias is for the rigid energy, and the energy of a free boundary is the symmetric "
        "Dirichlet one",
        "the rigid energy, or no area bias");
    }
  }
  if (options.cloth)
  {
    std::vector<double> angles = options.cloth->grainAngles;
    const std::size_t curves = options.cloth->grainCurves.size();
    if (angles.size() != curves)
    {
      return invalidOption("grain curves: " + std::to_string(curves) +
          ", angles for them: " + std::to_string(angles.size()),
        "one angle for each curve of the grain");
    }
    angles.push_back(options.cloth->grainAngle);
    if (!std::all_of(angles.begin(), angles.end(), [](double a) { return std::isfinite(a); }))
    {
      return { StatusCode::InvalidOption, "the grain's angle is not a number", {},
        { Remedy::GiveGrainAngle } };
    }
  }
  return options.cloth ? checkMaterial(options.cloth->material) : Status();
}
}
