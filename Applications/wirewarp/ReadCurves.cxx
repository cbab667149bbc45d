// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCurves.h"

#include "InputError.h"
#include "ReadVtk.h"
#include "TextFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
/// The value of the cell array CurveType, -1 for a word that is no type.
int parseType(std::string_view word)
{
  static constexpr std::array<std::string_view, 4> types{ "accessory", "key", "dart", "seam" };
  const auto* const found = std::find(types.begin(), types.end(), word);
  return found == types.end() ? -1 : static_cast<int>(found - types.begin());
}

struct CurveReader
{
  std::string path;
  LineReader lines;
  vtkIdType pointCount;

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  std::vector<vtkIdType> readIds(std::string_view rest, const std::string& name) const
  {
    std::vector<vtkIdType> ids;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      long long id = 0;
      if (!parseInteger(word, id))
      {
        this->refuse(
          inQuotes(word) + " is not a vertex id; write TYPE NAME v0 v1 ... with whole numbers");
      }
      if (id < 0 || id >= this->pointCount)
      {
        this->refuse("curve " + inQuotes(name) + ": vertex id " + std::to_string(id) +
          " is out of range; the surface has " + std::to_string(this->pointCount) +
          " vertices and ids count from 0");
      }
      ids.push_back(id);
    }
    if (ids.size() < 2)
    {
      this->refuse("curve " + inQuotes(name) + " needs two vertices; the file may be truncated");
    }
    return ids;
  }
};

vtkSmartPointer<vtkPolyData> readCurveText(const std::string& path, vtkPolyData* surface)
{
  const std::string text = readWholeFile(path);
  vtkNew<vtkCellArray> polylines;
  vtkNew<vtkIntArray> curveType;
  curveType->SetName("CurveType");
  vtkNew<vtkStringArray> curveName;
  curveName->SetName("CurveName");

  CurveReader reader{ path, LineReader(text), surface->GetNumberOfPoints() };
  std::string line;
  while (reader.lines.next(line))
  {
    std::string_view rest(line);
    rest = rest.substr(0, rest.find('#'));
    const std::string_view word = takeWord(rest);
    if (word.empty())
    {
      continue;
    }
    const int type = parseType(word);
    if (type < 0)
    {
      reader.refuse("unknown curve type " + inQuotes(word) + "; use accessory, key, dart or seam");
    }
    std::string name(takeWord(rest));
    std::replace(name.begin(), name.end(), '\0', ' '); // VTK ends a text there when it writes it
    if (name.empty())
    {
      reader.refuse("the curve has no name; write TYPE NAME v0 v1 ...");
    }
    const std::vector<vtkIdType> ids = reader.readIds(rest, name);
    polylines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    curveType->InsertNextValue(type);
    curveName->InsertNextValue(name);
  }

  auto curves = vtkSmartPointer<vtkPolyData>::New();
  curves->SetPoints(surface->GetPoints());
  curves->SetLines(polylines);
  curves->GetCellData()->AddArray(curveType);
  curves->GetCellData()->AddArray(curveName);
  return curves;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readCurves(const std::string& path, vtkPolyData* surface)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension != ".vtp" && extension != ".vtk")
  {
    return readCurveText(path, surface);
  }
  vtkSmartPointer<vtkPolyData> curves = readVtk(path);
  if (curves->GetNumberOfLines() == 0)
  {
    throw InputError(path, "has no polyline; save the feature curves as line cells");
  }
  return curves;
}
}
