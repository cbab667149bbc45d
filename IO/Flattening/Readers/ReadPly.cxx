// SPDX-License-Identifier: BSD-3-Clause
#include "ReadPly.h"

#include "InputError.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
template <typename T>
double decode(const char* bytes, bool swap)
{
  std::array<char, sizeof(T)> copy{};
  std::copy_n(bytes, sizeof(T), copy.begin());
  if (swap)
  {
    std::reverse(copy.begin(), copy.end());
  }
  T value{};
  std::memcpy(&value, copy.data(), sizeof(T));
  return static_cast<double>(value);
}

/// A type of numbers, by the names that it has.
struct PlyScalar
{
  std::string_view name;
  std::string_view otherName;
  std::size_t size = 0; ///< bytes
  double (*decode)(const char* bytes, bool swap) = nullptr;
};

constexpr std::array<PlyScalar, 8> scalars{ { { "char", "int8", 1, &decode<std::int8_t> },
  { "uchar", "uint8", 1, &decode<std::uint8_t> }, { "short", "int16", 2, &decode<std::int16_t> },
  { "ushort", "uint16", 2, &decode<std::uint16_t> }, { "int", "int32", 4, &decode<std::int32_t> },
  { "uint", "uint32", 4, &decode<std::uint32_t> }, { "float", "float32", 4, &decode<float> },
  { "double", "float64", 8, &decode<double> } } };

/// Null where no type has the name.
const PlyScalar* scalarNamed(std::string_view name)
{
  const auto* const found = std::find_if(scalars.begin(), scalars.end(),
    [name](const PlyScalar& scalar) { return name == scalar.name || name == scalar.otherName; });
  return found == scalars.end() ? nullptr : found;
}

struct PlyProperty
{
  std::string name;
  const PlyScalar* type = nullptr;
  const PlyScalar* countType = nullptr; ///< of a list
};

struct PlyElement
{
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding
{
  Ascii,
  LittleEndian,
  BigEndian,
};

struct PlyHeader
{
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::string_view data; ///< behind the header
  std::size_t lines = 0; ///< of the header
};

//------------------------------------------------------------------------------
/// Reads the header of a PLY file. Throws InputError with file and line.
class HeaderParser
{
public:
  /// \param text of the whole file \param path for messages
  HeaderParser(const std::string& path, std::string_view text)
    : Path(path)
    , Lines(text, false)
  {
  }

  PlyHeader parse()
  {
    std::string line;
    this->Lines.next(line);
    std::string_view rest(line);
    if (takeWord(rest) != "ply")
    {
      this->refuse("is not a PLY file: its first line is not 'ply'");
    }
    while (this->Lines.next(line))
    {
      rest = line;
      const std::string_view keyword = takeWord(rest);
      if (keyword == "end_header")
      {
        this->Result.data = this->Lines.rest();
        this->Result.lines = this->Lines.number();
        return this->Result;
      }
      if (keyword == "format")
      {
        this->parseFormat(rest);
      }
      else if (keyword == "element")
      {
        this->parseElement(rest);
      }
      else if (keyword == "property")
      {
        this->parseProperty(rest);
      }
    }
    this->refuse("has no 'end_header' line; the file may be truncated");
  }

private:
  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->Path, this->Lines.number(), text);
  }

  void parseFormat(std::string_view rest)
  {
    static constexpr std::array<std::string_view, 3> names{ "ascii", "binary_little_endian",
      "binary_big_endian" };
    const std::string_view name = takeWord(rest);
    const auto* const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
    {
      this->refuse("unknown format " + inQuotes(name) +
        "; use ascii, binary_little_endian or binary_big_endian");
    }
    this->Result.encoding = static_cast<PlyEncoding>(found - names.begin());
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
    const bool list = type == "list";
    if (list)
    {
      property.countType = scalarNamed(takeWord(rest));
      type = takeWord(rest);
    }
    property.type = scalarNamed(type);
    if (!property.type || (list && !property.countType))
    {
      this->refuse("unknown property type; use one of PLY's, such as float, double, uchar, int");
    }
    property.name = takeWord(rest);
    this->Result.elements.back().properties.push_back(property);
  }

  const std::string& Path;
  LineReader Lines;
  PlyHeader Result;
};

bool hostIsLittleEndian()
{
  const std::uint16_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

//------------------------------------------------------------------------------
/// The numbers after the header, one after the other.
class ValueReader
{
public:
  explicit ValueReader(const PlyHeader& header)
    : Data(header.data)
    , Counted(header.data.data())
    , Line(header.lines + 1)
    , Text(header.encoding == PlyEncoding::Ascii)
    , Swap((header.encoding == PlyEncoding::LittleEndian) != hostIsLittleEndian())
  {
  }

  bool isText() const { return this->Text; }
  /// Of a text, in which the last number stands.
  std::size_t line()
  {
    const char* const end = this->Data.data();
    this->Line += static_cast<std::size_t>(std::count(this->Counted, end, '\n'));
    this->Counted = end;
    return this->Line;
  }

  /// False where the data ends or holds no number.
  bool next(const PlyScalar& type, double& value)
  {
    if (this->Text)
    {
      return parseNumber(this->nextWord(), value);
    }
    if (this->Data.size() < type.size)
    {
      return false;
    }
    value = type.decode(this->Data.data(), this->Swap);
    this->Data.remove_prefix(type.size);
    return true;
  }

private:
  std::string_view nextWord()
  {
    const std::string_view blanks(" \t\r\n\v\f");
    const std::size_t begin = std::min(this->Data.find_first_not_of(blanks), this->Data.size());
    this->Data.remove_prefix(begin);
    const std::size_t end = std::min(this->Data.find_first_of(blanks), this->Data.size());
    const std::string_view word = this->Data.substr(0, end);
    this->Data.remove_prefix(end);
    return word;
  }

  std::string_view Data;
  const char* Counted; ///< up to where lines are counted
  std::size_t Line;
  bool Text;
  bool Swap;
};

//------------------------------------------------------------------------------
/// One element's values: scalars by property, and the list of each property that is one.
class ElementReader
{
public:
  ElementReader(const std::string& path, ValueReader& values)
    : Path(path)
    , Values(values)
  {
  }

  void read(const PlyElement& element, long long index)
  {
    this->Scalars.assign(element.properties.size(), 0.0);
    this->Lists.resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const PlyProperty& property = element.properties[p];
      if (!property.countType)
      {
        this->Scalars[p] = this->value(*property.type, element, index);
        continue;
      }
      const double count = this->value(*property.countType, element, index);
      if (!(count >= 0.0) || count != std::floor(count))
      {
        throw InputError(this->Path,
          "element " + element.name + " " + std::to_string(index) +
            " has a list of invalid length");
      }
      this->Lists[p].clear();
      for (double k = 0.0; k < count; k += 1.0)
      {
        this->Lists[p].push_back(this->value(*property.type, element, index));
      }
    }
  }
  double scalar(std::size_t property) const { return this->Scalars[property]; }
  const std::vector<double>& list(std::size_t property) const { return this->Lists[property]; }

private:
  double value(const PlyScalar& type, const PlyElement& element, long long index)
  {
    double number = 0.0;
    if (!this->Values.next(type, number))
    {
      throw InputError(this->Path,
        "ends or is damaged at element " + element.name + " " + std::to_string(index) + " of " +
          std::to_string(element.count) + "; write the file again");
    }
    return number;
  }

  std::string Path;
  ValueReader& Values;
  std::vector<double> Scalars;
  std::vector<std::vector<double>> Lists;
};

std::size_t findProperty(const std::string& path, const PlyElement& element, const char* name,
  bool list, const char* otherName = nullptr)
{
  for (std::size_t p = 0; p < element.properties.size(); ++p)
  {
    const PlyProperty& property = element.properties[p];
    if ((property.countType != nullptr) == list &&
      (property.name == name || (otherName && property.name == otherName)))
    {
      return p;
    }
  }
  throw InputError(path, "element " + element.name + " has no property '" + name + "'");
}

void readVertices(const std::string& path, const PlyElement& element, ValueReader& values,
  ElementReader& reader, Points3& points, InvalidPoints& invalid)
{
  const std::array<std::size_t, 3> place{ findProperty(path, element, "x", false),
    findProperty(path, element, "y", false), findProperty(path, element, "z", false) };
  for (long long k = 0; k < element.count; ++k)
  {
    reader.read(element, k);
    points.emplace_back(reader.scalar(place[0]), reader.scalar(place[1]), reader.scalar(place[2]));
    if (values.isText() && !points.back().allFinite())
    {
      invalid.add(points.size() - 1, values.line());
    }
  }
}

/// A vertex id, -1 for what is none.
std::int64_t idOf(double value)
{
  const bool valid = value >= 0.0 && value < 4e9 && value == std::floor(value);
  return valid ? static_cast<std::int64_t>(value) : -1;
}

std::size_t findIndices(const std::string& path, const PlyElement& element)
{
  return findProperty(path, element, "vertex_indices", true, "vertex_index");
}

void readFaces(const std::string& path, const PlyElement& element, ElementReader& reader,
  flattening::CellList& polygons)
{
  const std::size_t place = findIndices(path, element);
  std::vector<std::int64_t> ids;
  for (long long k = 0; k < element.count; ++k)
  {
    reader.read(element, k);
    ids.clear();
    for (const double id : reader.list(place))
    {
      ids.push_back(idOf(id));
    }
    if (ids.size() < 3)
    {
      throw InputError(path,
        "face " + std::to_string(k) + " has " + std::to_string(ids.size()) +
          " vertices; remove it or give it three");
    }
    polygons.add(ids);
  }
}

/// Strips of triangles, one list or several: -1 ends a strip, every other triangle is turned, and
/// those with a corner twice only lead on.
void readStrips(const std::string& path, const PlyElement& element, ElementReader& reader,
  flattening::CellList& polygons)
{
  const std::size_t place = findIndices(path, element);
  for (long long k = 0; k < element.count; ++k)
  {
    reader.read(element, k);
    std::array<std::int64_t, 3> corners{};
    std::size_t length = 0; // of the strip so far
    for (const double value : reader.list(place))
    {
      const std::int64_t id = idOf(value);
      if (value == -1.0)
      {
        length = 0;
        continue;
      }
      if (id < 0)
      {
        throw InputError(
          path, "strip " + std::to_string(k) + " has an invalid vertex id; ids count from 0");
      }
      corners = { corners[1], corners[2], id };
      const auto& [a, b, c] = corners;
      if (++length > 2 && a != b && b != c && c != a)
      {
        const std::array<std::int64_t, 3> turned{ b, a, c };
        polygons.add(length % 2 == 1 ? corners : turned);
      }
    }
  }
}

void checkIds(const std::string& path, const flattening::CellList& polygons,
  std::int64_t pointCount, const InvalidPoints& invalid)
{
  for (std::size_t cell = 0; cell < polygons.size(); ++cell)
  {
    for (const auto* id = polygons.begin(cell); id != polygons.end(cell); ++id)
    {
      if (*id < 0 || *id >= pointCount)
      {
        throw InputError(path,
          "face " + std::to_string(cell) + " names vertex " + std::to_string(*id) + " of " +
            std::to_string(pointCount) + "; ids count from 0");
      }
      invalid.check(path, *id);
    }
  }
}
}

//------------------------------------------------------------------------------
DataSet readPly(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  const PlyHeader header = HeaderParser(path, bytes).parse();
  ValueReader values(header);
  ElementReader reader(path, values);

  Points3 points;
  InvalidPoints invalid;
  DataSet surface;
  for (const PlyElement& element : header.elements)
  {
    if (element.name == "vertex")
    {
      readVertices(path, element, values, reader, points, invalid);
    }
    else if (element.name == "face")
    {
      readFaces(path, element, reader, surface.faces);
    }
    else if (element.name == "tristrips")
    {
      readStrips(path, element, reader, surface.faces);
    }
    else if (!element.properties.empty())
    {
      for (long long k = 0; k < element.count; ++k)
      {
        reader.read(element, k);
      }
    }
  }
  checkIds(path, surface.faces, static_cast<std::int64_t>(points.size()), invalid);

  surface.points = std::make_shared<const Points3>(std::move(points));
  return surface;
}
}
