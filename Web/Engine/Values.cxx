// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "CurveList.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Options/OptionTable.h"
#include "Options/OptionValues.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

namespace flattening::web
{
namespace
{
template <class Item>
val listOf(const std::vector<Item>& items)
{
  val list = val::array();
  for (const Item& item : items)
  {
    if constexpr (std::is_same_v<Item, ReportValue>)
    {
      list.call<void>("push", objectOf(item));
    }
    else
    {
      list.call<void>("push", item);
    }
  }
  return list;
}

/// What the page calls an option: "close cuts", "scheme isometric".
std::string inPlainWords(const std::string& property, const std::string& value)
{
  std::string words;
  for (const Option& option : optionTable())
  {
    if (option.property == property)
    {
      words = labelOf(option) + (value.empty() ? "" : " " + value);
    }
  }
  std::transform(
    words.begin(), words.end(), words.begin(), [](unsigned char c) { return std::tolower(c); });
  return words;
}
}

val objectOf(const Columns& columns)
{
  val object = val::object();
  for (const Column& column : columns)
  {
    object.set(column.name,
      std::visit(
        [](const auto& values) -> val {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_same_v<Value, std::string>)
          {
            return listOf(values);
          }
          else if constexpr (std::is_same_v<Value, std::int64_t>)
          {
            return idsOf(values);
          }
          else
          {
            return arrayOf<Value>(values);
          }
        },
        column.values));
  }
  return object;
}

val objectOf(const DataSet& data)
{
  val lines = val::array();
  for (std::size_t k = 0; k < data.lines.size(); ++k)
  {
    lines.call<void>("push", idsOf(std::vector<int>(data.lines.begin(k), data.lines.end(k))));
  }
  std::vector<int> corners;
  const SurfaceTriangles read = data.faces.size() > 0 ? readTriangles(data) : SurfaceTriangles();
  for (const Triangle& triangle : read.triangles)
  {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  val object = val::object();
  object.set("points", arrayOf<double>(*data.points));
  object.set("corners", arrayOf<int>(corners));
  object.set("lines", lines);
  object.set("pointArrays", objectOf(data.pointArrays));
  object.set("cellArrays", objectOf(data.cellArrays));
  object.set("fieldArrays", objectOf(data.fieldArrays));
  return object;
}

val objectOf(const ReportValue& value)
{
  return std::visit(
    [](const auto& held) -> val {
      using Held = std::decay_t<decltype(held)>;
      if constexpr (std::is_same_v<Held, std::nullptr_t>)
      {
        return val::null();
      }
      else if constexpr (std::is_same_v<Held, std::int64_t>)
      {
        return val(static_cast<double>(held));
      }
      else if constexpr (std::is_same_v<Held, ReportList>)
      {
        return listOf(held);
      }
      else if constexpr (std::is_same_v<Held, ReportObject>)
      {
        val object = val::object();
        for (const auto& [key, item] : held)
        {
          object.set(key, objectOf(item));
        }
        return object;
      }
      else
      {
        return val(held);
      }
    },
    value.value);
}

val objectOf(const Status& status)
{
  val object = val::object();
  object.set("code", static_cast<int>(status.code));
  object.set("name", std::string(statusName(status.code)));
  object.set("message", describeDefect(status.message, remediesOf(status), inPlainWords));
  object.set("ids", idsOf(status.ids.values));
  object.set("kind", std::string(kindName(status.ids.kind)));
  return object;
}

Points3 pointsOf(const val& numbers)
{
  const std::vector<double> all = emscripten::convertJSArrayToNumberVector<double>(numbers);
  if (all.size() % 3 != 0)
  {
    throw std::invalid_argument("points must be three numbers each");
  }
  Points3 points(all.size() / 3);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k] = Point3(all[3 * k], all[3 * k + 1], all[3 * k + 2]);
  }
  return points;
}

DataSet curvesOf(const val& list)
{
  DataSet data;
  Points3 points;
  std::vector<std::string> names;
  std::vector<int> types;
  std::vector<int> shapes;
  std::vector<double> tolerances;
  const auto count = list.isUndefined() ? 0 : list["length"].as<std::size_t>();
  for (std::size_t k = 0; k < count; ++k)
  {
    const val curve = list[k];
    std::vector<std::int64_t> line;
    for (const Point3& point : pointsOf(curve["points"]))
    {
      line.push_back(static_cast<std::int64_t>(points.size()));
      points.push_back(point);
    }
    data.lines.add(line);
    const auto word =
      curve["type"].isString() ? curve["type"].as<std::string>() : std::string("accessory");
    const std::optional<wirewarp::CurveKind> kind = wirewarp::curveKindOf(word);
    if (!kind)
    {
      throw std::invalid_argument(
        "a curve has the type \"" + word + "\"; it must be " + wirewarp::curveKindWords);
    }
    types.push_back(kind->type);
    shapes.push_back(kind->keyShape);
    const auto name = curve["name"].isString() ? curve["name"].as<std::string>() : std::string();
    names.push_back(name.empty() ? "curve " + std::to_string(k) : name);
    tolerances.push_back(curve["tolerance"].isNumber() ? curve["tolerance"].as<double>() : 0.0);
  }
  data.points = std::make_shared<const Points3>(std::move(points));
  data.cellArrays = { { "CurveName", std::move(names) }, { "CurveType", std::move(types) },
    { "KeyShape", std::move(shapes) }, { "LengthTolerance", std::move(tolerances) } };
  return data;
}

OptionValue valueOf(const Option& option, const val& value)
{
  const auto refuse = [&option](const std::string& what) {
    throw std::invalid_argument(
      "option " + spelled(option, OptionSpelling::Python) + " must be " + what);
  };
  if (option.type == OptionType::Text)
  {
    return value.as<std::string>();
  }
  if (option.type == OptionType::Ids || option.type == OptionType::Numbers)
  {
    return emscripten::convertJSArrayToNumberVector<double>(value);
  }
  if (option.type == OptionType::Word)
  {
    const auto word = value.isString() ? value.as<std::string>() : std::string();
    std::string known;
    for (std::size_t k = 0; k < option.words.size(); ++k)
    {
      if (option.words[k].word == word)
      {
        return static_cast<double>(k);
      }
      known += (k > 0 ? ", " : "") + option.words[k].word;
    }
    refuse("one of " + known);
  }
  if (option.type == OptionType::Flag)
  {
    return value.isTrue() ? 1.0 : 0.0;
  }
  const OptionValue number =
    value.isNumber() ? value.as<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!isValid(option, number))
  {
    refuse("a number in " + rangeOf(option));
  }
  return number;
}
}
