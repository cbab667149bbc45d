// SPDX-License-Identifier: BSD-3-Clause
#include "ReadOff.h"

#include "InputError.h"
#include "TextFile.h"

#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
/// Walks the lines that hold something beside comments.
struct OffReader
{
  const std::string& path;
  LineReader lines;
  std::string line = {};
  std::string_view rest = {}; ///< of the line

  void nextLine()
  {
    do
    {
      if (!this->lines.next(this->line))
      {
        this->lines.refuse(
          "the file ends before all that its head counts; it is truncated, write it again");
      }
      this->rest = trimmed(std::string_view(this->line).substr(0, this->line.find('#')));
    } while (this->rest.empty());
  }

  /// A face may go on in the next line.
  std::int64_t integer(std::int64_t end, const std::string& what)
  {
    if (this->rest.empty())
    {
      this->nextLine();
    }
    const std::string_view word = takeWord(this->rest);
    long long value = 0;
    if (!parseInteger(word, value) || value < 0 || value >= end)
    {
      this->lines.refuse(inQuotes(word) + " is not " + what);
    }
    return value;
  }

  /// Counts may follow in the same line.
  void readKind()
  {
    this->nextLine();
    const std::size_t end = this->rest.find("OFF") + 3;
    const std::string_view before = this->rest.substr(0, end < 3 ? 0 : end - 3);
    const std::string_view after = this->rest.substr(end < 3 ? 0 : end);
    if (end < 3 || before.find_first_not_of("STCN") != std::string_view::npos ||
      after.find_first_not_of(" \t0123456789-") == 0)
    {
      this->lines.refuse(inQuotes(takeWord(this->rest)) +
        " is not OFF, with ST, C or N before it for what its vertices have beside three "
        "coordinates; save the surface so, as text");
    }
    this->rest = trimmed(after);
    if (this->rest == "BINARY")
    {
      this->lines.refuse("is binary OFF, which is not read; save the surface as text (ASCII)");
    }
  }

  DataSet read()
  {
    this->readKind();
    if (this->rest.empty())
    {
      this->nextLine();
    }
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const std::string counts = "a count; write vertices, faces and edges";
    const std::int64_t vertices = this->integer(most, counts);
    const std::int64_t faces = this->integer(most, counts);
    FilePoints points;
    for (std::int64_t k = 0; k < vertices; ++k)
    {
      this->nextLine();
      points.add(takePoint(this->rest, this->lines), this->lines.number());
    }
    DataSet surface;
    std::vector<std::int64_t> ids;
    for (std::int64_t k = 0; k < faces; ++k)
    {
      this->nextLine();
      const std::int64_t corners = this->integer(most, counts);
      ids.clear();
      for (std::int64_t corner = 0; corner < corners; ++corner)
      {
        ids.push_back(this->integer(vertices, "a vertex id below " + std::to_string(vertices)));
        points.check(this->path, ids.back());
      }
      if (ids.size() < 3)
      {
        this->lines.refuse("a face needs three vertices");
      }
      surface.faces.add(ids);
    }
    surface.points = points.share();
    return surface;
  }
};
}

DataSet readOff(const std::string& path)
{
  const std::string text = readWholeFile(path);
  return OffReader{ path, LineReader(path, text, false) }.read();
}
}
