// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCurves.h"

#include "CurveList.h"
#include "InputError.h"
#include "ReadCsvCurves.h"
#include "ReadDxfCurves.h"
#include "ReadObj.h"
#include "ReadVtk.h"
#include "TextFile.h"

#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
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
  CurveList curves;
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
    const int type = curveTypeOf(word);
    if (type < 0)
    {
      reader.refuse("unknown curve type " + inQuotes(word) + "; use accessory, key, dart or seam");
    }
    const std::string name(takeWord(rest));
    if (name.empty())
    {
      reader.refuse("the curve has no name; write TYPE NAME v0 v1 ...");
    }
    curves.add(reader.readIds(rest, name), { type, name });
  }
  return curves.polyData(surface->GetPoints());
}

vtkSmartPointer<vtkPolyData> readObjCurves(const std::string& path)
{
  vtkSmartPointer<vtkPolyData> curves = readObj(path).curves;
  if (!curves)
  {
    throw InputError(path, "has no line element ('l'); save the feature curves as lines");
  }
  return curves;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readCurves(const std::string& path, vtkPolyData* surface)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".obj")
  {
    return readObjCurves(path);
  }
  if (extension == ".csv")
  {
    return readCsvCurves(path);
  }
  if (extension == ".dxf")
  {
    return readDxfCurves(path);
  }
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
