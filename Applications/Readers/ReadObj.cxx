// SPDX-License-Identifier: BSD-3-Clause
#include "ReadObj.h"

#include "CurveList.h"
#include "InputError.h"
#include "TextFile.h"
#include "Units.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
struct ObjReader
{
  std::string path;
  LineReader lines;
  vtkPoints* points;
  std::vector<vtkIdType> ids;

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  void readPoint(std::string_view rest) const
  {
    double x[3];
    for (double& coordinate : x)
    {
      const std::string_view word = takeWord(rest);
      if (word.empty())
      {
        this->refuse("a vertex needs three coordinates; the file may be truncated");
      }
      if (!parseNumber(word, coordinate))
      {
        this->refuse(inQuotes(word) + " is not a coordinate; write a decimal number");
      }
    }
    this->points->InsertNextPoint(x);
  }

  void readIds(std::string_view rest)
  {
    this->ids.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      long long id = 0;
      if (!parseInteger(word.substr(0, word.find('/')), id))
      {
        this->refuse(inQuotes(word) + " is not a vertex id; write v, v/vt, v//vn or v/vt/vn");
      }
      const vtkIdType count = this->points->GetNumberOfPoints();
      if (id == 0 || id > count || id < -count)
      {
        this->refuse("vertex id " + std::to_string(id) + " is out of range; " +
          std::to_string(count) +
          " vertices stand above this line and ids count from 1, or from -1 backwards");
      }
      this->ids.push_back(static_cast<vtkIdType>(id > 0 ? id - 1 : count + id));
    }
  }
};
}

//------------------------------------------------------------------------------
ObjContents readObj(const std::string& path)
{
  const std::string text = readWholeFile(path);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  CurveList curves;
  CurveTitle title;
  std::string unit;

  ObjReader reader{ path, LineReader(text), points, {} };
  std::string line;
  while (reader.lines.next(line))
  {
    std::string_view rest(line);
    const std::string_view keyword = takeWord(rest);
    if (keyword == "v")
    {
      reader.readPoint(rest);
    }
    else if (keyword == "f")
    {
      reader.readIds(rest);
      if (reader.ids.size() < 3)
      {
        reader.refuse("a face needs three vertices; the file may be truncated");
      }
      polygons->InsertNextCell(static_cast<vtkIdType>(reader.ids.size()), reader.ids.data());
    }
    else if (keyword == "l")
    {
      reader.readIds(rest);
      if (reader.ids.size() < 2)
      {
        reader.refuse("a line needs two vertices; the file may be truncated");
      }
      curves.add(reader.ids, title);
    }
    else if (keyword == "g" || keyword == "o")
    {
      title = curveTitle(rest);
    }
    else if (unit.empty() && !keyword.empty() && keyword.front() == '#')
    {
      unit = unitInComment(line);
    }
  }
  if (points->GetNumberOfPoints() == 0)
  {
    throw InputError(path, "has no vertex ('v' line); it may be no OBJ file or be truncated");
  }

  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return { surface, curves.empty() ? nullptr : curves.polyData(points), unit };
}
}
