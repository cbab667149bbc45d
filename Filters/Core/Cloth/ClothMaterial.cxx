// SPDX-License-Identifier: BSD-3-Clause
#include "Cloth/ClothMaterial.h"

#include "Base/Types.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
/// A softer sheet than this beside its stiffest thread makes the systems singular.
constexpr double minRatio = 1e-6;
/// The same of a thread that is compressed beside the same thread drawn.
constexpr double minCompression = 1e-3;
/// Far beyond any cloth, in the unit of a material: products of what is outside overflow or vanish.
constexpr double minModulus = 1e-9;
constexpr double largestModulus = 1e15;
/// Strains and shears (in radians) below it cannot be told from rounding.
constexpr double minLimit = 1e-6;

Status refusal(const ClothMaterial& material, const std::string& defect, const std::string& give)
{
  return invalidOption("the material \"" + material.name + "\" has " + defect, give);
}

bool areLimits(const StrainLimits& limits)
{
  return !std::isnan(limits.least) && !std::isnan(limits.greatest) && limits.least <= -minLimit &&
    limits.greatest >= minLimit;
}
}

Status checkMaterial(const ClothMaterial& material)
{
  if (!material.status.ok() || material.isotropic)
  {
    return material.status;
  }
  for (const auto& [name, value] : { std::pair("warp", material.warp),
         std::pair("weft", material.weft), std::pair("shear", material.shear) })
  {
    if (!std::isfinite(value) || value < minModulus || value > largestModulus)
    {
      return refusal(material, std::string("the ") + name + " stiffness " + shortNumber(value),
        "a number above 0 in N/m, from " + shortNumber(minModulus) + " to " +
          shortNumber(largestModulus));
    }
  }
  const double stiffest = std::max({ material.warp, material.weft, material.shear });
  if (std::min({ material.warp, material.weft, material.shear }) < minRatio * stiffest)
  {
    return refusal(material, "a stiffness too small beside the stiffest, " + shortNumber(stiffest),
      "at least a millionth of it");
  }
  if (!std::isfinite(material.compression) || material.compression < minCompression ||
    material.compression > 1.0)
  {
    return refusal(material, "the compression ratio " + shortNumber(material.compression),
      "a ratio from " + shortNumber(minCompression) + " to 1");
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
  if (std::isnan(material.shearLimit) || material.shearLimit < minLimit)
  {
    return refusal(material, "a shear limit that is not above 0", "one of at least 0.0001 degrees");
  }
  return {};
}

namespace
{
const char* const allowances =
  "; strain allowances: Zhang, Wang, Ramani, 2016 (leather and textile 1 %, jeans 5 %, neoprene 10 "
  "%), the others and compression assumed";

ClothMaterial isotropic()
{
  ClothMaterial sheet;
  sheet.name = "isotropic";
  sheet.description = "alike in all directions, as without a material";
  sheet.source = "none: it has no numbers";
  sheet.isotropic = true;
  sheet.sheet = true;
  return sheet;
}

struct Stiffness
{
  double warp;
  double weft;
  double shear;
};

ClothMaterial threads(const char* name, const char* description, const Stiffness& stiffness,
  double compression, const StrainLimits& warp, const StrainLimits& weft, double shearDegrees,
  const std::string& source)
{
  ClothMaterial cloth;
  cloth.name = name;
  cloth.description = description;
  cloth.source = source + allowances;
  cloth.warp = stiffness.warp;
  cloth.weft = stiffness.weft;
  cloth.shear = stiffness.shear;
  cloth.compression = compression;
  cloth.warpLimits = warp;
  cloth.weftLimits = weft;
  cloth.shearLimit = shearDegrees * degree;
  return cloth;
}

ClothMaterial unfrayed(ClothMaterial sheet)
{
  sheet.sheet = true;
  return sheet;
}

std::vector<ClothMaterial> makePresets()
{
  const std::string wang =
    "Wang, O'Brien, Ramamoorthi, \"Data-driven elastic models for cloth\", 2011, ";
  std::vector<ClothMaterial> all;
  all.push_back(isotropic());
  all.push_back(threads("plain", "plain woven wool suiting, 168 g/m2", { 2130, 1660, 26 }, 1.0,
    { -0.01, 0.01 }, { -0.02, 0.02 }, 20,
    "FAST test of a plain woven wool: extension at 98.1 N/m 4.6 % in warp and 5.9 % in weft, bias "
    "extension 4.7 % (shear stiffness 123 / 4.7 N/m)"));
  all.push_back(threads("twill", "woven cotton and polyester for trousers, 220 g/m2",
    { 2017, 2035, 26 }, 1.0, { -0.01, 0.01 }, { -0.02, 0.02 }, 25,
    wang + "65/35 cotton and polyester of trousers; that it is a twill is assumed"));
  all.push_back(threads("denim", "rigid cotton denim, about 1000 g/m2", { 9500, 9500, 135 }, 1.0,
    { -0.01, 0.05 }, { -0.02, 0.05 }, 15,
    "KES-F tests of six denims, Hindawi 2016: extension 4.7 to 5.7 % at 490 N/m, shear 1.5 to 3.4 "
    "gf/cm/degree, their middle"));
  all.push_back(threads("stretch-woven", "denim with elastane in the weft, 324 g/m2",
    { 1014, 205, 13 }, 1.0, { -0.01, 0.01 }, { -0.02, 0.12 }, 25,
    wang + "11 oz stretch denim; its soft direction is taken for the weft"));
  all.push_back(threads("jersey", "knitted T-shirt, interlock, 187 g/m2", { 34, 17, 9 }, 0.5,
    { -0.05, 0.25 }, { -0.05, 0.25 }, 25,
    wang + "gray interlock; its soft direction is taken for the courses (weft)"));
  all.push_back(threads("rib", "rib knit, 276 g/m2", { 65, 43, 21 }, 0.5, { -0.05, 0.25 },
    { -0.05, 0.35 }, 25, wang + "ivory rib knit; its soft direction is taken for the courses"));
  all.push_back(unfrayed(threads("neoprene", "foamed rubber for wetsuits, 3 mm",
    { 2000, 2000, 800 }, 1.0, { -0.1, 0.1 }, { -0.1, 0.1 }, 20,
    "assumed: alike in all directions, Poisson's ratio 0.25, so that shear is 0.4 of the "
    "threads'")));
  all.push_back(unfrayed(
    threads("leather", "upper leather, 1.5 mm", { 30000, 30000, 12000 }, 1.0, { -0.01, 0.01 },
      { -0.01, 0.01 }, 5, "assumed: alike in all directions, Poisson's ratio 0.25")));
  all.push_back(unfrayed(threads("laminate", "film laminate for sails", { 500000, 500000, 100000 },
    1.0, { -0.002, 0.002 }, { -0.002, 0.002 }, 1,
    "assumed: balanced scrims between films, shear 0.2 of the threads'")));
  all.push_back(unfrayed(threads("woven-carbon", "dry woven carbon for moulding",
    { 1000000, 1000000, 100 }, 1.0, { -0.002, 0.002 }, { -0.002, 0.002 }, 50,
    "assumed: threads that do not give, shear 1e-4 of theirs, locked at 50 degrees of 40 to 60")));
  // Modulus times thickness.
  all.push_back(unfrayed(threads("eva-foam", "ethylene-vinyl acetate foam, 10 mm",
    { 20000, 20000, 8000 }, 1.0, { -0.05, 0.05 }, { -0.05, 0.05 }, 10,
    "assumed: 2 MPa, alike in all directions, Poisson's ratio 0.25")));
  all.push_back(unfrayed(threads("plywood", "birch plywood, 3 mm, warp along the face grain",
    { 3e7, 1.8e7, 2.1e6 }, 1.0, { -0.003, 0.003 }, { -0.003, 0.003 }, 0.3,
    "assumed: 10 GPa along and 6 GPa across the face grain, 0.7 GPa in shear")));
  all.push_back(unfrayed(threads("aluminum", "aluminum alloy, 1 mm", { 7e7, 7e7, 2.7e7 }, 1.0,
    { -0.002, 0.002 }, { -0.002, 0.002 }, 0.2,
    "EN 1999-1-1: 70 GPa, 27 GPa in shear; limits where plastic strain begins, 0.2 %")));
  all.push_back(unfrayed(threads("steel", "mild steel, 1 mm", { 2.1e8, 2.1e8, 8.1e7 }, 1.0,
    { -0.0011, 0.0011 }, { -0.0011, 0.0011 }, 0.1,
    "EN 1993-1-1: 210 GPa, 81 GPa in shear; limits where S235 yields, 235 MPa")));
  return all;
}
}

const std::vector<ClothMaterial>& materialPresets()
{
  static const std::vector<ClothMaterial> presets = makePresets();
  return presets;
}

std::optional<ClothMaterial> findPreset(const std::string& name)
{
  const std::vector<ClothMaterial>& presets = materialPresets();
  const auto found =
    std::find_if(presets.begin(), presets.end(), [&name](const ClothMaterial& preset) {
      return std::equal(preset.name.begin(), preset.name.end(), name.begin(), name.end(),
        [](char wanted, char given) {
          return std::tolower(static_cast<unsigned char>(given)) == wanted;
        });
    });
  return found == presets.end() ? std::nullopt : std::optional<ClothMaterial>(*found);
}

std::string presetNames()
{
  std::string names;
  for (const ClothMaterial& preset : materialPresets())
  {
    names += (names.empty() ? "" : ", ") + preset.name;
  }
  return names;
}
}
