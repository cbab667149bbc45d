// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCurves.h"

#include "BorderWays.h"
#include "BoundaryLoops.h"
#include "CurveList.h"
#include "CurveWords.h"
#include "InputError.h"
#include "ReadCsvCurves.h"
#include "ReadDxfCurves.h"
#include "ReadObj.h"
#include "ReadVtk.h"
#include "TextFile.h"
#include "TriangleList.h"
#include "Units.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
  const DataSet& surface;
  CurveWords named;
  std::optional<BorderWays> ways = std::nullopt; ///< made where an edge needs them
  std::shared_ptr<Points3> points = nullptr;     ///< those of the surface and new ones, if any

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  /// The point of the surface with an id, or a new one at coordinates.
  std::int64_t pointOf(std::string_view word, const std::string& name, bool isEdge)
  {
    long long id = 0;
    if (word.find(',') != std::string_view::npos)
    {
      return this->pointAt(word, name, isEdge);
    }
    if (!parseInteger(word, id))
    {
      this->refuse(inQuotes(word) +
        " is not a vertex id; write TYPE NAME v0 v1 ... with whole numbers, or points as x,y,z");
    }
    const auto count = static_cast<long long>(this->surface.points->size());
    if (id < 0 || id >= count)
    {
      this->refuse("curve " + inQuotes(name) + ": vertex id " + std::to_string(id) +
        " is out of range; the surface has " + std::to_string(count) +
        " vertices and ids count from 0");
    }
    return id;
  }

  std::int64_t pointAt(std::string_view word, const std::string& name, bool isEdge)
  {
    Point3 x = Point3::Zero();
    std::string_view rest = word;
    bool read = true;
    for (Eigen::Index k = 0; k < 3 && read; ++k)
    {
      const std::size_t comma = rest.find(',');
      read = parseNumber(rest.substr(0, comma), x[k]) && (comma == rest.npos) == (k == 2);
      rest.remove_prefix(std::min(rest.size(), comma == rest.npos ? rest.size() : comma + 1));
    }
    if (!read)
    {
      this->refuse(inQuotes(word) + " is not a point; write x,y,z without blanks");
    }
    if (!isEdge)
    {
      this->newPoints().push_back(x);
      return static_cast<std::int64_t>(this->points->size()) - 1;
    }
    double distance = 0.0;
    const std::int64_t vertex = this->borders().nearest(x, distance);
    if (vertex < 0)
    {
      this->refuse(
        "edge " + inQuotes(name) + ": the surface has no boundary; make the curve accessory");
    }
    return vertex;
  }

  Points3& newPoints()
  {
    if (!this->points)
    {
      this->points = std::make_shared<Points3>(*this->surface.points);
    }
    return *this->points;
  }

  std::vector<std::int64_t> readIds(std::string_view rest, const std::string& name, bool isEdge)
  {
    std::vector<std::int64_t> ids;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      ids.push_back(this->pointOf(word, name, isEdge));
    }
    if (ids.size() < 2)
    {
      this->refuse("curve " + inQuotes(name) + " needs two vertices; the file may be truncated");
    }
    return ids;
  }

  /// Curves that words give.
  void readWords(std::string_view words, const CurveTitle& title, bool isEdge, CurveList& curves)
  {
    std::string fault;
    for (const CurveWords::Line& line : this->named.lines(words, isEdge, fault))
    {
      line.vertices.empty() ? curves.add(line.points, this->newPoints(), title)
                            : curves.add(line.vertices, title);
      this->named.keep(title.name, line.points);
    }
    if (!fault.empty())
    {
      this->refuse("curve " + inQuotes(title.name) + ": " + fault);
    }
  }

  /// Makes the curve known for words of others.
  void keep(const std::string& name, const std::vector<std::int64_t>& ids)
  {
    const Points3& places = this->points ? *this->points : *this->surface.points;
    Points3 line;
    for (const std::int64_t id : ids)
    {
      line.push_back(places[static_cast<std::size_t>(id)]);
    }
    this->named.keep(name, line);
  }

  BorderWays& borders()
  {
    if (!this->ways)
    {
      this->ways.emplace(this->surface);
    }
    return *this->ways;
  }

  std::vector<std::int64_t> alongBorder(
    const std::vector<std::int64_t>& ids, const std::string& name)
  {
    std::string fault;
    const std::optional<std::vector<std::int64_t>> way = this->borders().through(ids, fault);
    if (!way)
    {
      this->refuse("edge " + inQuotes(name) + ": " + fault);
    }
    return *way;
  }
};

DataSet readCurveText(const std::string& path, const DataSet& surface)
{
  const std::string text = readWholeFile(path);
  CurveList curves;
  CurveReader reader{ path, LineReader(text), surface, CurveWords(surface) };
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
    if (CurveWords::areWords(rest))
    {
      reader.readWords(rest, { *kind, *name }, isEdge, curves);
      continue;
    }
    std::vector<std::int64_t> ids = reader.readIds(rest, *name, isEdge);
    ids = isEdge ? reader.alongBorder(ids, *name) : ids;
    curves.add(ids, { *kind, *name });
    reader.keep(*name, ids);
  }
  return curves.over(reader.points ? reader.points : surface.points);
}

DataSet readObjCurves(const std::string& path)
{
  ObjContents contents = readObj(path);
  if (contents.curves.lines.size() == 0)
  {
    throw InputError(path, "has no line element ('l'); save the feature curves as lines");
  }
  setUnit(contents.curves, contents.unit);
  return contents.curves;
}
}

//------------------------------------------------------------------------------
CurveContents readCurves(const std::string& path, const DataSet& surface)
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
  DataSet curves = readVtk(path);
  if (curves.lines.size() == 0)
  {
    throw InputError(path, "has no polyline; save the feature curves as line cells");
  }
  return { std::move(curves) };
}
}
