// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultColors.h"

#include "ClothColors.h"

#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionPresets.h"

#include <string>

namespace
{
/// Those that the user does not have yet, so that what was changed under a name stays.
void addClothPresets()
{
  vtkSMTransferFunctionPresets* const known = vtkSMTransferFunctionPresets::GetInstance();
  for (const ClothPreset& preset : clothPresets)
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
  addClothPresets();
  // Blue at 1 to red at 0.5, as in Fig. 9e of the paper, whatever range the data has; wires in the
  // colours of its figures.
  const std::string tables = R"({
    "array_lookup_tables": {
      "HomogeneityOfDistortion": {
        "PVLookupTable": {
          "RGBPoints": [0.5, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0],
          "ColorSpace": 1,
          "AutomaticRescaleRangeMode": -1
        }
      },
      "WireKind": {
        "PVLookupTable": {
          "IndexedLookup": 1,
          "AutomaticRescaleRangeMode": -1,
          "Annotations": ["-2", "connector", "-1", "boundary", "0", "accessory", "1", "key",
            "2", "dart", "3", "seam"],
          "IndexedColors": [0.7, 0.7, 0.7, 0.0, 0.0, 0.0, 0.0, 0.6, 0.1, 0.85, 0.0, 0.0,
            0.0, 0.2, 0.9, 0.6, 0.0, 0.75]
        }
      },
      "CurveType": {
        "PVLookupTable": {
          "IndexedLookup": 1,
          "AutomaticRescaleRangeMode": -1,
          "Annotations": ["0", "accessory", "1", "key", "2", "dart", "3", "seam"],
          "IndexedColors": [0.0, 0.6, 0.1, 0.85, 0.0, 0.0, 0.0, 0.2, 0.9, 0.6, 0.0, 0.75]
        }
      }
      )" +
    std::string(clothTables) + R"(
    }
  })";
  static const bool told = vtkSMSettings::GetInstance()->AddCollectionFromString(
    tables, 1.0); // below what a user has saved
  static_cast<void>(told);
}
