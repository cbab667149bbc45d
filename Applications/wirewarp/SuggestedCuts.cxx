// SPDX-License-Identifier: BSD-3-Clause
#include "SuggestedCuts.h"

#include "PlainText.h"
#include "Report.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkStringArray.h>

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
    cut.strainBefore = at("StrainBefore", row);
    cut.strainAfter = at("StrainAfter", row);
    const auto mirrorOf = static_cast<vtkIdType>(at("MirrorOf", row));
    cut.mirrorOf = mirrorOf > 0 ? std::string(names->GetValue(first + mirrorOf - 1)) : "";
    cuts.push_back(cut);
  }
  return cuts;
}

//------------------------------------------------------------------------------
std::string suggestionTable(const Flattening& result)
{
  if (!result.curves)
  {
    return "";
  }
  const std::vector<SuggestedCut> cuts = suggestedCuts(result);
  if (cuts.empty())
  {
    return "\nno cut is proposed\n";
  }
  std::ostringstream text;
  text << "\n"
       << std::left << std::setw(12) << "proposed" << std::right << std::setw(12) << "length"
       << std::setw(12) << "gain" << std::setw(22) << "strain_p95" << '\n';
  for (const SuggestedCut& cut : cuts)
  {
    text << std::left << std::setw(12) << plainText(cut.name) << std::right << std::setprecision(4)
         << std::setw(12) << cut.length << std::setw(12) << cut.gain << std::setw(11)
         << cut.strainBefore << " -> " << std::left << cut.strainAfter << '\n';
  }
  return text.str();
}
}
