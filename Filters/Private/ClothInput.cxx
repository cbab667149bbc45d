// SPDX-License-Identifier: BSD-3-Clause
#include "ClothInput.h"

#include "Base/Types.h"
#include "Cloth/ClothMaterial.h"
#include "FieldArrays.h"
#include "MaterialFile.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdlib>
#include <optional>

namespace flattening
{
namespace bridge
{
namespace
{
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
  unknown.status = { StatusCode::InvalidOption,
    "\"" + material + "\" is neither a material nor a file that can be read", {},
    { { Remedy::Give, "one of " + presetNames() + ", or a JSON file" } } };
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
  else if (!entry.empty())
  {
    options.grainCurves.push_back(entry);
    options.grainAngles.push_back(0.0);
  }
}
}

ClothOptions readCloth(const std::string& material, const std::string& grain)
{
  ClothOptions options;
  options.material = readMaterial(material);
  double degrees = 0.0;
  if (grain == "free")
  {
    options.grain = GrainKind::Free;
  }
  else if (parseNumber(grain, degrees))
  {
    options.grainAngle = degrees * degree;
  }
  else if (!grain.empty())
  {
    options.grain = GrainKind::Curve;
    std::size_t begin = 0;
    while (begin <= grain.size())
    {
      const std::size_t end = std::min(grain.find(';', begin), grain.size());
      readGrainCurve(grain.substr(begin, end - begin), options);
      begin = end + 1;
    }
  }
  return options;
}

void writeMaterials(vtkTable* table)
{
  const std::vector<ClothMaterial>& presets = materialPresets();
  table->Initialize();
  vtkDataSetAttributes* rows = table->GetRowData();
  const auto addText = [&](const char* name, std::string ClothMaterial::*member) {
    addRows<vtkStringArray>(
      rows, name, presets.size(), [&](std::size_t row) { return presets[row].*member; });
  };
  const auto addNumber = [&](const char* name, auto value) {
    addRows<vtkDoubleArray>(
      rows, name, presets.size(), [&](std::size_t row) { return value(presets[row]); });
  };
  using Material = const ClothMaterial&;
  addText("Name", &ClothMaterial::name);
  addText("Description", &ClothMaterial::description);
  addNumber("Warp", [](Material m) { return m.warp; });
  addNumber("Weft", [](Material m) { return m.weft; });
  addNumber("Shear", [](Material m) { return m.shear; });
  addNumber("Compression", [](Material m) { return m.compression; });
  addNumber("WarpLeast", [](Material m) { return 100.0 * m.warpLimits.least; });
  addNumber("WarpGreatest", [](Material m) { return 100.0 * m.warpLimits.greatest; });
  addNumber("WeftLeast", [](Material m) { return 100.0 * m.weftLimits.least; });
  addNumber("WeftGreatest", [](Material m) { return 100.0 * m.weftLimits.greatest; });
  addNumber("ShearLimit", [](Material m) { return m.shearLimit / degree; });
  addRows<vtkIntArray>(
    rows, "OneWay", presets.size(), [&](std::size_t row) { return presets[row].oneWay ? 1 : 0; });
  addRows<vtkIntArray>(
    rows, "Sheet", presets.size(), [&](std::size_t row) { return presets[row].sheet ? 1 : 0; });
  addText("Source", &ClothMaterial::source);
}
}
}
