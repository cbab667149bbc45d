// SPDX-License-Identifier: BSD-3-Clause
#include "DataSpecimens.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <filesystem>

namespace hostile
{
namespace
{
namespace fs = std::filesystem;

vtkSmartPointer<vtkPolyData> readFile(const fs::path& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

Point3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Point3 p;
  data->GetPoint(id, p.data());
  return p;
}

std::vector<Polyline> readCurves(vtkPolyData* data)
{
  std::vector<Polyline> curves;
  vtkDataArray* types = data->GetCellData()->GetArray("CurveType");
  auto cells = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdList* ids = cells->GetCurrentCell();
    Polyline curve;
    curve.name = "c" + std::to_string(curves.size());
    if (types)
    {
      curve.type = static_cast<CurveType>(types->GetTuple1(cells->GetCurrentCellId()));
    }
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      curve.points.push_back(pointOf(data, ids->GetId(k)));
      curve.pointIds.push_back(static_cast<Index>(ids->GetId(k)));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Specimen> readAll()
{
  std::vector<fs::path> files;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(FLATTENING_DATA_DIR, failure))
  {
    if (entry.path().extension() == ".vtp")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Specimen> specimens;
  for (const fs::path& file : files)
  {
    const std::string name = file.stem().string();
    const std::size_t mark = name.find("_curves");
    if (mark == std::string::npos)
    {
      continue;
    }
    const auto data = readFile(file.parent_path() / (name.substr(0, mark) + ".vtp"));
    Specimen specimen;
    specimen.name = name;
    for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
    {
      specimen.points.push_back(pointOf(data, p));
    }
    auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      vtkIdList* ids = cells->GetCurrentCell();
      specimen.triangles.push_back({ static_cast<Index>(ids->GetId(0)),
        static_cast<Index>(ids->GetId(1)), static_cast<Index>(ids->GetId(2)) });
    }
    specimen.curves = readCurves(readFile(file));
    specimens.push_back(std::move(specimen));
  }
  return specimens;
}
}

const std::vector<Specimen>& dataSpecimens()
{
  static const std::vector<Specimen> specimens = readAll();
  return specimens;
}
}
