// SPDX-License-Identifier: BSD-3-Clause
#include "Proposals.h"

#include "Files.h"
#include "LiveFlattening.h"
#include "WindowWords.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkFeatureCurveSuggestion.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkStringArray.h>

namespace editor
{
namespace
{
/// How far an accepted curve may be from the one proposed, as a fraction of its length.
constexpr double nearness = 1e-4;

/// Hands on what a search has found so far.
class Preview : public vtkCommand
{
public:
  static Preview* New() { return new Preview; }
  void Execute(vtkObject*, unsigned long, void* lines) override
  {
    this->show(static_cast<vtkPolyData*>(lines));
  }

  std::function<void(vtkPolyData*)> show;
};

Proposal proposalOf(vtkPolyData* curves, vtkIdType cell)
{
  vtkCellData* const data = curves->GetCellData();
  const auto number = [&](const char* name) { return data->GetArray(name)->GetComponent(cell, 0); };
  Proposal proposal;
  proposal.name = vtkStringArray::SafeDownCast(data->GetAbstractArray("CurveName"))->GetValue(cell);
  proposal.type = static_cast<int>(number("CurveType"));
  proposal.length = number("Length");
  proposal.strainBefore = number("StrainBefore");
  proposal.strainAfter = number("StrainAfter");
  proposal.points = vtkSmartPointer<vtkPoints>::New();
  proposal.points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  curves->GetCellPoints(cell, ids);
  for (const vtkIdType id : *ids)
  {
    proposal.points->InsertNextPoint(curves->GetPoint(id));
  }
  return proposal;
}
}

Proposals propose(vtkPolyData* surface, vtkPolyData* curves, const std::string& weights,
  const std::function<bool(const std::string&)>& goOn,
  const std::function<void(vtkPolyData*)>& preview)
{
  vtkNew<vtkFeatureCurveSuggestion> filter;
  figures::silence(filter);
  Proposals proposals;
  vtkNew<Stopper> stopper;
  stopper->isOver = [&] {
    const char* const phase = filter->GetProgressText();
    proposals.stopped = proposals.stopped || !goOn(phase ? phase : "");
    return proposals.stopped;
  };
  filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  vtkNew<Preview> watched;
  watched->show = preview;
  filter->AddObserver(vtkFeatureCurveSuggestion::PreviewEvent, watched);
  filter->SetSchemeToIsometric();
  filter->ReleaseTrialsOff();
  filter->SetWeightArray(weights.c_str());
  filter->SetInputData(surface);
  filter->SetCurvesData(curves);
  filter->Update();

  proposals.message = proposals.stopped ? "" : messageOf(filter);
  vtkPolyData* const found = filter->GetOutput(5);
  vtkDataArray* const ranks = found->GetCellData()->GetArray("Rank");
  for (vtkIdType cell = 0; ranks && cell < found->GetNumberOfCells(); ++cell)
  {
    if (ranks->GetComponent(cell, 0) > 0.0)
    {
      proposals.cuts.push_back(proposalOf(found, cell));
    }
  }
  vtkFieldData* const field = found->GetFieldData();
  proposals.mirror = field->HasArray("MirrorPlane") ? "a plane"
    : field->HasArray("MirrorAxis")                 ? "an axis of the cloth, though not in space"
                                                    : "";
  return proposals;
}

std::vector<std::string> weightArrays(vtkPolyData* surface)
{
  std::vector<std::string> names;
  vtkCellData* const data = surface->GetCellData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const array = data->GetArray(k);
    // Its range leaves out numbers that are none, which the search refuses by their cells.
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      array->GetRange()[0] >= 0.0 && array->GetRange()[1] > 0.0)
    {
      names.emplace_back(array->GetName());
    }
  }
  return names;
}

bool accept(const Proposal& proposal, vtkFeatureCurveEditor* curves)
{
  const int curve = curves->GetNumberOfCurves();
  curves->BeginGroup();
  const bool added =
    curves->AddStroke(proposal.points, nearness * proposal.length, vtkFeatureCurveEditor::GEODESIC);
  if (added)
  {
    curves->SetCurveType(curve, proposal.type);
    curves->SetCurveName(curve, proposal.name); // another may have it, then it keeps its own
  }
  curves->EndGroup();
  return added;
}

figures::PolyData linesOf(const std::vector<Proposal>& proposals)
{
  figures::PolyData lines = figures::PolyData::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Proposal& proposal : proposals)
  {
    const vtkIdType count = proposal.points->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(count));
    for (vtkIdType k = 0; k < count; ++k)
    {
      cells->InsertCellPoint(points->InsertNextPoint(proposal.points->GetPoint(k)));
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  return lines;
}
}
