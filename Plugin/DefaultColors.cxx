// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultColors.h"

#include "ColorPresets.h"

#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionPresets.h"

#include <string>

namespace
{
/// Those that the user does not have yet, so that what was changed under a name stays.
void addPresets()
{
  vtkSMTransferFunctionPresets* const known = vtkSMTransferFunctionPresets::GetInstance();
  for (const ColorPreset& preset : colorPresets)
  {
    if (!known->HasPreset(preset.name))
    {
      known->AddPreset(preset.name, std::string(preset.json));
    }
  }
}
}

void setDefaultColors()
{
  addPresets();
  // Wires in colors that no map of a measure has; what is measured by the presets, whatever range
  // the data has.
  const std::string tables = R"({
    "array_lookup_tables": {
      "WireKind": {
        "PVLookupTable": {
          "IndexedLookup": 1,
          "AutomaticRescaleRangeMode": -1,
          "Annotations": ["-2", "connector", "-1", "boundary", "0", "accessory", "1", "key",
            "2", "dart", "3", "seam"],
          "IndexedColors": [0.7, 0.7, 0.7, 0.0, 0.0, 0.0, 0.35, 0.35, 0.35, 0.85, 0.0, 0.0,
            0.95, 0.1, 0.7, 0.9, 0.45, 0.1]
        }
      },
      "CurveType": {
        "PVLookupTable": {
          "IndexedLookup": 1,
          "AutomaticRescaleRangeMode": -1,
          "Annotations": ["0", "accessory", "1", "key", "2", "dart", "3", "seam"],
          "IndexedColors": [0.35, 0.35, 0.35, 0.85, 0.0, 0.0, 0.95, 0.1, 0.7, 0.9, 0.45, 0.1]
        }
      }
      )" +
    std::string(colorTables) + R"(
    }
  })";
  static const bool told = vtkSMSettings::GetInstance()->AddCollectionFromString(
    tables, 1.0); // below what a user has saved
  static_cast<void>(told);
}
