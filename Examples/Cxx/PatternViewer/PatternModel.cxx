// SPDX-License-Identifier: BSD-3-Clause
#include "PatternModel.h"

#include "Files.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <cstdio>
#include <stdexcept>

namespace viewer
{
namespace
{
/// Cell array that tells released curves from wires.
const char* const mark = "Released";

PolyData marked(const PolyData& data, bool released)
{
  PolyData result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(data);
  vtkNew<vtkIntArray> marks;
  marks->SetName(mark);
  marks->SetNumberOfTuples(data->GetNumberOfCells());
  marks->FillValue(released ? 1 : 0);
  result->GetCellData()->AddArray(marks);
  return result;
}
}

//------------------------------------------------------------------------------
const char* nameOf(Role role)
{
  switch (role)
  {
    case Role::Accessory:
      return "accessory";
    case Role::Key:
      return "key";
    case Role::Released:
      return "released";
    default:
      return "cut";
  }
}

//------------------------------------------------------------------------------
PatternModel::PatternModel(
  const PolyData& surface, const PolyData& curves, const PolyData& released)
{
  figures::silence(this->Imprinter);
  figures::silence(this->Filter);
  // Imprinted once, so that the mesh stays the same whatever the roles are.
  this->Imprinter->SetInputDataObject(0, marked(surface, false));
  if (curves)
  {
    this->Imprinter->AddInputDataObject(1, marked(curves, false));
  }
  if (released)
  {
    this->Imprinter->AddInputDataObject(1, marked(released, true));
  }
  this->Imprinter->Update();
  if (this->Imprinter->IsRefused())
  {
    throw std::runtime_error(this->Imprinter->GetStatusMessage());
  }
  vtkPolyData* const all = this->Imprinter->GetOutput(1);
  vtkDataArray* const types = all->GetCellData()->GetArray("CurveType");
  vtkDataArray* const marks = all->GetCellData()->GetArray(mark);
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    const int type = static_cast<int>(types->GetComponent(cell, 0));
    this->Roles.push_back(type > vtkWireWarpingFilter::KEY ? Role::Cut
        : marks->GetComponent(cell, 0) != 0.0              ? Role::Released
        : type == vtkWireWarpingFilter::KEY                ? Role::Key
                                                           : Role::Accessory);
  }
  this->findEdges();
}

//------------------------------------------------------------------------------
std::string PatternModel::curveName(int curve) const
{
  auto* const names = vtkStringArray::SafeDownCast(
    this->Imprinter->GetOutput(1)->GetCellData()->GetAbstractArray("CurveName"));
  return names ? names->GetValue(curve) : "curve " + std::to_string(curve);
}

//------------------------------------------------------------------------------
void PatternModel::findEdges()
{
  vtkPolyData* const surface = this->Imprinter->GetOutput(0);
  vtkPolyData* const curves = this->Imprinter->GetOutput(1);
  surface->BuildLinks();
  vtkNew<vtkIdList> points;
  vtkNew<vtkIdList> triangles;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfCells(); ++cell)
  {
    std::vector<Edge> edges;
    curves->GetCellPoints(cell, points);
    for (vtkIdType k = 0; k + 1 < points->GetNumberOfIds(); ++k)
    {
      const vtkIdType start = points->GetId(k);
      const vtkIdType end = points->GetId(k + 1);
      surface->GetCellEdgeNeighbors(-1, start, end, triangles);
      if (triangles->GetNumberOfIds() > 0)
      {
        edges.push_back({ triangles->GetId(0), start, end });
      }
    }
    this->Edges.push_back(edges);
  }
}

//------------------------------------------------------------------------------
PolyData PatternModel::curvesOf(bool released) const
{
  vtkPolyData* const all = this->Imprinter->GetOutput(1);
  PolyData result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(all->GetPoints());
  result->GetPointData()->PassData(all->GetPointData());
  result->GetCellData()->CopyAllocate(all->GetCellData());
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> types;
  types->SetName("CurveType");
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    if ((this->Roles[cell] == Role::Released) == released)
    {
      all->GetCellPoints(cell, points);
      const vtkIdType to = lines->InsertNextCell(points);
      result->GetCellData()->CopyData(all->GetCellData(), cell, to);
      const bool key = this->Roles[cell] == Role::Key;
      const bool cut = this->Roles[cell] == Role::Cut;
      types->InsertNextValue(cut
          ? static_cast<int>(all->GetCellData()->GetArray("CurveType")->GetComponent(cell, 0))
          : key ? vtkWireWarpingFilter::KEY
                : vtkWireWarpingFilter::ACCESSORY);
    }
  }
  result->SetLines(lines);
  result->GetCellData()->AddArray(types);
  result->GetCellData()->RemoveArray(mark);
  return result;
}

//------------------------------------------------------------------------------
void PatternModel::flatten()
{
  this->Filter->SetInputData(this->Imprinter->GetOutput(0));
  this->Filter->SetCurvesData(this->curvesOf(false));
  this->Filter->Update();
  if (this->Filter->IsRefused())
  {
    throw std::runtime_error(this->Filter->GetStatusMessage());
  }
  this->Message = this->Filter->GetStatusMessage();
  // Copies, so that a later refusal leaves the last result.
  for (auto [piece, port] : { std::pair(&this->Result.flat, 0), std::pair(&this->Result.wires, 1),
         std::pair(&this->Result.cut, 2) })
  {
    *piece = vtkSmartPointer<vtkPolyData>::New();
    (*piece)->ShallowCopy(this->Filter->GetOutput(port));
  }
  this->updateCopies();
}

//------------------------------------------------------------------------------
void PatternModel::updateCopies()
{
  vtkDataArray* const originals = this->Result.flat->GetCellData()->GetArray("vtkOriginalCellIds");
  this->TriangleCopies.assign(this->Imprinter->GetOutput(0)->GetNumberOfCells(), -1);
  for (vtkIdType cell = 0; cell < originals->GetNumberOfTuples(); ++cell)
  {
    this->TriangleCopies[static_cast<vtkIdType>(originals->GetComponent(cell, 0))] = cell;
  }
}

//------------------------------------------------------------------------------
bool PatternModel::advance(int curve)
{
  const Role before = this->Roles[curve];
  if (before == Role::Cut)
  {
    this->Message = this->curveName(curve) + " is cut; only accessory and key curves can change";
    return false;
  }
  this->Roles[curve] = before == Role::Accessory ? Role::Key
    : before == Role::Key                        ? Role::Released
                                                 : Role::Accessory;
  try
  {
    this->flatten();
  }
  catch (const std::runtime_error& error)
  {
    this->Roles[curve] = before;
    this->Message = error.what();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<Segment> PatternModel::segments(int curve, bool inPlane) const
{
  const PolyData& data = inPlane ? this->Result.flat : this->Result.cut;
  vtkDataArray* const originals = data->GetPointData()->GetArray("vtkOriginalPointIds");
  std::vector<Segment> result;
  vtkNew<vtkIdList> corners;
  for (const Edge& edge : this->Edges[curve])
  {
    Segment segment{};
    data->GetCellPoints(this->TriangleCopies[edge.triangle], corners);
    for (const vtkIdType corner : *corners)
    {
      const auto original = static_cast<vtkIdType>(originals->GetComponent(corner, 0));
      if (original == edge.start)
      {
        data->GetPoint(corner, segment.start.data());
      }
      else if (original == edge.end)
      {
        data->GetPoint(corner, segment.end.data());
      }
    }
    result.push_back(segment);
  }
  return result;
}

//------------------------------------------------------------------------------
PolyData PatternModel::releasedLines(bool inPlane) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int curve = 0; curve < this->numberOfCurves(); ++curve)
  {
    if (this->Roles[curve] != Role::Released)
    {
      continue;
    }
    for (const Segment& segment : this->segments(curve, inPlane))
    {
      const vtkIdType ends[2] = { points->InsertNextPoint(segment.start.data()),
        points->InsertNextPoint(segment.end.data()) };
      lines->InsertNextCell(2, ends);
    }
  }
  PolyData result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> PatternModel::writeCurves(const std::string& prefix) const
{
  std::vector<std::string> files{ prefix + "_curves.vtp" };
  figures::writePolyData(files[0], this->curvesOf(false));
  const std::string other = prefix + "_released.vtp";
  const PolyData released = this->curvesOf(true);
  if (released->GetNumberOfCells() > 0)
  {
    figures::writePolyData(other, released);
    files.push_back(other);
  }
  else
  {
    std::remove(other.c_str()); // of an earlier state
  }
  return files;
}

//------------------------------------------------------------------------------
void PatternModel::writePattern(const std::string& path, const std::string& unit) const
{
  figures::writePattern(path, this->Result, unit);
}
}
