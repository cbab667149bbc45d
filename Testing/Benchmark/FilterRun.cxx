// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

#include "Base/Stopwatch.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <ctime>
#include <stdexcept>

namespace benchmarks
{
namespace
{
using namespace flattening;

vtkSmartPointer<vtkPolyData> surfaceOf(const RefinedPiece& piece)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& p : piece.mesh.points())
  {
    points->InsertNextPoint(p.x(), p.y(), p.z());
  }
  vtkNew<vtkCellArray> triangles;
  for (const Triangle& t : piece.mesh.triangles())
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

vtkSmartPointer<vtkPolyData> curvesOf(const RefinedPiece& piece, vtkPoints* points)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> types;
  types->SetName("CurveType");
  for (const FeatureCurve& curve : piece.curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.vertices.size()));
    for (const Index v : curve.vertices)
    {
      lines->InsertCellPoint(v);
    }
    types->InsertNextValue(static_cast<int>(curve.type));
  }
  auto curves = vtkSmartPointer<vtkPolyData>::New();
  curves->SetPoints(points);
  curves->SetLines(lines);
  curves->GetCellData()->AddArray(types);
  return curves;
}
}

FilterRun::FilterRun(const RefinedPiece& piece, int interior, bool caching)
{
  const vtkSmartPointer<vtkPolyData> surface = surfaceOf(piece);
  this->Filter->SetInputData(surface);
  this->Filter->SetCurvesData(curvesOf(piece, surface->GetPoints()));
  this->Filter->SetSchemeToGlobal();
  this->Filter->SetDartLegsToFree();
  this->Filter->SetInterior(interior);
  this->Filter->SetCaching(caching);
  this->Filter->ReleaseKeysOn();
}

void FilterRun::update()
{
  this->Filter->Modified();
  const Stopwatch watch;
  const std::clock_t start = std::clock();
  this->Filter->Update();
  const double processor = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double wall = watch.seconds();
  if (this->Filter->IsRefused())
  {
    throw std::runtime_error(this->Filter->GetStatusMessage());
  }
  // The filter reports Core's time by the clock on the wall; its share is what counts.
  this->Core = processor * this->Filter->GetSeconds()[3] / wall;
  this->Overhead = processor - this->Core;
}
}
