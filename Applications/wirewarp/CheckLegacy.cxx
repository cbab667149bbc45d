// SPDX-License-Identifier: BSD-3-Clause
#include "CheckLegacy.h"

#include "InputError.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace wirewarp
{
namespace
{
std::string lowerCase(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Bytes of one value of a binary file, 0 for a type that this check does not know.
std::size_t sizeOf(const std::string& type)
{
  struct Entry
  {
    const char* name;
    std::size_t size;
  };
  static constexpr std::array<Entry, 16> entries{ { { "char", 1 }, { "signed_char", 1 },
    { "unsigned_char", 1 }, { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 },
    { "unsigned_int", 4 }, { "long", 8 }, { "unsigned_long", 8 }, { "float", 4 }, { "double", 8 },
    { "vtkidtype", 4 }, { "vtktypeint32", 4 }, { "vtktypeuint32", 4 }, { "vtktypeint64", 8 },
    { "vtktypeuint64", 8 } } };
  for (const Entry& entry : entries)
  {
    if (type == entry.name)
    {
      return entry.size;
    }
  }
  return 0;
}

class LegacyCheck
{
public:
  LegacyCheck(const std::string& path, std::string_view bytes)
    : Path(path)
    , Rest(bytes)
  {
  }

  void run()
  {
    const std::string version(this->line());
    this->line(); // title
    this->Binary = lowerCase(this->word()) == "binary";
    this->OffsetCells = version.find("Version 5") != std::string::npos;
    while (this->section())
    {
    }
  }

private:
  [[noreturn]] void refuse(const std::string& text) const { throw InputError(this->Path, text); }
  [[noreturn]] void refuseEnd(const std::string& section) const
  {
    this->refuse("ends or is damaged within " + section + "; write the file again");
  }

  std::string_view line()
  {
    const std::size_t end = std::min(this->Rest.find('\n'), this->Rest.size());
    const std::string_view text = this->Rest.substr(0, end);
    this->Rest.remove_prefix(std::min(end + 1, this->Rest.size()));
    return text;
  }

  std::string_view word()
  {
    const std::string_view blanks(" \t\r\n\v\f");
    this->Rest.remove_prefix(std::min(this->Rest.find_first_not_of(blanks), this->Rest.size()));
    const std::size_t end = std::min(this->Rest.find_first_of(blanks), this->Rest.size());
    const std::string_view text = this->Rest.substr(0, end);
    this->Rest.remove_prefix(end);
    return text;
  }

  /// How many values a section announces; no more than the file has bytes left.
  std::size_t count(const std::string& section)
  {
    long long value = 0;
    if (!parseInteger(this->word(), value) || value < 0 ||
      static_cast<unsigned long long>(value) > this->Rest.size())
    {
      this->refuseEnd(section);
    }
    return static_cast<std::size_t>(value);
  }

  /// One section; false where the geometry is over or this check knows no further.
  bool section()
  {
    const std::string keyword = lowerCase(this->word());
    if (keyword == "dataset")
    {
      if (lowerCase(this->word()) != "polydata")
      {
        this->refuse("holds no polydata; save the surface or the curves as vtkPolyData");
      }
      return true;
    }
    if (keyword == "metadata")
    {
      this->line();
      while (!this->Rest.empty() && !this->line().empty())
      {
      }
      return true;
    }
    if (keyword == "points")
    {
      this->points();
      return true;
    }
    if (keyword == "vertices" || keyword == "lines" || keyword == "polygons" ||
      keyword == "triangle_strips")
    {
      this->cells(keyword);
      return true;
    }
    return false;
  }

  void points()
  {
    const std::size_t values = 3 * this->count("points");
    const std::size_t size = sizeOf(lowerCase(this->word()));
    if (size == 0)
    {
      this->refuse("the points have an unknown type; use float or double");
    }
    this->PointCount = static_cast<long long>(values / 3);
    if (this->Binary)
    {
      this->skipBinary(values * size, "points");
      return;
    }
    for (std::size_t k = 0; k < values; ++k)
    {
      double value = 0.0;
      if (!parseNumber(this->word(), value))
      {
        this->refuseEnd("points, at point " + std::to_string(k / 3));
      }
      if (!std::isfinite(value))
      {
        this->refuse("point " + std::to_string(k / 3) +
          " has a coordinate that is not finite; remove or repair the point");
      }
    }
  }

  void skipBinary(std::size_t bytes, const std::string& section)
  {
    this->line();
    if (bytes > this->Rest.size())
    {
      this->refuseEnd(section);
    }
    this->Rest.remove_prefix(bytes);
  }

  /// Whole numbers of `size` bytes, most significant byte first, or words.
  template <typename Take>
  void values(std::size_t howMany, std::size_t size, const std::string& section, Take take)
  {
    if (this->Binary)
    {
      this->line();
      if (howMany > this->Rest.size() / size)
      {
        this->refuseEnd(section);
      }
    }
    for (std::size_t k = 0; k < howMany; ++k)
    {
      long long value = 0;
      if (this->Binary)
      {
        value = this->decode(size);
      }
      else if (!parseInteger(this->word(), value))
      {
        this->refuseEnd(section);
      }
      take(value);
    }
  }

  long long decode(std::size_t size)
  {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      bits = bits << 8 | static_cast<unsigned char>(this->Rest[k]);
    }
    this->Rest.remove_prefix(size);
    return size == 4 ? static_cast<std::int32_t>(bits) : static_cast<std::int64_t>(bits);
  }

  void checkId(long long id, const std::string& section) const
  {
    if (id < 0 || id >= this->PointCount)
    {
      this->refuse("a cell of " + section + " names point " + std::to_string(id) + " of " +
        std::to_string(this->PointCount) + "; ids count from 0");
    }
  }

  void cells(const std::string& section)
  {
    const std::size_t first = this->count(section);
    const std::size_t second = this->count(section);
    if (this->OffsetCells)
    {
      this->cellsByOffset(first, second, section);
      return;
    }
    std::size_t complete = 0;
    long long left = 0; // ids of the cell that is being read
    this->values(second, 4, section, [&](long long value) {
      if (left > 0)
      {
        this->checkId(value, section);
        --left;
        complete += left == 0 ? 1 : 0;
      }
      else if (value < 1)
      {
        this->refuse("a cell of " + section + " has no point; remove it");
      }
      else
      {
        left = value;
      }
    });
    if (complete != first || left != 0)
    {
      this->refuseEnd(section);
    }
  }

  void cellsByOffset(std::size_t offsets, std::size_t ids, const std::string& section)
  {
    if (lowerCase(this->word()) != "offsets")
    {
      this->refuseEnd(section);
    }
    const std::size_t offsetSize = this->idSize(section);
    long long last = 0;
    this->values(offsets, offsetSize, section, [&](long long value) {
      if (value < last)
      {
        this->refuseEnd(section);
      }
      last = value;
    });
    if (lowerCase(this->word()) != "connectivity" || last != static_cast<long long>(ids))
    {
      this->refuseEnd(section);
    }
    const std::size_t idSize = this->idSize(section);
    this->values(ids, idSize, section, [&](long long value) { this->checkId(value, section); });
  }

  std::size_t idSize(const std::string& section)
  {
    const std::size_t size = sizeOf(lowerCase(this->word()));
    if (size != 4 && size != 8)
    {
      this->refuseEnd(section);
    }
    return size;
  }

  std::string Path;
  std::string_view Rest;
  bool Binary = false;
  bool OffsetCells = false; ///< cells as offsets and ids, not as counts with ids
  long long PointCount = 0;
};
}

//------------------------------------------------------------------------------
void checkLegacyPolyData(const std::string& path, std::string_view bytes)
{
  LegacyCheck(path, bytes).run();
}
}
