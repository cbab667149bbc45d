// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCurves.h"

#include "CurveBuilder.h"
#include "InputError.h"
#include "ReadCsvCurves.h"
#include "ReadDxfCurves.h"
#include "ReadObj.h"
#include "ReadVtk.h"
#include "TextFile.h"
#include "Units.h"

#include <algorithm>
#include <cstddef>
#include <optional>
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

/// A vertex of the surface by its id.
std::int64_t vertexOf(
  std::string_view word, const DataSet& surface, const std::string& curve, const LineReader& lines)
{
  long long id = 0;
  if (!parseInteger(word, id))
  {
    lines.refuse(inQuotes(word) +
      " is not a vertex id; write TYPE NAME v0 v1 ... with whole numbers, or points as x,y,z");
  }
  const auto count = static_cast<long long>(surface.points->size());
  if (id < 0 || id >= count)
  {
    lines.refuse("curve " + inQuotes(curve) + ": vertex id " + std::to_string(id) +
      " is out of range; the surface has " + std::to_string(count) +
      " vertices and ids count from 0");
  }
  return id;
}

/// A point as x,y,z.
Point3 placeOf(std::string_view word, const LineReader& lines)
{
  Point3 place = Point3::Zero();
  std::string_view rest = word;
  bool read = true;
  for (Eigen::Index k = 0; k < 3 && read; ++k)
  {
    const std::size_t comma = rest.find(',');
    read = parseNumber(rest.substr(0, comma), place[k]) && (comma == rest.npos) == (k == 2);
    rest.remove_prefix(std::min(rest.size(), comma == rest.npos ? rest.size() : comma + 1));
  }
  if (!read)
  {
    lines.refuse(inQuotes(word) + " is not a point; write x,y,z without blanks");
  }
  return place;
}

DataSet readCurveText(const std::string& path, const DataSet& surface)
{
  const std::string text = readWholeFile(path);
  LineReader lines(path, text);
  CurveBuilder builder(lines, surface, true);
  std::string line;
  while (lines.next(line))
  {
    std::string_view rest = withoutComment(line);
    const std::string_view type = takeWord(rest);
    if (type.empty())
    {
      continue;
    }
    const RowType row = rowType(type, lines);
    const std::optional<std::string> name = takeName(rest);
    if (!name)
    {
      lines.refuse("the quotes of the name are not closed; write TYPE \"NAME\" v0 v1 ...");
    }
    if (trimmed(*name).empty())
    {
      lines.refuse("the curve has no name; write TYPE NAME v0 v1 ...");
    }
    const CurveTitle title{ row.kind, *name };
    if (CurveBuilder::areWords(rest))
    {
      builder.addWords(title, row.isEdge, rest);
      continue;
    }
    std::vector<std::int64_t> ids;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      ids.push_back(word.find(',') == std::string_view::npos ? vertexOf(word, surface, *name, lines)
          : row.isEdge ? builder.borderVertex(placeOf(word, lines), *name)
                       : builder.newPoint(placeOf(word, lines)));
    }
    if (ids.size() < 2)
    {
      lines.refuse("curve " + inQuotes(*name) + " needs two vertices; the file may be truncated");
    }
    builder.addIds(title, row.isEdge, ids);
  }
  return builder.take();
}

CurveContents readObjCurves(const std::string& path)
{
  SurfaceContents contents = readObj(path);
  if (contents.curves.lines.size() == 0)
  {
    throw InputError(path, "has no line element ('l'); save the feature curves as lines");
  }
  setUnit(contents.curves, contents.unit);
  return { std::move(contents.curves), std::move(contents.note) };
}
}

CurveContents readCurves(const std::string& path, const DataSet& surface)
{
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".obj")
  {
    return readObjCurves(path);
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
