// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveSuggestion.h"

#include "CurvedPolyData.h"
#include "Design/LineSuggestion.h"
#include "FieldArrays.h"
#include "FilterExecution.h"
#include "Flattening/FlatteningOptions.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Report/ReportColumns.h"
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

/// A curve of the input as a row beside the proposed ones.
SuggestedCurve rowOf(const Polyline& curve)
{
  SuggestedCurve row;
  row.curve = curve;
  for (std::size_t k = 1; k < curve.points.size(); ++k)
  {
    row.length += (curve.points[k] - curve.points[k - 1]).norm();
  }
  return row;
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

/// The lines that were tried and not proposed.
Columns leftOutLines(const CurveSuggestions& suggestions)
{
  Columns table;
  const TableColumns<SuggestedCurve> columns(table, suggestions.leftOut);
  columns.add("Name", [](const SuggestedCurve& line) { return line.curve.name; });
  columns.add("Type", [](const SuggestedCurve& line) { return curveTypeName(line.curve.type); });
  columns.add("Sound", &SuggestedCurve::sound);
  columns.add("Length", &SuggestedCurve::length);
  columns.add("Gain", &SuggestedCurve::gain);
  columns.add("AreaErrorBefore", &SuggestedCurve::areaErrorBefore);
  columns.add("AreaErrorAfter", &SuggestedCurve::areaErrorAfter);
  columns.add("StrainBefore", &SuggestedCurve::strainBefore);
  columns.add("StrainAfter", &SuggestedCurve::strainAfter);
  return table;
}

/// Writes one row: how the search ended.
Columns searchTable(const CurveSuggestions& suggestions)
{
  Columns table;
  const std::vector<const CurveSuggestions*> rows{ &suggestions };
  const TableColumns<const CurveSuggestions*> columns(table, rows);
  columns.add("BoundMet", &CurveSuggestions::boundMet);
  columns.add("StrainBefore", &CurveSuggestions::strainBefore);
  columns.add("StrainAfter", &CurveSuggestions::strainAfter);
  columns.add("Trials", &CurveSuggestions::trials);
  columns.add("Work", &CurveSuggestions::work);
  return table;
}

/// Curves and then proposed cuts as polylines with points of their own; the arrays are those of
/// vtkFeatureCurveSuggestion.
void writeSuggestions(
  const std::vector<Polyline>& curves, const CurveSuggestions& suggestions, vtkPolyData* output)
{
  std::vector<SuggestedCurve> rows;
  for (const Polyline& curve : curves)
  {
    rows.push_back(rowOf(curve));
  }
  const std::size_t first = rows.size();
  rows.insert(rows.end(), suggestions.curves.begin(), suggestions.curves.end());
  writeLines(rows, output);

  vtkCellData* const cells = output->GetCellData();
  const std::size_t count = rows.size();
  const auto addNumbers = [&](const char* name, double SuggestedCurve::*value) {
    addRows<vtkDoubleArray>(cells, name, count, [&](std::size_t c) { return rows[c].*value; });
  };
  addRows<vtkIntArray>(
    cells, "CurveType", count, [&](std::size_t c) { return static_cast<int>(rows[c].curve.type); });
  addRows<vtkStringArray>(
    cells, "CurveName", count, [&](std::size_t c) { return rows[c].curve.name; });
  addRows<vtkIntArray>(cells, "KeyShape", count,
    [&](std::size_t c) { return rows[c].curve.keyShape == KeyShape::Straight ? 1 : 0; });
  addRows<vtkDoubleArray>(
    cells, "LengthTolerance", count, [&](std::size_t c) { return rows[c].curve.tolerance; });
  addEases(cells, count, [&](std::size_t c) { return rows[c].curve.ease; });
  addRows<vtkIntArray>(cells, "Rank", count,
    [&](std::size_t c) { return c < first ? -1 : static_cast<int>(c - first) + 1; });
  addNumbers("Length", &SuggestedCurve::length);
  addNumbers("PredictedGain", &SuggestedCurve::predictedGain);
  addNumbers("Gain", &SuggestedCurve::gain);
  addNumbers("Opening", &SuggestedCurve::opening);
  addNumbers("AreaErrorBefore", &SuggestedCurve::areaErrorBefore);
  addNumbers("AreaErrorAfter", &SuggestedCurve::areaErrorAfter);
  addNumbers("StrainBefore", &SuggestedCurve::strainBefore);
  addNumbers("StrainAfter", &SuggestedCurve::strainAfter);
  addRows<vtkIntArray>(cells, "MirrorOf", count, [&](std::size_t c) {
    return rows[c].mirrorOf == none ? -1 : static_cast<int>(rows[c].mirrorOf) + 1;
  });

  vtkFieldData* const field = output->GetFieldData();
  if (suggestions.mirror && suggestions.mirror->intrinsic())
  {
    const std::array<Point3, 2>& axis = suggestions.mirror->intrinsic()->axis();
    addRows<vtkDoubleArray>(field, "MirrorAxis", 6,
      [&](std::size_t k) { return axis[k / 3][static_cast<Eigen::Index>(k % 3)]; });
  }
  if (suggestions.mirror && suggestions.mirror->plane())
  {
    const SymmetryPlane& plane = *suggestions.mirror->plane();
    addRows<vtkDoubleArray>(field, "MirrorPlane", 4, [&](std::size_t k) {
      return k < 3 ? plane.normal[static_cast<Eigen::Index>(k)] : plane.offset;
    });
  }
}

/// For a warning: how far the strain stays above the bound and where, and what ended the search.
/// Empty where the bound is met, or there is none and no limit of work ended the search.
/// \param curves of the input
std::string describeShortfall(
  const CurveSuggestions& suggestions, double bound, const std::vector<Polyline>& curves)
{
  const std::string byWork =
    "the limit of work ended the search after " + std::to_string(suggestions.trials) + " trials";
  const bool worked = suggestions.end == SearchEnd::WorkUsedUp;
  const std::string interrupted =
    "the search was interrupted after " + std::to_string(suggestions.trials) + " trials";
  if (suggestions.end == SearchEnd::CutsUsedUp && suggestions.cutsNeeded > 0.0)
  {
    return "nothing was tried: the surface takes " +
      std::to_string(std::lround(suggestions.cutsNeeded)) +
      " seams to be opened, more than the cuts allowed; allow as many";
  }
  if (std::isnan(suggestions.strainAfter) && suggestions.end == SearchEnd::Interrupted)
  {
    return interrupted + ", before any cut was found";
  }
  if (std::isnan(suggestions.strainAfter) && worked)
  {
    return byWork +
      ", before the surface could be flattened with any cuts; allow more work, or draw "
      "seams that open the surface";
  }
  if (std::isnan(suggestions.strainAfter))
  {
    const bool keys = std::any_of(curves.begin(), curves.end(),
      [](const Polyline& curve) { return curve.type == CurveType::Key; });
    return keys
      ? "nothing could be tried: the seams that open the surface meet a key curve, or cannot be "
        "made; make it an accessory curve, or draw seams that open the surface"
      : "nothing could be tried: seams that open the surface are not found, or it cannot be "
        "flattened with them; draw seams that open the surface";
  }
  if (suggestions.boundMet || bound == 0.0)
  {
    return suggestions.end == SearchEnd::Interrupted ? interrupted
      : worked && bound == 0.0                       ? byWork + "; allow more work for more cuts"
                                                     : std::string();
  }
  const Point3& p = suggestions.worstPlace;
  const std::string left = "the proposed cuts leave a strain of " +
    shortNumber(suggestions.strainAfter) + " on 95 % of a piece, above the bound of " +
    shortNumber(bound) + ", the largest at (" + shortNumber(p.x()) + ", " + shortNumber(p.y()) +
    ", " + shortNumber(p.z()) + "); ";
  switch (suggestions.end)
  {
    case SearchEnd::WorkUsedUp:
      return left + byWork + "; allow more work, or a larger bound";
    case SearchEnd::Interrupted:
      return left + interrupted;
    case SearchEnd::GivenUp:
      return left + "the search was given up, since " +
        (suggestions.cutsNeeded > 0.0 && suggestions.cutsNeeded < 1e6
            ? "at this rate about " + std::to_string(std::lround(suggestions.cutsNeeded)) +
              " cuts would be needed"
            : std::string("cuts do not help here")) +
        "; smooth the surface, or take a larger bound, or 0 to use up the cuts";
    default:
      return left + "allow more or longer cuts, seams as well as darts, or a larger bound";
  }
}
}
}
}

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
  visit("PieceCount", this->PieceCount);
  visit("Symmetric", this->Symmetric);
  std::string weights = this->GetWeightArray();
  visit("WeightArray", weights);
  if (weights != this->GetWeightArray())
  {
    this->SetWeightArray(weights.c_str());
  }
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
    flattening::bridge::writeTable(
      flattening::bridge::searchTable(suggestions), vtkTable::GetData(outputVector, 6));
    this->LeftOutLines =
      flattening::bridge::makeTable(flattening::bridge::leftOutLines(suggestions));
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
