// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace flattening
{
/// Values of an array: those of a row one after the other.
using ColumnValues = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<int>,
  std::vector<unsigned char>, std::vector<std::string>>;

/// What viewers take an array of points or cells for, in VTK's order.
enum class ArrayRole
{
  None = -1,
  Scalars,
  Vectors,
  Normals,
  TextureCoordinates,
  Tensors,
  GlobalIds,
  PedigreeIds,
  EdgeFlags,
  Tangents,
};

/// An array with a name, as front ends make it their own: of a table, or of points or cells.
struct Column
{
  std::string name;
  ColumnValues values;
  int components = 1;
  ArrayRole role = ArrayRole::None;

  std::size_t rows() const;
  bool isText() const { return std::holds_alternative<std::vector<std::string>>(this->values); }
  /// A value as a number; 0 of a text.
  double number(std::size_t row, int component = 0) const;
  /// A value as a text.
  std::string text(std::size_t row) const;
};

using Columns = std::vector<Column>;

/// The column of a name; null where there is none.
const Column* findColumn(const Columns& columns, const std::string& name);

/// Of a table.
std::size_t rowsOf(const Columns& table);

/// A value of a table; 0 or empty where there is no such column or row.
double numberIn(const Columns& table, std::size_t row, const std::string& name);
std::int64_t integerIn(const Columns& table, std::size_t row, const std::string& name);
std::string textIn(const Columns& table, std::size_t row, const std::string& name);

/// Replaces the column of its name, or adds it.
void setColumn(Columns& columns, Column column);

/// Adds columns; one replaces that of its name.
void setColumns(Columns& columns, Columns added);

/// The rows of arrays that other elements are copies of, without ids that are of one element alone.
Columns copiedRows(const Columns& columns, const std::vector<std::int64_t>& rowOf);

/// Adds a column of one value a row, made by value(row).
template <class Type, class Value>
void addRows(Columns& columns, const char* name, std::size_t rows, const Value& value)
{
  std::vector<Type> values;
  values.reserve(rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    values.push_back(static_cast<Type>(value(row)));
  }
  columns.push_back({ name, std::move(values) });
}

/// Adds `LengthEase` and `EasedPiece` of curves, where one of them is eased. \param easeOf the
/// LengthEase of a row
template <class EaseOf>
void addEases(Columns& columns, std::size_t rows, const EaseOf& easeOf)
{
  bool eased = false;
  for (std::size_t row = 0; row < rows; ++row)
  {
    eased = eased || easeOf(row).fraction != 0.0;
  }
  if (eased)
  {
    addRows<double>(
      columns, "LengthEase", rows, [&](std::size_t row) { return easeOf(row).fraction; });
    addRows<int>(columns, "EasedPiece", rows, [&](std::size_t row) { return easeOf(row).piece; });
  }
}

/// Writes a table with one row per element of a list, column by column.
template <class Row>
class TableColumns
{
public:
  /// Both lists must live as long as this.
  TableColumns(Columns& columns, const std::vector<Row>& rows)
    : Written(columns)
    , Rows(rows)
  {
  }

  /// Adds a column. \param value a member of a row or a function of it: a truth value, written as 0
  /// or 1, an integer, a number or a text
  template <class Value>
  void add(const char* name, const Value& value) const
  {
    using Result = std::decay_t<std::invoke_result_t<const Value&, const Row&>>;
    if constexpr (std::is_same_v<Result, bool>)
    {
      this->addAs<int>(name, value);
    }
    else if constexpr (std::is_integral_v<Result>)
    {
      this->addAs<std::int64_t>(name, value);
    }
    else if constexpr (std::is_floating_point_v<Result>)
    {
      this->addAs<double>(name, value);
    }
    else
    {
      this->addAs<std::string>(name, value);
    }
  }

  /// The same as numbers of a type.
  template <class Type, class Value>
  void addAs(const char* name, const Value& value) const
  {
    addRows<Type>(this->Written, name, this->Rows.size(),
      [this, &value](std::size_t row) { return std::invoke(value, this->Rows[row]); });
  }

  /// Adds a column of the rows' numbers, from 0.
  void addNumbers(const char* name) const
  {
    addRows<std::int64_t>(
      this->Written, name, this->Rows.size(), [](std::size_t row) { return row; });
  }

private:
  Columns& Written;
  const std::vector<Row>& Rows;
};

/// The elements of the lists of several owners, each with the number of its owner.
template <class Owner, class Element>
std::vector<std::pair<std::size_t, Element>> numberedElements(
  const std::vector<Owner>& owners, std::vector<Element> Owner::*list)
{
  std::vector<std::pair<std::size_t, Element>> elements;
  for (std::size_t k = 0; k < owners.size(); ++k)
  {
    for (const Element& element : owners[k].*list)
    {
      elements.emplace_back(k, element);
    }
  }
  return elements;
}
}
