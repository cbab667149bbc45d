// SPDX-License-Identifier: BSD-3-Clause
// Between JavaScript and Core.
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"
#include "Input/Columns.h"
#include "Input/DataSet.h"
#include "Options/Option.h"
#include "Report/ReportRows.h"

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>
#include <vector>

namespace flattening::web
{
using emscripten::val;

/// A typed array of its own. \tparam Number of a value of the vector, such as double of a Point3
template <class Number, class Value>
val arrayOf(const std::vector<Value>& values)
{
  const auto count = values.size() * (sizeof(Value) / sizeof(Number));
  const auto* const data = reinterpret_cast<const Number*>(values.data());
  return val(emscripten::typed_memory_view(count, data)).call<val>("slice");
}

/// Ids as an Int32Array.
template <class Id>
val idsOf(const std::vector<Id>& ids)
{
  return arrayOf<int>(std::vector<int>(ids.begin(), ids.end()));
}

/// By name a typed array, ids as Int32Array, or a list of texts.
val objectOf(const Columns& columns);
/// { points, corners, lines, pointArrays, cellArrays, fieldArrays }, polygons as triangles.
val objectOf(const DataSet& data);
val objectOf(const ReportValue& value);
/// { code, name, message, ids, kind }
val objectOf(const Status& status);

/// Points from a Float64Array or a list of numbers, three a point. Throws std::invalid_argument.
Points3 pointsOf(const val& numbers);
/// Polylines with the arrays of feature curves, of { points, type, name, tolerance }. Throws
/// std::invalid_argument.
DataSet curvesOf(const val& list);
/// Value of an option: word, text, flag or number, or a list of numbers. Throws
/// std::invalid_argument.
OptionValue valueOf(const Option& option, const val& value);
}
