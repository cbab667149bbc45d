// SPDX-License-Identifier: BSD-3-Clause
#include "DataSetBytes.h"

#include "PlainText.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace wirewarp
{
namespace
{
using flattening::CellList;
using flattening::Column;
using flattening::Columns;
using flattening::ColumnValues;
using flattening::DataSet;
using flattening::Points3;

constexpr std::int64_t mostComponents = 1 << 16;

void check(bool sound, const char* text)
{
  if (!sound)
  {
    throw std::runtime_error(text);
  }
}

/// Takes values into bytes.
class Packer
{
public:
  std::string Bytes;

  void number(std::int64_t& value)
  {
    this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  template <class List>
  void list(List& values)
  {
    this->size(values, 0);
    this->Bytes.append(
      reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  }

  template <class List>
  void size(List& values, std::size_t)
  {
    auto count = static_cast<std::int64_t>(values.size());
    this->number(count);
  }
};

/// Gives values what the bytes hold, with memory only where there are bytes for it.
class Unpacker
{
public:
  std::string_view Rest;

  void number(std::int64_t& value)
  {
    check(sizeof value <= this->Rest.size(), "ends too early");
    this->take(&value, sizeof value);
  }

  template <class List>
  void list(List& values)
  {
    this->size(values, sizeof(values[0]));
    this->take(values.data(), values.size() * sizeof(values[0]));
  }

  /// \param bytesEach that follow of each value at least
  template <class List>
  void size(List& values, std::size_t bytesEach)
  {
    std::int64_t count = 0;
    this->number(count);
    check(count >= 0 && static_cast<std::uint64_t>(count) <= this->Rest.size() / bytesEach,
      "ends too early");
    values.resize(static_cast<std::size_t>(count));
  }

private:
  void take(void* to, std::size_t size)
  {
    if (size > 0)
    {
      std::memcpy(to, this->Rest.data(), size);
    }
    this->Rest.remove_prefix(size);
  }
};

/// Passes a number on as a whole one within limits.
template <class Stream, class Number>
void pass(Stream& stream, Number& value, std::int64_t least, std::int64_t most, const char* defect)
{
  auto whole = static_cast<std::int64_t>(value);
  stream.number(whole);
  check(whole >= least && whole <= most, defect);
  value = static_cast<Number>(whole);
}

template <class Stream>
void pass(Stream& stream, CellList& cells, std::int64_t pointCount)
{
  stream.list(cells.offsets);
  stream.list(cells.ids);
  check(!cells.offsets.empty() && cells.offsets.front() == 0 &&
      std::is_sorted(cells.offsets.begin(), cells.offsets.end()) &&
      cells.offsets.back() == static_cast<std::int64_t>(cells.ids.size()),
    "has damaged cells");
  for (const std::int64_t id : cells.ids)
  {
    if (std::is_same_v<Stream, Unpacker> && (id < 0 || id >= pointCount))
    {
      throw std::runtime_error("a cell names point " + std::to_string(id) + " of " +
        std::to_string(pointCount) + "; ids count from 0");
    }
  }
}

ColumnValues emptyValues(std::size_t kind)
{
  // In the order of the variant.
  const std::array<ColumnValues, 5> kinds{ std::vector<double>(), std::vector<std::int64_t>(),
    std::vector<int>(), std::vector<unsigned char>(), std::vector<std::string>() };
  static_assert(std::variant_size_v<ColumnValues> == std::tuple_size_v<decltype(kinds)>);
  return kinds[kind];
}

template <class Stream>
void pass(Stream& stream, Column& column)
{
  const char* const damaged = "has a damaged array";
  stream.list(column.name);
  pass(stream, column.components, 1, mostComponents, damaged);
  pass(
    stream, column.role, -1, static_cast<std::int64_t>(flattening::ArrayRole::Tangents), damaged);
  std::size_t kind = column.values.index();
  pass(stream, kind, 0, std::variant_size_v<ColumnValues> - 1, damaged);
  if (kind != column.values.index())
  {
    column.values = emptyValues(kind);
  }
  std::visit(
    [&](auto& values) {
      if constexpr (std::is_same_v<std::decay_t<decltype(values)>, std::vector<std::string>>)
      {
        stream.size(values, sizeof(std::int64_t));
        for (std::string& text : values)
        {
          stream.list(text);
        }
      }
      else
      {
        stream.list(values);
      }
      check(values.size() % static_cast<std::size_t>(column.components) == 0, damaged);
    },
    column.values);
}

template <class Stream>
void pass(Stream& stream, DataSet& data)
{
  Points3 points = *data.points;
  stream.list(points);
  data.points = std::make_shared<const Points3>(std::move(points));
  pass(stream, data.vertexCells, 0, std::numeric_limits<int>::max(), "has damaged cells");
  for (CellList* const cells : { &data.lines, &data.faces, &data.strips })
  {
    pass(stream, *cells, static_cast<std::int64_t>(data.points->size()));
  }
  for (Columns* const columns : { &data.pointArrays, &data.cellArrays, &data.fieldArrays })
  {
    stream.size(*columns, sizeof(std::int64_t));
    for (Column& column : *columns)
    {
      pass(stream, column);
    }
  }
}

/// Names as XML can hold them, and texts without the character that ends them in VTK.
void clean(Columns& columns)
{
  for (Column& column : columns)
  {
    column.name = plainText(column.name);
    auto* const texts = std::get_if<std::vector<std::string>>(&column.values);
    for (std::size_t k = 0; texts && k < texts->size(); ++k)
    {
      std::replace((*texts)[k].begin(), (*texts)[k].end(), '\0', ' ');
    }
  }
}
}

std::string packDataSet(DataSet data)
{
  Packer packer;
  pass(packer, data);
  return std::move(packer.Bytes);
}

DataSet unpackDataSet(std::string_view bytes)
{
  Unpacker unpacker{ bytes };
  DataSet data;
  pass(unpacker, data);
  check(unpacker.Rest.empty(), "has more data than it announces");
  for (Columns* const columns : { &data.pointArrays, &data.cellArrays, &data.fieldArrays })
  {
    clean(*columns);
  }
  return data;
}
}
