// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothMaterial.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// A softer sheet than this beside its stiffest thread makes the systems singular.
constexpr double leastRatio = 1e-6;
constexpr double leastCompression = 1e-3;
constexpr double leastModulus = 1e-9;
constexpr double largestModulus = 1e15;
/// Strains and shears (in radians) below it cannot be told from rounding.
constexpr double leastLimit = 1e-6;

Status refusal(const ClothMaterial& material, const std::string& defect, const std::string& give)
{
  return { StatusCode::InvalidOption, "the material \"" + material.name + "\" has " + defect, {},
    { { Remedy::Give, give } } };
}

bool areLimits(const StrainLimits& limits)
{
  return !std::isnan(limits.least) && !std::isnan(limits.greatest) && limits.least <= -leastLimit &&
    limits.greatest >= leastLimit;
}

struct Modulus
{
  const char* name;
  double value;
};
}

bool ClothMaterial::limited() const
{
  return std::isfinite(this->warpLimits.least) || std::isfinite(this->warpLimits.greatest) ||
    std::isfinite(this->weftLimits.least) || std::isfinite(this->weftLimits.greatest) ||
    std::isfinite(this->shearLimit);
}

Status checkMaterial(const ClothMaterial& material)
{
  if (!material.status.ok() || material.isotropic)
  {
    return material.status;
  }
  for (const auto& [name, value] : { Modulus{ "warp", material.warp },
         Modulus{ "weft", material.weft }, Modulus{ "shear", material.shear } })
  {
    if (!std::isfinite(value) || value < leastModulus || value > largestModulus)
    {
      return refusal(material, std::string("the ") + name + " stiffness " + shortNumber(value),
        "a number above 0 in N/m, from " + shortNumber(leastModulus) + " to " +
          shortNumber(largestModulus));
    }
  }
  const double stiffest = std::max({ material.warp, material.weft, material.shear });
  if (std::min({ material.warp, material.weft, material.shear }) < leastRatio * stiffest)
  {
    return refusal(material, "a stiffness too small beside the stiffest, " + shortNumber(stiffest),
      "at least a millionth of it");
  }
  if (!std::isfinite(material.compression) || material.compression < leastCompression ||
    material.compression > 1.0)
  {
    return refusal(material, "the compression ratio " + shortNumber(material.compression),
      "a ratio from " + shortNumber(leastCompression) + " to 1");
  }
  if (!std::isfinite(material.cross) ||
    std::abs(material.cross) >= material.compression * std::sqrt(material.warp * material.weft))
  {
    return refusal(material, "the coupling " + shortNumber(material.cross) + ", which is unstable",
      "one smaller than the root of warp times weft, times the compression ratio");
  }
  if (!areLimits(material.warpLimits) || !areLimits(material.weftLimits))
  {
    return refusal(material, "strain limits that leave out 0",
      "a least strain below 0 and a greatest above 0, by at least 0.0001 %");
  }
  if (std::isnan(material.shearLimit) || material.shearLimit < leastLimit)
  {
    return refusal(material, "a shear limit that is not above 0", "one of at least 0.0001 degrees");
  }
  return {};
}
}
