// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveSuggestion.h"

#include "CurvedSurface.h"
#include "Design/LineSuggestion.h"
#include "FilterExecution.h"
#include "Flattening/FlatteningOptions.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Suggestion/CurveSuggestion.h"
#include "SuggestionOutput.h"
#include "WeightInput.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFeatureCurveSuggestion);

//------------------------------------------------------------------------------
bool vtkFeatureCurveSuggestion::IsProposedName(const std::string& name)
{
  return flattening::isProposedName(name);
}

//------------------------------------------------------------------------------
vtkFeatureCurveSuggestion::vtkFeatureCurveSuggestion()
{
  this->SetTablePort(6);
  this->LeftOutLines = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  visit("SuggestedCuts", this->SuggestedCuts);
  visit("Bound", this->Bound);
  visit("MaximumCuts", this->MaximumCuts);
  visit("MaximumCutLength", this->MaximumCutLength);
  visit("MaximumWork", this->MaximumWork);
  visit("Symmetric", this->Symmetric);
  std::string weights = this->GetWeightArray();
  visit("WeightArray", weights);
  if (weights != this->GetWeightArray())
  {
    this->SetWeightArray(weights.c_str());
  }
}

//------------------------------------------------------------------------------
vtkFeatureCurveSuggestion::~vtkFeatureCurveSuggestion() = default;

//------------------------------------------------------------------------------
vtkTable* vtkFeatureCurveSuggestion::GetLeftOutLines() const
{
  return this->LeftOutLines;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::SetWeightArray(const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name ? name : "");
}

//------------------------------------------------------------------------------
const char* vtkFeatureCurveSuggestion::GetWeightArray()
{
  vtkInformation* const array = this->GetInputArrayInformation(0);
  return array->Has(vtkDataObject::FIELD_NAME()) ? array->Get(vtkDataObject::FIELD_NAME()) : "";
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::AddPreference(const std::string& curve, double weight)
{
  if (flattening::bridge::changeEntry(this->Preferences, curve, weight))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::RemoveAllPreferences()
{
  if (flattening::bridge::changeToNone(this->Preferences))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkFeatureCurveSuggestion::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  static_assert(static_cast<int>(flattening::SuggestedCuts::Seams) == SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::All) == DARTS_AND_SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::Lines) == LINES, "");
  this->Begin(outputVector);
  flattening::CurveSuggestions suggestions;
  const auto source = this->LoadInput(inputVector);
  bool done = false;
  flattening::SuggestionOptions options;
  if (source &&
    this->Conclude(
      flattening::bridge::readWeights(*source, this->GetWeightArray(), options.weights)))
  {
    const flattening::OptionStructures all = this->OptionsForCore();
    options.search = all.search;
    options.imprint = all.imprint;
    options.flattening = this->Settings();
    for (const auto& [curve, weight] : this->Preferences)
    {
      options.search.preferences.push_back({ curve, weight });
    }
    const auto& suggest =
      this->SuggestedCuts == LINES ? flattening::suggestLines : flattening::suggestCurves;
    suggestions = suggest(source->surface.prepared.mesh, source->curves.polylines, options,
      flattening::bridge::executionOf(this));
    if (suggestions.end == flattening::SearchEnd::Interrupted)
    {
      this->SetAbortExecute(0); // it is heard; the surface is flattened with the cuts found so far
    }
    done = this->Conclude(source->outcomeOfStage(suggestions.status));
  }
  if (!done)
  {
    this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
    return 1;
  }
  vtkNew<vtkPolyData> proposed;
  flattening::bridge::writeSuggestions({}, suggestions, proposed);
  vtkNew<vtkPolyData> all;
  flattening::bridge::writeSuggestions(source->curves.polylines, suggestions, all);
  // The curves of the input, and the proposed ones as one more connection.
  vtkNew<vtkInformationVector> curves;
  curves->Copy(inputVector[1]);
  if (!suggestions.curves.empty())
  {
    vtkNew<vtkInformation> information;
    information->Set(vtkDataObject::DATA_OBJECT(), proposed);
    curves->Append(information);
  }
  vtkInformationVector* inputs[] = { inputVector[0], curves };
  this->Superclass::RequestData(request, inputs, outputVector);
  if (!this->IsRefused())
  {
    vtkPolyData::GetData(outputVector, 5)->ShallowCopy(all);
    flattening::bridge::writeSearch(suggestions, vtkTable::GetData(outputVector, 6));
    this->LeftOutLines = flattening::bridge::leftOutLines(suggestions);
    const std::string shortfall = this->SuggestedCuts == LINES
      ? std::string()
      : flattening::bridge::describeShortfall(suggestions, this->Bound, source->curves.polylines);
    if (!shortfall.empty())
    {
      this->Warn({ shortfall });
      this->WriteRunStatus(vtkPolyData::GetData(outputVector, 0));
    }
  }
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
