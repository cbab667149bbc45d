// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include "FieldRows.h"
#include "FlagWords.h"
#include "PlainText.h"
#include "Report.h"
#include "Units.h"

#include <algorithm>
#include <cstdio>
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
  const FieldRows field(result.flat);
  const double millimetres = millimetresOf(result.unit);
  return format("%.0f", millimetres * field.number("FlatWidth", piece)) + "x" +
    format("%.0f", millimetres * field.number("FlatHeight", piece));
}

/// The row of the first curve to release in a piece; past the last where there is none.
vtkIdType firstRelease(const FieldRows& field, vtkIdType piece)
{
  vtkIdType row = 0;
  while (row < field.count("ReleasePiece") && field.integer("ReleasePiece", row) != piece)
  {
    ++row;
  }
  return row;
}

/// What the trial of a release would better, in the measure of the scheme; empty where nothing.
std::string gain(const FieldRows& field, vtkIdType piece, vtkIdType row)
{
  // Schemes that choose the wires' angles alone are judged by them.
  const bool whole = field.count("IsometricHistoryPiece") > 0;
  const char* const measure = whole ? "E_area" : "the objective";
  const double now = field.number(whole ? "AreaError" : "Objective", piece);
  const double then = field.number(whole ? "ReleaseAreaError" : "ReleaseObjective", row);
  if (!(then < now))
  {
    return "";
  }
  return std::string(measure) + " would fall from " + format("%.4g", now) + " to " +
    format("%.4g", then) + ", E_h go from " +
    format("%.3f", field.number("GlobalHomogeneity", piece)) + " to " +
    format("%.3f", field.number("ReleaseHomogeneity", row));
}
}

//------------------------------------------------------------------------------
std::string pieceTable(const Flattening& result)
{
  const FieldRows field(result.flat);
  const vtkIdType pieces = field.count("Triangles");
  const std::string optimized = format("%.3f", field.number("SecondsWires", 0));
  const std::string all = format("%.3f", field.number("SecondsTotal", 0));
  std::vector<Row> rows{ { "piece", "triangles", "size [mm]", "wire-patches", "E_len x1e3",
    "E_len max", "E_ang x1e3", "E_h", "E_r", "E_area", "strain p95", "flips", "overlaps",
    "iterations", "T_opt [s]", "T_all [s]", "status" } };
  for (vtkIdType piece = 0; piece < pieces; ++piece)
  {
    const std::string name = plainText(field.text("PieceNames", piece));
    rows.push_back({ nameOf(piece) + (name.empty() ? "" : " " + name),
      std::to_string(field.integer("Triangles", piece)), sizeInMillimetres(result, piece),
      std::to_string(field.integer("WirePatches", piece)),
      format("%.2f", 1e3 * field.number("EdgeLengthError", piece)),
      format("%.1e", field.number("MaxEdgeLengthError", piece)),
      format("%.1f", 1e3 * field.number("AngleErrorMean", piece)),
      format("%.3f", field.number("GlobalHomogeneity", piece)),
      format("%.3f", field.number("GlobalAspectRatio", piece)),
      format("%.4f", field.number("AreaError", piece)),
      format("%.4f", field.number("StrainP95", piece)),
      std::to_string(field.integer("FlippedTriangles", piece)),
      std::to_string(field.integer("Overlaps", piece)),
      std::to_string(field.integer("Iterations", piece)), pieces == 1 ? optimized : "-",
      pieces == 1 ? all : "-", field.text("Status", piece) });
  }
  for (vtkIdType row = 0; row < field.count("LeftOutCells"); ++row)
  {
    Row leftOut(rows.front().size(), "-");
    leftOut[1] = std::to_string(field.integer("LeftOutTriangles", row));
    leftOut.back() = field.text("LeftOutReasons", row) + ", left out";
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

//------------------------------------------------------------------------------
std::string verdicts(const Flattening& result, bool unitAsked)
{
  const FieldRows field(result.flat);
  std::string text;
  for (vtkIdType piece = 0; piece < field.count("SizeInWords"); ++piece)
  {
    const std::string name = plainText(field.text("PieceNames", piece));
    text += "piece " + nameOf(piece) + (name.empty() ? "" : " " + name) + ": " +
      field.text("SizeInWords", piece) +
      (result.unitStated || unitAsked || piece > 0 ? "" : " (lengths taken as cm: --unit)") + "; " +
      plainText(field.text("EaseInWords", piece)) + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::string curveTable(const Flattening& result)
{
  const FieldRows field(result.wires);
  std::vector<Row> rows{ { "curve", "length", "flat length", "largest error", "tolerance",
    "type" } };
  for (vtkIdType curve = 0; curve < field.count("CurveNames"); ++curve)
  {
    rows.push_back({ plainText(field.text("CurveNames", curve)),
      format("%.10g", field.number("CurveRestLengths", curve)),
      format("%.10g", field.number("CurveFlatLengths", curve)),
      format("%.1e", field.number("CurveLengthErrors", curve)),
      format("%.3g", field.number("CurveTolerances", curve)),
      curveTypeName(field.integer("CurveTypes", curve)) +
        (field.integer("CurveReleased", curve) != 0 ? " (released)" : "") });
  }
  return layOut(rows, 1);
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
std::string releaseAdvice(const Flattening& result)
{
  const FieldRows field(result.flat);
  const FieldRows wires(result.wires);
  std::string text;
  for (vtkIdType piece = 0; piece < field.count("ReleaseFirst"); ++piece)
  {
    const vtkIdType row = firstRelease(field, piece);
    if (row == field.count("ReleasePiece") || field.integer("ReleaseTried", row) == 0)
    {
      continue;
    }
    const std::string better = gain(field, piece, row);
    if (!better.empty())
    {
      const bool key = field.integer("ReleaseShape", row) != 0;
      text += "piece " + nameOf(piece) + " has no good exact solution: without " +
        (key ? "the shape of the key curve " : "the curve ") +
        plainText(wires.text("CurveNames", field.integer("ReleaseCurve", row))) + ' ' + better +
        (key ? "; make it an accessory curve, or release all keys with --release-keys\n"
             : "; remove it, or make it elastic with --tolerance\n");
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string warnings(const Flattening& result, const std::string& where)
{
  const FieldRows field(result.flat);
  std::string text;
  for (vtkIdType row = 0; row < field.count("RunWarnings"); ++row)
  {
    text += "wirewarp: warning: " + plainText(where + field.text("RunWarnings", row)) + '\n';
  }
  for (const std::string& note : result.notes)
  {
    text += "wirewarp: warning: " + plainText(where + note) + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::string writeErrors(const Flattening& result)
{
  std::string text;
  for (const std::string& error : result.unwritten)
  {
    text += "wirewarp: error: " + plainText(error) + '\n';
  }
  return text;
}

//------------------------------------------------------------------------------
std::string fallbacks(const Flattening& result)
{
  const FieldRows field(result.flat);
  std::string text;
  for (vtkIdType piece = 0; piece < field.count("Fallbacks"); ++piece)
  {
    if (!field.text("Fallbacks", piece).empty())
    {
      text += "piece " + nameOf(piece) + ": " + field.text("Fallbacks", piece) + '\n';
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string pieceWarnings(const Flattening& result, const std::string& where)
{
  const FieldRows field(result.flat);
  std::string text;
  for (vtkIdType piece = 0; piece < field.count("Status"); ++piece)
  {
    if (field.text("Status", piece) != "Ok")
    {
      text += "wirewarp: warning: " + plainText(where) + "piece " + nameOf(piece) + ": " +
        plainText(messageOf(field.text("StatusDefect", piece), remediesOf(field, piece))) + '\n';
    }
  }
  return text.empty() ? "wirewarp: warning: " + plainText(where + result.message) + '\n' : text;
}
}
