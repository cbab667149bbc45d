// SPDX-License-Identifier: BSD-3-Clause
#include "ImprintOutput.h"

#include "FieldArrays.h"
#include "Input/Columns.h"
#include "SurfaceOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace bridge
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

double length(const TriangleMesh& mesh, const Indices& chain)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    sum += (mesh.point(chain[i]) - mesh.point(chain[i - 1])).norm();
  }
  return sum;
}

void writePlanarShapes(const std::vector<FeatureCurve>& curves, vtkPolyData* output)
{
  const bool any = std::any_of(curves.begin(), curves.end(),
    [](const FeatureCurve& curve) { return curve.keyShape == KeyShape::Planar; });
  if (!any)
  {
    return;
  }
  vtkNew<vtkDoubleArray> shape;
  shape->SetName("PlanarShape");
  shape->SetNumberOfComponents(2);
  shape->SetNumberOfTuples(output->GetNumberOfPoints());
  shape->Fill(std::numeric_limits<double>::quiet_NaN());
  for (const FeatureCurve& curve : curves)
  {
    for (std::size_t i = 0; i < curve.planarShape.size(); ++i)
    {
      shape->SetTypedTuple(curve.vertices[i], curve.planarShape[i].data());
    }
  }
  output->GetPointData()->AddArray(shape);
}

void writeCurves(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* output,
  std::vector<std::string>& warnings)
{
  const std::vector<FeatureCurve>& curves = source.imprinted.curves;
  const std::size_t count = curves.size();
  vtkNew<vtkCellArray> lines;
  for (const FeatureCurve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.vertices.size()));
    for (const Index v : curve.vertices)
    {
      lines->InsertCellPoint(v);
    }
  }
  output->SetPoints(surface->GetPoints());
  output->SetLines(lines);
  output->GetPointData()->ShallowCopy(surface->GetPointData());
  writePlanarShapes(curves, output);

  vtkCellData* cells = output->GetCellData();
  if (count > 0)
  {
    copyCurveData(source, cells, warnings);
  }
  addRows<vtkIntArray>(
    cells, "CurveType", count, [&](std::size_t c) { return static_cast<int>(curves[c].type); });
  addRows<vtkStringArray>(cells, "CurveName", count, [&](std::size_t c) { return curves[c].name; });
  addRows<vtkIntArray>(cells, "KeyShape", count,
    [&](std::size_t c) { return curves[c].keyShape == KeyShape::Straight ? 1 : 0; });
  addRows<vtkDoubleArray>(
    cells, "LengthTolerance", count, [&](std::size_t c) { return curves[c].tolerance; });
  Columns eases;
  addEases(eases, count, [&](std::size_t c) { return curves[c].ease; });
  addColumns(cells, eases);
  addRows<vtkIdTypeArray>(
    cells, "CurveId", count, [](std::size_t c) { return static_cast<vtkIdType>(c); });
  addRows<vtkDoubleArray>(cells, "RestLength", count,
    [&](std::size_t c) { return length(source.imprinted.mesh, curves[c].vertices); });
  addRows<vtkIdTypeArray>(cells, "vtkOriginalCellIds", count,
    [&](std::size_t c) { return source.curves.cellOfPolyline[c]; });
}
}

void writeImprint(const CurvedPolyData& source, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings)
{
  writeImprintedSurface(source, surface);
  writeCurves(source, surface, curves, warnings);
}
}
}
