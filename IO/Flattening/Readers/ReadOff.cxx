// SPDX-License-Identifier: BSD-3-Clause
#include "ReadOff.h"

#include "InputError.h"
#include "TextFile.h"

#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
/// Walks the words of a file, whatever lines they stand in.
struct OffReader
{
  const std::string& path;
  LineReader lines;
  bool byLine;   ///< a vertex ends with its line: it may have colors that the head does not tell of
  int extra = 0; ///< numbers of a vertex beside its coordinates
  std::string line;
  std::string_view rest; ///< of the line
  InvalidPoints invalid = {};

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  bool nextLine()
  {
    const bool any = this->lines.next(this->line);
    this->rest = std::string_view(this->line).substr(0, any ? this->line.find('#') : 0);
    return any;
  }

  std::string_view word()
  {
    for (;;)
    {
      const std::string_view found = takeWord(this->rest);
      if (!found.empty())
      {
        return found;
      }
      if (!this->nextLine())
      {
        this->refuse(
          "the file ends before all that its head counts; it is truncated, write it again");
      }
    }
  }

  /// \return whether the line has more words
  bool skipLine()
  {
    const bool any = !takeWord(this->rest).empty();
    this->rest = {};
    return any;
  }

  long long integer(long long end, const std::string& what)
  {
    const std::string_view found = this->word();
    long long value = 0;
    if (!parseInteger(found, value) || value < 0 || value >= end)
    {
      this->refuse(inQuotes(found) + " is not " + what);
    }
    return value;
  }

  long long count()
  {
    return this->integer(
      std::numeric_limits<long long>::max(), "a count; write vertices, faces and edges");
  }

  void readKind()
  {
    const std::string_view kind = this->word();
    const std::size_t end = kind.find("OFF") + 3; // counts may follow at once
    std::string_view before = kind.substr(0, end - 3);
    for (const auto& [prefix, numbers] :
      { std::pair("ST", 2), std::pair("C", 4), std::pair("N", 3) })
    {
      if (before.rfind(prefix, 0) == 0)
      {
        before.remove_prefix(std::strlen(prefix));
        this->extra += numbers;
      }
    }
    if (end < 3 || !before.empty() ||
      kind.find_first_not_of("0123456789", end) != std::string_view::npos)
    {
      this->refuse(inQuotes(kind) +
        " is not OFF, with ST, C or N before it for what its vertices "
        "have beside three coordinates; save the surface so, as text");
    }
    this->rest = { kind.data() + end,
      static_cast<std::size_t>(this->rest.data() + this->rest.size() - kind.data()) - end };
    std::string_view text = this->rest;
    if (takeWord(text) == "BINARY")
    {
      this->refuse("is binary OFF, which is not read; save the surface as text (ASCII)");
    }
  }

  void readPoint(Points3& points)
  {
    Point3 x;
    for (double& coordinate : x)
    {
      const std::string_view found = this->word();
      if (!parseNumber(found, coordinate))
      {
        this->refuse(inQuotes(found) + " is not a coordinate; write three decimal numbers");
      }
    }
    if (!x.allFinite())
    {
      this->invalid.add(points.size(), this->lines.number());
    }
    points.push_back(x);
    for (int k = 0; !this->byLine && k < this->extra; ++k)
    {
      this->word();
    }
    if (this->byLine)
    {
      this->skipLine();
    }
  }

  void readFace(flattening::CellList& polygons, long long points)
  {
    const long long corners = this->count();
    if (corners < 3)
    {
      this->refuse("a face needs three vertices");
    }
    std::vector<std::int64_t> ids;
    for (long long k = 0; k < corners; ++k)
    {
      ids.push_back(this->integer(points, "a vertex id below " + std::to_string(points)));
      this->invalid.check(this->path, ids.back());
    }
    this->skipLine(); // its color
    polygons.add(ids);
  }

  DataSet read()
  {
    this->readKind();
    const long long vertices = this->count();
    const long long faces = this->count();
    if (!this->skipLine()) // edges may have a line of their own
    {
      this->word();
      const bool alone = !this->skipLine();
      this->rest = std::string_view(this->line).substr(0, alone ? 0 : this->line.find('#'));
    }
    Points3 points;
    for (long long k = 0; k < vertices; ++k)
    {
      this->readPoint(points);
    }
    DataSet surface;
    for (long long k = 0; k < faces; ++k)
    {
      this->readFace(surface.faces, vertices);
    }
    while (!this->byLine && this->nextLine())
    {
      if (this->skipLine())
      {
        this->refuse("more follows than its head counts");
      }
    }
    surface.points = std::make_shared<const Points3>(std::move(points));
    return surface;
  }
};
}

//------------------------------------------------------------------------------
DataSet readOff(const std::string& path)
{
  const std::string text = readWholeFile(path);
  try
  {
    return OffReader{ path, LineReader(text, false), false, 0, {}, {} }.read();
  }
  catch (const InputError&)
  {
    return OffReader{ path, LineReader(text, false), true, 0, {}, {} }.read();
  }
}
}
