// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FieldArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace flattening
{
namespace bridge
{
/// Writes a table with one row per element of a list, column by column.
template <class Row>
class TableColumns
{
public:
  /// The list must live as long as this.
  TableColumns(vtkTable* table, const std::vector<Row>& rows)
    : Data(table->GetRowData())
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
      this->addAs<vtkIntArray, int>(name, value);
    }
    else if constexpr (std::is_integral_v<Result>)
    {
      this->addAs<vtkIdTypeArray, vtkIdType>(name, value);
    }
    else if constexpr (std::is_floating_point_v<Result>)
    {
      this->addAs<vtkDoubleArray, double>(name, value);
    }
    else
    {
      this->addAs<vtkStringArray, std::string>(name, value);
    }
  }

  /// Adds a column of the rows' numbers, from 0.
  void addNumbers(const char* name) const
  {
    addRows<vtkIdTypeArray>(this->Data, name, this->Rows.size(),
      [](std::size_t row) { return static_cast<vtkIdType>(row); });
  }

private:
  template <class Array, class Type, class Value>
  void addAs(const char* name, const Value& value) const
  {
    addRows<Array>(this->Data, name, this->Rows.size(), [this, &value](std::size_t row) {
      return static_cast<Type>(std::invoke(value, this->Rows[row]));
    });
  }

  vtkDataSetAttributes* Data;
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
}
