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

PlyEncoding encodingNamed(std::string_view name, const LineReader& lines)
{
  static constexpr std::array<std::string_view, 3> names{ "ascii", "binary_little_endian",
    "binary_big_endian" };
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    lines.refuse("unknown format " + inQuotes(name) +
      "; use ascii, binary_little_endian or binary_big_endian");
  }
  return static_cast<PlyEncoding>(found - names.begin());
}

/// \param rest of a line that begins with "property"
PlyProperty takeProperty(std::string_view rest, const LineReader& lines)
{
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
    lines.refuse("unknown property type; use one of PLY's, such as float, double, uchar, int");
  }
  property.name = takeWord(rest);
  return property;
}

/// Reads the header of a PLY file. Throws InputError with file and line.
/// \param text of the whole file
PlyHeader readHeader(const std::string& path, std::string_view text)
{
  PlyHeader header;
  LineReader lines(path, text, false);
  std::string line;
  lines.next(line);
  std::string_view rest(line);
  if (takeWord(rest) != "ply")
  {
    lines.refuse("is not a PLY file: its first line is not 'ply'");
  }
  while (lines.next(line))
  {
    rest = line;
    const std::string_view keyword = takeWord(rest);
    if (keyword == "end_header")
    {
      header.data = lines.rest();
      header.lines = lines.number();
      return header;
    }
    if (keyword == "format")
    {
      header.encoding = encodingNamed(takeWord(rest), lines);
    }
    else if (keyword == "element")
    {
      PlyElement& element = header.elements.emplace_back();
      element.name = takeWord(rest);
      if (!parseInteger(takeWord(rest), element.count) || element.count < 0)
      {
        lines.refuse("element " + inQuotes(element.name) + " has no valid count");
      }
    }
    else if (keyword == "property")
    {
      if (header.elements.empty())
      {
        lines.refuse("a property stands before the first element");
      }
      header.elements.back().properties.push_back(takeProperty(rest, lines));
    }
  }
  lines.refuse("has no 'end_header' line; the file may be truncated");
}

bool hostIsLittleEndian()
{
  const std::uint16_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

/// A vertex id, -1 for what is none.
std::int64_t idOf(double value)
{
  const bool valid = value >= 0.0 && value < 4e9 && value == std::floor(value);
  return valid ? static_cast<std::int64_t>(value) : -1;
}

/// Reads what is behind the header.
class PlyReader
{
public:
  PlyReader(const std::string& path, const PlyHeader& header)
    : Path(path)
    , Header(header)
    , Data(header.data)
    , Counted(header.data.data())
    , Line(header.lines + 1)
    , Text(header.encoding == PlyEncoding::Ascii)
    , Swap((header.encoding == PlyEncoding::LittleEndian) != hostIsLittleEndian())
  {
  }

  DataSet read()
  {
    for (const PlyElement& element : this->Header.elements)
    {
      if (element.name == "vertex")
      {
        this->readVertices(element);
      }
      else if (element.name == "face" || element.name == "tristrips")
      {
        this->readFaces(element);
      }
      else if (!element.properties.empty())
      {
        this->forEach(element, [](long long) {});
      }
    }
    this->checkIds();
    DataSet surface;
    surface.points = this->Points.share();
    surface.faces = std::move(this->Faces);
    return surface;
  }

private:
  /// Of a text, in which the last number stands; 0 of other data.
  std::size_t line()
  {
    if (!this->Text)
    {
      return 0;
    }
    const char* const end = this->Data.data();
    this->Line += static_cast<std::size_t>(std::count(this->Counted, end, '\n'));
    this->Counted = end;
    return this->Line;
  }

  double number(const PlyScalar& type, const PlyElement& element, long long index)
  {
    double value = 0.0;
    bool known = this->Data.size() >= type.size;
    if (this->Text)
    {
      known = parseNumber(takeWord(this->Data, " \t\r\n\v\f"), value);
    }
    else if (known)
    {
      value = type.decode(this->Data.data(), this->Swap);
      this->Data.remove_prefix(type.size);
    }
    if (!known)
    {
      throw InputError(this->Path,
        "ends or is damaged at element " + element.name + " " + std::to_string(index) + " of " +
          std::to_string(element.count) + "; write the file again");
    }
    return value;
  }

  /// Reads all of an element, one after the other, and calls visit(index) for each.
  template <class Visit>
  void forEach(const PlyElement& element, const Visit& visit)
  {
    this->Values.resize(std::max(this->Values.size(), element.properties.size()));
    for (long long k = 0; k < element.count; ++k)
    {
      for (std::size_t p = 0; p < element.properties.size(); ++p)
      {
        const PlyProperty& property = element.properties[p];
        const double count =
          property.countType ? this->number(*property.countType, element, k) : 1.0;
        if (!(count >= 0.0) || count != std::floor(count))
        {
          throw InputError(this->Path,
            "element " + element.name + " " + std::to_string(k) + " has a list of invalid length");
        }
        this->Values[p].clear();
        for (double n = 0.0; n < count; n += 1.0)
        {
          this->Values[p].push_back(this->number(*property.type, element, k));
        }
      }
      visit(k);
    }
  }

  /// The values of a property, or of the same by another name, while its element is visited.
  const std::vector<double>& valuesOf(const PlyElement& element, const std::string& name, bool list,
    const std::string& otherName = {})
  {
    this->Values.resize(std::max(this->Values.size(), element.properties.size()));
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const PlyProperty& property = element.properties[p];
      if ((property.countType != nullptr) == list &&
        (property.name == name || property.name == otherName))
      {
        return this->Values[p];
      }
    }
    throw InputError(this->Path, "element " + element.name + " has no property '" + name + "'");
  }

  void readVertices(const PlyElement& element)
  {
    const std::vector<double>& x = this->valuesOf(element, "x", false);
    const std::vector<double>& y = this->valuesOf(element, "y", false);
    const std::vector<double>& z = this->valuesOf(element, "z", false);
    this->forEach(element, [&](long long) {
      const Point3 point(x.front(), y.front(), z.front());
      this->Points.add(point, point.allFinite() ? 0 : this->line());
    });
  }

  void readFaces(const PlyElement& element)
  {
    const std::vector<double>& corners =
      this->valuesOf(element, "vertex_indices", true, "vertex_index");
    this->forEach(element, [&](long long k) {
      if (element.name == "tristrips")
      {
        this->addStrips(corners, k);
        return;
      }
      if (corners.size() < 3)
      {
        throw InputError(this->Path,
          "face " + std::to_string(k) + " has " + std::to_string(corners.size()) +
            " vertices; remove it or give it three");
      }
      std::vector<std::int64_t> ids(corners.size());
      std::transform(corners.begin(), corners.end(), ids.begin(), idOf);
      this->Faces.add(ids);
    });
  }

  /// Strips of triangles: -1 ends a strip, every other triangle is turned, and those with a corner
  /// twice only lead on.
  void addStrips(const std::vector<double>& list, long long index)
  {
    std::array<std::int64_t, 3> corners{};
    std::size_t length = 0; // of the strip so far
    for (const double value : list)
    {
      const std::int64_t id = idOf(value);
      if (value == -1.0)
      {
        length = 0;
        continue;
      }
      if (id < 0)
      {
        throw InputError(this->Path,
          "strip " + std::to_string(index) + " has an invalid vertex id; ids count from 0");
      }
      corners = { corners[1], corners[2], id };
      const auto& [a, b, c] = corners;
      if (++length > 2 && a != b && b != c && c != a)
      {
        const std::array<std::int64_t, 3> turned{ b, a, c };
        this->Faces.add(length % 2 == 1 ? corners : turned);
      }
    }
  }

  void checkIds() const
  {
    for (std::size_t cell = 0; cell < this->Faces.size(); ++cell)
    {
      for (const auto* id = this->Faces.begin(cell); id != this->Faces.end(cell); ++id)
      {
        if (*id < 0 || *id >= this->Points.size())
        {
          throw InputError(this->Path,
            "face " + std::to_string(cell) + " names vertex " + std::to_string(*id) + " of " +
              std::to_string(this->Points.size()) + "; ids count from 0");
        }
        this->Points.check(this->Path, *id);
      }
    }
  }

  const std::string& Path;
  const PlyHeader& Header;
  std::string_view Data;
  const char* Counted; ///< up to where lines are counted
  std::size_t Line;
  bool Text;
  bool Swap;
  std::vector<std::vector<double>> Values; ///< by property, of the element that is visited
  FilePoints Points;
  flattening::CellList Faces;
};
}

DataSet readPly(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  const PlyHeader header = readHeader(path, bytes);
  return PlyReader(path, header).read();
}
}
