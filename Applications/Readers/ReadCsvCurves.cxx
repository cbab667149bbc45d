// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCsvCurves.h"

#include "CurveList.h"
#include "InputError.h"
#include "TextFile.h"

#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace wirewarp
{
namespace
{
constexpr std::size_t nowhere = std::string_view::npos;

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view around = " \t\"";
  const std::size_t begin = text.find_first_not_of(around);
  return begin == nowhere ? std::string_view()
                          : text.substr(begin, text.find_last_not_of(around) + 1 - begin);
}

std::vector<std::string_view> fieldsOf(std::string_view line, char divider)
{
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin != nowhere;)
  {
    const std::size_t end = line.find(divider, begin);
    fields.push_back(trimmed(line.substr(begin, end == nowhere ? end : end - begin)));
    begin = end == nowhere ? end : end + 1;
  }
  return fields;
}

struct CsvReader
{
  CsvReader(const std::string& file, const std::string& text)
    : path(file)
    , lines(text)
  {
  }

  const std::string& path;
  LineReader lines;
  char divider = ',';
  std::array<std::size_t, 5> column{}; ///< of name, type, x, y, z

  vtkNew<vtkPoints> points;
  CurveList curves;
  std::vector<vtkIdType> ids;
  CurveTitle title;

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  void readHead(const std::string& line)
  {
    for (const char candidate : { ';', '\t', ',' })
    {
      this->divider = line.find(candidate) != nowhere ? candidate : this->divider;
    }
    static constexpr std::array<std::string_view, 5> names{ "name", "type", "x", "y", "z" };
    std::string lower = line;
    std::transform(lower.begin(), lower.end(), lower.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::vector<std::string_view> head = fieldsOf(lower, this->divider);
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      const auto found = std::find(head.begin(), head.end(), names[k]);
      this->column[k] = static_cast<std::size_t>(found - head.begin());
      if (found == head.end() && names[k] != "type")
      {
        this->refuse("the first line names no column " + inQuotes(names[k]) +
          "; write name,type,x,y,z and a point a line below");
      }
    }
  }

  std::string_view field(const std::vector<std::string_view>& row, int k) const
  {
    return this->column[k] < row.size() ? row[this->column[k]] : std::string_view();
  }

  /// Tables of countries that write decimals with a comma divide columns otherwise.
  bool readNumber(std::string_view word, double& value) const
  {
    std::string text(word);
    if (this->divider != ',')
    {
      std::replace(text.begin(), text.end(), ',', '.');
    }
    return parseNumber(text, value);
  }

  CurveTitle titleOf(const std::vector<std::string_view>& row) const
  {
    const std::string_view name = this->field(row, 0);
    const std::string_view type = this->field(row, 1);
    if (name.empty())
    {
      this->refuse("the point has no curve; give it the name of one");
    }
    if (type.empty())
    {
      return curveTitle(name);
    }
    const auto kind = curveKindOf(type);
    if (!kind)
    {
      this->refuse("unknown curve type " + inQuotes(type) + "; use " + curveKindWords);
    }
    return { *kind, std::string(name) };
  }

  void endCurve()
  {
    if (this->ids.size() == 1)
    {
      this->refuse("curve " + inQuotes(this->title.name) +
        " has one point only above this line; it needs two");
    }
    if (!this->ids.empty())
    {
      this->curves.add(this->ids, this->title);
    }
    this->ids.clear();
  }

  void readRow(const std::string& line)
  {
    const std::vector<std::string_view> row = fieldsOf(line, this->divider);
    CurveTitle next = this->titleOf(row);
    if (next.name != this->title.name || next.kind.type != this->title.kind.type ||
      next.kind.keyShape != this->title.kind.keyShape)
    {
      this->endCurve();
      this->title = std::move(next);
    }
    double x[3];
    for (int k = 0; k < 3; ++k)
    {
      const std::string_view word = this->field(row, 2 + k);
      if (!this->readNumber(word, x[k]))
      {
        this->refuse(inQuotes(word) + " is not a coordinate; write a decimal number");
      }
    }
    this->ids.push_back(this->points->InsertNextPoint(x));
  }
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readCsvCurves(const std::string& path)
{
  const std::string text = readWholeFile(path);
  CsvReader reader(path, text);
  reader.points->SetDataTypeToDouble();
  bool headed = false;
  std::string line;
  while (reader.lines.next(line))
  {
    if (line.find_first_not_of(" \t\",;") == nowhere)
    {
      reader.endCurve(); // the next one may have the same name
      continue;
    }
    if (headed)
    {
      reader.readRow(line);
    }
    else
    {
      reader.readHead(line);
      headed = true;
    }
  }
  reader.endCurve();
  if (reader.curves.empty())
  {
    throw InputError(path, "has no curve; write name,type,x,y,z and a point a line below");
  }
  return reader.curves.polyData(reader.points);
}
}
