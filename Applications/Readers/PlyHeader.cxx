// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include "InputError.h"
#include "TextFile.h"

#include <algorithm>
#include <array>

namespace wirewarp
{
namespace
{
bool parseScalar(std::string_view name, PlyScalar& type)
{
  struct Entry
  {
    std::string_view name;
    PlyScalar type;
  };
  static constexpr std::array<Entry, 16> entries{ { { "char", PlyScalar::Int8 },
    { "int8", PlyScalar::Int8 }, { "uchar", PlyScalar::UInt8 }, { "uint8", PlyScalar::UInt8 },
    { "short", PlyScalar::Int16 }, { "int16", PlyScalar::Int16 }, { "ushort", PlyScalar::UInt16 },
    { "uint16", PlyScalar::UInt16 }, { "int", PlyScalar::Int32 }, { "int32", PlyScalar::Int32 },
    { "uint", PlyScalar::UInt32 }, { "uint32", PlyScalar::UInt32 }, { "float", PlyScalar::Float32 },
    { "float32", PlyScalar::Float32 }, { "double", PlyScalar::Float64 },
    { "float64", PlyScalar::Float64 } } };
  const auto* const found = std::find_if(
    entries.begin(), entries.end(), [name](const Entry& entry) { return entry.name == name; });
  if (found == entries.end())
  {
    return false;
  }
  type = found->type;
  return true;
}

//------------------------------------------------------------------------------
class HeaderParser
{
public:
  HeaderParser(const std::string& path, std::string_view text)
    : Path(path)
    , Rest(text)
    , Size(text.size())
  {
  }

  PlyHeader parse()
  {
    std::string_view line = this->line();
    if (takeWord(line) != "ply")
    {
      this->refuse("is no PLY file: its first line is not 'ply'");
    }
    for (;;)
    {
      if (this->Rest.empty())
      {
        this->refuse("has no 'end_header' line; the file may be truncated");
      }
      line = this->line();
      const std::string_view keyword = takeWord(line);
      if (keyword == "end_header")
      {
        break;
      }
      if (keyword == "format")
      {
        this->parseFormat(line);
      }
      else if (keyword == "element")
      {
        this->parseElement(line);
      }
      else if (keyword == "property")
      {
        this->parseProperty(line);
      }
    }
    this->Result.size = this->Size - this->Rest.size();
    return this->Result;
  }

private:
  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->Path, this->Line, text);
  }

  std::string_view line()
  {
    const std::size_t end = std::min(this->Rest.find('\n'), this->Rest.size());
    std::string_view line = this->Rest.substr(0, end);
    this->Rest.remove_prefix(std::min(end + 1, this->Rest.size()));
    if (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    ++this->Line;
    return line;
  }

  void parseFormat(std::string_view rest)
  {
    const std::string_view name = takeWord(rest);
    if (name == "ascii")
    {
      this->Result.encoding = PlyEncoding::Ascii;
    }
    else if (name == "binary_little_endian")
    {
      this->Result.encoding = PlyEncoding::LittleEndian;
    }
    else if (name == "binary_big_endian")
    {
      this->Result.encoding = PlyEncoding::BigEndian;
    }
    else
    {
      this->refuse("unknown format " + inQuotes(name) +
        "; use ascii, binary_little_endian or binary_big_endian");
    }
  }

  void parseElement(std::string_view rest)
  {
    PlyElement element;
    element.name = takeWord(rest);
    if (!parseInteger(takeWord(rest), element.count) || element.count < 0)
    {
      this->refuse("element " + inQuotes(element.name) + " has no valid count");
    }
    this->Result.elements.push_back(element);
  }

  void parseProperty(std::string_view rest)
  {
    if (this->Result.elements.empty())
    {
      this->refuse("a property stands before the first element");
    }
    PlyProperty property;
    std::string_view type = takeWord(rest);
    bool known = true;
    if (type == "list")
    {
      property.list = true;
      known = parseScalar(takeWord(rest), property.countType);
      type = takeWord(rest);
    }
    if (!parseScalar(type, property.type) || !known)
    {
      this->refuse("unknown property type; use one of PLY's, such as float, double, uchar, int");
    }
    property.name = takeWord(rest);
    this->Result.elements.back().properties.push_back(property);
  }

  std::string Path;
  std::string_view Rest;
  std::size_t Size;
  std::size_t Line = 0;
  PlyHeader Result;
};

}

//------------------------------------------------------------------------------
PlyHeader parsePlyHeader(const std::string& path, std::string_view bytes)
{
  return HeaderParser(path, bytes).parse();
}
}
