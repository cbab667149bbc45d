// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include "FlagWords.h"
#include "PlainText.h"
#include "Units.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>
#include <vector>

namespace wirewarp
{
namespace
{
using Row = std::vector<std::string>;

template <typename Value>
std::string format(const char* pattern, Value value)
{
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

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

/// Pieces are counted from 1 wherever somebody reads of them, as on the pattern.
std::string nameOf(vtkIdType piece)
{
  return std::to_string(piece + 1);
}

std::string sizeInMillimetres(const Flattening& result, vtkIdType piece)
{
  vtkTable* const table = result.tables.pieces;
  const double millimetres = millimetresOf(result.unit);
  return format("%.0f", millimetres * numberIn(table, piece, "FlatWidth")) + "x" +
    format("%.0f", millimetres * numberIn(table, piece, "FlatHeight"));
}

std::string curveTypeName(double type)
{
  static constexpr std::array<const char*, 4> names{ "accessory", "key", "dart", "seam" };
  return names.at(static_cast<std::size_t>(type));
}

/// The row of the first curve to release in a piece; past the last where there is none.
vtkIdType firstRelease(vtkTable* trials, vtkIdType piece)
{
  vtkIdType row = 0;
  while (row < trials->GetNumberOfRows() && integerIn(trials, row, "Piece") != piece)
  {
    ++row;
  }
  return row;
}

/// What the trial of a release would better, in the measure of the scheme; empty where nothing.
std::string gain(const PieceTables& tables, vtkIdType piece, vtkIdType row)
{
  // Schemes that choose the wires' angles alone are judged by them.
  const bool whole = tables.isometricIterations->GetNumberOfRows() > 0;
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
  vtkTable* const table = result.tables.pieces;
  const vtkIdType pieces = table->GetNumberOfRows();
  const std::string optimized = format("%.3f", result.seconds[0]);
  const std::string all = format("%.3f", result.seconds[3]);
  std::vector<Row> rows{ { "piece", "triangles", "size [mm]", "wire-patches", "E_len x1e3",
    "E_len max", "E_ang x1e3", "E_h", "E_r", "E_area", "strain p95", "flips", "overlaps",
    "iterations", "T_opt [s]", "T_all [s]", "status" } };
  for (vtkIdType piece = 0; piece < pieces; ++piece)
  {
    const std::string name = plainText(textIn(table, piece, "Name"));
    rows.push_back({ nameOf(piece) + (name.empty() ? "" : " " + name),
      std::to_string(integerIn(table, piece, "Triangles")), sizeInMillimetres(result, piece),
      std::to_string(integerIn(table, piece, "WirePatches")),
      format("%.2f", 1e3 * numberIn(table, piece, "EdgeLengthError")),
      format("%.1e", numberIn(table, piece, "MaxEdgeLengthError")),
      format("%.1f", 1e3 * numberIn(table, piece, "AngleErrorMean")),
      format("%.3f", numberIn(table, piece, "GlobalHomogeneity")),
      format("%.3f", numberIn(table, piece, "GlobalAspectRatio")),
      format("%.4f", numberIn(table, piece, "AreaError")),
      format("%.4f", numberIn(table, piece, "StrainP95")),
      std::to_string(integerIn(table, piece, "FlippedTriangles")),
      std::to_string(integerIn(table, piece, "Overlaps")),
      std::to_string(integerIn(table, piece, "Iterations")), pieces == 1 ? optimized : "-",
      pieces == 1 ? all : "-", textIn(table, piece, "Status") });
  }
  for (vtkIdType row = 0; row < result.leftOutPieces->GetNumberOfRows(); ++row)
  {
    Row leftOut(rows.front().size(), "-");
    leftOut[1] = std::to_string(integerIn(result.leftOutPieces, row, "Triangles"));
    leftOut.back() = textIn(result.leftOutPieces, row, "Reason") + ", left out";
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

std::string verdicts(const Flattening& result)
{
  vtkTable* const table = result.tables.pieces;
  std::string text;
  for (vtkIdType piece = 0; piece < table->GetNumberOfRows(); ++piece)
  {
    const std::string name = plainText(textIn(table, piece, "Name"));
    text += "piece " + nameOf(piece) + (name.empty() ? "" : " " + name) + ": " +
      textIn(table, piece, "SizeInWords") + "; " + plainText(textIn(table, piece, "EaseInWords")) +
      '\n';
  }
  return text;
}

std::string curveTable(const Flattening& result)
{
  vtkTable* const table = result.curveTable;
  std::vector<Row> rows{ { "curve", "length", "flat length", "largest error", "tolerance",
    "type" } };
  for (vtkIdType curve = 0; curve < table->GetNumberOfRows(); ++curve)
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
  if (!result.cut || result.curveDistance <= 1e-6 * result.cut->GetLength())
  {
    return "";
  }
  return "the points of curves were up to " +
    format("%.2g", result.curveDistance * millimetresOf(result.unit)) +
    " mm off the surface, and laid on it\n";
}

std::string releaseAdvice(const Flattening& result)
{
  vtkTable* const trials = result.tables.releaseTrials;
  std::string text;
  for (vtkIdType piece = 0; piece < result.tables.pieces->GetNumberOfRows(); ++piece)
  {
    const vtkIdType row = firstRelease(trials, piece);
    if (row == trials->GetNumberOfRows() || integerIn(trials, row, "Tried") == 0)
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
  return result.unitNote.empty() ? ""
                                 : "wirewarp: note: " + plainText(where + result.unitNote) + '\n';
}

std::string warnings(const Flattening& result, const std::string& where)
{
  std::string text;
  for (const std::string& warning : result.warnings)
  {
    text += "wirewarp: warning: " + plainText(where + warning) + '\n';
  }
  for (const std::string& note : result.notes)
  {
    text += "wirewarp: warning: " + plainText(where + note) + '\n';
  }
  return text;
}

std::string writeErrors(const Flattening& result)
{
  std::string text;
  for (const std::string& error : result.unwritten)
  {
    text += "wirewarp: error: " + plainText(error) + '\n';
  }
  return text;
}

std::string fallbacks(const Flattening& result)
{
  vtkTable* const table = result.tables.pieces;
  std::string text;
  for (vtkIdType piece = 0; piece < table->GetNumberOfRows(); ++piece)
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
  vtkTable* const table = result.tables.pieces;
  std::string text;
  for (vtkIdType piece = 0; piece < table->GetNumberOfRows(); ++piece)
  {
    if (textIn(table, piece, "Status") != "Ok")
    {
      text += "wirewarp: warning: " + plainText(where) + "piece " + nameOf(piece) + ": " +
        plainText(
          messageOf(textIn(table, piece, "StatusDefect"), remediesOf(result.tables, piece))) +
        '\n';
    }
  }
  return text.empty() ? "wirewarp: warning: " + plainText(where + result.message) + '\n' : text;
}

std::vector<SuggestedCut> suggestedCuts(const Flattening& result)
{
  std::vector<SuggestedCut> cuts;
  if (!result.curves || result.curves->GetNumberOfCells() == 0)
  {
    return cuts;
  }
  vtkCellData* const cells = result.curves->GetCellData();
  auto* const names = vtkStringArray::SafeDownCast(cells->GetAbstractArray("CurveName"));
  const auto at = [cells](const char* array, vtkIdType row) {
    return cells->GetArray(array)->GetComponent(row, 0);
  };
  const vtkIdType count = result.curves->GetNumberOfCells();
  vtkIdType first = 0;
  while (first < count && at("Rank", first) < 0.0)
  {
    ++first;
  }
  for (vtkIdType row = first; row < count; ++row)
  {
    SuggestedCut cut;
    cut.type = curveTypeName(at("CurveType", row));
    cut.name = names->GetValue(row);
    cut.length = at("Length", row);
    cut.predictedGain = at("PredictedGain", row);
    cut.gain = at("Gain", row);
    cut.opening = at("Opening", row);
    cut.areaErrorBefore = at("AreaErrorBefore", row);
    cut.areaErrorAfter = at("AreaErrorAfter", row);
    cut.strainBefore = at("StrainBefore", row);
    cut.strainAfter = at("StrainAfter", row);
    const auto mirrorOf = static_cast<vtkIdType>(at("MirrorOf", row));
    cut.mirrorOf = mirrorOf > 0 ? std::string(names->GetValue(first + mirrorOf - 1)) : "";
    cuts.push_back(cut);
  }
  return cuts;
}

std::vector<LeftOutLine> leftOutLines(const Flattening& result)
{
  std::vector<LeftOutLine> lines;
  vtkTable* const table = result.leftOutLines;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto at = [table, row](const char* name) { return numberIn(table, row, name); };
    LeftOutLine line;
    line.type = textIn(table, row, "Type");
    line.name = textIn(table, row, "Name");
    line.length = at("Length");
    line.gain = at("Gain");
    line.areaErrorBefore = at("AreaErrorBefore");
    line.areaErrorAfter = at("AreaErrorAfter");
    line.strainBefore = at("StrainBefore");
    line.strainAfter = at("StrainAfter");
    line.sound = at("Sound") != 0.0;
    lines.push_back(line);
  }
  return lines;
}

std::vector<double> mirrorNumbers(const Flattening& result, const char* array)
{
  std::vector<double> numbers;
  vtkDataArray* const values =
    result.curves ? result.curves->GetFieldData()->GetArray(array) : nullptr;
  for (vtkIdType k = 0; values && k < values->GetNumberOfTuples(); ++k)
  {
    numbers.push_back(values->GetComponent(k, 0));
  }
  return numbers;
}

namespace
{
void writeHead(const char* what, std::ostream& text)
{
  text << "\n"
       << std::left << std::setw(14) << what << std::right << std::setw(12) << "length"
       << std::setw(12) << "gain" << std::setw(22) << "E_area" << std::setw(22) << "strain_p95"
       << '\n';
}

/// What the proposals keep to; empty where that is nothing.
std::string mirrorLine(const Flattening& result)
{
  const std::vector<double> plane = mirrorNumbers(result, "MirrorPlane");
  const std::vector<double> axis = mirrorNumbers(result, "MirrorAxis");
  const auto triple = [](const double* numbers) {
    std::ostringstream words;
    words << std::setprecision(4) << '(' << numbers[0] << ", " << numbers[1] << ", " << numbers[2]
          << ')';
    return words.str();
  };
  std::ostringstream line;
  if (!plane.empty())
  {
    line << "mirrored across the plane with normal " << triple(plane.data()) << " and offset "
         << std::setprecision(4) << plane[3] << '\n';
  }
  else if (!axis.empty())
  {
    line << "mirrored, by lengths and angles, across the axis from " << triple(axis.data())
         << " to " << triple(axis.data() + 3) << '\n';
  }
  return line.str();
}

/// Nothing is known of a surface that cannot be flattened, as a closed one until it is cut.
std::string known(double value)
{
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return std::isnan(value) ? "-" : text.str();
}

void writeRow(const SuggestedCut& cut, std::ostream& text)
{
  text << std::left << std::setw(14) << plainText(cut.name) << std::right << std::setw(12)
       << known(cut.length) << std::setw(12) << known(cut.gain) << std::setw(11)
       << known(cut.areaErrorBefore) << " -> " << std::left << std::setw(7)
       << known(cut.areaErrorAfter) << std::right << std::setw(11) << known(cut.strainBefore)
       << " -> " << std::left << known(cut.strainAfter);
}

std::string percent(double strain)
{
  std::ostringstream text;
  text << std::setprecision(2) << 100.0 * strain << " %";
  return std::isnan(strain) ? "unknown" : text.str();
}

/// What was proposed, for people.
std::string shortList(const Flattening& result)
{
  std::ostringstream text;
  for (const SuggestedCut& cut : suggestedCuts(result))
  {
    text << plainText(cut.name) << ": " << known(cut.length) << ' ' << result.unit
         << " long, strain " << percent(cut.strainBefore) << " -> " << percent(cut.strainAfter)
         << '\n';
  }
  for (const bool sound : { true, false })
  {
    std::string names;
    for (const LeftOutLine& line : leftOutLines(result))
    {
      if (line.sound == sound)
      {
        names.append(names.empty() ? "" : ", ").append(plainText(line.name));
      }
    }
    if (!names.empty())
    {
      text << "left out, since they "
           << (sound ? "cost more than they give: " : "break what holds without them: ") << names
           << '\n';
    }
  }
  return text.str();
}
}

std::string suggestionTable(const Flattening& result, bool numbers)
{
  if (!result.curves)
  {
    return "";
  }
  const std::vector<SuggestedCut> cuts = suggestedCuts(result);
  const std::string nothing = cuts.empty() ? "nothing is proposed\n" : "";
  const std::string mirror = cuts.empty() ? "" : mirrorLine(result);
  if (!numbers)
  {
    return nothing + shortList(result) + mirror;
  }
  std::ostringstream text;
  text << nothing;
  if (!cuts.empty())
  {
    writeHead("proposed", text);
  }
  for (const SuggestedCut& cut : cuts)
  {
    writeRow(cut, text);
    text << '\n';
  }
  text << mirror;
  const std::vector<LeftOutLine> lines = leftOutLines(result);
  if (!lines.empty())
  {
    writeHead("left out", text);
  }
  for (const LeftOutLine& line : lines)
  {
    writeRow(line, text);
    text << (line.sound ? "" : "  breaks what holds without it") << '\n';
  }
  return text.str();
}

std::vector<KeyTrialRow> keyTrials(const Flattening& result)
{
  std::vector<KeyTrialRow> rows;
  vtkTable* const table = result.keyPrices;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    rows.push_back({ textIn(table, row, "Trial"), numberIn(table, row, "Price"),
      numberIn(table, row, "AreaError"), numberIn(table, row, "StrainP95"),
      textIn(table, row, "Status"), textIn(table, row, "Released") });
  }
  return rows;
}

std::string keyPriceTable(const Flattening& result)
{
  const std::vector<KeyTrialRow> rows = keyTrials(result);
  if (rows.empty())
  {
    return "";
  }
  std::size_t width = 0;
  for (const KeyTrialRow& row : rows)
  {
    width = std::max(width, plainText(row.what).size());
  }
  std::ostringstream text;
  text << '\n'
       << std::left << std::setw(static_cast<int>(width)) << "trial" << std::right << std::setw(12)
       << "price" << std::setw(12) << "E_area" << std::setw(12) << "strain_p95"
       << "  status\n";
  text << std::fixed << std::setprecision(5);
  const auto number = [&text](double value) {
    text << std::setw(12);
    std::isnan(value) ? text << "" : text << value;
  };
  for (const KeyTrialRow& row : rows)
  {
    text << std::left << std::setw(static_cast<int>(width)) << plainText(row.what) << std::right;
    number(row.price);
    number(row.areaError);
    number(row.strainP95);
    text << "  " << row.status
         << (row.released.empty() ? "" : ", gave up " + plainText(row.released)) << '\n';
  }
  return text.str();
}
}
