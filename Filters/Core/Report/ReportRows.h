// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Columns.h"
#include "Report/FlatteningTables.h"
#include "Report/ReportKeys.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace flattening
{
struct ReportValue;
using ReportList = std::vector<ReportValue>;
using ReportObject = std::vector<std::pair<std::string, ReportValue>>;

/// A value of a report as JSON has them.
struct ReportValue
{
  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, ReportList, ReportObject>
    value;
};

/// A row of a table by the keys of a report; 0 or empty where there is no such column.
ReportObject reportRow(const Columns& table, std::size_t row, const std::vector<ReportKey>& keys);
ReportList reportRows(const Columns& table, const std::vector<ReportKey>& keys);

/// A PieceReport each; its message is the defect alone, for front ends to add the remedies in their
/// words.
ReportList pieceReports(const ReportTables& tables);
}
