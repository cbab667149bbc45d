// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveSuggestion.h"

#include "CurvedPolyData.h"
#include "Design/LineSuggestion.h"
#include "FieldArrays.h"
#include "FilterExecution.h"
#include "Flattening/FlatteningOptions.h"
#include "ListChanges.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Report/SuggestionReport.h"
#include "Suggestion/CurveSuggestion.h"
#include "Suggestion/RegionWeights.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkFeatureCurveSuggestion);

namespace flattening
{
namespace bridge
{
namespace
{
/// The cell arrays that could be meant.
std::string candidates(vtkCellData* cells)
{
  std::string names;
  for (int k = 0; k < cells->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const array = cells->GetArray(k);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1)
    {
      names += (names.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  return names.empty() ? "a cell array with a number for each cell" : "one of " + names;
}

/// The weights of the surface's triangles in a cell array of the input. An empty name: none.
/// InvalidOption: there is no cell array of that name with one number for each cell.
Status readWeights(const CurvedPolyData& source, const std::string& array, RegionWeights& weights)
{
  weights.clear();
  if (array.empty())
  {
    return {};
  }
  vtkDataArray* const values = source.cellArrays->GetArray(array.c_str());
  if (!values || values->GetNumberOfComponents() != 1)
  {
    const std::string what = values
      ? "the cell array \"" + array + "\" has " + std::to_string(values->GetNumberOfComponents()) +
        " numbers a cell"
      : "the surface has no cell array of numbers named \"" + array + "\"";
    return { StatusCode::InvalidOption, what, {},
      { { Remedy::Give, candidates(source.cellArrays) } } };
  }
  for (const vtkIdType cell : source.surface.input.cellOfTriangle)
  {
    weights.push_back(values->GetComponent(cell, 0));
  }
  return {};
}

void writeLines(const std::vector<SuggestedCurve>& rows, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> shape;
  shape->SetName("PlanarShape");
  shape->SetNumberOfComponents(2);
  bool shaped = false;
  for (const SuggestedCurve& row : rows)
  {
    const Polyline& curve = row.curve;
    lines->InsertNextCell(static_cast<int>(curve.points.size()));
    for (std::size_t k = 0; k < curve.points.size(); ++k)
    {
      lines->InsertCellPoint(points->InsertNextPoint(curve.points[k].data()));
      constexpr double no = std::numeric_limits<double>::quiet_NaN();
      const bool has = curve.keyShape == KeyShape::Planar && k < curve.planarShape.size();
      const Point2 place = has ? curve.planarShape[k] : Point2(no, no);
      shape->InsertNextTypedTuple(place.data());
      shaped = shaped || has;
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  if (shaped)
  {
    output->GetPointData()->AddArray(shape);
  }
}

/// Curves and then proposed cuts as polylines with points of their own; the arrays are those of
/// vtkFeatureCurveSuggestion.
void writeSuggestions(
  const std::vector<Polyline>& curves, const CurveSuggestions& suggestions, vtkPolyData* output)
{
  const std::vector<SuggestedCurve> rows = suggestionRows(curves, suggestions);
  writeLines(rows, output);
  addColumns(output->GetCellData(), suggestionArrays(rows, curves.size()));
  addColumns(output->GetFieldData(), mirrorArrays(suggestions));
}
}
}
}

//------------------------------------------------------------------------------
vtkFeatureCurveSuggestion::vtkFeatureCurveSuggestion()
{
  this->SetTablePort(6);
  this->LeftOutLines = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::AddOtherOptions(flattening::OptionValues& values)
{
  this->Superclass::AddOtherOptions(values);
  values.set("WeightArray", std::string(this->GetWeightArray()));
}

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
  flattening::bridge::changeEntry(this, this->Preferences, curve, weight);
}

//------------------------------------------------------------------------------
void vtkFeatureCurveSuggestion::RemoveAllPreferences()
{
  flattening::bridge::changeToNone(this, this->Preferences);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveSuggestion::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  static_assert(static_cast<int>(flattening::SuggestedCuts::Seams) == SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::All) == DARTS_AND_SEAMS, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::Lines) == LINES, "");
  static_assert(static_cast<int>(flattening::SuggestedCuts::Gores) == GORES, "");
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
      this->GetSuggestedCuts() == LINES ? flattening::suggestLines : flattening::suggestCurves;
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
    flattening::bridge::writeTable(
      flattening::searchTable(suggestions), vtkTable::GetData(outputVector, 6));
    this->LeftOutLines = flattening::bridge::makeTable(flattening::leftOutTable(suggestions));
    const std::string shortfall = this->GetSuggestedCuts() == LINES
      ? std::string()
      : flattening::describeShortfall(
          suggestions, this->GetBound(), this->GetMaximumWidth(), source->curves.polylines);
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
