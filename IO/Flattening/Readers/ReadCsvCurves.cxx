// SPDX-License-Identifier: BSD-3-Clause
#include "ReadCsvCurves.h"

#include "CurveBuilder.h"
#include "InputError.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
constexpr std::size_t nowhere = std::string_view::npos;

/// The fields of a line; none where quotes are not closed, or go on behind their end.
std::optional<std::vector<std::string>> fieldsOf(std::string_view line, char divider)
{
  const std::string_view blanks = divider == '\t' ? " " : " \t";
  std::vector<std::string> fields;
  for (;;)
  {
    std::string_view rest = line.substr(std::min(line.find_first_not_of(blanks), line.size()));
    if (!rest.empty() && rest.front() == '"')
    {
      const std::optional<std::string> field = takeQuoted(rest);
      rest = rest.substr(std::min(rest.find_first_not_of(blanks), rest.size()));
      if (!field || (!rest.empty() && rest.front() != divider))
      {
        return std::nullopt;
      }
      fields.emplace_back(trimmed(*field));
      line = rest;
    }
    else
    {
      const std::size_t end = std::min(line.find(divider), line.size());
      fields.emplace_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end);
    }
    if (line.empty())
    {
      return fields;
    }
    line.remove_prefix(1);
  }
}

/// A line without what stands in quotes.
std::string unquoted(const std::string& line)
{
  std::string text;
  bool quoted = false;
  for (const char c : line)
  {
    quoted = quoted != (c == '"');
    text += quoted ? "" : std::string(1, c);
  }
  return text;
}

/// What a row says of its curve.
struct RowTitle
{
  std::string field; ///< of the name
  CurveTitle curve;
  bool isEdge = false;

  bool operator==(const RowTitle& other) const
  {
    return this->curve.name == other.curve.name && this->curve.kind.type == other.curve.kind.type &&
      this->curve.kind.keyShape == other.curve.kind.keyShape && this->isEdge == other.isEdge;
  }
};

struct CsvReader
{
  LineReader lines;
  CurveBuilder builder;
  char divider = ',';
  std::array<std::size_t, 5> column{}; ///< of name, type, x, y, z
  RowTitle title = {};
  Points3 points = {};                ///< of the curve
  std::vector<std::int64_t> ids = {}; ///< of an edge

  CsvReader(const std::string& path, const std::string& text, const DataSet& owner)
    : lines(path, text, false)
    , builder(this->lines, owner, false)
  {
  }

  [[noreturn]] void refuse(const std::string& text) const { this->lines.refuse(text); }

  std::vector<std::string> fields(std::string_view line) const
  {
    std::optional<std::vector<std::string>> row = fieldsOf(line, this->divider);
    if (!row)
    {
      this->refuse(
        "a field in quotes does not end with them; write \"...\", and \"\" for a quote in it");
    }
    return std::move(*row);
  }

  void readHead(const std::string& line)
  {
    const std::string dividers = unquoted(line);
    for (const char candidate : { ';', '\t', ',' })
    {
      this->divider = dividers.find(candidate) != nowhere ? candidate : this->divider;
    }
    static constexpr std::array<std::string_view, 5> names{ "name", "type", "x", "y", "z" };
    const std::vector<std::string> head = this->fields(lowered(line));
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      const auto found = std::find(head.begin(), head.end(), names[k]);
      this->column[k] =
        found == head.end() ? nowhere : static_cast<std::size_t>(found - head.begin());
      if (found == head.end() && names[k] != "type")
      {
        this->refuse("the first line names no column " + inQuotes(names[k]) +
          "; write name,type,x,y,z and one point on each line below");
      }
    }
  }

  std::string field(const std::vector<std::string>& row, std::size_t k) const
  {
    return this->column[k] < row.size() ? row[this->column[k]] : std::string();
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

  RowTitle titleOf(const std::vector<std::string>& row) const
  {
    const std::string name = this->field(row, 0);
    const std::string type = this->field(row, 1);
    if (name.empty())
    {
      this->refuse("the point has no curve; give it the name of one");
    }
    if (type.empty() && this->size() > 0 && name == this->title.field)
    {
      return this->title;
    }
    if (type.empty())
    {
      std::string_view rest(name);
      const bool isEdge = isEdgeWord(takeWord(rest)) && !trimmed(rest).empty();
      return { name, isEdge ? CurveTitle{ {}, std::string(trimmed(rest)) } : curveTitle(name),
        isEdge };
    }
    const RowType type_of_row = rowType(type, this->lines);
    return { name, { type_of_row.kind, name }, type_of_row.isEdge };
  }

  /// Points of the curve so far.
  std::size_t size() const { return this->points.size() + this->ids.size(); }

  void endCurve()
  {
    if (this->size() == 1)
    {
      this->refuse("curve " + inQuotes(this->title.curve.name) +
        " has one point only above this line; it needs two");
    }
    if (this->title.isEdge && !this->ids.empty())
    {
      this->builder.addIds(this->title.curve, true, this->ids);
    }
    else if (!this->points.empty())
    {
      this->builder.addLine(this->title.curve, this->points);
    }
    this->points.clear();
    this->ids.clear();
  }

  void readRow(const std::string& line)
  {
    const std::vector<std::string> row = this->fields(line);
    RowTitle next = this->titleOf(row);
    if (!(next == this->title))
    {
      this->endCurve();
      this->title = std::move(next);
    }
    const std::string words = this->field(row, 2);
    if (CurveBuilder::areWords(words))
    {
      this->endCurve();
      this->builder.addWords(this->title.curve, this->title.isEdge, words);
      return;
    }
    Point3 x;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::string word = this->field(row, 2 + k);
      if (!this->readNumber(word, x[static_cast<Eigen::Index>(k)]))
      {
        this->refuse(inQuotes(word) + " is not a coordinate; write a decimal number");
      }
    }
    if (this->title.isEdge)
    {
      this->ids.push_back(this->builder.borderVertex(x, this->title.curve.name));
      return;
    }
    this->points.push_back(x);
  }
};
}

DataSet readCsvCurves(const std::string& path, const DataSet& surface)
{
  const std::string text = readWholeFile(path);
  CsvReader reader(path, text, surface);
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
  if (reader.builder.empty())
  {
    throw InputError(path, "has no curve; write name,type,x,y,z and one point on each line below");
  }
  return reader.builder.take();
}
}
