// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCurves.h"

#include "BorderWays.h"
#include "CurveList.h"
#include "InputError.h"
#include "ReadCsvCurves.h"
#include "ReadDxfCurves.h"
#include "ReadObj.h"
#include "ReadVtk.h"
#include "TextFile.h"

#include <vtkFlatteningAlgorithm.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
/// A line up to a comment. Within quotes, which begin a word, there is none.
std::string_view withoutComment(std::string_view line)
{
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    if (line[k] == '"' && (quoted || k == 0 || line[k - 1] == ' ' || line[k - 1] == '\t'))
    {
      quoted = !quoted;
    }
    else if (line[k] == '#' && !quoted)
    {
      return line.substr(0, k);
    }
  }
  return line;
}

struct CurveReader
{
  std::string path;
  LineReader lines;
  vtkPolyData* surface;
  std::optional<BorderWays> ways = std::nullopt; ///< made where an edge asks for them

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
      if (id < 0 || id >= this->surface->GetNumberOfPoints())
      {
        this->refuse("curve " + inQuotes(name) + ": vertex id " + std::to_string(id) +
          " is out of range; the surface has " +
          std::to_string(this->surface->GetNumberOfPoints()) + " vertices and ids count from 0");
      }
      ids.push_back(id);
    }
    if (ids.size() < 2)
    {
      this->refuse("curve " + inQuotes(name) + " needs two vertices; the file may be truncated");
    }
    return ids;
  }

  std::vector<vtkIdType> alongBorder(const std::vector<vtkIdType>& ids, const std::string& name)
  {
    if (!this->ways)
    {
      this->ways.emplace(this->surface);
    }
    std::string fault;
    const std::optional<std::vector<vtkIdType>> way = this->ways->through(ids, fault);
    if (!way)
    {
      this->refuse("edge " + inQuotes(name) + ": " + fault);
    }
    return *way;
  }
};

vtkSmartPointer<vtkPolyData> readCurveText(const std::string& path, vtkPolyData* surface)
{
  const std::string text = readWholeFile(path);
  CurveList curves;
  CurveReader reader{ path, LineReader(text), surface };
  std::string line;
  while (reader.lines.next(line))
  {
    std::string_view rest = withoutComment(line);
    const std::string_view word = takeWord(rest);
    if (word.empty())
    {
      continue;
    }
    const bool isEdge = isEdgeWord(word);
    const auto kind = isEdge ? CurveKind() : curveKindOf(word);
    if (!kind)
    {
      reader.refuse(
        "unknown curve type " + inQuotes(word) + "; use " + curveKindWords + ", or edge");
    }
    const std::optional<std::string> name = takeName(rest);
    if (!name)
    {
      reader.refuse("the quotes of the name are not closed; write TYPE \"NAME\" v0 v1 ...");
    }
    if (name->find_first_not_of(" \t") == std::string::npos)
    {
      reader.refuse("the curve has no name; write TYPE NAME v0 v1 ...");
    }
    std::vector<vtkIdType> ids = reader.readIds(rest, *name);
    curves.add(isEdge ? reader.alongBorder(ids, *name) : ids, { *kind, *name });
  }
  return curves.polyData(surface->GetPoints());
}

vtkSmartPointer<vtkPolyData> readObjCurves(const std::string& path)
{
  const ObjContents contents = readObj(path);
  if (!contents.curves)
  {
    throw InputError(path, "has no line element ('l'); save the feature curves as lines");
  }
  vtkFlatteningAlgorithm::SetLengthUnitOf(contents.curves, contents.unit);
  return contents.curves;
}
}

//------------------------------------------------------------------------------
CurveContents readCurves(const std::string& path, vtkPolyData* surface)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".obj")
  {
    return { readObjCurves(path) };
  }
  if (extension == ".csv")
  {
    return { readCsvCurves(path, surface) };
  }
  if (extension == ".dxf")
  {
    return readDxfCurves(path);
  }
  if (extension == ".stl" || extension == ".ply" || extension == ".off" || extension == ".gltf" ||
    extension == ".glb")
  {
    throw InputError(path,
      "curves are read from .vtp, .vtk, .obj, .dxf, .csv or text, not from " + inQuotes(extension));
  }
  if (extension != ".vtp" && extension != ".vtk")
  {
    return { readCurveText(path, surface) };
  }
  vtkSmartPointer<vtkPolyData> curves = readVtk(path);
  if (curves->GetNumberOfLines() == 0)
  {
    throw InputError(path, "has no polyline; save the feature curves as line cells");
  }
  return { curves };
}
}
