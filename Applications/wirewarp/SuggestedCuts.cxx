// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestedCuts.h"

#include "FieldRows.h"
#include "PlainText.h"
#include "Report.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace wirewarp
{
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
    cut.type = static_cast<long long>(at("CurveType", row));
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
  vtkFieldData* const field = result.curves ? result.curves->GetFieldData() : nullptr;
  auto* const names =
    field ? vtkStringArray::SafeDownCast(field->GetAbstractArray("LeftOutCurveName")) : nullptr;
  for (vtkIdType row = 0; names && row < names->GetNumberOfValues(); ++row)
  {
    const auto at = [field, row](const std::string& array) {
      return field->GetArray(("LeftOut" + array).c_str())->GetComponent(row, 0);
    };
    LeftOutLine line;
    line.type = static_cast<long long>(at("CurveType"));
    line.name = names->GetValue(row);
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
  const FieldRows field(result.curves);
  const auto triple = [&field](const char* array, vtkIdType first) {
    std::ostringstream words;
    words << std::setprecision(4) << '(' << field.number(array, first) << ", "
          << field.number(array, first + 1) << ", " << field.number(array, first + 2) << ')';
    return words.str();
  };
  std::ostringstream line;
  if (field.count("MirrorPlane") > 0)
  {
    line << "mirrored across the plane with normal " << triple("MirrorPlane", 0) << " and offset "
         << std::setprecision(4) << field.number("MirrorPlane", 3) << '\n';
  }
  else if (field.count("MirrorAxis") > 0)
  {
    line << "mirrored, by lengths and angles, across the axis from " << triple("MirrorAxis", 0)
         << " to " << triple("MirrorAxis", 3) << '\n';
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
