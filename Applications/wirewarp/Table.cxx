// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include "Base/Status.h"
#include "FlagWords.h"
#include "PlainText.h"
#include "Surface/FeatureCurve.h"
#include "TriangleList.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
using flattening::shortNumber;
using Row = std::vector<std::string>;

template <typename Value>
std::string format(const char* pattern, Value value)
{
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

struct NumberColumn
{
  const char* head;
  const char* column;
  const char* pattern;
  double factor = 1.0;
};

/// Of the table of pieces.
constexpr NumberColumn measureColumns[] = { { "wire-patches", "WirePatches", "%.0f" },
  { "E_len x1e3", "EdgeLengthError", "%.2f", 1e3 }, { "E_len max", "MaxEdgeLengthError", "%.1e" },
  { "E_len all", "EdgeLengthErrorAll", "%.4f" }, { "E_ang x1e3", "AngleErrorMean", "%.1f", 1e3 },
  { "E_h", "GlobalHomogeneity", "%.3f" }, { "E_r", "GlobalAspectRatio", "%.3f" },
  { "E_area", "AreaError", "%.4f" }, { "strain p95", "StrainP95", "%.4f" },
  { "flips", "FlippedTriangles", "%.0f" }, { "overlaps", "Overlaps", "%.0f" },
  { "iterations", "Iterations", "%.0f" } };

/// Columns side by side: the first `left` ones and the last to the left, the others to the right.
std::string layOut(const std::vector<Row>& rows, std::size_t left)
{
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const Row& row : rows)
  {
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      width[c] = std::max(width[c], row[c].size());
    }
  }
  std::string text;
  for (const Row& row : rows)
  {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      const std::string blanks(width[c] - row[c].size(), ' ');
      const bool toTheLeft = c < left || c + 1 == row.size();
      line += (c ? "  " : "") + (toTheLeft ? row[c] + blanks : blanks + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

/// Of more pieces or cuts not all have a line.
constexpr std::size_t mostListed = 20;

std::string moreThanListed(std::size_t count, const std::string& what)
{
  return count <= mostListed
    ? ""
    : "and " + std::to_string(count - mostListed) + " more " + what + "; --table lists all\n";
}

/// Pieces are counted from 1 wherever somebody reads of them, as on the pattern.
std::string nameOf(std::size_t piece)
{
  return std::to_string(piece + 1);
}

std::string sizeInMillimetres(const Flattening& result, std::size_t piece)
{
  const Table& table = result.tables.pieces;
  const double millimetres = millimetresOf(result.unit);
  return format("%.0f", millimetres * numberIn(table, piece, "FlatWidth")) + "x" +
    format("%.0f", millimetres * numberIn(table, piece, "FlatHeight"));
}

std::string percent(double strain)
{
  constexpr double least = 0.0005;
  return std::isnan(strain) ? "unknown"
    : strain < least        ? "under 0.1 %"
    : strain < 0.1          ? format("%.2g %%", 100.0 * strain)
                            : format("%.0f %%", 100.0 * strain);
}

/// The row of the first curve to release in a piece; past the last where there is none.
std::size_t firstRelease(const Table& trials, std::size_t piece)
{
  std::size_t row = 0;
  while (row < rowsOf(trials) && integerIn(trials, row, "Piece") != static_cast<long long>(piece))
  {
    ++row;
  }
  return row;
}

/// What the trial of a release would better, in the measure of the scheme; empty where nothing.
std::string gain(const flattening::ReportTables& tables, std::size_t piece, std::size_t row)
{
  // Schemes that choose the wires' angles alone are judged by them.
  const bool whole = rowsOf(tables.isometricIterations) > 0;
  const char* const measure = whole ? "E_area" : "the objective";
  const char* const column = whole ? "AreaError" : "Objective";
  const double now = numberIn(tables.pieces, piece, column);
  const double then = numberIn(tables.releaseTrials, row, column);
  if (!(then < now))
  {
    return "";
  }
  return std::string(measure) + " would fall from " + format("%.4g", now) + " to " +
    format("%.4g", then) + ", E_h go from " +
    format("%.3f", numberIn(tables.pieces, piece, "GlobalHomogeneity")) + " to " +
    format("%.3f", numberIn(tables.releaseTrials, row, "Homogeneity"));
}
}

std::string pieceTable(const Flattening& result)
{
  const Table& table = result.tables.pieces;
  const std::size_t pieces = rowsOf(table);
  const std::string optimized = format("%.3f", result.seconds.wires);
  const std::string all = format("%.3f", result.seconds.total);
  std::vector<Row> rows{ { "piece", "triangles", "size [mm]" } };
  for (const NumberColumn& column : measureColumns)
  {
    rows.front().emplace_back(column.head);
  }
  rows.front().insert(rows.front().end(), { "T_opt [s]", "T_all [s]", "status" });
  for (std::size_t piece = 0; piece < pieces; ++piece)
  {
    const std::string name = plainText(textIn(table, piece, "Name"));
    Row row{ nameOf(piece) + (name.empty() ? "" : " " + name),
      std::to_string(integerIn(table, piece, "Triangles")), sizeInMillimetres(result, piece) };
    for (const NumberColumn& column : measureColumns)
    {
      row.push_back(format(column.pattern, column.factor * numberIn(table, piece, column.column)));
    }
    row.insert(row.end(),
      { pieces == 1 ? optimized : "-", pieces == 1 ? all : "-", textIn(table, piece, "Status") });
    rows.push_back(std::move(row));
  }
  for (std::size_t row = 0; row < rowsOf(result.tables.leftOutPieces); ++row)
  {
    Row leftOut(rows.front().size(), "-");
    leftOut[1] = std::to_string(integerIn(result.tables.leftOutPieces, row, "Triangles"));
    leftOut.back() = textIn(result.tables.leftOutPieces, row, "Reason") + ", left out";
    rows.push_back(leftOut);
  }
  if (rows.size() != 2)
  {
    Row total(rows.front().size());
    total.front() = "all";
    total[total.size() - 3] = optimized;
    total[total.size() - 2] = all;
    total.back() = result.status;
    rows.push_back(total);
  }
  return layOut(rows, 1);
}

bool coversItself(const Table& pieces, std::size_t piece)
{
  const std::string status = textIn(pieces, piece, "Status");
  return status == "Overlap" || status == "FlippedTriangles";
}

std::string fitVerdict(const Table& pieces, std::size_t piece, double bound)
{
  if (coversItself(pieces, piece))
  {
    return "does not fit: it lies over itself, cut it";
  }
  const double strain = numberIn(pieces, piece, "StrainP95");
  constexpr double hardlyAny = 0.01;
  constexpr double ofCloth = 0.05;
  constexpr double ofElastic = 0.15;
  constexpr double tolerance = 1.1; // a search ends about at its bound
  std::string words = percent(strain);
  const double enough = bound > 0.0 ? tolerance * bound : ofCloth;
  if (std::isnan(strain))
  {
    return words;
  }
  if (strain <= enough)
  {
    return strain <= hardlyAny ? "fits, strain " + words : "fits with a strain of " + words;
  }
  if (strain > (bound > 0.0 ? missedBy * bound : ofElastic))
  {
    return "does not fit: strain " + words + ", cut it";
  }
  return "strain " + words + (bound > 0.0 ? ", more than wanted" : ", for material that gives");
}

std::string verdicts(const Flattening& result)
{
  const Table& table = result.tables.pieces;
  std::vector<std::size_t> pieces(rowsOf(table));
  std::iota(pieces.begin(), pieces.end(), std::size_t{ 0 });
  if (pieces.size() > mostListed)
  {
    // Those that fit worst; the strain of what has none is not a number.
    const auto fits = [&table](std::size_t piece) {
      const double strain = numberIn(table, piece, "StrainP95");
      return coversItself(table, piece) || std::isnan(strain) ? -1.0 : 1.0 / (1.0 + strain);
    };
    std::stable_sort(pieces.begin(), pieces.end(),
      [&fits](std::size_t a, std::size_t b) { return fits(a) < fits(b); });
    pieces.resize(mostListed);
    std::sort(pieces.begin(), pieces.end());
  }
  std::string text;
  for (const std::size_t piece : pieces)
  {
    const std::string name = plainText(textIn(table, piece, "Name"));
    text += "piece " + nameOf(piece) + (name.empty() ? "" : " " + name) + ": " +
      textIn(table, piece, "SizeInWords") + "; " + plainText(textIn(table, piece, "EaseInWords")) +
      "; " + fitVerdict(table, piece, 0.0) + '\n';
  }
  return text + moreThanListed(rowsOf(table), "pieces, which fit better");
}

std::string curveTable(const Flattening& result)
{
  const Table& table = result.tables.curves;
  std::vector<Row> rows{ { "curve", "length", "flat length", "largest error", "tolerance",
    "type" } };
  for (std::size_t curve = 0; curve < rowsOf(table); ++curve)
  {
    rows.push_back({ plainText(textIn(table, curve, "Name")),
      format("%.10g", numberIn(table, curve, "RestLength")),
      format("%.10g", numberIn(table, curve, "FlatLength")),
      format("%.1e", numberIn(table, curve, "LengthError")),
      format("%.3g", numberIn(table, curve, "Tolerance")),
      textIn(table, curve, "Type") +
        (integerIn(table, curve, "Released") != 0 ? " (released)" : "") });
  }
  return layOut(rows, 1);
}

std::string curveDistance(const Flattening& result)
{
  // Coordinates as files have them, with seven figures, are on the surface.
  const double size = result.cut ? boxOf(*result.cut->points).diagonal().norm() : 0.0;
  if (!result.cut || result.curveDistance <= 1e-6 * size)
  {
    return "";
  }
  return "the points of curves were up to " +
    format("%.2g", result.curveDistance * millimetresOf(result.unit)) +
    " mm off the surface, and laid on it\n";
}

std::string releaseAdvice(const Flattening& result)
{
  const Table& trials = result.tables.releaseTrials;
  std::string text;
  for (std::size_t piece = 0; piece < rowsOf(result.tables.pieces); ++piece)
  {
    const std::size_t row = firstRelease(trials, piece);
    if (row == rowsOf(trials) || integerIn(trials, row, "Tried") == 0)
    {
      continue;
    }
    const std::string better = gain(result.tables, piece, row);
    if (!better.empty())
    {
      const bool key = integerIn(trials, row, "Shape") != 0;
      text += "piece " + nameOf(piece) + " has no good exact solution: without " +
        (key ? "the shape of the key curve " : "the curve ") +
        plainText(textIn(trials, row, "Name")) + ' ' + better +
        (key ? "; make it an accessory curve, or free all keys with --no-keys\n"
             : "; remove it, or make it elastic with --tolerance\n");
    }
  }
  return text;
}

std::string unitNote(const Flattening& result, const std::string& where)
{
  return result.unitNote.empty() ? "" : messageLine("note", where + result.unitNote);
}

std::string warnings(const Flattening& result, const std::string& where)
{
  std::string text;
  for (const std::string& warning : result.warnings)
  {
    text += messageLine("warning", where + warning);
  }
  return text;
}

std::string writeErrors(const Flattening& result)
{
  std::string text;
  for (const std::string& error : result.unwritten)
  {
    text += messageLine("error", error);
  }
  return text;
}

std::string fallbacks(const Flattening& result)
{
  const Table& table = result.tables.pieces;
  std::string text;
  for (std::size_t piece = 0; piece < rowsOf(table); ++piece)
  {
    if (!textIn(table, piece, "Fallbacks").empty())
    {
      text += "piece " + nameOf(piece) + ": " + textIn(table, piece, "Fallbacks") + '\n';
    }
  }
  return text;
}

std::string pieceWarnings(const Flattening& result, const std::string& where)
{
  const Table& table = result.tables.pieces;
  std::string text;
  for (std::size_t piece = 0; piece < rowsOf(table); ++piece)
  {
    if (textIn(table, piece, "Status") != "Ok")
    {
      text += messageLine("warning",
        where + "piece " + nameOf(piece) + ": " +
          messageOf(textIn(table, piece, "StatusDefect"), remediesOf(result.tables, piece)));
    }
  }
  return text.empty() ? messageLine("warning", where + result.message) : text;
}

Table suggestedCuts(const Flattening& result)
{
  if (!result.curves || result.curves->lines.size() == 0)
  {
    return {};
  }
  const Table& cells = result.curves->cellArrays;
  const std::size_t count = result.curves->lines.size();
  std::size_t first = 0;
  while (first < count && numberIn(cells, first, "Rank") < 0.0)
  {
    ++first;
  }
  std::vector<std::int64_t> rows;
  std::vector<std::string> types;
  std::vector<std::string> images;
  for (std::size_t row = first; row < count; ++row)
  {
    const long long mirrorOf = integerIn(cells, row, "MirrorOf");
    rows.push_back(static_cast<std::int64_t>(row));
    types.emplace_back(flattening::curveTypeName(
      static_cast<flattening::CurveType>(integerIn(cells, row, "CurveType"))));
    images.push_back(mirrorOf > 0
        ? textIn(cells, first + static_cast<std::size_t>(mirrorOf) - 1, "CurveName")
        : "");
  }
  Table table = flattening::copiedRows(cells, rows);
  for (flattening::Column& column : table)
  {
    column.name = column.name == "CurveName" ? "Name" : column.name;
  }
  setColumn(table, { "Type", std::move(types) });
  setColumn(table, { "MirrorOf", std::move(images) });
  return table;
}

std::vector<double> mirrorNumbers(const Flattening& result, const char* array)
{
  const flattening::Column* const values =
    result.curves ? findColumn(result.curves->fieldArrays, array) : nullptr;
  std::vector<double> numbers;
  for (std::size_t k = 0; values && k < values->rows(); ++k)
  {
    numbers.push_back(values->number(k));
  }
  return numbers;
}

namespace
{
/// What the proposals keep to; empty where that is nothing.
std::string mirrorLine(const Flattening& result)
{
  const std::vector<double> plane = mirrorNumbers(result, "MirrorPlane");
  const std::vector<double> axis = mirrorNumbers(result, "MirrorAxis");
  const auto triple = [](const double* numbers) {
    return '(' + shortNumber(numbers[0]) + ", " + shortNumber(numbers[1]) + ", " +
      shortNumber(numbers[2]) + ')';
  };
  if (!plane.empty())
  {
    return "mirrored across the plane with normal " + triple(plane.data()) + " and offset " +
      shortNumber(plane[3]) + '\n';
  }
  if (!axis.empty())
  {
    return "mirrored, by lengths and angles, across the axis from " + triple(axis.data()) + " to " +
      triple(axis.data() + 3) + '\n';
  }
  return "";
}

/// Nothing is known of a surface that cannot be flattened, as a closed one until it is cut.
std::string known(double value)
{
  return std::isnan(value) ? "-" : shortNumber(value);
}

/// Rows of proposals, or of lines that were left out, under a head.
std::string tableOf(const char* head, const Table& lines)
{
  std::vector<Row> rows{ { head, "length", "gain", "E_area", "strain_p95", "" } };
  for (std::size_t row = 0; row < rowsOf(lines); ++row)
  {
    const auto at = [&lines, row](const char* name) { return known(numberIn(lines, row, name)); };
    const bool breaks = findColumn(lines, "Sound") && integerIn(lines, row, "Sound") == 0;
    rows.push_back({ plainText(textIn(lines, row, "Name")), at("Length"), at("Gain"),
      at("AreaErrorBefore") + " -> " + at("AreaErrorAfter"),
      at("StrainBefore") + " -> " + at("StrainAfter"),
      breaks ? "breaks what holds without it" : "" });
  }
  return rows.size() == 1 ? "" : '\n' + layOut(rows, 1);
}

/// What was proposed, for people.
std::string shortList(const Table& cuts, const Table& leftOut, const std::string& unit)
{
  std::string text;
  for (std::size_t row = 0; row < std::min(rowsOf(cuts), mostListed); ++row)
  {
    const double before = numberIn(cuts, row, "StrainBefore");
    const double after = numberIn(cuts, row, "StrainAfter");
    text += plainText(textIn(cuts, row, "Name")) + ": " + known(numberIn(cuts, row, "Length")) +
      ' ' + unit + " long";
    if (!std::isnan(after))
    {
      text += ", strain " + (std::isnan(before) ? "" : percent(before) + " -> ") + percent(after);
    }
    text += '\n';
  }
  text += moreThanListed(rowsOf(cuts), "cuts");
  for (const bool sound : { true, false })
  {
    std::string names;
    for (std::size_t row = 0; row < rowsOf(leftOut); ++row)
    {
      if ((integerIn(leftOut, row, "Sound") != 0) == sound)
      {
        names += (names.empty() ? "" : ", ") + plainText(textIn(leftOut, row, "Name"));
      }
    }
    if (!names.empty())
    {
      text += std::string("left out, since they ") +
        (sound ? "cost more than they give: " : "break what holds without them: ") + names + '\n';
    }
  }
  return text;
}
}

std::string suggestionTable(const Flattening& result, bool numbers)
{
  if (!result.curves)
  {
    return "";
  }
  const Table cuts = suggestedCuts(result);
  const bool none = rowsOf(cuts) == 0;
  const std::string mirror = none ? "" : mirrorLine(result);
  return (none ? "nothing is proposed\n" : "") +
    (numbers ? tableOf("proposed", cuts) + mirror + tableOf("left out", result.leftOutLines)
             : shortList(cuts, result.leftOutLines, result.unit) + mirror);
}

std::string keyPriceTable(const Flattening& result)
{
  const Table& table = result.keyPrices;
  std::vector<Row> rows{ { "trial", "price", "E_area", "strain_p95", "status" } };
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    const auto at = [&table, row](const char* name) {
      const double value = numberIn(table, row, name);
      return std::isnan(value) ? std::string() : format("%.5f", value);
    };
    const std::string released = plainText(textIn(table, row, "Released"));
    rows.push_back(
      { plainText(textIn(table, row, "Trial")), at("Price"), at("AreaError"), at("StrainP95"),
        textIn(table, row, "Status") + (released.empty() ? "" : ", released " + released) });
  }
  return rows.size() == 1 ? "" : '\n' + layOut(rows, 1);
}
}
