// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestedCuts.h"

#include "PlainText.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace wirewarp
{
namespace
{
std::string curveTypeName(double type)
{
  static constexpr std::array<const char*, 4> names{ "accessory", "key", "dart", "seam" };
  return names.at(static_cast<std::size_t>(type));
}
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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
}

//------------------------------------------------------------------------------
std::string suggestionTable(const Flattening& result)
{
  if (!result.curves)
  {
    return "";
  }
  std::ostringstream text;
  const std::vector<SuggestedCut> cuts = suggestedCuts(result);
  if (cuts.empty())
  {
    text << "\nnothing is proposed\n";
  }
  else
  {
    writeHead("proposed", text);
  }
  for (const SuggestedCut& cut : cuts)
  {
    writeRow(cut, text);
    text << '\n';
  }
  if (!cuts.empty())
  {
    text << mirrorLine(result);
  }
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
}
