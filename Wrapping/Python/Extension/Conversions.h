// SPDX-License-Identifier: BSD-3-Clause
// Between numpy and Core.
#pragma once

#include "Base/Execution.h"
#include "Base/Status.h"
#include "Input/Columns.h"
#include "Input/DataSet.h"
#include "Options/OptionStructures.h"
#include "Options/OptionValues.h"
#include "Report/ReportRows.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flattening::python
{
namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ids = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// An array that keeps the values, which are not copied. \tparam Value a number, or a point of
/// numbers
template <class Number, class Value>
py::array arrayOf(std::vector<Value> values, int components = sizeof(Value) / sizeof(Number))
{
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  const auto count = static_cast<py::ssize_t>(kept->size() * (sizeof(Value) / sizeof(Number)));
  std::vector<py::ssize_t> shape{ count / components };
  if (components > 1)
  {
    shape.push_back(components);
  }
  const auto* const data = reinterpret_cast<const Number*>(kept->data());
  const py::capsule owner(
    kept.get(), [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
  static_cast<void>(kept.release()); // the capsule has it
  return py::array_t<Number>(shape, data, owner);
}

/// A text, with a mark for what is not UTF-8.
py::object textOf(const std::string& text);

/// Name: array, or list of texts.
py::dict dictOf(Columns columns);

/// Points, corners of polygons (without offsets of triangles), lines, strips, arrays, and their
/// roles.
DataSet dataSetOf(const py::dict& data);
py::dict dictOf(DataSet data);

/// As json would read it.
py::object objectOf(const ReportValue& value);

/// None: no body.
LoadedBody bodyOf(const py::object& surface);

/// The list as texts.
py::list textsOf(const std::vector<std::string>& texts);

/// Code, name, defect, ids, their kind, and remedies with their subjects.
py::tuple tupleOf(const Status& status);

OptionValue valueOf(const Option& option, const py::handle& value);

/// Core's options of a filter, and what it has beside them. \param values by property
struct Settings
{
  Settings(const std::string& owner, const py::dict& values);

  OptionStructures structures;
  std::map<std::string, double> tolerances;
  std::string weights; ///< cell array of the surface
  std::array<std::int64_t, 2> pins{ -1, -1 };
  std::set<std::string> keptCurves;
};

/// A run that Python sees: calls progress(), and ends with what that or a signal raises.
class WatchedRun
{
public:
  /// \param progress a function, or None
  explicit WatchedRun(py::object progress);

  Execution execution();
  /// Lets what follows run, although the run has been ended.
  void goOn() { this->Ended = false; }
  /// Raises what ended the run; tells the end of the others. \param early KeyboardInterrupt ends a
  /// run with what it has found so far
  void finish(bool early = false);

private:
  using Clock = std::chrono::steady_clock;

  void tell(double fraction);

  py::object Progress;
  double Fraction = 0.0;
  Clock::time_point Told = Clock::now();
  bool Ended = false;
  std::exception_ptr Raised;
};
}
