// SPDX-License-Identifier: BSD-3-Clause
#include "Report/ReportRows.h"

#include <cmath>
#include <sstream>

namespace flattening
{
namespace
{
ReportValue valueOf(const Columns& table, std::size_t row, const ReportKey& key)
{
  const double number = key.kind == ReportKind::Text ? 0.0 : numberIn(table, row, key.column);
  switch (key.kind)
  {
    case ReportKind::Text:
      return { textIn(table, row, key.column) };
    case ReportKind::Integer:
      return { static_cast<std::int64_t>(number) };
    case ReportKind::Truth:
      return { number != 0.0 };
    case ReportKind::Limit:
      return std::isfinite(number) ? ReportValue{ number } : ReportValue{};
    default:
      return { number };
  }
}

/// The rows of one piece in a table with the column Piece.
std::vector<std::size_t> rowsOfPiece(const Columns& table, std::size_t piece)
{
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    if (numberIn(table, row, "Piece") == static_cast<double>(piece))
    {
      rows.push_back(row);
    }
  }
  return rows;
}

ReportList listOf(const Columns& table, std::size_t piece, const char* record)
{
  ReportList list;
  for (const std::size_t row : rowsOfPiece(table, piece))
  {
    list.push_back({ reportRow(table, row, reportKeys(record)) });
  }
  return list;
}

/// Curves to release, the best first, and what that would bring; null where there is none.
ReportValue releaseOf(const ReportTables& tables, std::size_t piece)
{
  const std::string first = textIn(tables.pieces, piece, "ReleaseFirst");
  if (first.empty())
  {
    return {};
  }
  const double objective = numberIn(tables.pieces, piece, "ObjectiveWithoutFirst");
  ReportList ranking;
  const Columns& trials = tables.releaseTrials;
  for (const std::size_t row : rowsOfPiece(trials, piece))
  {
    const bool tried = numberIn(trials, row, "Tried") != 0.0;
    const auto without = [&](const char* name) {
      return tried ? ReportValue{ numberIn(trials, row, name) } : ReportValue{};
    };
    const bool shape = numberIn(trials, row, "Shape") != 0.0;
    ranking.push_back({ ReportObject{ { "curve", { textIn(trials, row, "Name") } },
      { "release", { std::string(shape ? "shape" : "curve") } },
      { "objective_without", without("Objective") }, { "E_area_without", without("AreaError") },
      { "E_h_without", without("Homogeneity") } } });
  }
  return { ReportObject{ { "first", { first } },
    { "objective_without_first", objective >= 0.0 ? ReportValue{ objective } : ReportValue{} },
    { "ranking", { std::move(ranking) } } } };
}
}

ReportObject reportRow(const Columns& table, std::size_t row, const std::vector<ReportKey>& keys)
{
  ReportObject object;
  for (const ReportKey& key : keys)
  {
    object.emplace_back(key.key, valueOf(table, row, key));
  }
  return object;
}

ReportList reportRows(const Columns& table, const std::vector<ReportKey>& keys)
{
  ReportList rows;
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    rows.push_back({ reportRow(table, row, keys) });
  }
  return rows;
}

ReportList pieceReports(const ReportTables& tables)
{
  const Columns& pieces = tables.pieces;
  const bool cloth = findColumn(pieces, "StrainWarpRms") != nullptr;
  ReportList reports;
  for (std::size_t piece = 0; piece < rowsOf(pieces); ++piece)
  {
    ReportObject report = reportRow(pieces, piece, reportKeys("PieceReport"));
    ReportList ids;
    std::istringstream words(textIn(pieces, piece, "StatusIds"));
    for (std::int64_t id = 0; words >> id;)
    {
      ids.emplace_back().value = id;
    }
    ReportList remedies;
    for (const std::size_t row : rowsOfPiece(tables.pieceRemedies, piece))
    {
      remedies.push_back(
        { ReportObject{ { "name", { textIn(tables.pieceRemedies, row, "Remedy") } },
          { "subject", { textIn(tables.pieceRemedies, row, "Subject") } } } });
    }
    report.emplace_back("message", ReportValue{ textIn(pieces, piece, "StatusDefect") });
    report.emplace_back("ids", ReportValue{ std::move(ids) });
    report.emplace_back("remedies", ReportValue{ std::move(remedies) });
    report.emplace_back("release", releaseOf(tables, piece));
    report.emplace_back("isometric_history",
      ReportValue{ listOf(tables.isometricIterations, piece, "IsometricStep") });
    report.emplace_back(
      "history", ReportValue{ listOf(tables.angleIterations, piece, "AngleStep") });
    report.emplace_back("cloth",
      cloth ? ReportValue{ reportRow(pieces, piece, reportKeys("ClothReport")) } : ReportValue{});
    reports.push_back({ std::move(report) });
  }
  return reports;
}
}
