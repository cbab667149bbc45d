// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveSuggestion.h"

#include "CurvedPolyData.h"
#include "FilterExecution.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"
#include "PolyDataSets.h"
#include "Report/FlatteningData.h"
#include "Report/FlatteningRun.h"
#include "Report/SuggestionReport.h"

#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <optional>

vtkStandardNewMacro(vtkFeatureCurveSuggestion);

//------------------------------------------------------------------------------
vtkFeatureCurveSuggestion::vtkFeatureCurveSuggestion()
{
  this->SetTablePort(6);
  this->LeftOutLines = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::AddPreference(const std::string& curve, double weight)
{
  flattening::bridge::changeEntry(this, this->Preferences, curve, weight);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::RemoveAllPreferences()
{
  flattening::bridge::changeToNone(this, this->Preferences);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveSuggestion::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  static_assert(static_cast<int>(flattening::SuggestedCuts::Seams) == SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::All) == DARTS_AND_SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::Lines) == LINES, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::Gores) == GORES, "");
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  const auto source = this->LoadInput(inputVector);
  if (source)
  {
    flattening::OptionStructures options = this->OptionsForCore();
    options.flattening = this->Settings();
    for (const auto& [curve, weight] : this->Preferences)
    {
      options.search.preferences.push_back({ curve, weight });
    }
    const std::vector<flattening::Polyline> given = source->curves.polylines;
    flattening::FlatteningRun run(*source);
    flattening::CurveSuggestions found;
    std::optional<flattening::FlatteningResult> result;
    if (this->Weigh(run, *source))
    {
      flattening::Execution execution = bridge::executionOf(this);
      execution.preview = [this](const std::vector<flattening::Points3>& lines) {
        vtkNew<vtkPolyData> preview;
        bridge::fill(preview, flattening::lineData(lines));
        this->InvokeEvent(PreviewEvent, preview);
      };
      // An abort is heard; the surface is flattened with the cuts found so far.
      result = run.suggest(
        options, execution, [this] { this->SetAbortExecute(0); }, found, this->KeptPieces());
    }
    if (this->TakeResult(
          run, *source, result ? &*result : nullptr, options.flattening, inputVector, outputVector))
    {
      bridge::fill(vtkPolyData::GetData(outputVector, 5), suggestionData(given, found));
      bridge::writeTable(flattening::searchTable(found), vtkTable::GetData(outputVector, 6));
      this->LeftOutLines = bridge::makeTable(flattening::leftOutTable(found));
    }
  }
  this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& entry : this->Preferences)
  {
    os << indent << "Preference " << entry.first << ": " << entry.second << "\n";
  }
}
