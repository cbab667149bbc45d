// SPDX-License-Identifier: BSD-3-Clause
#include "ReadObj.h"

#include "CurveList.h"
#include "InputError.h"
#include "TextFile.h"
#include "Units.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
/// A line element.
struct ObjLine
{
  std::vector<std::int64_t> ids;
  CurveTitle title;
  std::size_t object = 0;
  std::size_t number = 0; ///< of its line in the file
};

struct ObjReader
{
  std::string path;
  LineReader lines;
  FilePoints points = {};
  std::vector<std::int64_t> ids = {};
  FaceLabels labels = {};
  std::map<std::string, std::size_t> numbers = { { std::string(), 0 } }; ///< of names
  std::size_t object = 0;
  std::size_t group = 0;
  std::size_t material = 0;

  void readTexture(std::string_view rest)
  {
    std::array<double, 2> texture{}; // one that is no number is one like all others of its kind
    for (double& coordinate : texture)
    {
      parseNumber(takeWord(rest), coordinate);
    }
    this->labels.textures.push_back(texture);
  }

  /// The number of a name, with the blanks around it left out.
  std::size_t numberOf(std::string_view name)
  {
    std::string text(trimmed(name));
    std::replace(text.begin(), text.end(), '\0', ' '); // VTK ends a text there when it writes it
    const auto [entry, isNew] = this->numbers.emplace(text, this->labels.names.size());
    if (isNew)
    {
      this->labels.names.push_back(text);
    }
    return entry->second;
  }

  /// Of the corner of a face, from 1; 0: none, or none that is there.
  std::size_t textureOf(std::string_view word) const
  {
    const std::size_t slash = word.find('/');
    long long id = 0;
    if (slash == std::string_view::npos ||
      !parseInteger(word.substr(slash + 1, word.find('/', slash + 1) - slash - 1), id))
    {
      return 0;
    }
    const auto count = static_cast<long long>(this->labels.textures.size());
    const long long at = id > 0 ? id : count + 1 + id;
    return at > 0 && at <= count ? static_cast<std::size_t>(at) : 0;
  }

  void labelFace(std::string_view rest)
  {
    this->labels.objects.push_back(this->object);
    this->labels.groups.push_back(this->group);
    this->labels.materials.push_back(this->material);
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      this->labels.corners.push_back(this->textureOf(word));
    }
  }

  void readIds(std::string_view rest)
  {
    this->ids.clear();
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    {
      long long id = 0;
      if (!parseInteger(word.substr(0, word.find('/')), id))
      {
        this->lines.refuse(inQuotes(word) + " is not a vertex id; write v, v/vt, v//vn or v/vt/vn");
      }
      const std::int64_t count = this->points.size();
      if (id == 0 || id > count || id < -count)
      {
        this->lines.refuse("vertex id " + std::to_string(id) + " is out of range; " +
          std::to_string(count) +
          " vertices stand above this line and ids count from 1, or from -1 backwards");
      }
      this->ids.push_back(static_cast<std::int64_t>(id > 0 ? id - 1 : count + id));
      this->points.check(this->path, this->ids.back());
    }
  }
};

/// The lines that are curves. Modellers also write edges without faces so, in the object of the
/// faces that they hang on to. \param objects by face, 0: without a name
CurveList curvesOf(const std::vector<ObjLine>& lines, const DataSet& surface,
  const std::vector<std::size_t>& objects, std::string& note)
{
  std::vector<char> used(surface.points->size(), 0);
  for (std::size_t k = 0; k < surface.faces.size(); ++k)
  {
    for (const std::int64_t* id = surface.faces.begin(k); id != surface.faces.end(k); ++id)
    {
      used[static_cast<std::size_t>(*id)] = 1;
    }
  }
  const std::set<std::size_t> ofFaces(objects.begin(), objects.end());
  CurveList curves;
  std::size_t count = 0;
  for (const ObjLine& line : lines)
  {
    const bool loose = line.ids.size() == 2 && line.object != 0 && ofFaces.count(line.object) > 0 &&
      std::any_of(line.ids.begin(), line.ids.end(),
        [&used](std::int64_t id) { return !used[static_cast<std::size_t>(id)]; });
    if (!loose)
    {
      curves.add(line.ids, line.title);
    }
    else if (++count == 1)
    {
      note = "line " + std::to_string(line.number);
    }
  }
  if (count > 0)
  {
    note = std::to_string(count) +
      (count == 1 ? " edge without a face is left out, at "
                  : " edges without a face are left out, the first at ") +
      note + "; a curve would be in an object or a group of its own";
  }
  return curves;
}
}

SurfaceContents readObj(const std::string& path)
{
  const std::string text = readWholeFile(path);
  DataSet surface;
  std::vector<ObjLine> found;
  CurveTitle title;
  std::string unit;

  ObjReader reader{ path, LineReader(path, text) };
  std::string line;
  while (reader.lines.next(line))
  {
    std::string_view rest(line);
    const std::string_view keyword = takeWord(rest);
    if (keyword == "v")
    {
      reader.points.add(takePoint(rest, reader.lines), reader.lines.number());
    }
    else if (keyword == "f")
    {
      reader.readIds(rest);
      if (reader.ids.size() < 3)
      {
        reader.lines.refuse("a face needs three vertices; the file may be truncated");
      }
      surface.faces.add(reader.ids);
      reader.labelFace(rest);
    }
    else if (keyword == "vt")
    {
      reader.readTexture(rest);
    }
    else if (keyword == "usemtl")
    {
      reader.material = reader.numberOf(rest);
    }
    else if (keyword == "l")
    {
      reader.readIds(rest);
      if (reader.ids.size() < 2)
      {
        reader.lines.refuse("a line needs two vertices; the file may be truncated");
      }
      found.push_back({ reader.ids, title, reader.object, reader.lines.number() });
    }
    else if (keyword == "g" || keyword == "o")
    {
      title = curveTitle(rest);
      (keyword == "o" ? reader.object : reader.group) = reader.numberOf(rest);
    }
    else if (unit.empty() && !keyword.empty() && keyword.front() == '#')
    {
      unit = unitInComment(line);
    }
  }
  if (reader.points.size() == 0)
  {
    throw InputError(path, "has no vertex ('v' line); it may be no OBJ file or be truncated");
  }

  surface.points = reader.points.share();
  std::vector<std::string> names = pieceNames(reader.labels);
  if (!names.empty())
  {
    surface.cellArrays.push_back({ "PieceName", std::move(names) });
  }
  std::string note;
  DataSet lines = curvesOf(found, surface, reader.labels.objects, note).over(surface.points);
  return { std::move(surface), std::move(lines), unit, std::move(reader.labels), false, note };
}
}
