// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultColors.h"

#include "ColorPresets.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkObjectBase.h"
#include "vtkObjectFactory.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProxy.h"
#include "vtkSMSettings.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtkSetGet.h"

#include <string>
#include <utility>

namespace
{
/// What shows the outputs of the filters. ColorBy() of ParaView's Python rescales by force the
/// table of the array that it has chosen; here this first rescaling leaves tables alone whose range
/// is fixed, as ParaView's window does.
class FlatteningRepresentation : public vtkSMPVRepresentationProxy
{
public:
  static FlatteningRepresentation* New();
  vtkTypeMacro(FlatteningRepresentation, vtkSMPVRepresentationProxy);

  using vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange;
  using vtkSMPVRepresentationProxy::SetScalarColoring;

  bool SetScalarColoring(const char* array, int association) override
  {
    this->IsNewlyColored = array != nullptr;
    return this->Superclass::SetScalarColoring(array, association);
  }

  bool SetScalarColoring(const char* array, int association, int component) override
  {
    this->IsNewlyColored = array != nullptr;
    return this->Superclass::SetScalarColoring(array, association, component);
  }

  bool RescaleTransferFunctionToDataRange(bool extend, bool force) override
  {
    const bool isNewlyColored = std::exchange(this->IsNewlyColored, false);
    return this->Superclass::RescaleTransferFunctionToDataRange(extend, force && !isNewlyColored);
  }

  void ViewUpdated(vtkSMProxy* view) override
  {
    this->IsNewlyColored = false;
    this->Superclass::ViewUpdated(view);
  }

private:
  bool IsNewlyColored = false; // since then neither rescaled nor drawn
};
vtkStandardNewMacro(FlatteningRepresentation);

/// Makes the class known by the name of its element in SurfaceFlattening.xml.in.
void addRepresentation(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction("vtkSMFlatteningRepresentationProxy",
    [](void*) -> vtkObjectBase* { return FlatteningRepresentation::New(); });
}

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
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(&addRepresentation);
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
