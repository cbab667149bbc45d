// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ClothInput.h"

#include "Base/Types.h"
#include "Cloth/ClothMaterial.h"

#ifdef FLATTENING_WITH_JSON
#include "Input/JsonKeys.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace flattening
{
namespace
{
const char* const example = "an object such as {\"warp\": 2000, \"weft\": 1800, \"shear\": 25}";

Status refusal(const std::string& path, const std::string& defect, const std::string& give)
{
  return invalidOption("the material file \"" + path + "\" " + defect, give);
}

bool isMaterialFile(const std::string& text)
{
  std::error_code failed;
  // A pipe or a device may have no end.
  return std::filesystem::is_regular_file(std::filesystem::u8path(text), failed) &&
    std::ifstream(text).good();
}

#ifndef FLATTENING_WITH_JSON
ClothMaterial readMaterialFile(const std::string& path)
{
  ClothMaterial material;
  material.status = refusal(
    path, "cannot be read: the library was built without nlohmann-json", "the name of a material");
  return material;
}
#else
using Json = nlohmann::json;
/// In bytes and characters: a hundred times what materials take, so that no other file is read
/// whole.
constexpr std::uintmax_t largestFile = 1000000;
constexpr std::size_t longestText = 1000;

/// Takes members of an object one after the other and remembers the first thing that is wrong.
class MaterialReader
{
public:
  MaterialReader(const std::string& path, const Json& object)
    : Path(path)
    , Object(object)
  {
  }

  ClothMaterial read()
  {
    ClothMaterial material;
    material.name = this->Path;
    this->onlyMembers(this->Object,
      { "name", "description", "source", "warp", "weft", "shear", "cross", "compression", "limits",
        "one_way", "sheet" });
    this->text("name", material.name);
    this->text("description", material.description);
    this->text("source", material.source);
    this->number(this->Object, "warp", material.warp, true);
    this->number(this->Object, "weft", material.weft, true);
    this->number(this->Object, "shear", material.shear, true);
    this->number(this->Object, "cross", material.cross, false);
    this->number(this->Object, "compression", material.compression, false);
    this->flag("one_way", material.oneWay);
    this->flag("sheet", material.sheet);
    this->limits(material);
    material.status = this->Wrong;
    return material;
  }

private:
  void blame(const std::string& defect, const std::string& give)
  {
    if (this->Wrong.ok())
    {
      this->Wrong = refusal(this->Path, defect, give);
    }
  }

  void onlyMembers(const Json& object, const std::vector<std::string>& known)
  {
    for (const auto& [key, value] : object.items())
    {
      if (std::find(known.begin(), known.end(), key) == known.end())
      {
        this->blame("has a member \"" + key + "\" that means nothing",
          "only " + listNames(known, known.size()));
      }
    }
  }

  void text(const char* key, std::string& value)
  {
    const auto found = this->Object.find(key);
    if (found != this->Object.end() &&
      (!found->is_string() || found->get_ref<const std::string&>().size() > longestText))
    {
      this->blame(std::string("has a \"") + key + "\" that is not text, or is too long",
        "a text of at most " + std::to_string(longestText) + " characters");
    }
    else if (found != this->Object.end())
    {
      value = found->get<std::string>();
    }
  }

  void flag(const char* key, bool& value)
  {
    const auto found = this->Object.find(key);
    if (found != this->Object.end() && !found->is_boolean())
    {
      this->blame(
        std::string("has a \"") + key + "\" that is neither true nor false", "true or false");
    }
    else if (found != this->Object.end())
    {
      value = found->get<bool>();
    }
  }

  void number(const Json& object, const char* key, double& value, bool needed)
  {
    const auto found = object.find(key);
    if (found == object.end())
    {
      if (needed)
      {
        this->blame(std::string("has no \"") + key + "\"", "a stiffness above 0 in N/m");
      }
      return;
    }
    if (!found->is_number())
    {
      this->blame(std::string("has a \"") + key + "\" that is not a number", "a number");
      return;
    }
    value = found->get<double>();
  }

  void range(const Json& limits, const char* key, StrainLimits& value)
  {
    const auto found = limits.find(key);
    if (found == limits.end())
    {
      return;
    }
    if (!found->is_array() || found->size() != 2 || !(*found)[0].is_number() ||
      !(*found)[1].is_number())
    {
      this->blame(std::string("has limits of \"") + key + "\" that are not two numbers",
        "the least and the greatest strain in percent, such as [-1, 5]");
      return;
    }
    value.least = 0.01 * (*found)[0].get<double>();
    value.greatest = 0.01 * (*found)[1].get<double>();
  }

  void limits(ClothMaterial& material)
  {
    const auto limits = this->Object.find("limits");
    if (limits == this->Object.end())
    {
      return;
    }
    if (!limits->is_object())
    {
      this->blame("has \"limits\" that are not an object", "such as {\"warp\": [-1, 1]}");
      return;
    }
    this->onlyMembers(*limits, { "warp", "weft", "shear" });
    this->range(*limits, "warp", material.warpLimits);
    this->range(*limits, "weft", material.weftLimits);
    double degrees = material.shearLimit / degree;
    this->number(*limits, "shear", degrees, false);
    material.shearLimit = degrees * degree;
  }

  const std::string& Path;
  const Json& Object;
  Status Wrong;
};

ClothMaterial readMaterialFile(const std::string& path)
{
  ClothMaterial material;
  material.name = path;
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(std::filesystem::u8path(path), failed);
  if (failed || size > largestFile)
  {
    material.status = refusal(path, "has more than a megabyte", example);
    return material;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const JsonFault fault = readJson<Json>(text, [&](const Json& json) {
    if (json.is_object())
    {
      material = MaterialReader(path, json).read();
    }
    else
    {
      material.status = refusal(path, "holds no object", example);
    }
  });
  if (!fault.text.empty())
  {
    material.status = refusal(path, fault.text, fault.remedy.empty() ? example : fault.remedy);
  }
  return material;
}
#endif

/// The whole text as a number.
bool parseNumber(const std::string& text, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size() && std::isfinite(value);
}

ClothMaterial readMaterial(const std::string& material)
{
  const std::optional<ClothMaterial> preset = findPreset(material);
  const bool file = isMaterialFile(material);
  if (preset && (preset->name == material || !file))
  {
    return *preset;
  }
  if (file)
  {
    return readMaterialFile(material);
  }
  ClothMaterial unknown;
  unknown.name = material;
  unknown.status =
    invalidOption("\"" + material + "\" is neither a material nor a file that can be read",
      "one of " + presetNames() + ", or a JSON file");
  return unknown;
}

/// NAME or NAME:DEGREES.
void readGrainCurve(const std::string& entry, ClothOptions& options)
{
  const std::size_t sign = entry.rfind(':');
  double degrees = 0.0;
  if (sign != std::string::npos && sign > 0 && parseNumber(entry.substr(sign + 1), degrees))
  {
    options.grainCurves.push_back(entry.substr(0, sign));
    options.grainAngles.push_back(degrees * degree);
  }
  else
  {
    options.grainCurves.push_back(entry);
    options.grainAngles.push_back(0.0);
  }
}
}

ClothOptions readCloth(const std::string& material, const std::vector<std::string>& grain)
{
  ClothOptions options;
  options.material = readMaterial(material);
  double degrees = 0.0;
  const std::string first = grain.size() == 1 ? grain.front() : std::string();
  if (first == "free")
  {
    options.grain = GrainKind::Free;
  }
  else if (parseNumber(first, degrees))
  {
    options.grainAngle = degrees * degree;
  }
  else if (!grain.empty())
  {
    options.grain = GrainKind::Curve;
    for (const std::string& entry : grain)
    {
      readGrainCurve(entry, options);
    }
  }
  return options;
}
}
