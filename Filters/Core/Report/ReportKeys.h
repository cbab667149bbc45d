// SPDX-License-Identifier: BSD-3-Clause
// The keys of report.json and of Python's reports, each declared once. Front ends may include this
// header: it needs the standard library alone.
#pragma once

#include <string>
#include <vector>

namespace flattening
{
/// What a key of a report has for a value.
enum class ReportKind
{
  Text,
  Integer,
  Number,
  Truth,
  Limit ///< a number, or null where it is infinite
};

/// A key of a report and the column of a table that it has.
struct ReportKey
{
  const char* key;
  const char* column;
  ReportKind kind;
  const char* help; ///< empty: that of the next key is of both
};

/// The keys of a record by its name in Python, such as "PieceReport", or by that of its list in
/// report.json where that has other keys; none where there is none.
const std::vector<ReportKey>& reportKeys(const std::string& record);
}
