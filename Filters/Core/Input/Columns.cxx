// SPDX-License-Identifier: BSD-3-Clause
#include "Input/Columns.h"

#include <algorithm>
#include <sstream>

namespace flattening
{
namespace
{
/// The values of some rows one after the other.
template <class Value>
std::vector<Value> valuesOf(
  const std::vector<Value>& values, int components, const std::vector<std::int64_t>& rows)
{
  std::vector<Value> copied;
  copied.reserve(rows.size() * static_cast<std::size_t>(components));
  for (const std::int64_t row : rows)
  {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row) * components;
    copied.insert(copied.end(), first, first + components);
  }
  return copied;
}

/// A column that has a row; null where there is none.
const Column* cellOf(const Columns& table, std::size_t row, const std::string& name)
{
  const Column* const column = findColumn(table, name);
  return column && row < column->rows() ? column : nullptr;
}
}

std::size_t Column::rows() const
{
  return std::visit([](const auto& all) { return all.size(); }, this->values) /
    static_cast<std::size_t>(this->components);
}

double Column::number(std::size_t row, int component) const
{
  const std::size_t at =
    row * static_cast<std::size_t>(this->components) + static_cast<std::size_t>(component);
  return std::visit(
    [at](const auto& all) {
      using Value = typename std::decay_t<decltype(all)>::value_type;
      if constexpr (std::is_same_v<Value, std::string>)
      {
        return 0.0;
      }
      else
      {
        return static_cast<double>(all[at]);
      }
    },
    this->values);
}

std::string Column::text(std::size_t row) const
{
  if (const auto* const texts = std::get_if<std::vector<std::string>>(&this->values))
  {
    return (*texts)[row * static_cast<std::size_t>(this->components)];
  }
  std::ostringstream text;
  text << this->number(row);
  return text.str();
}

const Column* findColumn(const Columns& columns, const std::string& name)
{
  const auto found = std::find_if(
    columns.begin(), columns.end(), [&name](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::size_t rowsOf(const Columns& table)
{
  return table.empty() ? 0 : table.front().rows();
}

double numberIn(const Columns& table, std::size_t row, const std::string& name)
{
  const Column* const column = cellOf(table, row, name);
  return column ? column->number(row) : 0.0;
}

std::int64_t integerIn(const Columns& table, std::size_t row, const std::string& name)
{
  return static_cast<std::int64_t>(numberIn(table, row, name));
}

std::string textIn(const Columns& table, std::size_t row, const std::string& name)
{
  const Column* const column = cellOf(table, row, name);
  return column ? column->text(row) : std::string();
}

void setColumn(Columns& columns, Column column)
{
  const auto known = std::find_if(columns.begin(), columns.end(),
    [&column](const Column& other) { return other.name == column.name; });
  if (known == columns.end())
  {
    columns.push_back(std::move(column));
  }
  else
  {
    *known = std::move(column);
  }
}

void setColumns(Columns& columns, Columns added)
{
  for (Column& column : added)
  {
    setColumn(columns, std::move(column));
  }
}

Columns copiedRows(const Columns& columns, const std::vector<std::int64_t>& rowOf)
{
  Columns copied;
  for (const Column& column : columns)
  {
    if (column.role == ArrayRole::GlobalIds) // a copy would have the id of another
    {
      continue;
    }
    copied.push_back({ column.name,
      std::visit(
        [&](const auto& all) { return ColumnValues(valuesOf(all, column.components, rowOf)); },
        column.values),
      column.components, column.role });
  }
  return copied;
}
}
