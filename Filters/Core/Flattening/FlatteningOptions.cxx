// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/FlatteningOptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flattening
{
Status checkOptions(const FlatteningOptions& options)
{
  struct Range
  {
    const char* name;
    double value;
    double most;
  };
  constexpr double large = std::numeric_limits<double>::max();
  for (const Range& range :
    { Range{ "closure tolerance", options.angles.closureTolerance, large },
      Range{ "optimality tolerance", options.angles.optimalityTolerance, large },
      Range{ "number of iterations", static_cast<double>(options.angles.maximumIterations), large },
      Range{ "number of isometric iterations",
        static_cast<double>(options.isometric.maximumIterations), large },
      Range{ "isometric tolerance", options.isometric.tolerance, large },
      Range{ "angle weight", options.isometric.angleWeight, 100.0 },
      Range{ "length tolerance", options.lengthTolerance, large },
      Range{ "spacing", options.spacing, 1e6 } })
  {
    if (!std::isfinite(range.value) || range.value < 0.0 || range.value > range.most)
    {
      return { StatusCode::InvalidOption,
        std::string("the ") + range.name + " is " + shortNumber(range.value), {},
        { { Remedy::Give,
          "a number from 0" +
            (range.most < large ? " to " + shortNumber(range.most) : std::string()) } } };
    }
  }
  if (options.cloth)
  {
    std::vector<double> angles = options.cloth->grainAngles;
    const std::size_t curves = options.cloth->grainCurves.size();
    if (angles.size() != curves)
    {
      return { StatusCode::InvalidOption,
        "grain curves: " + std::to_string(curves) +
          ", angles for them: " + std::to_string(angles.size()),
        {}, { { Remedy::Give, "one angle for each curve of the grain" } } };
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
