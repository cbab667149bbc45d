// SPDX-License-Identifier: BSD-3-Clause
#include "Conversions.h"

#include "Base/ThreadedLoop.h"
#include "Base/Types.h"
#include "Flattening/FlatteningOptions.h"
#include "Input/ClothInput.h"
#include "Input/CurvedSurface.h"
#include "Input/InputSurface.h"
#include "Input/StatusWords.h"
#include "Options/OptionTable.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <variant>

namespace flattening::python
{
OptionValue valueOf(const Option& option, const py::handle& value)
{
  switch (option.type)
  {
    case OptionType::Text:
      return value.cast<std::string>();
    case OptionType::Ids:
    case OptionType::Numbers:
    {
      std::vector<double> numbers;
      for (const py::handle number : value)
      {
        numbers.push_back(number.cast<double>());
      }
      return numbers;
    }
    default:
      return value.cast<double>();
  }
}

py::object textOf(const std::string& text)
{
  PyObject* const decoded =
    PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (!decoded)
  {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::object>(decoded);
}

py::dict dictOf(Columns columns)
{
  py::dict dict;
  for (Column& column : columns)
  {
    dict[textOf(column.name)] = std::visit(
      [&column](auto&& values) -> py::object {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_same_v<Value, std::string>)
        {
          return textsOf(values);
        }
        else
        {
          return arrayOf<Value>(std::move(values), column.components);
        }
      },
      std::move(column.values));
  }
  return dict;
}

namespace
{
/// Columns of arrays and of lists of texts.
Columns columnsOf(const py::dict& arrays)
{
  Columns columns;
  for (const auto& [name, values] : arrays)
  {
    Column column{ name.cast<std::string>(), {} };
    const bool list = py::isinstance<py::list>(values);
    if (list && (py::len(values) == 0 || py::isinstance<py::str>(values[py::int_(0)])))
    {
      column.values = values.cast<std::vector<std::string>>();
    }
    else
    {
      const auto array = py::array::ensure(values);
      column.components = array.ndim() > 1 ? static_cast<int>(array.shape(1)) : 1;
      const auto take = [&](const auto& all) {
        using Value = typename std::decay_t<decltype(all)>::value_type;
        column.values = std::vector<Value>(all.data(), all.data() + all.size());
      };
      const char kind = array.dtype().kind();
      if (kind == 'f')
      {
        take(Numbers(array));
      }
      else if (kind == 'i' && array.itemsize() == sizeof(int))
      {
        take(py::array_t<int, py::array::c_style>(array));
      }
      else if (kind == 'b' || (kind == 'u' && array.itemsize() == 1))
      {
        take(py::array_t<unsigned char, py::array::c_style | py::array::forcecast>(array));
      }
      else
      {
        take(Ids(array));
      }
    }
    columns.push_back(std::move(column));
  }
  return columns;
}
}

DataSet dataSetOf(const py::dict& data)
{
  DataSet set;
  const auto points = data["points"].cast<Numbers>();
  const auto components = points.shape(1); // of others there are no points
  Points3 places;
  places.reserve(static_cast<std::size_t>(points.shape(0)));
  for (py::ssize_t k = 0; (components == 2 || components == 3) && k < points.shape(0); ++k)
  {
    const double* const x = points.data() + components * k;
    places.emplace_back(x[0], x[1], components == 3 ? x[2] : 0.0);
  }
  set.points = std::make_shared<const Points3>(std::move(places));
  const auto idsOf = [](const py::handle& values) {
    const auto ids = values.cast<Ids>();
    return std::vector<std::int64_t>(ids.data(), ids.data() + ids.size());
  };
  if (data.contains("corners"))
  {
    set.faces.ids = idsOf(data["corners"]);
    if (data.contains("offsets"))
    {
      set.faces.offsets = idsOf(data["offsets"]);
    }
    else
    {
      for (std::size_t k = 3; k <= set.faces.ids.size(); k += 3)
      {
        set.faces.offsets.push_back(static_cast<std::int64_t>(k));
      }
    }
  }
  for (const auto& [key, list] : { std::pair("lines", &set.lines), { "strips", &set.strips } })
  {
    for (const py::handle cell : data.contains(key) ? data[key].cast<py::list>() : py::list())
    {
      list->add(idsOf(cell));
    }
  }
  set.vertexCells = data.contains("vertices") ? data["vertices"].cast<std::size_t>() : 0;
  for (const auto& [key, columns] : { std::pair("point_arrays", &set.pointArrays),
         { "cell_arrays", &set.cellArrays }, { "field_arrays", &set.fieldArrays } })
  {
    *columns = data.contains(key) ? columnsOf(data[key].cast<py::dict>()) : Columns();
    const py::dict roles = data.contains("roles") ? data["roles"].cast<py::dict>() : py::dict();
    for (Column& column : *columns)
    {
      const py::tuple name = py::make_tuple(key, column.name);
      column.role =
        roles.contains(name) ? static_cast<ArrayRole>(roles[name].cast<int>()) : ArrayRole::None;
    }
  }
  return set;
}

py::dict dictOf(DataSet data)
{
  py::list lines;
  for (std::size_t k = 0; k < data.lines.size(); ++k)
  {
    lines.append(
      arrayOf<std::int64_t>(std::vector<std::int64_t>(data.lines.begin(k), data.lines.end(k))));
  }
  py::dict roles;
  for (const auto& [key, columns] :
    { std::pair("point_arrays", &data.pointArrays), { "cell_arrays", &data.cellArrays } })
  {
    for (const Column& column : *columns)
    {
      if (column.role != ArrayRole::None)
      {
        roles[py::make_tuple(key, textOf(column.name))] = static_cast<int>(column.role);
      }
    }
  }
  using pybind11::literals::operator""_a;
  return py::dict("points"_a = arrayOf<double>(Points3(*data.points)),
    "corners"_a = arrayOf<std::int64_t>(std::move(data.faces.ids)),
    "offsets"_a = arrayOf<std::int64_t>(std::move(data.faces.offsets)), "lines"_a = lines,
    "point_arrays"_a = dictOf(std::move(data.pointArrays)),
    "cell_arrays"_a = dictOf(std::move(data.cellArrays)),
    "field_arrays"_a = dictOf(std::move(data.fieldArrays)), "roles"_a = roles);
}

py::object objectOf(const ReportValue& value)
{
  return std::visit(
    [](const auto& held) -> py::object {
      using Held = std::decay_t<decltype(held)>;
      if constexpr (std::is_same_v<Held, std::nullptr_t>)
      {
        return py::none();
      }
      else if constexpr (std::is_same_v<Held, std::string>)
      {
        return textOf(held);
      }
      else if constexpr (std::is_same_v<Held, ReportList>)
      {
        py::list list;
        for (const ReportValue& item : held)
        {
          list.append(objectOf(item));
        }
        return std::move(list);
      }
      else if constexpr (std::is_same_v<Held, ReportObject>)
      {
        py::dict dict;
        for (const auto& [key, item] : held)
        {
          dict[key.c_str()] = objectOf(item);
        }
        return std::move(dict);
      }
      else
      {
        return py::cast(held);
      }
    },
    value.value);
}

LoadedBody bodyOf(const py::object& surface)
{
  return surface.is_none() ? LoadedBody()
                           : loadBody(readTriangles(dataSetOf(surface.cast<py::dict>())));
}

py::list textsOf(const std::vector<std::string>& texts)
{
  py::list list;
  for (const std::string& text : texts)
  {
    list.append(textOf(text));
  }
  return list;
}

py::tuple tupleOf(const Status& status)
{
  py::list remedies;
  for (const SuggestedRemedy& suggested : status.remedies)
  {
    remedies.append(py::make_tuple(remedyName(suggested.remedy), textOf(suggested.subject)));
  }
  py::list ids;
  for (const std::int64_t id : status.ids.values)
  {
    ids.append(id);
  }
  return py::make_tuple(static_cast<int>(status.code), statusName(status.code),
    textOf(status.message), ids, kindName(status.ids.kind), remedies);
}

namespace
{
/// The rows of a list; none where it is not given.
template <class... Values>
std::vector<std::tuple<Values...>> rowsOf(const py::dict& values, const char* property)
{
  return values.contains(property) ? values[property].cast<std::vector<std::tuple<Values...>>>()
                                   : std::vector<std::tuple<Values...>>();
}
}

Settings::Settings(const std::string& owner, const py::dict& values)
{
  const auto has = [&values](const char* property) { return values.contains(property); };
  const OptionOwner last = ownerNamed(owner).value();
  for (const Option* const option : optionsOf(last))
  {
    if (option->set && has(option->property.c_str()))
    {
      option->set(this->structures, valueOf(*option, values[option->property.c_str()]));
    }
  }
  this->structures.proposes = last == OptionOwner::Suggestion;
  FlatteningOptions& flattening = this->structures.flattening;
  if (last == OptionOwner::Conformal)
  {
    flattening.scheme = Scheme::LeastSquaresConformal;
    const auto ids = values["Pins"].cast<py::sequence>();
    this->pins = { ids[0].cast<std::int64_t>(), ids[1].cast<std::int64_t>() };
  }
  this->weights = has("WeightArray") ? values["WeightArray"].cast<std::string>() : std::string();
  const auto material = values["Material"].cast<std::string>();
  if (!material.empty())
  {
    std::vector<std::string> grain;
    for (const auto& [entry] : rowsOf<std::string>(values, "Grain"))
    {
      grain.push_back(entry);
    }
    flattening.cloth = readCloth(material, grain);
  }
  for (const auto& [curve, tolerance] : rowsOf<std::string, double>(values, "CurveTolerances"))
  {
    this->tolerances[curve] = tolerance;
    if (curve == boundaryName)
    {
      flattening.boundaryTolerance = tolerance;
    }
  }
  for (const auto& [curve, weight] : rowsOf<std::string, double>(values, "Preferences"))
  {
    this->structures.search.preferences.push_back({ curve, weight });
  }
  for (const auto& [curve] : rowsOf<std::string>(values, "KeptCurves"))
  {
    this->keptCurves.insert(curve);
  }
  for (const auto& [curve, piece, fraction] :
    rowsOf<std::string, Index, double>(values, "CurveEases"))
  {
    flattening.eases.push_back({ curve, piece, fraction });
  }
}

WatchedRun::WatchedRun(py::object progress)
  : Progress(std::move(progress))
{
  this->tell(0.0);
}

Execution WatchedRun::execution()
{
  Execution execution;
  execution.progress = [this](double fraction, const char*) { this->tell(fraction); };
  execution.cancel = [this] {
    // Who watches may want to end the run, however long a phase takes.
    if (Clock::now() - this->Told > std::chrono::milliseconds(50))
    {
      this->tell(this->Fraction);
    }
    return this->Ended;
  };
  execution.parallel = ThreadedLoop();
  return execution;
}

void WatchedRun::tell(double fraction)
{
  this->Fraction = fraction;
  if (!this->Raised)
  {
    const py::gil_scoped_acquire lock;
    try
    {
      if (PyErr_CheckSignals() != 0)
      {
        throw py::error_already_set();
      }
      if (!this->Progress.is_none())
      {
        this->Progress(fraction);
      }
    }
    catch (...)
    {
      this->Raised = std::current_exception();
      this->Ended = true;
    }
  }
  this->Told = Clock::now();
}

void WatchedRun::finish(bool early)
{
  if (!this->Raised)
  {
    this->tell(1.0);
  }
  if (!this->Raised)
  {
    return;
  }
  try
  {
    std::rethrow_exception(this->Raised);
  }
  catch (const py::error_already_set& error)
  {
    if (!early || !error.matches(PyExc_KeyboardInterrupt))
    {
      throw;
    }
  }
}
}
