// SPDX-License-Identifier: BSD-3-Clause
#include "ImprintOutput.h"

#include "Report/FlatteningData.h"
#include "SurfaceOutput.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace flattening::bridge
{
namespace
{
/// The cell arrays that all data sets of the curves have.
void copyCurveData(
  const CurvedPolyData& source, vtkCellData* cells, std::vector<std::string>& warnings)
{
  std::vector<vtkPolyData*> sources;
  std::vector<vtkSmartPointer<vtkCellData>> arrays;
  std::vector<int> sourceOfCurve;
  const CurveInput& curves = source.curves;
  for (const int number : curves.sourceOfPolyline)
  {
    vtkPolyData* const data = source.sources[static_cast<std::size_t>(number)];
    const auto known = std::find(sources.begin(), sources.end(), data);
    sourceOfCurve.push_back(static_cast<int>(known - sources.begin()));
    if (known == sources.end())
    {
      sources.push_back(data);
      arrays.push_back(wholeCellArrays(data, warnings));
    }
  }
  vtkDataSetAttributes::FieldList common(static_cast<int>(sources.size()));
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    if (s == 0)
    {
      common.InitializeFieldList(arrays[s]);
    }
    else
    {
      common.IntersectFieldList(arrays[s]);
    }
  }
  const vtkIdType count = static_cast<vtkIdType>(curves.cellOfPolyline.size());
  cells->CopyGlobalIdsOff(); // a curve can be joined from several cells
  cells->CopyAllocate(common, count);
  for (vtkIdType c = 0; c < count; ++c)
  {
    cells->CopyData(
      common, arrays[sourceOfCurve[c]], sourceOfCurve[c], curves.cellOfPolyline[c], c);
  }
}
}

void writeImprint(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings)
{
  writeImprintedSurface(source, surface);
  const DataSet data = imprintData({}, source).curves;
  curves->SetPoints(surface->GetPoints());
  curves->SetLines(makeCells(data.lines));
  curves->GetPointData()->ShallowCopy(surface->GetPointData());
  addColumns(curves->GetPointData(), data.pointArrays);
  if (data.lines.size() > 0)
  {
    copyCurveData(source, curves->GetCellData(), warnings);
  }
  addColumns(curves->GetCellData(), data.cellArrays);
}
}
