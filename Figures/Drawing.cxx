// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkGlyph3D.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace figures
{
namespace
{
constexpr Vector surfaceColor{ 0.86, 0.86, 0.83 };

Vector normalized(Vector vector)
{
  vtkMath::Normalize(vector.data());
  return vector;
}

Vector cross(const Vector& a, const Vector& b)
{
  Vector result;
  vtkMath::Cross(a.data(), b.data(), result.data());
  return result;
}

int valueAt(vtkDataArray* array, vtkIdType cell, int otherwise)
{
  return array ? static_cast<int>(array->GetComponent(cell, 0)) : otherwise;
}
}

Vector facing(const PolyData& surface, const Vector& up)
{
  Vector sum{ 0.0, 0.0, 0.0 };
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    Vector origin;
    surface->GetPoint(ids->GetId(0), origin.data());
    for (vtkIdType k = 1; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      Vector a;
      Vector b;
      surface->GetPoint(ids->GetId(k), a.data());
      surface->GetPoint(ids->GetId(k + 1), b.data());
      vtkMath::Subtract(a.data(), origin.data(), a.data());
      vtkMath::Subtract(b.data(), origin.data(), b.data());
      const Vector normal = cross(a, b);
      vtkMath::Add(sum.data(), normal.data(), sum.data());
      area += vtkMath::Norm(normal.data());
    }
  }
  // Bodies face all sides: they are seen from the front, the right and above.
  constexpr double ofPanel = 0.4;
  const bool isBody = vtkMath::Norm(sum.data()) < ofPanel * area;
  const Vector direction = normalized(sum);
  const Vector oblique = up[1] > 0.0 ? Vector{ 0.8, 0.7, 0.9 } : Vector{ 0.8, -0.9, 0.7 };
  return !isBody && std::abs(vtkMath::Dot(direction.data(), up.data())) < 0.8 ? direction : oblique;
}

Vector upOf(const PolyData& surface)
{
  const double* const bounds = surface->GetBounds();
  return bounds[3] - bounds[2] > bounds[5] - bounds[4] ? Vector{ 0.0, 1.0, 0.0 }
                                                       : Vector{ 0.0, 0.0, 1.0 };
}

vtkSmartPointer<vtkLookupTable> makeColors(ColorRange range)
{
  const bool turned = range.low > range.high;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  table->SetHueRange(turned ? 0.0 : 2.0 / 3.0, turned ? 2.0 / 3.0 : 0.0);
  table->SetRampToLinear();
  table->SetTableRange(std::min(range.low, range.high), std::max(range.low, range.high));
  table->Build();
  return table;
}

vtkSmartPointer<vtkLookupTable> makeCategories(const std::vector<Vector>& colors, int count)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(count);
  table->SetTableRange(-0.5, count - 0.5);
  for (int k = 0; k < count; ++k)
  {
    const Vector& color = colors[k % colors.size()];
    table->SetTableValue(k, color[0], color[1], color[2]);
  }
  return table;
}

vtkSmartPointer<vtkScalarBarActor> makeScaleBar(vtkLookupTable* colors, int labels, int textSize)
{
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colors);
  bar->SetOrientationToHorizontal();
  bar->SetNumberOfLabels(labels);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  vtkTextProperty* const property = bar->GetLabelTextProperty();
  property->SetColor(0.0, 0.0, 0.0);
  property->SetFontSize(textSize);
  property->BoldOff();
  property->ItalicOff();
  property->ShadowOff();
  return bar;
}

Drawing::Drawing()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
}

void Drawing::setTitle(const std::string& title)
{
  this->Title = vtkSmartPointer<vtkTextActor>::New();
  this->Title->SetInput(title.c_str());
  vtkTextProperty* const text = this->Title->GetTextProperty();
  text->SetColor(0.0, 0.0, 0.0);
  text->SetFontSize(18);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  this->Renderer->AddViewProp(this->Title);
}

void Drawing::lookFrom(const Vector& direction, const Vector& up)
{
  this->InSpace = true;
  this->Back = normalized(direction);
  this->Right = normalized(cross(up, this->Back));
  this->Up = cross(this->Back, this->Right);
}

vtkActor* Drawing::addActor(const PolyData& data, bool interpolated)
{
  this->Shown.push_back(data);
  vtkNew<vtkPolyDataMapper> mapper;
  if (this->InSpace)
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(data);
    normals->SplittingOff();
    normals->ConsistencyOff();
    mapper->SetInputConnection(normals->GetOutputPort());
  }
  else
  {
    mapper->SetInputData(data);
  }
  mapper->SetInterpolateScalarsBeforeMapping(interpolated);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(this->InSpace);
  // Shaded enough to show the form, and not more, so that colors stay readable.
  actor->GetProperty()->SetAmbient(0.5);
  actor->GetProperty()->SetDiffuse(0.5);
  this->Renderer->AddActor(actor);
  return actor;
}

void Drawing::addSurface(const PolyData& surface)
{
  const Vector& color = surfaceColor;
  this->addActor(surface, false)->GetProperty()->SetColor(color[0], color[1], color[2]);
}

void Drawing::addGhost(const PolyData& surface)
{
  constexpr double opacity = 0.35;
  vtkProperty* const property = this->addActor(surface, true)->GetProperty();
  property->SetColor(0.5, 0.5, 0.5);
  property->SetOpacity(opacity);
}

void Drawing::addPointMap(const PolyData& surface, const char* array, ColorRange range)
{
  this->addMap(surface, array, true, makeColors(range));
}

void Drawing::addCellMap(const PolyData& surface, const char* array, ColorRange range)
{
  this->addMap(surface, array, false, makeColors(range));
}

void Drawing::addMap(
  const PolyData& surface, const char* array, bool onPoints, vtkLookupTable* colors)
{
  colorBy(this->addActor(surface, onPoints)->GetMapper(), array, onPoints, colors);
}

void colorBy(vtkMapper* mapper, const char* array, bool onPoints, vtkLookupTable* colors)
{
  mapper->ScalarVisibilityOn();
  mapper->SetScalarMode(
    onPoints ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectColorArray(array);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
}

void Drawing::addCategories(const PolyData& surface, const char* array)
{
  // Twelve light colors, far apart from one to the next.
  static const std::vector<Vector> colors{ { 0.99, 0.71, 0.38 }, { 0.55, 0.83, 0.78 },
    { 0.74, 0.73, 0.95 }, { 0.98, 0.50, 0.45 }, { 0.70, 0.87, 0.41 }, { 0.50, 0.69, 0.83 },
    { 1.00, 0.93, 0.44 }, { 0.99, 0.80, 0.90 }, { 0.60, 0.60, 0.60 }, { 0.74, 0.50, 0.74 },
    { 0.80, 0.92, 0.77 }, { 0.80, 0.65, 0.45 } };
  vtkDataArray* const numbers = surface->GetCellData()->GetArray(array);
  const int count = numbers ? static_cast<int>(numbers->GetRange()[1]) + 1 : 1;
  this->addMap(surface, array, false, makeCategories(colors, count));
}

std::array<WireGroup, 5> groupWires(vtkPolyData* wires, DartSides sides)
{
  std::array<WireGroup, 5> groups{ { { accessoryColor, {} }, { keyColor, {} }, { dartColor, {} },
    { seamColor, {} }, { boundaryColor, {} } } };
  vtkDataArray* const types = wires->GetCellData()->GetArray("CurveType");
  vtkDataArray* const boundary = wires->GetCellData()->GetArray("Boundary");
  for (vtkIdType cell = 0; cell < wires->GetNumberOfCells(); ++cell)
  {
    const int type = valueAt(types, cell, 0);
    // The sides of an opened dart bound the piece.
    const bool dart = type == 2 && sides == DartSides::Blue;
    const bool bounds = type < 0 || (!dart && valueAt(boundary, cell, 0) != 0);
    const auto kind = static_cast<std::size_t>(std::min(type, 3));
    groups[bounds ? groups.size() - 1 : kind].cells.push_back(cell);
  }
  return groups;
}

void Drawing::addWires(const PolyData& wires, DartSides sides)
{
  double lift = 1.0;
  for (const WireGroup& group : groupWires(wires, sides))
  {
    this->addEdges(wires, group.cells, group.color, lift);
    lift = std::min(lift + 1.0, 3.0);
  }
}

PolyData boundaryOf(const PolyData& surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

void Drawing::addBoundary(const PolyData& surface)
{
  const PolyData edges = boundaryOf(surface);
  std::vector<vtkIdType> cells(edges->GetNumberOfCells());
  std::iota(cells.begin(), cells.end(), 0);
  this->addEdges(edges, cells, boundaryColor, 3.0);
}

void Drawing::addEdges(
  const PolyData& lines, const std::vector<vtkIdType>& cells, const Vector& color, double lift)
{
  // Edge by edge: a tube along a whole polyline has no good shape where it turns back at a dart's
  // tip.
  vtkNew<vtkCellArray> edges;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<vtkIdType, vtkIdType> copies;
  const auto copyOf = [&](vtkIdType point) {
    const auto found = copies.find(point);
    return found != copies.end()
      ? found->second
      : copies.emplace(point, points->InsertNextPoint(lines->GetPoint(point))).first->second;
  };
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    lines->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType ends[2] = { copyOf(ids->GetId(k)), copyOf(ids->GetId(k + 1)) };
      edges->InsertNextCell(2, ends);
    }
  }
  if (edges->GetNumberOfCells() > 0)
  {
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(edges);
    this->Shown.push_back(data);
    this->Wires.push_back({ data, color, lift });
  }
}

void Drawing::drawWires(const WireSet& set, double radius)
{
  // In the plane the last drawn lies on top; in space depth decides.
  const double lift = this->InSpace ? 0.0 : 2.0 * radius * set.lift;
  const PolyData edges = moved(set.edges, 0.0, 0.0, lift);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(edges);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(12);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(16);
  vtkNew<vtkGlyph3D> balls;
  balls->SetInputData(edges);
  balls->SetSourceConnection(ball->GetOutputPort());
  balls->ScalingOff();
  for (vtkAlgorithm* shape :
    { static_cast<vtkAlgorithm*>(tubes), static_cast<vtkAlgorithm*>(balls) })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(shape->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(set.color[0], set.color[1], set.color[2]);
    this->Renderer->AddActor(actor);
  }
}

std::array<double, 6> Drawing::extent() const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 6> range{ infinity, -infinity, infinity, -infinity, infinity, -infinity };
  const std::array<const Vector*, 3> axes{ &this->Right, &this->Up, &this->Back };
  for (const PolyData& data : this->Shown)
  {
    for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k)
    {
      double point[3];
      data->GetPoint(k, point);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double value = vtkMath::Dot(point, axes[axis]->data());
        range[2 * axis] = std::min(range[2 * axis], value);
        range[2 * axis + 1] = std::max(range[2 * axis + 1], value);
      }
    }
  }
  return this->Shown.empty() ? std::array<double, 6>{} : range;
}

std::array<double, 2> Drawing::size() const
{
  const std::array<double, 6> range = this->extent();
  return { range[1] - range[0], range[3] - range[2] };
}

void Drawing::finish(const std::array<int, 4>& area, double pixel, const FigureStyle& style)
{
  for (const WireSet& set : this->Wires)
  {
    this->drawWires(set, 0.5 * style.wireWidth * pixel);
  }
  this->Wires.clear();

  const int* const window = this->Renderer->GetRenderWindow()->GetSize();
  this->Renderer->SetViewport(static_cast<double>(area[0]) / window[0],
    static_cast<double>(area[1]) / window[1], static_cast<double>(area[0] + area[2]) / window[0],
    static_cast<double>(area[1] + area[3]) / window[1]);
  double down = 0.0;
  if (this->Title)
  {
    this->Title->SetPosition(0.5 * area[2], area[3] - 0.5 * style.titleHeight);
    down = 0.5 * style.titleHeight * pixel;
  }

  const std::array<double, 6> range = this->extent();
  const double distance = range[5] - range[4] + 1e3 * pixel;
  Vector center;
  Vector eye;
  for (int k = 0; k < 3; ++k)
  {
    center[k] = 0.5 * (range[0] + range[1]) * this->Right[k] +
      (0.5 * (range[2] + range[3]) + down) * this->Up[k] +
      0.5 * (range[4] + range[5]) * this->Back[k];
    eye[k] = center[k] + distance * this->Back[k];
  }
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(center.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(this->Up.data());
  camera->SetParallelScale(0.5 * pixel * area[3]);
  this->Renderer->ResetCameraClippingRange();
}
}
